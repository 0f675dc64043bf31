// test_text.c -- a printed word reads back as the same word, and has no blank
// too many (LANGUAGE.md section 9).
#include "grammar.h"

#include "lsys/keys.h"

enum { MOST_SYMBOLS = 6, LONGEST_WORD = 12, WORDS = 200 };

#define DECLARED "#modules plant pl ant\n"

// Symbols that, side by side, begin or go on with others.
static const char *const symbols[] = {
  "a", "b", "_", "r",  "1",   "2",   "a_r", "b_2", "x", "x_1", "x_12", "plant", "p", "l",  "n",   "t",
  "E", "P", "/", "*",  "@v",  "v",   "F",   "F_l", "-", "+",   "~",    "\"",    "%", ".",  "=",   "!",
  "é", "|", "&", "\\", "é_r", "ant", ";",   "#",   "{", "}",   "$",    "G",     "'", "pl", "@Gs",
};

// The word as it is printed, to be freed. words: modules with blanks between.
static char *print(const char *word) {
  char text[512];
  snprintf(text, sizeof text, DECLARED "axiom: %s\nsteps: 0\n", word);
  Grammar grammar = grammar_read(text);
  char *printed = grammar_run(&grammar, (const char *[]){"-n", "0", NULL});
  grammar_free(&grammar);
  return printed;
}

// Modules of each symbol, to be freed: words that look the same may still be cut differently.
static char *count(const char *word) {
  char text[512];
  snprintf(text, sizeof text, DECLARED "axiom: %s\nsteps: 0\n", word);
  Grammar grammar = grammar_read(text);
  char *counts = grammar_run(&grammar, (const char *[]){"-n", "0", "--format", "count", NULL});
  grammar_free(&grammar);
  return counts;
}

static void assert_same(const char *word, const char *printed) {
  char *again = print(printed), *counts = count(word), *counts_again = count(printed);
  assert_string_equal(again, printed);
  assert_string_equal(counts, counts_again);
  free(again);
  free(counts);
  free(counts_again);
}

// Without any one of its blanks the text would be another word.
static void assert_needs_blanks(const char *word, const char *printed) {
  char *counts = count(word);
  for (const char *blank = strchr(printed, ' '); blank; blank = strchr(blank + 1, ' ')) {
    char shorter[512];
    snprintf(shorter, sizeof shorter, "%.*s%s", (int)(blank - printed), printed, blank + 1);
    if (strstr(shorter, "/*")) continue;  // a comment to the end of the file
    char *counts_without = count(shorter);
    if (strcmp(counts, counts_without) == 0) fail_msg("a blank too many in '%s'", printed);
    free(counts_without);
  }
  free(counts);
}

static void check_word(const char *word) {
  char *printed = print(word);
  assert_same(word, printed);
  assert_needs_blanks(word, printed);
  free(printed);
}

static void random_words(void **state) {
  (void)state;
  uint64_t key = lsys_root(11), draws = 0;
  for (int i = 0; i < WORDS; i++) {
    const char *some[MOST_SYMBOLS];
    for (int j = 0; j < MOST_SYMBOLS; j++)
      some[j] = symbols[(size_t)(lsys_draw(key, draws++) * (sizeof symbols / sizeof *symbols))];
    char word[256] = "Q";
    int length = 1 + (int)(lsys_draw(key, draws++) * LONGEST_WORD);
    for (int j = 0; j < length; j++) {
      const char *symbol = some[(size_t)(lsys_draw(key, draws++) * MOST_SYMBOLS)];
      strcat(strcat(word, " "), symbol);
      if (lsys_draw(key, draws++) < 0.1 && *symbol != '%' && *symbol != '@') strcat(word, "(0.1,-2)");
    }
    check_word(strcat(word, " Q"));  // a last `\\` would go on in the next line
  }
}

static void expect(const char *word, const char *wanted) {
  char *printed = print(word);
  assert_string_equal(printed, wanted);
  free(printed);
}

static void known_words(void **state) {
  (void)state;
  expect("a _ r a_r a _", "a _ra_ra_");
  expect("x_1 2 x_12 x 1", "x_1 2x_12x1");
  expect("p l a n t plant p l n", "p la ntplantp ln");
  expect("/ * / / @v v", "/ *//@vv");
  expect("F ,() + ,(2) A", "F,()+,(2)A");
  expect("A(1, nan, inf, -inf, 0.1, 1e17, -0.00001)", "A(1,nan,inf,-inf,0.1,1e+17,-1e-05)");
  expect("ε", "");
  expect("*()", "*()");
  expect("\\()", "\\()");
  expect("é é_r", "éé_r");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(known_words),
    cmocka_unit_test(random_words),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
