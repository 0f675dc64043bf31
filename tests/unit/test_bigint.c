// test_bigint.c -- exact natural numbers, against known Fibonacci numbers and factorials.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/bigint.h"

#include <stdio.h>
#include <string.h>

static LsysMemory memory = {.limit = UINT64_C(1) << 28};

static void expect(LsysBig *a, const char *wanted) {
  size_t size;
  char *digits = lsys_big_decimal(&memory, a, &size);
  assert_non_null(digits);
  assert_string_equal(digits, wanted);
  lsys_memory_free(&memory, digits, size, 1);
  lsys_big_free(&memory, a);
}

static LsysBig of(uint64_t n) {
  uint64_t one = 1;
  LsysBig a = {0};
  assert_true(lsys_big_add_product(&memory, &a, &(LsysBig){&one, 1, 1}, n));
  return a;
}

static void small_numbers(void **state) {
  (void)state;
  static const uint64_t numbers[] = {0,         1, 9, 10, UINT64_C(9999999999999999999), UINT64_C(10000000000000000000),
                                     UINT64_MAX};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
    char wanted[24];
    snprintf(wanted, sizeof wanted, "%llu", (unsigned long long)numbers[i]);
    LsysBig a = of(numbers[i]);
    expect(&a, wanted);
  }
}

static void fibonacci(void **state) {
  (void)state;
  LsysBig a = of(0), b = of(1);
  for (int i = 0; i < 300; i++) {
    assert_true(lsys_big_add_product(&memory, &a, &b, 1));
    LsysBig c = a;
    a = b;
    b = c;
  }
  lsys_big_free(&memory, &b);
  expect(&a, "222232244629420445529739893461909967206666939096499764990979600");
}

// 30! by multiplying, and limbs of ones whose carry runs through.
static void products_and_carries(void **state) {
  (void)state;
  LsysBig a = of(1);
  for (uint64_t i = 2; i <= 30; i++) {
    LsysBig b = {0};
    assert_true(lsys_big_add_product(&memory, &b, &a, i));
    lsys_big_free(&memory, &a);
    a = b;
  }
  expect(&a, "265252859812191058636308480000000");
  uint64_t ones[2] = {UINT64_MAX, UINT64_MAX};
  LsysBig b = of(1);
  assert_true(lsys_big_add_product(&memory, &b, &(LsysBig){ones, 2, 2}, UINT64_MAX));
  expect(&b, "6277101735386680763495507056286727952620534092958556749826");
}

static void nothing_stays_booked(void **state) {
  (void)state;
  assert_true(memory.used == 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(small_numbers),
    cmocka_unit_test(fibonacci),
    cmocka_unit_test(products_and_carries),
    cmocka_unit_test(nothing_stays_booked),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
