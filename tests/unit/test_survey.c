// test_survey.c -- what a survey finds of a segment, compared with what one
// module after the other gives: brackets without a partner, and what stands
// next to them on their axes.
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/stream.h"
#include "core/survey.h"

#include <string.h>

enum { SEEN, OTHER, IGNORED, OPEN, CLOSE, KINDS, MOST = 700 };

static const uint8_t classes[KINDS] = {
  [IGNORED] = LSYS_CLASS_IGNORED, [OPEN] = LSYS_CLASS_OPEN, [CLOSE] = LSYS_CLASS_CLOSE};
static const LsysKind kinds[KINDS];
static const LsysContextView view = {classes, 0};
static const LsysGrammar grammar = {
  .kind_count = KINDS, .kinds = kinds, .views = &view, .left_window = 1, .flags = LSYS_GRAMMAR_LETTERS};

// Each module's partner, or -1: the place of its bracket's other end.
static void find_partners(const uint8_t *word, int length, int *partner) {
  int stack[MOST], depth = 0;
  for (int i = 0; i < length; i++) {
    partner[i] = -1;
    if (word[i] == OPEN) stack[depth++] = i;
    if (word[i] != CLOSE || !depth) continue;
    partner[i] = stack[--depth];
    partner[partner[i]] = i;
  }
}

static bool is_seen(uint8_t kind) {
  return kind == SEEN || kind == OTHER;
}

// The first seen module from `at` on to where `step` leads, over branches, until a bracket without a partner.
static uint32_t walk(const uint8_t *word, int length, const int *partner, int at, int step) {
  for (; at >= 0 && at < length; at += step) {
    if (is_seen(word[at])) return word[at];
    if (word[at] != OPEN && word[at] != CLOSE) continue;
    if (partner[at] < 0) break;
    at = partner[at];
  }
  return LSYS_NO_MODULE;
}

static uint32_t near(const Survey *survey, size_t frame) {
  return survey->near_count[frame] ? survey->near[frame].kind : LSYS_NO_MODULE;
}

static void compare(const Survey *survey, const uint8_t *word, int length) {
  int partner[MOST];
  size_t opens = 0, closes = 0;
  find_partners(word, length, partner);
  assert_int_equal(survey->next[0], walk(word, length, partner, 0, 1));
  for (int i = 0; i < length; i++) {
    if (partner[i] >= 0 || (word[i] != OPEN && word[i] != CLOSE)) continue;
    if (word[i] == CLOSE) {
      assert_ptr_equal(survey->closes.at[closes++].sym, word + i);
      assert_int_equal(survey->next[closes], walk(word, length, partner, i + 1, 1));
    } else {
      assert_int_equal(near(survey, opens), walk(word, length, partner, i - 1, -1));
      assert_ptr_equal(survey->opens.at[opens++].sym, word + i);
    }
  }
  assert_int_equal(survey->closes.count, closes);
  assert_int_equal(survey->opens.count, opens);
  assert_int_equal(near(survey, opens), walk(word, length, partner, length - 1, -1));
}

// A word in which so many of 256 modules are brackets, and so many of 256 brackets open.
static void make_word(uint64_t *state, uint8_t *word, int length, unsigned brackets, unsigned opening) {
  for (int i = 0; i < length; i++) {
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    unsigned first = (unsigned)(*state >> 56), second = *state >> 48 & 255;
    word[i] = (uint8_t)(first < brackets ? (second < opening ? OPEN : CLOSE) : second < 40 ? second % 2 : IGNORED);
  }
}

static void random_words(void **unused) {
  (void)unused;
  static const unsigned brackets[] = {2, 20, 128, 255}, opening[] = {0, 90, 120, 128, 136, 170, 256};
  LsysWorker worker = {.run = {.grammar = &grammar}};
  ScanTables tables;
  Survey survey = {0};
  uint64_t state = 1;
  assert_true(scan_tables(&tables, &grammar, NULL));
  for (int i = 0; i < 4 * 7 * 60; i++) {
    uint8_t word[MOST];
    int length = i % 60 < 30 ? i % 60 : i % 60 * 11;
    make_word(&state, word, length, brackets[i % 4], opening[i / 4 % 7]);
    LsysSegment segment = {.sym = word, .end = word + length};
    survey_segment(&survey, &tables, &worker.run, &segment, 0, NULL);
    compare(&survey, word, length);
  }
  survey_free(&survey, &worker.run);
  scan_tables_free(&tables);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(random_words)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
