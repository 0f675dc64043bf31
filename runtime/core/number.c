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

char *lsys_whole_print(char *to, uint64_t n) {
  char digits[20], *at = digits + sizeof digits;
  do *--at = (char)('0' + n % 10);
  while (n /= 10);
  size_t length = (size_t)(digits + sizeof digits - at);
  memcpy(to, at, length);
  return to + length;
}

static char *zeros(char *to, int count) {
  memset(to, '0', (size_t)count);
  return to + count;
}

// As %.17g: fixed notation for exponents -4..16, else scientific with at least two digits of exponent.
static char *layout(char *to, Decimal d) {
  while (d.digits % 10 == 0) d.digits /= 10, d.exponent++;
  char digits[20];
  int count = (int)(lsys_whole_print(digits, d.digits) - digits);
  int exponent = d.exponent + count - 1;  // of the first digit
  if (exponent < -4 || exponent >= 17) {
    *to++ = digits[0];
    if (count > 1) *to++ = '.';
    memcpy(to, digits + 1, (size_t)count - 1);
    to += count - 1;
    *to++ = 'e';
    *to++ = exponent < 0 ? '-' : '+';
    unsigned magnitude = exponent < 0 ? -(unsigned)exponent : (unsigned)exponent;
    if (magnitude < 10) *to++ = '0';
    return lsys_whole_print(to, magnitude);
  }
  if (exponent < 0) {  // 0.00ddd
    *to++ = '0';
    *to++ = '.';
    to = zeros(to, -exponent - 1);
    memcpy(to, digits, (size_t)count);
    return to + count;
  }
  int whole = exponent + 1;
  if (count <= whole) {  // ddd00
    memcpy(to, digits, (size_t)count);
    return zeros(to + count, whole - count);
  }
  memcpy(to, digits, (size_t)whole);
  to[whole] = '.';
  memcpy(to + whole + 1, digits + whole, (size_t)(count - whole));
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

// x * 10^k to the nearest whole number, to the even one of two; k from 0 to 13, x at least 2^-14 and less than 2^30.
static uint64_t scale(double x, int k) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  uint64_t c = (bits & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
  int shift = 1075 - (int)(bits >> 52);
  unsigned __int128 product = (unsigned __int128)c * tens[k], half = (unsigned __int128)1 << (shift - 1);
  uint64_t whole = (uint64_t)(product >> shift);
  unsigned __int128 rest = product - ((unsigned __int128)whole << shift);
  return whole + (rest > half || (rest == half && (whole & 1)));
}

// 10^(exponent + 1) of the exponents from -4.
static const double next_power[] = {1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

char *lsys_number_round(char *to, double x, int digits) {
  if (x == 0) return lsys_number_print(to, x);
  double magnitude = x < 0 ? -x : x;
  if (!(magnitude >= 1e-4 && magnitude < (double)tens[digits - 1])) return to + sprintf(to, "%.*g", digits, x);
  int exponent = -4;  // of the first digit
  while (magnitude >= next_power[exponent + 4]) exponent++;
  uint64_t rounded = scale(magnitude, digits - 1 - exponent);
  if (rounded >= tens[digits]) rounded = scale(magnitude, digits - 1 - ++exponent);
  if (rounded < tens[digits - 1]) rounded = scale(magnitude, digits - 1 - --exponent);
  if (x < 0) *to++ = '-';
  return layout(to, (Decimal){rounded, exponent - digits + 1});
}
