// The growth matrix, counts at step n and the class of growth, against
// numbers from the literature.
#include "analysis/growth.h"

#include "grammar.h"

// The number of modules of one symbol (NULL: of all) at a step of the first start word, in decimal.
static char *count(const Grammar *g, const char *symbol, uint64_t step, char *digits) {
  mpz_t *counts = calloc(g->program->kind_count, sizeof *counts), sum;
  mpz_init(sum);
  for (size_t k = 0; k < g->program->kind_count; k++) mpz_init(counts[k]);
  assert_true(g->facts->counts_by_kind);
  growth_counts(g->program, g->facts, &g->program->axioms[0], step, counts);
  for (size_t k = 0; k < g->program->kind_count; k++) {
    if (!symbol || strcmp(g->program->kinds[k].symbol, symbol) == 0) mpz_add(sum, sum, counts[k]);
    mpz_clear(counts[k]);
  }
  mpz_get_str(digits, 10, sum);
  mpz_clear(sum);
  free(counts);
  return digits;
}

static void test_fibonacci(void **state) {
  (void)state;
  char digits[1000];
  Grammar g = grammar_read("axiom: b\na -> ab\nb -> a\n");
  assert_string_equal(count(&g, NULL, 0, digits), "1");
  assert_string_equal(count(&g, NULL, 5, digits), "8");
  assert_string_equal(count(&g, NULL, 59, digits), "1548008755920");
  assert_string_equal(count(&g, "a", 299, digits),
                      "137347080577163115432025771710279131845700275212767467264610201");  // F(299) of OEIS A000045
  GrowthRate rate = growth_rate(g.program, g.facts);
  assert_int_equal(rate.kind, GROWTH_EXPONENTIAL);
  assert_int_equal(rate.degree, 0);
  assert_true(fabs(rate.rate - (1 + sqrt(5)) / 2) < 1e-11);
  grammar_free(&g);
}

// Far steps by squaring equal what stepping gives: 2^n has one bit and n zeros.
static void test_squaring(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> AA\n");
  char *digits = malloc(40000);
  mpz_t expected, found;
  mpz_inits(expected, found, NULL);
  mpz_ui_pow_ui(expected, 2, 100000);
  mpz_set_str(found, count(&g, NULL, 100000, digits), 10);
  assert_int_equal(mpz_cmp(expected, found), 0);
  mpz_clears(expected, found, NULL);
  free(digits);
  grammar_free(&g);
}

// A kind that becomes nothing still counts in the step in which it stands.
static void test_vanishing(void **state) {
  (void)state;
  char digits[100];
  Grammar g = grammar_read("axiom: AB\nA -> AB\nB -> \xce\xb5\n");
  assert_string_equal(count(&g, NULL, 0, digits), "2");
  assert_string_equal(count(&g, NULL, 1, digits), "2");
  assert_string_equal(count(&g, "B", UINT64_C(1000000000000000), digits), "1");
  assert_int_equal(growth_rate(g.program, g.facts).kind, GROWTH_POLYNOMIAL);
  assert_int_equal(growth_rate(g.program, g.facts).degree, 0);
  grammar_free(&g);
}

static void test_polynomial(void **state) {
  (void)state;
  char digits[100];
  Grammar g = grammar_read("axiom: a\na -> abcc\nb -> bcc\nc -> c\n");  // (n+1)^2
  assert_string_equal(count(&g, NULL, 8, digits), "81");
  assert_string_equal(count(&g, NULL, 1000000000, digits), "1000000002000000001");
  GrowthRate rate = growth_rate(g.program, g.facts);
  assert_int_equal(rate.kind, GROWTH_POLYNOMIAL);
  assert_int_equal(rate.degree, 2);
  grammar_free(&g);
}

static void test_dies(void **state) {
  (void)state;
  char digits[100];
  Grammar g = grammar_read("axiom: A\nA -> BB\nB -> \xce\xb5\n");
  assert_string_equal(count(&g, NULL, 1, digits), "2");
  assert_string_equal(count(&g, NULL, 2, digits), "0");
  assert_int_equal(growth_rate(g.program, g.facts).kind, GROWTH_DIES);
  grammar_free(&g);
}

// X adds a doubling F each step: n 2^(n-1).
static void test_exponential_times_polynomial(void **state) {
  (void)state;
  char digits[100];
  Grammar g = grammar_read("axiom: X\nX -> XXF\nF -> FF\n");
  assert_string_equal(count(&g, "F", 10, digits), "5120");
  GrowthRate rate = growth_rate(g.program, g.facts);
  assert_int_equal(rate.kind, GROWTH_EXPONENTIAL);
  assert_int_equal(rate.degree, 1);
  assert_true(fabs(rate.rate - 2) < 1e-11);
  grammar_free(&g);
}

// A cyclic component: period 3, rate the cube root of 2.
static void test_periodic(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> B\nB -> C\nC -> AA\n");
  assert_true(fabs(growth_rate(g.program, g.facts).rate - cbrt(2)) < 1e-11);
  grammar_free(&g);
}

// Guards and draws do not matter where every outcome has the same counts.
static void test_same_counts(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A(0)\nA(x) : x > 3 -> A(0)B\nA(x) : ran(1) < x -> BA(x)\nA(x) -> A(x+1)B\n");
  assert_true(g.facts->counts_by_kind);
  grammar_free(&g);
  g = grammar_read("axiom: F\nF -> F[+F] : 1\nF -> [+F]F : 2\n");
  assert_true(g.facts->counts_by_kind);
  grammar_free(&g);
  g = grammar_read("axiom: A(0)\nA(x) : x > 3 -> A(0)A(0)\n");
  assert_false(g.facts->counts_by_kind);
  grammar_free(&g);
  g = grammar_read("axiom: F\nF -> FF : 1\nF -> FFF : 1\n");
  assert_false(g.facts->counts_by_kind);
  grammar_free(&g);
}

static void test_decomposition(void **state) {
  (void)state;
  char digits[100];
  Grammar g = grammar_read("axiom: A\nA -> BB\ndecomposition\nmaximum depth: 5\nB -> CD\nD -> E\n");
  assert_string_equal(count(&g, "E", 1, digits), "2");
  assert_string_equal(count(&g, "D", 1, digits), "0");
  assert_string_equal(count(&g, "C", 1, digits), "2");
  grammar_free(&g);
}

// Counts of more than 2^32 in one step are not in the matrix.
static void test_too_big(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> B\ndecomposition\nmaximum depth: 40\nB -> BB\n");
  assert_false(g.facts->counts_by_kind);
  grammar_free(&g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_fibonacci),     cmocka_unit_test(test_squaring),
    cmocka_unit_test(test_vanishing),     cmocka_unit_test(test_polynomial),
    cmocka_unit_test(test_dies),          cmocka_unit_test(test_exponential_times_polynomial),
    cmocka_unit_test(test_periodic),      cmocka_unit_test(test_same_counts),
    cmocka_unit_test(test_decomposition), cmocka_unit_test(test_too_big),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
