// Facts of small grammars: which kinds can occur, draw, change; which grammars are context-free.
#include "grammar.h"

static const KindFacts *kind(const Grammar *grammar, const char *symbol) {
  return &grammar->facts->kinds[grammar_kind(grammar, symbol)];
}

static void test_reachable(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> B[C]\nD -> E\nB : 0 -> G\n");
  assert_true(kind(&g, "A")->reachable);
  assert_true(kind(&g, "C")->reachable);
  assert_false(kind(&g, "D")->reachable);
  assert_false(kind(&g, "E")->reachable);
  assert_false(kind(&g, "G")->reachable);  // its guard never holds
  assert_true(g.facts->bracketed);
  assert_false(g.facts->parametric);
  grammar_free(&g);
}

static void test_keys(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A D\nA -> B\nB -> C : 1\nB -> A : 1\nC -> C\nD(x) -> D(ran(x))\n");
  assert_true(kind(&g, "A")->key);  // becomes B, which draws
  assert_true(kind(&g, "B")->key);
  assert_false(kind(&g, "C")->key);
  assert_false(g.facts->kinds[grammar_kind(&g, "D")].key);  // D, not D(x)
  assert_true(g.facts->stochastic);
  assert_false(g.facts->deterministic);
  grammar_free(&g);
}

static void test_keys_of_homomorphism(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> BC\nhomomorphism\nB -> E\nE -> F(ran(1))\n");
  assert_true(kind(&g, "A")->key);
  assert_true(kind(&g, "B")->key);
  assert_false(kind(&g, "C")->key);
  assert_true(g.description->flags & LSYS_GRAMMAR_HOMOMORPHISM);
  assert_true(g.description->flags & LSYS_GRAMMAR_RANDOM);
  assert_false(g.description->flags & LSYS_GRAMMAR_WHOLE);
  grammar_free(&g);
}

static void test_keys_through_functions(void **state) {
  (void)state;
  Grammar g = grammar_read("#define two(x) one(x)+one(x)\n#define one(x) x*ran(1)\naxiom: A\nA -> F(two(3))\n");
  assert_true(kind(&g, "A")->key);
  assert_false(kind(&g, "F")->key);
  grammar_free(&g);
}

static void test_terminal_and_fixed(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> F[+A]B\nB -> G(1)\nG(x) : x > 3 -> H\nC(x) -> C(x)\n");
  assert_true(kind(&g, "A")->fixed);
  assert_true(kind(&g, "B")->fixed);
  assert_false(kind(&g, "G")->fixed);  // has an argument
  assert_true(kind(&g, "F")->terminal);
  assert_false(kind(&g, "G")->terminal);
  grammar_free(&g);
}

static void test_not_fixed(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> BC\nB < C -> D\nE -> F\n");
  assert_false(kind(&g, "A")->fixed);  // C has a context
  assert_false(kind(&g, "C")->fixed);
  assert_true(kind(&g, "E")->fixed);
  assert_false(g.facts->context_free);
  grammar_free(&g);
}

static void test_context_free(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A(1)\nA(x) : x < 5 -> A(x+1) : 0.5\nA(x) -> B : 0.5\ndecomposition\nB -> CD\n");
  assert_true(g.facts->context_free);
  assert_true(g.facts->parametric);
  assert_true(g.description->flags & LSYS_GRAMMAR_EXPAND);
  assert_int_equal(g.facts->longest_successor, 2);
  assert_int_equal(g.facts->most_arguments, 1);
  grammar_free(&g);
}

static void test_cut_is_not_context_free(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A\nA -> B%C\n");
  assert_false(g.facts->context_free);
  assert_false(kind(&g, "%")->terminal);
  grammar_free(&g);
}

static void test_balanced(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: A[B]\nA -> [A][[B]]\nC -> ]\n");
  assert_true(g.facts->balanced);  // C is never reached
  grammar_free(&g);
  g = grammar_read("axiom: A\nA -> ]A[\n");
  assert_false(g.facts->balanced);
  grammar_free(&g);
  g = grammar_read("axiom: A\nA -> [A\n");
  assert_false(g.facts->balanced);
  grammar_free(&g);
}

static void test_describe(void **state) {
  (void)state;
  Grammar g = grammar_read("param r = 2*3 in 1..9\n#define c 1/4\naxiom: A(c, r)B, A(1, 7)\nA(x,y) -> BBB\nseed: 5\n");
  const LsysGrammar *d = g.description;
  assert_int_equal(d->abi_version, LSYS_ABI_VERSION);
  assert_int_equal(d->kind_count, 2);
  assert_string_equal(d->kinds[0].symbol, "A");
  assert_int_equal(d->kinds[0].arity, 2);
  assert_int_equal(d->param_count, 1);
  assert_string_equal(d->params[0].name, "r");
  assert_true(d->params[0].low == 1 && d->params[0].high == 9);
  assert_int_equal(d->axiom_count, 2);
  assert_int_equal(d->axioms[0].word.nsym, 2);
  assert_int_equal(d->axioms[0].word.narg, 2);
  assert_true(d->axioms[0].word.arg[0] == 0.25);
  assert_true(d->axioms[0].word.arg[1] == 0);  // known only when the program runs
  assert_true(d->axioms[1].word.arg[1] == 7);
  assert_int_equal(d->seed, 5);
  grammar_free(&g);
}

static double work(Grammar *grammar, uint64_t steps) {
  return work_bound(grammar->arena, grammar->program, grammar->facts, steps, 1e6);
}

// All words of a derivation together, whatever guards and chances do.
static void test_work(void **state) {
  (void)state;
  Grammar g = grammar_read("axiom: AA\nA -> AB : 1\nA -> A : 3\n");
  assert_true(work(&g, 0) == 2);
  assert_true(work(&g, 3) == 2 + 4 + 6 + 8);
  assert_true(work(&g, 100000) > 1e6);
  grammar_free(&g);
  g = grammar_read("axiom: A\nA -> AA\ndecomposition\nA -> AB\nhomomorphism\nB -> FF\n");
  assert_true(work(&g, 1) == 1 + 2 * 3);
  assert_true(work(&g, 50) > 1e6);
  grammar_free(&g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_work),
    cmocka_unit_test(test_reachable),
    cmocka_unit_test(test_keys),
    cmocka_unit_test(test_keys_of_homomorphism),
    cmocka_unit_test(test_keys_through_functions),
    cmocka_unit_test(test_terminal_and_fixed),
    cmocka_unit_test(test_not_fixed),
    cmocka_unit_test(test_context_free),
    cmocka_unit_test(test_cut_is_not_context_free),
    cmocka_unit_test(test_balanced),
    cmocka_unit_test(test_describe),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
