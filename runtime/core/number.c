// number.c -- double -> the shortest decimal that reads back to it, the nearest
// of them where there are several; or the nearest one of few digits.
//
// Source: Raffaello Giulietti, "The Schubfach way to render doubles" (2021).
// x = c * 2^q; a 128-bit approximation of a power of ten scales the interval of
// decimals that round to x so that only two candidates are left to compare.
#include "lsys/number.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

typedef struct Wide {  // high * 2^64 + low
  uint64_t high, low;
} Wide;

typedef struct Decimal {  // digits * 10^exponent
  uint64_t digits;
  int exponent;
} Decimal;

// ---- powers of ten ---------------------------------------------------------

// Enough limbs for 10^324 and for 10^-292 with 128 bits that count.
enum { LEAST_POWER = -292, GREATEST_POWER = 324, LIMBS = 36 };

// powers[k - LEAST_POWER] = 10^k * 2^p rounded up, with p such that bit 127 is the highest one set.
static Wide powers[GREATEST_POWER - LEAST_POWER + 1];
static pthread_once_t powers_once = PTHREAD_ONCE_INIT;

// The 128 highest bits of a big number of 32-bit limbs (little-endian), rounded up if any below are set, or inexact is.
static Wide leading_bits(const uint32_t *limb, int inexact) {
  int top = LIMBS - 1;
  while (!limb[top]) top--;
  int shift = __builtin_clz(limb[top]);
  uint32_t word[5];  // the highest limbs, then shifted left so that bit 31 of word[0] is set
  for (int i = 0; i < 5; i++) word[i] = top >= i ? limb[top - i] : 0;
  for (int i = top - 5; i >= 0 && !inexact; i--) inexact = limb[i] != 0;
  for (int i = 0; shift && i < 4; i++) word[i] = word[i] << shift | word[i + 1] >> (32 - shift);
  if ((uint32_t)(word[4] << shift)) inexact = 1;
  Wide bits = {(uint64_t)word[0] << 32 | word[1], (uint64_t)word[2] << 32 | word[3]};
  if (inexact && ++bits.low == 0) bits.high++;
  return bits;
}

// 10^k is multiplied up from 1; 10^-k is divided down from a power of two, of
// which floor after floor is the floor of the whole quotient.
static void powers_make(void) {
  uint32_t limb[LIMBS] = {1};
  for (int k = 0; k <= GREATEST_POWER; k++) {
    powers[k - LEAST_POWER] = leading_bits(limb, 0);
    uint64_t carry = 0;
    for (int i = 0; i < LIMBS; i++) {
      carry += (uint64_t)limb[i] * 10;
      limb[i] = (uint32_t)carry;
      carry >>= 32;
    }
  }
  memset(limb, 0, sizeof limb);
  limb[LIMBS - 1] = 1;
  for (int k = -1; k >= LEAST_POWER; k--) {
    uint64_t rest = 0;
    for (int i = LIMBS - 1; i >= 0; i--) {
      rest = rest << 32 | limb[i];
      limb[i] = (uint32_t)(rest / 10);
      rest %= 10;
    }
    powers[k - LEAST_POWER] = leading_bits(limb, 1);
  }
}

// ---- the shortest digits ---------------------------------------------------

// floor(log10(2^e)), floor(log10(3/4 * 2^e)) and floor(log2(10^e)) for |e| <= 1700.
static int log10_pow2(int e) {
  return (e * 1262611) >> 22;
}

static int log10_three_quarters_pow2(int e) {
  return (e * 1262611 - 524031) >> 22;
}

static int log2_pow10(int e) {
  return (e * 1741647) >> 19;
}

// power * c / 2^128, whose last bit also says that something was cut off.
static uint64_t round_to_odd(Wide power, uint64_t c) {
  unsigned __int128 low = (unsigned __int128)power.low * c, high = (unsigned __int128)power.high * c;
  high += (uint64_t)(low >> 64);
  return (uint64_t)(high >> 64) | ((uint64_t)high > 1);
}

// Of a positive finite number given by its significand and exponent fields. All
// of vb, lower, upper are in quarters of 10^k.
static Decimal shortest(uint64_t fraction, int exponent) {
  int q = (exponent ? exponent : 1) - 1075;
  uint64_t c = exponent ? fraction | UINT64_C(1) << 52 : fraction;
  int even = (c & 1) == 0, closer_below = fraction == 0 && exponent > 1;
  int k = closer_below ? log10_three_quarters_pow2(q) : log10_pow2(q), h = q + log2_pow10(-k) + 1;
  Wide power = powers[-k - LEAST_POWER];
  uint64_t vb = round_to_odd(power, (4 * c) << h);
  uint64_t lower = round_to_odd(power, (4 * c - 2 + (uint64_t)closer_below) << h) + !even;
  uint64_t upper = round_to_odd(power, (4 * c + 2) << h) - !even;
  uint64_t s = vb / 4;
  if (s >= 10) {  // one digit fewer
    uint64_t t = s / 10;
    int below = lower <= 40 * t, above = 40 * t + 40 <= upper;
    if (below != above) return (Decimal){t + (uint64_t)above, k + 1};
  }
  int below = lower <= 4 * s, above = 4 * s + 4 <= upper;
  if (below != above) return (Decimal){s + (uint64_t)above, k};
  uint64_t middle = 4 * s + 2;
  return (Decimal){s + (vb > middle || (vb == middle && (s & 1))), k};
}

// ---- layout ------------------------------------------------------------------

// A number's digits, and room behind them: what is copied has a length that the compiler knows.
enum { MOST_DIGITS = 20, DIGITS_ROOM = 2 * MOST_DIGITS };

static const char pairs[] =
  "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"
  "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899";

// Writes n in decimal so that it ends at `end`; returns where it begins.
static char *put_digits(char *end, uint64_t n) {
  for (; n >= 100; n /= 100) memcpy(end -= 2, pairs + 2 * (n % 100), 2);
  if (n >= 10) return memcpy(end - 2, pairs + 2 * n, 2);
  *--end = (char)('0' + n);
  return end;
}

char *lsys_whole_print(char *to, uint64_t n) {
  if (n < 10) {
    *to = (char)('0' + n);
    return to + 1;
  }
  char digits[MOST_DIGITS], *end = digits + sizeof digits, *at = put_digits(end, n);
  size_t length = (size_t)(end - at);
  memcpy(to, at, length);
  return to + length;
}

static char *scientific(char *to, const char *digits, int count, int exponent) {
  *to++ = digits[0];
  if (count > 1) *to++ = '.';
  memcpy(to, digits + 1, MOST_DIGITS - 1);
  to += count - 1;
  *to++ = 'e';
  *to++ = exponent < 0 ? '-' : '+';
  unsigned magnitude = exponent < 0 ? -(unsigned)exponent : (unsigned)exponent;
  if (magnitude < 10) *to++ = '0';
  return lsys_whole_print(to, magnitude);
}

// As %.17g: fixed notation for exponents -4..16, else scientific with at least two digits of exponent.
static char *layout(char *to, Decimal d) {
  static const char zeros[] = "0.0000000000000000";
  while (d.digits % 10 == 0) d.digits /= 10, d.exponent++;
  char text[DIGITS_ROOM] = "";
  const char *digits = put_digits(text + MOST_DIGITS, d.digits);
  int count = (int)(text + MOST_DIGITS - digits);
  int exponent = d.exponent + count - 1;  // of the first digit
  if (exponent < -4 || exponent >= 17) return scientific(to, digits, count, exponent);
  if (exponent < 0) {  // 0.00ddd
    memcpy(to, zeros, 8);
    memcpy(to + 1 - exponent, digits, MOST_DIGITS);
    return to + 1 - exponent + count;
  }
  int whole = exponent + 1;
  memcpy(to, digits, MOST_DIGITS);
  if (count <= whole) {  // ddd00
    memcpy(to + count, zeros + 2, 16);
    return to + whole;
  }
  to[whole] = '.';
  memcpy(to + whole + 1, digits + whole, 16);
  return to + count + 1;
}

char *lsys_number_print(char *to, double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  uint64_t fraction = bits & ((UINT64_C(1) << 52) - 1);
  int exponent = (int)(bits >> 52 & 2047);
  if (exponent == 2047 && fraction) return stpcpy(to, "nan");
  if (bits >> 63) *to++ = '-';
  if (exponent == 2047) return stpcpy(to, "inf");
  double magnitude = bits >> 63 ? -x : x;
  if (magnitude < 0x1p53 && magnitude == (double)(uint64_t)magnitude) return lsys_whole_print(to, (uint64_t)magnitude);
  pthread_once(&powers_once, powers_make);
  return layout(to, shortest(fraction, exponent));
}

// ---- few digits --------------------------------------------------------------

static const uint64_t tens[] = {1,
                                10,
                                100,
                                1000,
                                10000,
                                100000,
                                1000000,
                                10000000,
                                100000000,
                                1000000000,
                                UINT64_C(10000000000),
                                UINT64_C(100000000000),
                                UINT64_C(1000000000000),
                                UINT64_C(10000000000000)};

// x * 10^k to the nearest whole number, to the even one of two, in whole numbers.
static uint64_t scale_exactly(double x, int k) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  uint64_t c = (bits & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
  int shift = 1075 - (int)(bits >> 52);
  unsigned __int128 product = (unsigned __int128)c * tens[k], half = (unsigned __int128)1 << (shift - 1);
  uint64_t whole = (uint64_t)(product >> shift);
  unsigned __int128 rest = product - ((unsigned __int128)whole << shift);
  return whole + (rest > half || (rest == half && (whole & 1)));
}

// The same; k from 0 to 13, x at least 2^-14 and less than 2^30, the result at most 10^10: a product of doubles is then
// wrong by less than 10^-5, which matters near the middle of two numbers alone.
static uint64_t scale(double x, int k) {
  double product = x * (double)tens[k];
  uint64_t whole = (uint64_t)product;
  double rest = product - (double)whole;
  if (rest > 0.50001) return whole + 1;
  return rest < 0.49999 ? whole : scale_exactly(x, k);
}

// floor(log10(x)) of an x from 1e-4 to 1e9, or one less.
static int first_exponent(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  int exponent = log10_pow2((int)(bits >> 52) - 1023);
  return exponent < -4 ? -4 : exponent;
}

// 10^(exponent + 1) of the exponents from -4.
static const double next_power[] = {1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

char *lsys_number_round(char *to, double x, int digits) {
  if (x == 0) return lsys_number_print(to, x);
  double magnitude = x < 0 ? -x : x;
  if (!(magnitude >= 1e-4 && magnitude < (double)tens[digits - 1])) return to + sprintf(to, "%.*g", digits, x);
  int exponent = first_exponent(magnitude);
  exponent += magnitude >= next_power[exponent + 4];
  uint64_t rounded = scale(magnitude, digits - 1 - exponent);
  if (rounded >= tens[digits]) rounded = scale(magnitude, digits - 1 - ++exponent);
  if (rounded < tens[digits - 1]) rounded = scale(magnitude, digits - 1 - --exponent);
  if (x < 0) *to++ = '-';
  return layout(to, (Decimal){rounded, exponent - digits + 1});
}

bool lsys_numbers_same(const double *a, const double *b, size_t count) {
  size_t i = 0;
  while (i < count && (memcmp(&a[i], &b[i], sizeof *a) == 0 || (a[i] != a[i] && b[i] != b[i]))) i++;
  return i == count;
}
