// test_embed.c -- lsys_derive: the word in the hands of one's own program.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "grammars.h"
#include "lsys/lsys.h"

#include <stdlib.h>
#include <string.h>

typedef struct Seen {
  char text[64];
  uint64_t modules;
  bool stops;
} Seen;

static bool receive(void *data, uint32_t axiom, const LsysWord *part) {
  Seen *seen = data;
  assert_int_equal(axiom, 0);
  for (uint64_t i = 0; i < part->nsym; i++)
    if (seen->modules + i + 1 < sizeof seen->text) seen->text[seen->modules + i] = "AB"[part->sym[i]];
  seen->modules += part->nsym;
  return !seen->stops;
}

static void word_in_parts(void **state) {
  (void)state;
  Seen seen = {0};
  assert_true(lsys_derive(&algae, (const char *const[]){"-n", "5", NULL}, receive, &seen));
  assert_string_equal(seen.text, "ABAABABAABAAB");
  seen = (Seen){0};
  assert_true(lsys_derive(&algae, (const char *const[]){"-n30", "--threads=2", NULL}, receive, &seen));
  assert_int_equal(seen.modules, 2178309);
}

static void stopping(void **state) {
  (void)state;
  Seen seen = {.stops = true};
  assert_false(lsys_derive(&algae, (const char *const[]){"-n", "30", NULL}, receive, &seen));
  assert_in_range(seen.modules, 1, 1 << 20);
}

static void wrong_options(void **state) {
  (void)state;
  Seen seen = {0};
  assert_false(lsys_derive(&algae, (const char *const[]){"--setps", "5", NULL}, receive, &seen));
  assert_false(lsys_derive(&algae, (const char *const[]){"--help", NULL}, receive, &seen));
  assert_false(lsys_derive(&algae, (const char *const[]){NULL}, receive, &seen));
  LsysGrammar old = algae;
  old.abi_version = 0;
  assert_false(lsys_derive(&old, (const char *const[]){"-n", "5", NULL}, receive, &seen));
  assert_int_equal(seen.modules, 0);
}

// ---- in one piece ------------------------------------------------------------

enum { SYMBOLS = 1 << 26, ARGUMENTS = 1 << 22 };

// What flows by, collected by hand.
static bool collect(void *data, uint32_t axiom, const LsysWord *part) {
  (void)axiom;
  LsysWhole *whole = data;
  assert_true(whole->nsym + part->nsym <= whole->sym_bytes);
  assert_true((whole->narg + part->narg) * sizeof(double) <= whole->arg_bytes);
  memcpy(whole->sym + whole->nsym, part->sym, part->nsym);
  if (part->narg) memcpy(whole->arg + whole->narg, part->arg, part->narg * sizeof(double));
  whole->nsym += part->nsym;
  whole->narg += part->narg;
  return true;
}

static LsysWhole memory(size_t symbols, size_t arguments) {
  LsysWhole whole = {.sym_bytes = symbols, .arg_bytes = arguments * sizeof(double), .given = true};
  whole.sym = malloc(symbols + 1);
  whole.arg = malloc(whole.arg_bytes + 1);
  assert_non_null(whole.sym);
  assert_non_null(whole.arg);
  return whole;
}

static void release(LsysWhole *whole) {
  free(whole->sym);
  free(whole->arg);
}

static void check_same(const LsysWhole *a, const LsysWhole *b) {
  assert_int_equal(a->nsym, b->nsym);
  assert_int_equal(a->narg, b->narg);
  assert_memory_equal(a->sym, b->sym, a->nsym);
  if (a->narg) assert_memory_equal(a->arg, b->arg, a->narg * sizeof(double));
}

// The same word into memory that grows, that was used before, that is just long enough, and that is too short.
static void check_whole(const LsysGrammar *grammar, const char *const *options) {
  LsysWhole wanted = memory(SYMBOLS, ARGUMENTS), own = {0};
  assert_true(lsys_derive(grammar, options, collect, &wanted));
  for (int i = 0; i < 2; i++) {
    assert_true(lsys_derive_word(grammar, options, &own));
    check_same(&own, &wanted);
  }
  LsysWhole exact = memory(wanted.nsym, wanted.narg);
  assert_true(lsys_derive_word(grammar, options, &exact));
  check_same(&exact, &wanted);
  exact.sym_bytes--;
  assert_false(lsys_derive_word(grammar, options, &exact));
  lsys_whole_free(&own);
  assert_null(own.sym);
  release(&exact);
  release(&wanted);
}

static void word_in_one_piece(void **state) {
  (void)state;
  static const char *const threads[] = {"--threads=1", "--threads=2"};
  static const char *const few[] = {"-n0", "-n1", "-n12"};
  for (int i = 0; i < 2; i++) {
    for (size_t k = 0; k < sizeof few / sizeof *few; k++) {
      check_whole(&algae, (const char *const[]){few[k], threads[i], NULL});
      check_whole(&bush, (const char *const[]){few[k], threads[i], "--seed=3", NULL});
    }
    check_whole(&algae, (const char *const[]){"-n35", threads[i], NULL});  // 24 million modules: no cache holds them
    check_whole(&bush, (const char *const[]){"-n30", threads[i], "-Dr=0.9", NULL});
  }
}

static void no_whole_word(void **state) {
  (void)state;
  LsysGrammar two = algae;
  const LsysAxiom axioms[] = {algae.axioms[0], algae.axioms[0]};
  two.axiom_count = 2;
  two.axioms = axioms;
  LsysWhole whole = {0};
  assert_false(lsys_derive_word(&two, (const char *const[]){"-n5", NULL}, &whole));
  assert_true(lsys_derive_word(&two, (const char *const[]){"-n5", "--axiom=2", NULL}, &whole));
  assert_int_equal(whole.nsym, 13);
  assert_false(lsys_derive_word(&two, (const char *const[]){"-n20", "--axiom=2", "--max-memory=8K", NULL}, &whole));
  lsys_whole_free(&whole);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(word_in_parts),     cmocka_unit_test(stopping),      cmocka_unit_test(wrong_options),
    cmocka_unit_test(word_in_one_piece), cmocka_unit_test(no_whole_word),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
