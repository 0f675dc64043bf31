// expect.h -- the expectations that a grammar's comments hold (tests/README.md).
#ifndef LSYSC_GOLDEN_EXPECT_H
#define LSYSC_GOLDEN_EXPECT_H

#include "golden.h"

// What a program is asked for.
typedef enum View { VIEW_WORD, VIEW_SYMBOLS, VIEW_STATS, VIEW_HASH, VIEW_COUNT } View;
extern const char *const view_options[VIEW_COUNT];

// One line of a comment: a word, or a row of --count or --stats with its values.
typedef struct Expectation {
  View view;
  const char *text;
  unsigned line;
} Expectation;

typedef struct Outcome {
  const char *word;
  double probability;
  unsigned long came;
} Outcome;

typedef struct Test {
  const char *options;  // of the program
  unsigned line;
  VEC(Expectation) expectations;
  VEC(Outcome) outcomes;
  const char *fails;  // text of the error message; NULL: succeeds
  bool seeded, frequencies;
  unsigned long first_seed, last_seed;
  bool query;  // asks for what is expected only: the word would be too long to hash
} Test;

typedef VEC(Test) Tests;

// What a file says of all its tests.
typedef struct FileOptions {
  const char *options;  // of lsysc
  bool interp_only;     // the other engines do not know something in it yet
} FileOptions;

// Reads the comments of a grammar that stands at `line` of its file. False after reporting what is wrong with them.
bool expect_read(Case *test, const char *text, unsigned line, Tests *tests, FileOptions *file);

// Whether the test has to be run with that view.
bool expect_needs(const Test *t, View view);

// Compares what was printed with the test's expectations of that view; reports what differs.
bool expect_holds(Case *test, Test *t, View view, const char *printed);

// Whether the rows of --stats that the test names are equal in both; sizes and times beside them may differ.
bool expect_same_stats(const Test *t, const char *a, const char *b);

// Counts a word among the outcomes; false when it is none of them.
bool expect_outcome(Test *t, const char *printed);

// Whether every outcome came up at least once, and whether they came as often as they should (chi-square).
bool expect_all_came(Case *test, const Test *t);
bool expect_frequencies(Case *test, const Test *t);

#endif
