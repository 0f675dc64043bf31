// The interpreter on grammars that fit a line: each rule of LANGUAGE.md section 5.
#include "grammar.h"

static void test_first_that_holds(void **state) {
  (void)state;
  assert_word("axiom: AB\nA -> AC\nA -> B\n", "3", "ACCCB");
  assert_word("axiom: B(2)A(4,4)\nA(x,y) : y <= 3 -> A(x*2,x+y)\nA(x,y) : y > 3 -> B(x)A(x/y,0)\n"
              "B(x) : x < 1 -> C\nB(x) : x >= 1 -> B(x-1)\n",
              "4", "CB(1)A(8,7)");
  assert_word("axiom: A(0)\nA(0) -> A(1)\nA(1) -> A(0)B\nB -> A(0)\n", "4", "A(0)BA(1)");
}

static void test_nan_does_not_hold(void **state) {
  (void)state;
  assert_word("axiom: A(nan)A(0)A(-1)\nA(x) : x -> B\n", "1", "A(nan)A(0)B");
}

static void test_lazy_operators(void **state) {
  (void)state;
  assert_word("axiom: A(2)\nA(x) : x > 1 || ran(1) > 2 -> B(x ? 7 : ran(1), x && 3, !x)\n", "1", "B(7,1,0)");
}

static void test_axioms(void **state) {
  (void)state;
  assert_word("axiom: A, B\naxiom: C\nA -> AA\n", "2", "AAAA\nB\nC");
}

static void test_values(void **state) {
  (void)state;
  assert_word("#define h (p*q)^0.5\n#define q 1-p\nparam p = 0.5 in 0..1\n#define twice(x) 2*x\n"
              "axiom: A(h)\nA(x) -> A(twice(x)+twice(twice(q)))\n",
              "1", "A(3)");
}

static void test_given_param(void **state) {
  (void)state;
  Grammar g = grammar_read("param p = 2 in 0..9\nparam q = p+1\naxiom: A(p,q)\n");
  char *word = grammar_run(&g, (const char *[]){"-D", "p=5", NULL});
  assert_string_equal(word, "A(5,6)");
  free(word);
  word = grammar_run(&g, (const char *[]){"-D", "q=5", NULL});
  assert_string_equal(word, "A(2,5)");
  free(word);
  grammar_free(&g);
}

// ---- contexts ----------------------------------------------------------------

static void test_contexts_in_a_row(void **state) {
  (void)state;
  assert_word("axiom: ZAXYACDEF\nXY<A>CDE -> AAA\n", "1", "ZAXYAAACDEF");
  assert_word("axiom: ABCDEFGHI\nA < B > C -> Y\nA < B > D -> N\nG > HIJ -> N\nG > HI -> Y\nA > C -> N\nA -> Y\n", "1",
              "YYCDEFYHI");
}

static void test_contexts_see_the_old_word(void **state) {
  (void)state;
  assert_word("axiom: baaa\nb < a -> b\nb -> a\n", "2", "aaba");
}

static void test_left_context_through_branches(void **state) {
  (void)state;
  assert_word("axiom: A[X]BC\nA < B > C -> Z\n", "1", "A[X]ZC");
  assert_word("axiom: ABC[DE][SG]\nBC < S -> Z\n", "1", "ABC[DE][ZG]");
  assert_word("axiom: A[[B]C]\nA < C -> Y\nA < B -> X\n", "1", "A[[X]Y]");
}

static void test_right_context_skips_branches(void **state) {
  (void)state;
  assert_word("axiom: A[B]C\nA > C -> X\n", "1", "X[B]C");
  assert_word("axiom: A[B]C\nA > B -> X\n", "1", "A[B]C");
  assert_word("axiom: A[BD]C\nB > D -> X\nD > C -> Y\n", "1", "A[XD]C");  // never leaves the branch
}

static void test_right_context_with_branches(void **state) {
  (void)state;
  assert_word("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> Z\n", "1", "ABC[DE][ZG[HI[JK]L]MNO]");
  assert_word("axiom: A[B][C]D\nA > [B][C]D -> X\n", "1", "X[B][C]D");
  assert_word("axiom: A[B][C]D\nA > [C]D -> X\n", "1", "X[B][C]D");
  assert_word("axiom: A[B][C]D\nA > [C][B] -> X\n", "1", "A[B][C]D");
  assert_word("axiom: A[B[C]D]E\nA > [B[C]D]E -> X\n", "1", "X[B[C]D]E");
  assert_word("axiom: A[B(1)][B(2)]\nA > [B(x)][B(y)] -> A(x,y)\n", "1", "A(1,2)[B(1)][B(2)]");
}

static void test_ends(void **state) {
  (void)state;
  assert_word("axiom: A[AB]A\nA > @] -> X\n", "1", "A[AB]X");
  assert_word("axiom: F[AB]AB\n[ < A -> X\n", "1", "F[XB]AB");
  assert_word("axiom: F[[C]AB]\nF[ < A -> X\n", "1", "F[[C]XB]");
}

static void test_ignore(void **state) {
  (void)state;
  assert_word("ignore: +-\naxiom: A+[-B]-C\nA < B -> X\nA > C -> Y\n", "1", "Y+[-X]-C");
  assert_word("consider: AC\naxiom: ABC\nA > C -> Y\n", "1", "YBC");
  assert_word("ignore: +\naxiom: A(1)+B\nA(x) < + > B -> -\n", "1", "A(1)-B");
}

static void test_unmatched_brackets(void **state) {
  (void)state;
  assert_word("axiom: A]B\nA < B -> X\nA > B -> Y\n", "1", "A]B");
  assert_word("axiom: A[B\nA < B -> X\nA > B -> Y\n", "1", "A[X");
  assert_word("axiom: A[B[C]D]E]F\nB < D -> X\nA > E -> Y\nE < F -> Z\n", "1", "Y[B[C]X]E]F");
}

static void test_ring(void **state) {
  (void)state;
  assert_word("ring lsystem\naxiom: ABC\nC < A -> X\n", "1", "XBC");
  assert_word("ring lsystem\naxiom: ABC\nC > A -> X\n", "1", "ABX");
  assert_word("ring lsystem\naxiom: ABC\nBC < A > BC -> X\n", "1", "XBC");
  assert_word("ring lsystem\naxiom: ABC\nABC < A -> X\nA > BCA -> Y\n", "1", "ABC");
  assert_word("ring lsystem\naxiom: [A][B]C\nCC < A -> X\nC < B -> Y\n", "1", "[A][Y]C");
  assert_word("ring lsystem\naxiom: CA\nA > C@] -> X\n", "1", "CX");
}

static void test_hidden_neighbours_bind_arguments(void **state) {
  (void)state;
  assert_word("axiom: U(1)U(2)U(3)\nU(x) < U(y) > U(z) -> U(x+10*y+100*z)\n", "1", "U(1)U(321)U(3)");
}

// ---- place in the word ---------------------------------------------------------

static void test_cut(void **state) {
  (void)state;
  assert_word("axiom: F[FA]F\nA -> FF%FF\n", "1", "F[FFF%FF]F");
  assert_word("axiom: F[FA]F\nA -> FF%FF\n", "2", "F[FFF]F");
  assert_word("axiom: A[B%C[D]E]F\nB -> X\nC -> Y\n", "1", "A[X]F");
  assert_word("axiom: F%F[FF]F\nF -> G\n", "1", "G");
  assert_word("axiom: AB%C\n% -> Z\nC -> D\n", "1", "ABZD");
}

static void test_pseudo(void **state) {
  (void)state;
  assert_word("axiom: ABAB\nAB -> X\nA -> Y\n", "1", "XX");
  assert_word("axiom: AABA\nAB -> X\nA -> Y\n", "1", "YXY");
  assert_word("axiom: A(1)B(2)A(3)\nA(x)B(y) -> C(x+y)\n", "1", "C(3)A(3)");
}

// ---- decomposition, homomorphism, tables, blocks ---------------------------------

static void test_decomposition(void **state) {
  (void)state;
  assert_word("axiom: A\nA -> BB\ndecomposition\nmaximum depth: 5\nB -> CD\nD -> E\n", "1", "CECE");
  assert_word("axiom: B\ndecomposition\nB -> CB\n", "0", "B");
  assert_word("axiom: B\ndecomposition\nmaximum depth: 2\nB -> CB\n", "1", "CCB");
}

static void test_deep_decomposition(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: B(0)\ndecomposition\nmaximum depth: 60000\nB(x) -> [B(x+1)]\n");
  char *word = grammar_run(&g, (const char *[]){"-n", "1", NULL});
  assert_int_equal(strlen(word), 60000 + strlen("B(60000)") + 60000);
  assert_non_null(strstr(word, "[B(60000)]"));
  free(word);
  grammar_free(&g);
}

static void test_homomorphism(void **state) {
  (void)state;
  const char *text = "axiom: FP(1,5)\nhomomorphism\nmaximum depth: 2\nF -> GP(0,0)\nG > P(x,y) : y > 3 -> f\n";
  Grammar g = grammar_read(text);
  char *word = grammar_run(&g, (const char *[]){"-n", "0", "--homomorphism", NULL});
  assert_string_equal(word, "fP(0,0)P(1,5)");
  free(word);
  word = grammar_run(&g, (const char *[]){"-n", "0", NULL});
  assert_string_equal(word, "FP(1,5)");
  free(word);
  grammar_free(&g);
}

static void test_tables(void **state) {
  (void)state;
  const char *text = "axiom: A\ntables: one two\ntable one:\nA -> AB\ntable two:\nA -> AC\nB -> D\n";
  assert_word(text, "1", "AB");
  assert_word(text, "2", "ACD");
  assert_word(text, "3", "ABCD");
}

static void test_blocks(void **state) {
  (void)state;
  const char *text = "axiom: A(0)\nStart: { n = 10; }\nEndEach: { n = n + 1; }\nA(x) -> A(n)\n";
  assert_word(text, "1", "A(10)");
  assert_word(text, "3", "A(12)");
}

static void test_statement_blocks(void **state) {
  (void)state;
  assert_word("axiom: A(5)\nA(x) : { s = 0; i = 1; while (i <= x) { s = s + i; i = i + 1; } } s > 10 { t = s * 2; } -> "
              "B(s,t)\n",
              "1", "B(15,30)");
}

// ---- randomness ------------------------------------------------------------------

// The known answers of LANGUAGE.md 5.8.
static void test_known_draws(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> B(ran(1)) : 0.392\nA -> C(ran(1)) : 0.608\nseed: 1\n");
  char *word = grammar_run(&g, (const char *[]){"-n", "1", NULL});
  double value =
    strtod(word + 2, NULL);  // the choice is draw 0 (0.3921615...), the second production's call has site 2
  assert_int_equal(word[0], 'C');
  assert_true(value == lsys_draw(lsys_split(lsys_root(1), 0), 2));
  free(word);
  grammar_free(&g);
}

static void test_weights(void **state) {
  (void)state;
  assert_word("axiom: A\nA -> B : 0\nA -> C : nan\nA -> D : -1\n", "1", "A");
  assert_word("axiom: A\nA -> B : 0\nA -> C : 3\n", "1", "C");
  assert_word("axiom: A\nA : 0 -> B\nA -> C : 3\nA -> D\n", "1", "C");  // unweighted ones after it are skipped
}

static void test_repetitions(void **state) {
  (void)state;
  Grammar g = grammar_read("#define r(x) ran(x)\naxiom: A\nA -> B(r(1),r(1))\nseed: 1\n");
  char *word = grammar_run(&g, (const char *[]){"-n", "1", NULL});
  uint64_t key = lsys_split(lsys_root(1), 0);
  double x, y;
  assert_int_equal(sscanf(word, "B(%lf,%lf)", &x, &y), 2);
  assert_true(x == lsys_draw(key, 1));
  assert_true(y == lsys_draw(key, 1 + (UINT64_C(1) << LSYS_SITE_BITS)));
  free(word);
  grammar_free(&g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_first_that_holds),
    cmocka_unit_test(test_nan_does_not_hold),
    cmocka_unit_test(test_lazy_operators),
    cmocka_unit_test(test_axioms),
    cmocka_unit_test(test_values),
    cmocka_unit_test(test_given_param),
    cmocka_unit_test(test_contexts_in_a_row),
    cmocka_unit_test(test_contexts_see_the_old_word),
    cmocka_unit_test(test_left_context_through_branches),
    cmocka_unit_test(test_right_context_skips_branches),
    cmocka_unit_test(test_right_context_with_branches),
    cmocka_unit_test(test_ends),
    cmocka_unit_test(test_ignore),
    cmocka_unit_test(test_unmatched_brackets),
    cmocka_unit_test(test_ring),
    cmocka_unit_test(test_hidden_neighbours_bind_arguments),
    cmocka_unit_test(test_cut),
    cmocka_unit_test(test_pseudo),
    cmocka_unit_test(test_decomposition),
    cmocka_unit_test(test_deep_decomposition),
    cmocka_unit_test(test_homomorphism),
    cmocka_unit_test(test_tables),
    cmocka_unit_test(test_blocks),
    cmocka_unit_test(test_statement_blocks),
    cmocka_unit_test(test_known_draws),
    cmocka_unit_test(test_weights),
    cmocka_unit_test(test_repetitions),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
