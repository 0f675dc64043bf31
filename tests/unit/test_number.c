// test_number.c -- numbers as text: round trips, shortest digits, the layout of %.17g.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "lsys/keys.h"
#include "lsys/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *print(double x) {
  static char text[LSYS_NUMBER_SIZE];
  *lsys_number_print(text, x) = 0;
  return text;
}

// The fewest digits with which printf's %.*e reads back to x. Only of a power of two, whose neighbours are not
// equally far, can there be fewer.
static int fewest_digits(double x) {
  char text[64];
  for (int digits = 1; digits < 17; digits++) {
    snprintf(text, sizeof text, "%.*e", digits - 1, x);
    if (strtod(text, NULL) == x) return digits;
  }
  return 17;
}

// The significant digits of a printed number, without leading and trailing zeros.
static int count_digits(const char *text) {
  int count = 0, zeros = 0;
  for (; *text && *text != 'e'; text++) {
    if (*text < '0' || *text > '9' || (*text == '0' && !count)) continue;
    count++;
    zeros = *text == '0' ? zeros + 1 : 0;
  }
  return count - zeros;
}

static void check(double x) {
  const char *text = print(x);
  double back = strtod(text, NULL);
  if (memcmp(&back, &x, sizeof x)) fail_msg("%a is printed as %s", x, text);
  if (x != 0 && count_digits(text) > fewest_digits(x)) fail_msg("%a has fewer digits than %s", x, text);
}

// Fixed or scientific as %.17g chooses: where 17 digits are the shortest, the text is the same.
static void check_layout(double x) {
  char wanted[64];
  snprintf(wanted, sizeof wanted, "%.17g", x);
  assert_int_equal(strchr(wanted, 'e') != NULL, strchr(print(x), 'e') != NULL);
  if (fewest_digits(x) == 17) assert_string_equal(print(x), wanted);
}

static void known_texts(void **state) {
  (void)state;
  static const struct {
    double x;
    const char *text;
  } known[] = {
    {0, "0"},
    {-0.0, "-0"},
    {1, "1"},
    {-2.5, "-2.5"},
    {0.1, "0.1"},
    {1.0 / 3, "0.3333333333333333"},
    {100, "100"},
    {1e15, "1000000000000000"},
    {1e16, "10000000000000000"},
    {1e17, "1e+17"},
    {1e22, "1e+22"},
    {1e23, "1e+23"},
    {1.5e300, "1.5e+300"},
    {123456789012345680, "1.2345678901234568e+17"},
    {0.0001, "0.0001"},
    {0.00001, "1e-05"},
    {1.25e-7, "1.25e-07"},
    {5e-324, "5e-324"},
    {2.2250738585072014e-308, "2.2250738585072014e-308"},
    {1.7976931348623157e308, "1.7976931348623157e+308"},
    {0x1p-24, "5.960464477539063e-08"},
    {9007199254740993.0, "9007199254740992"},
    {INFINITY, "inf"},
    {-INFINITY, "-inf"},
    {NAN, "nan"},
    {-NAN, "nan"},
  };
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) assert_string_equal(print(known[i].x), known[i].text);
}

static void powers_of_two_and_neighbours(void **state) {
  (void)state;
  for (int e = -1074; e < 1024; e++) {
    double x = ldexp(1, e);
    check(x);
    check(-nextafter(x, INFINITY));
    check(nextafter(x, 0));
  }
}

static void powers_of_ten_and_neighbours(void **state) {
  (void)state;
  for (int e = -323; e < 309; e++) {
    char text[16];
    snprintf(text, sizeof text, "1e%d", e);
    double x = strtod(text, NULL);
    check(x);
    check(nextafter(x, INFINITY));
    check(nextafter(x, 0));
    check_layout(x);
    check_layout(nextafter(x, INFINITY));
  }
}

static void random_bits(void **state) {
  (void)state;
  for (uint64_t i = 0; i < 8000; i++) {
    uint64_t bits = lsys_mix64(i);
    double x;
    memcpy(&x, &bits, sizeof x);
    if (isfinite(x)) check(x);
    double uniform = lsys_draw(bits, 0) * 1000;
    check(uniform);
    check_layout(uniform);
    check((double)(bits % 1000000) / 1000);           // short decimals
    check((double)(int64_t)(bits >> (i % 53 + 10)));  // whole numbers
    bits = bits >> 12;                                // subnormal
    memcpy(&x, &bits, sizeof x);
    check(x);
  }
}

static void whole_numbers(void **state) {
  (void)state;
  char text[24];
  static const uint64_t numbers[] = {0, 9, 10, 99, 100, 12345678, UINT64_MAX};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
    char wanted[24];
    snprintf(wanted, sizeof wanted, "%llu", (unsigned long long)numbers[i]);
    *lsys_whole_print(text, numbers[i]) = 0;
    assert_string_equal(text, wanted);
  }
}

static void check_rounded(double x) {
  char text[64], wanted[64];
  for (int digits = 1; digits <= 9; digits++) {
    *lsys_number_round(text, x, digits) = 0;
    snprintf(wanted, sizeof wanted, "%.*g", digits, x);
    assert_string_equal(text, wanted);
  }
}

// As printf rounds: numbers of all sizes, ties, and what is next to a power of ten.
static void few_digits(void **state) {
  (void)state;
  check_rounded(0);
  check_rounded(-0.0);
  for (int e = -12; e < 12; e++) {
    char text[16];
    snprintf(text, sizeof text, "1e%d", e);
    double x = strtod(text, NULL);
    const double near[] = {x, nextafter(x, 0), nextafter(x, INFINITY), x * (1 - 1e-8), 0.99995 * x, -x};
    for (size_t i = 0; i < sizeof near / sizeof *near; i++) {
      check_rounded(near[i]);
      check_rounded((float)near[i]);
    }
  }
  for (uint64_t i = 0; i < 20000; i++) {
    uint64_t bits = lsys_mix64(i);
    double uniform = lsys_draw(bits, 0);
    check_rounded((float)(uniform * 1000 - 500));
    check_rounded(uniform * (double)(bits % 100000000));
    check_rounded(uniform / 1000);
    check_rounded((double)(bits % 100000) / 64);  // ties
  }
}

static void test_same(void **state) {
  (void)state;
  const double a[] = {1, NAN, -0.0}, b[] = {1, -NAN, -0.0}, c[] = {1, NAN, 0.0};
  assert_true(lsys_numbers_same(a, b, 3));
  assert_false(lsys_numbers_same(a, c, 3));
  assert_true(lsys_numbers_same(a, c, 2));
  assert_true(lsys_numbers_same(NULL, NULL, 0));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_same),
    cmocka_unit_test(known_texts),
    cmocka_unit_test(powers_of_two_and_neighbours),
    cmocka_unit_test(powers_of_ten_and_neighbours),
    cmocka_unit_test(random_bits),
    cmocka_unit_test(few_digits),
    cmocka_unit_test(whole_numbers),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
