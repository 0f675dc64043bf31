// test_keys.c -- LANGUAGE.md 5.8: known answers, and tests of uniformity and
// independence between a module's draws, its siblings, parents and children.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "lsys/keys.h"

#include <math.h>
#include <string.h>

enum { DRAWS = 1000000, SIDE = 16, CELLS = SIDE * SIDE };

static void known_answers(void **state) {
  (void)state;
  uint64_t root = lsys_root(1), first = lsys_split(root, 0);
  assert_true(root == UINT64_C(0x5692161d100b05e5));
  assert_true(first == UINT64_C(0xbfef8030ddc2d772));
  assert_true(lsys_draw(first, 0) == 0.39216153984815694);
  assert_true(lsys_draw(first, 1) == 0.36285219856185624);
  assert_true(lsys_split(first, 0) == UINT64_C(0x55c55969ed403149));
}

// Counts pairs of uniform numbers in the cells of a square; chi-square with 255 degrees of freedom has mean 255 and
// deviation 22.6: 5 deviations are never passed by chance.
typedef struct Square {
  uint64_t cell[CELLS];
} Square;

static void add(Square *square, double u, double v) {
  assert_true(u >= 0 && u < 1 && v >= 0 && v < 1);
  square->cell[(int)(u * SIDE) * SIDE + (int)(v * SIDE)]++;
}

static void check(const Square *square) {
  double expected = (double)DRAWS / CELLS, chi = 0;
  for (int i = 0; i < CELLS; i++) {
    double difference = (double)square->cell[i] - expected;
    chi += difference * difference / expected;
  }
  assert_true(chi > 255 - 5 * 22.6 && chi < 255 + 5 * 22.6);
}

static void siblings(void **state) {
  (void)state;
  Square square = {0};
  uint64_t parent = lsys_root(1);
  for (uint64_t i = 0; i < DRAWS; i++)
    add(&square, lsys_draw(lsys_split(parent, i), 0), lsys_draw(lsys_split(parent, i + 1), 0));
  check(&square);
}

static void parents_and_children(void **state) {
  (void)state;
  for (uint64_t child = 0; child < 3; child++) {
    Square square = {0};
    uint64_t key = lsys_root(2);
    for (uint64_t i = 0; i < DRAWS; i++) {
      uint64_t next = lsys_split(key, child);
      add(&square, lsys_draw(key, 0), lsys_draw(next, 0));
      key = next;
    }
    check(&square);
  }
}

static void draws_of_one_module(void **state) {
  (void)state;
  Square sites = {0}, parts = {0};
  for (uint64_t i = 0; i < DRAWS; i++) {
    uint64_t key = lsys_split(lsys_root(3), i);
    add(&sites, lsys_draw(key, 0), lsys_draw(key, 1));
    add(&parts, lsys_draw(key, 1), lsys_draw(key, 1 + (UINT64_C(1) << LSYS_PART_BITS)));
  }
  check(&sites);
  check(&parts);
}

static void seeds(void **state) {
  (void)state;
  Square square = {0};
  for (uint64_t seed = 0; seed < DRAWS; seed++)
    add(&square, lsys_draw(lsys_root(seed), 0), lsys_draw(lsys_root(seed + 1), 0));
  check(&square);
}

// ---- distributions -------------------------------------------------------------

typedef struct Moments {
  double sum, squares;
} Moments;

static void expect_moments(const Moments *moments, double n, double mean, double deviation) {
  double m = moments->sum / n, s = sqrt(moments->squares / n - m * m);
  assert_true(fabs(m - mean) < 6 * deviation / sqrt(n) + 1e-12);
  assert_true(fabs(s - deviation) < 0.02 * deviation + 1e-12);
}

static Moments sample(double (*draw)(uint64_t, uint64_t, double, double), double a, double b, int n) {
  Moments moments = {0};
  for (int i = 0; i < n; i++) {
    double x = draw(lsys_split(lsys_root(4), (uint64_t)i), 1, a, b);
    moments.sum += x;
    moments.squares += x * x;
  }
  return moments;
}

static void normal(void **state) {
  (void)state;
  enum { N = 200000 };
  Moments moments = sample(lsys_nran, 3, 2, N);
  expect_moments(&moments, N, 3, 2);
}

static void beta(void **state) {
  (void)state;
  enum { N = 50000 };
  static const double shapes[][2] = {{2, 3}, {0.5, 0.5}, {1, 1}, {0.3, 4}, {30, 1.5}, {1e-3, 1e-3}};
  for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
    double a = shapes[i][0], b = shapes[i][1], sum = a + b;
    Moments moments = sample(lsys_bran, a, b, N);
    expect_moments(&moments, N, a / sum, sqrt(a * b / (sum * sum * (sum + 1))));
  }
  assert_true(isnan(lsys_bran(1, 1, 0, 1)));
  assert_true(isnan(lsys_bran(1, 1, NAN, 1)));
}

// Both algorithms, both sides of 1/2, and where a step of 1 is far below the deviation.
static void binomial(void **state) {
  (void)state;
  enum { N = 50000 };
  static const double cases[][2] = {{10, 0.3},     {10, 0.8},  {100, 0.5}, {1000, 0.01},
                                    {1000, 0.995}, {1e6, 0.3}, {1e9, 1e-9}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    double n = cases[i][0], p = cases[i][1];
    Moments moments = sample(lsys_biran, n, p, N);
    expect_moments(&moments, N, n * p, sqrt(n * p * (1 - p)));
  }
  assert_true(lsys_biran(1, 1, 5, 0) == 0 && lsys_biran(1, 1, 5, 1) == 5 && lsys_biran(1, 1, 0, 0.5) == 0);
  assert_true(isnan(lsys_biran(1, 1, -1, 0.5)) && isnan(lsys_biran(1, 1, 5, 2)));
}

// The exact probabilities of a small binomial, by chi-square with 10 degrees of freedom.
static void binomial_frequencies(void **state) {
  (void)state;
  enum { N = 200000, TRIALS = 10 };
  double seen[TRIALS + 1] = {0}, chi = 0, probability = pow(0.6, TRIALS);
  for (int i = 0; i < N; i++) seen[(int)lsys_biran(lsys_split(lsys_root(5), (uint64_t)i), 1, TRIALS, 0.4)]++;
  for (int k = 0; k <= TRIALS; k++) {
    double expected = N * probability;
    chi += (seen[k] - expected) * (seen[k] - expected) / expected;
    probability *= (TRIALS - k) / (k + 1.0) * 0.4 / 0.6;
  }
  assert_true(chi < 35);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(known_answers),
    cmocka_unit_test(siblings),
    cmocka_unit_test(parents_and_children),
    cmocka_unit_test(draws_of_one_module),
    cmocka_unit_test(seeds),
    cmocka_unit_test(normal),
    cmocka_unit_test(beta),
    cmocka_unit_test(binomial),
    cmocka_unit_test(binomial_frequencies),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
