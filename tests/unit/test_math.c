// test_math.c -- the functions of expressions: exact angles, powers, nan.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "lsys/functions.h"

#include <math.h>

static void exact_angles(void **state) {
  (void)state;
  for (int turn = -1000000; turn <= 1000000; turn += 40000) {
    double full = 360.0 * turn;
    assert_true(lsys_sin(full) == 0 && lsys_sin(full + 90) == 1 && lsys_sin(full + 180) == 0);
    assert_true(lsys_sin(full + 270) == -1 && lsys_sin(full + 30) == 0.5 && lsys_sin(full + 150) == 0.5);
    assert_true(lsys_sin(full + 210) == -0.5 && lsys_sin(full + 330) == -0.5 && lsys_sin(full - 30) == -0.5);
    assert_true(lsys_cos(full) == 1 && lsys_cos(full + 90) == 0 && lsys_cos(full + 180) == -1);
    assert_true(lsys_cos(full + 270) == 0 && lsys_cos(full + 60) == 0.5 && lsys_cos(full + 120) == -0.5);
    assert_true(lsys_cos(full + 240) == -0.5 && lsys_cos(full + 300) == 0.5 && lsys_cos(full - 60) == 0.5);
    assert_true(lsys_tan(full) == 0 && lsys_tan(full + 180) == 0);
    assert_true(lsys_tan(full + 90) == INFINITY && lsys_tan(full + 270) == -INFINITY);
  }
}

// Zeros are positive: a word shows 0, not -0.
static void zeros_have_no_sign(void **state) {
  (void)state;
  for (int angle = -720; angle <= 720; angle += 90) {
    double x = angle;
    if (lsys_sin(x) == 0) assert_false(signbit(lsys_sin(x)));
    if (lsys_cos(x) == 0) assert_false(signbit(lsys_cos(x)));
    if (lsys_tan(x) == 0) assert_false(signbit(lsys_tan(x)));
  }
}

static void other_angles_are_libms(void **state) {
  (void)state;
  for (double x = -359.5; x < 360; x += 7.25) {
    if (fmod(x, 30) == 0) continue;
    assert_true(lsys_sin(x) == sin(x * M_PI / 180) && lsys_cos(x) == cos(x * M_PI / 180));
    assert_true(lsys_tan(x) == tan(x * M_PI / 180));
    assert_true(lsys_sin(x) == -lsys_sin(-x) && lsys_cos(x) == lsys_cos(-x));
    assert_true(lsys_sin(x + 360 * 1024) == lsys_sin(fmod(x + 360 * 1024, 360)));
  }
}

static void inverses(void **state) {
  (void)state;
  assert_true(lsys_asin(0.5) == 30 && lsys_asin(-0.5) == -30 && lsys_asin(1) == 90 && lsys_asin(0) == 0);
  assert_true(lsys_acos(0.5) == 60 && lsys_acos(-0.5) == 120 && lsys_acos(-1) == 180 && lsys_acos(0) == 90);
  assert_true(lsys_atan(1) == 45 && lsys_atan2(1, -1) == 135 && lsys_atan2(-1, 0) == -90);
}

static void powers(void **state) {
  (void)state;
  double x = 1.1;
  assert_true(lsys_pow(x, 1) == x && lsys_pow(x, 2) == x * x && lsys_pow(x, 3) == x * x * x);
  assert_true(lsys_pow(x, 0.5) == sqrt(x) && lsys_pow(x, 1.7) == pow(x, 1.7) && isnan(lsys_pow(-1, 0.5)));
}

static void nan_and_infinity(void **state) {
  (void)state;
  assert_true(isnan(lsys_sin(INFINITY)) && isnan(lsys_cos(NAN)) && isnan(lsys_tan(INFINITY)) && isnan(lsys_sign(NAN)));
  assert_true(isnan(lsys_min(NAN, 1)) && isnan(lsys_min(1, NAN)) && isnan(lsys_max(NAN, 1)) && isnan(lsys_max(1, NAN)));
  assert_true(isnan(lsys_mod(1, 0)) && lsys_mod(-7, 3) == -1 && lsys_mod(7, -3) == 1);
}

static void rounding(void **state) {
  (void)state;
  assert_true(lsys_round(2.5) == 3 && lsys_round(-2.5) == -3 && lsys_trunc(-2.7) == -2 && lsys_floor(-2.1) == -3);
  assert_true(lsys_ceil(2.1) == 3 && lsys_sign(-3) == -1 && lsys_sign(0) == 0 && lsys_min(2, 1) == 1);
  assert_true(lsys_max(2, 1) == 2 && lsys_fabs(-1) == 1 && lsys_abs(-1) == 1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(exact_angles),
    cmocka_unit_test(zeros_have_no_sign),
    cmocka_unit_test(other_angles_are_libms),
    cmocka_unit_test(inverses),
    cmocka_unit_test(powers),
    cmocka_unit_test(nan_and_infinity),
    cmocka_unit_test(rounding),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
