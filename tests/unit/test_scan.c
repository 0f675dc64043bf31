// test_scan.c -- neighbours through brackets: two grammars written by hand as
// the code generator would compile them, derived by the step engine.
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/derive.h"
#include "core/memory.h"
#include "core/store.h"
#include "grammars.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { A, B, C, D, E, S, G, H, I, J, K, L, M, N, O, Z, OPEN, CLOSE, KINDS };
static const char letters[] = "ABCDESGHIJKLMNOZ[]";
static const uint8_t classes[KINDS] = {[OPEN] = LSYS_CLASS_OPEN, [CLOSE] = LSYS_CLASS_CLOSE};
static LsysKind kinds[KINDS];

static void no_values(LsysRun *run, const uint8_t *given) {
  (void)given;
  grammar_settings(run);
}

// What every compiled step does with a module after writing what it becomes.
static void step_on(LsysScan *scan, uint8_t kind) {
  if (kind == OPEN)
    lsys_scan_open(scan);
  else if (kind == CLOSE)
    lsys_scan_close(scan);
  else {
    for (uint32_t i = scan->window; i-- > 1;) scan->left[i] = scan->left[i - 1];
    if (scan->window) scan->left[0] = (LsysNeighbour){.kind = kind, .arg = scan->arg};
    scan->fresh = 0;
    scan->passed += scan->depth == 0;
  }
  scan->sym++;
}

// BC < S > G[H]M --> Z   (ABOP p. 32)
static bool page_32(LsysScan *scan) {
  LsysCursor at, inside;
  if (*scan->sym != S || scan->left[0].kind != C || scan->left[1].kind != B) return false;
  if (lsys_right(scan, &at) != G) return false;
  do
    if (!lsys_branch(scan, &at, &inside)) return false;
  while (lsys_ahead(scan, &inside) != H);
  return lsys_ahead(scan, &at) == M;
}

static void step_page_32(LsysScan *scan, LsysStream *out) {
  while (scan->sym < scan->end) {
    if (!grammar_has_room(out, scan->run->grammar)) lsys_flush(out);
    uint8_t kind = *scan->sym;
    if (classes[kind] == LSYS_CLASS_SEEN) scan->ahead_known = 0;
    *out->sym++ = page_32(scan) ? Z : kind;
    step_on(scan, kind);
  }
}

// A > B --> B: a signal that travels against the axis.
static void step_signal(LsysScan *scan, LsysStream *out) {
  LsysCursor at;
  while (scan->sym < scan->end) {
    if (!grammar_has_room(out, scan->run->grammar)) lsys_flush(out);
    uint8_t kind = *scan->sym;
    if (classes[kind] == LSYS_CLASS_SEEN) scan->ahead_known = 0;
    *out->sym++ = kind == A && lsys_right(scan, &at) == B ? B : kind;
    step_on(scan, kind);
  }
}

// A > B --> B and B < A --> B in a ring.
static void step_ring(LsysScan *scan, LsysStream *out) {
  LsysCursor at;
  while (scan->sym < scan->end) {
    if (!grammar_has_room(out, scan->run->grammar)) lsys_flush(out);
    uint8_t kind = *scan->sym;
    scan->ahead_known = 0;
    bool far = scan->left[0].wrap && scan->left[0].wrap <= scan->passed + 1;
    bool left = !far && scan->left[0].kind == B;
    *out->sym++ = kind == A && (left || lsys_right(scan, &at) == B) ? B : kind;
    step_on(scan, kind);
  }
}

static uint8_t *packed(const char *word, size_t length) {
  uint8_t *sym = malloc(length + 1);
  for (size_t i = 0; i < length; i++) sym[i] = (uint8_t)(strchr(letters, word[i]) - letters);
  return sym;
}

// The word after some steps, as letters, to be freed; NULL where the derivation failed. stretch: modules that a thread
// takes at once.
static char *derive_on(unsigned threads, uint64_t stretch, void (*step)(LsysScan *, LsysStream *), uint32_t flags,
                       const char *word, size_t length, uint64_t steps) {
  for (int k = 0; k < KINDS; k++) kinds[k] = (LsysKind){.symbol = "?"};
  uint8_t *sym = packed(word, length);
  LsysAxiom axiom = {.word = {.sym = sym, .nsym = length}};
  LsysGrammar grammar = {.abi_version = LSYS_ABI_VERSION,
                         .flags = flags,
                         .name = "scan",
                         .kind_count = KINDS,
                         .kinds = kinds,
                         .axiom_count = 1,
                         .axioms = &axiom,
                         .value_count = LSYS_SETTING_COUNT,
                         .room_sym = 1,
                         .frame_bytes = 64,
                         .init = no_values,
                         .step = step,
                         .views = &(LsysContextView){classes, flags & LSYS_GRAMMAR_RING},
                         .view_count = 1,
                         .system_count = 1,
                         .system_number = (const double[]){0},
                         .left_window = 2};
  LsysMemory memory = {.limit = UINT64_MAX / 4};
  LsysDerivation derivation;
  LsysOptions options = {0};
  options.at[LSYS_OPTION_STEPS] = (LsysOptionValue){.given = true, .whole = steps};
  options.at[LSYS_OPTION_THREADS] = (LsysOptionValue){.given = true, .whole = threads};
  assert_true(lsys_derivation_open(&derivation, &grammar, &options, &memory));
  derivation.stretch = stretch;
  LsysStore store;
  lsys_store_open(&store, &grammar, &memory);
  char *result = NULL;
  if (lsys_derivation_run(&derivation, 0, &store.sink, 0)) {
    result = calloc(store.nsym + 1, 1);
    for (uint64_t i = 0; i < store.nsym; i++) result[i] = letters[store.sym[i]];
  }
  lsys_store_close(&store);
  lsys_derivation_close(&derivation);
  free(sym);
  assert_int_equal(memory.used, 0);
  return result;
}

// The same on one thread, and on three whose stretches begin and end everywhere.
static char *derive(void (*step)(LsysScan *, LsysStream *), uint32_t flags, const char *word, size_t length,
                    uint64_t steps) {
  char *result = derive_on(1, length, step, flags, word, length, steps);
  assert_non_null(result);
  for (uint64_t stretch = length < 100 ? 1 : length / 7; stretch < length; stretch *= 2) {
    char *other = derive_on(3, stretch, step, flags, word, length, steps);
    assert_string_equal(other, result);
    free(other);
  }
  return result;
}

static void expect(void (*step)(LsysScan *, LsysStream *), uint32_t flags, const char *word, uint64_t steps,
                   const char *wanted) {
  char *result = derive(step, flags | LSYS_GRAMMAR_RIGHT, word, strlen(word), steps);
  assert_string_equal(result, wanted);
  free(result);
}

static void branches_in_contexts(void **state) {
  (void)state;
  expect(step_page_32, 0, "ABC[DE][SG[HI[JK]L]MNO]", 1, "ABC[DE][ZG[HI[JK]L]MNO]");
  expect(step_page_32, 0, "ABC[DE][SG[D][HI[JK]L]MNO]", 1, "ABC[DE][ZG[D][HI[JK]L]MNO]");
  expect(step_page_32, 0, "ABC[DE][SG[D]MNO]", 1, "ABC[DE][SG[D]MNO]");
  expect(step_page_32, 0, "ABC[DE][SG[H]NMO]", 1, "ABC[DE][SG[H]NMO]");
  expect(step_page_32, 0, "AC[DE][SG[H]M]", 1, "AC[DE][SG[H]M]");
  expect(step_page_32, 0, "BC[DE][[[SG[H]M]]]", 1, "BC[DE][[[ZG[H]M]]]");
}

static void unmatched_brackets(void **state) {
  (void)state;
  expect(step_page_32, 0, "BC]SG[H]M", 1, "BC]SG[H]M");
  expect(step_page_32, 0, "BCSG[H", 1, "BCSG[H");
  expect(step_page_32, 0, "BCS]G[H]M", 1, "BCS]G[H]M");
  expect(step_signal, 0, "A[A[B", 1, "A[A[B");
}

static void signals(void **state) {
  (void)state;
  expect(step_signal, 0, "A[A]A[A]A[A]B", 1, "A[A]A[A]B[A]B");
  expect(step_signal, 0, "A[A]A[A]A[A]B", 3, "B[A]B[A]B[A]B");
  expect(step_signal, 0, "A[AB]C", 1, "A[BB]C");
}

static void rings(void **state) {
  (void)state;
  expect(step_ring, LSYS_GRAMMAR_RING, "BAAAA", 1, "BBAAB");
  expect(step_ring, LSYS_GRAMMAR_RING, "AAAAB", 1, "BAABB");
  expect(step_ring, LSYS_GRAMMAR_RING, "A", 1, "A");
  expect(step_ring, LSYS_GRAMMAR_RING, "B", 1, "B");
}

// The cost per module must not depend on what lies between a module and its neighbour: a quadratic
// scan would take minutes here.
static void long_branches(void **state) {
  (void)state;
  enum { MANY = 1000000 };
  size_t length = 3 * MANY + 2 * MANY + 2, at = 0;
  char *word = malloc(length + 1);
  for (int i = 0; i < MANY; i++) memcpy(word + 3 * at++, "[C]", 3);  // sibling branches
  at *= 3;
  memset(word + at, '[', MANY);  // a deep one
  memset(word + at + MANY, ']', MANY);
  at += 2 * (size_t)MANY;
  memcpy(word + at, "AB", 3);
  char *shifted = malloc(length + 2);
  shifted[0] = 'A';
  memcpy(shifted + 1, word, length + 1);
  shifted[length] = 'B';
  shifted[length - 1] = 'D';
  char *result = derive(step_signal, LSYS_GRAMMAR_RIGHT, word, length, 1);
  assert_int_equal(result[length - 2], 'B');
  free(result);
  shifted[length - 1] = 'A';
  result = derive(step_signal, LSYS_GRAMMAR_RIGHT, shifted, length + 1, 2);
  assert_int_equal(result[0], 'B');
  free(result);
  free(shifted);
  free(word);
}

// Fails at D, after a while, and at E.
static void step_failing(LsysScan *scan, LsysStream *out) {
  for (; scan->sym < scan->end; scan->sym++) {
    if (!grammar_has_room(out, scan->run->grammar)) lsys_flush(out);
    if (*scan->sym == D) usleep(20000);
    if (*scan->sym == D || *scan->sym == E) lsys_fail(scan->run, "met %c", letters[*scan->sym]);
    *out->sym++ = *scan->sym;
  }
}

// Of several errors the first one in the word is told, and no other.
static void errors_in_order(void **state) {
  (void)state;
  const char *word = "AAAAAAAADAAAEAAEAAAAAAAAAAEAAAEAAA";
  for (uint64_t steps = 1; steps <= 2; steps++) {
    FILE *said = tmpfile();
    int screen = dup(STDERR_FILENO);
    dup2(fileno(said), STDERR_FILENO);
    char *result = derive_on(3, 2, step_failing, 0, word, strlen(word), steps);
    dup2(screen, STDERR_FILENO);
    close(screen);
    assert_null(result);
    char text[100] = "";
    rewind(said);
    text[fread(text, 1, sizeof text - 1, said)] = 0;
    fclose(said);
    assert_string_equal(text, "lsys: error: met D\n");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(branches_in_contexts),
    cmocka_unit_test(unmatched_brackets),
    cmocka_unit_test(signals),
    cmocka_unit_test(rings),
    cmocka_unit_test(long_branches),
    cmocka_unit_test(errors_in_order),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
