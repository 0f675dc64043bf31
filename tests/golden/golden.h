// golden.h -- the test driver: every case is a data file, and its place says how it is run.
//
//   cases/derive, grammars   *.lsys with expectations in comments   derive.c
//   cases/errors             *.lsys, *.expected                      transcript.c
//   cases/cli                *.sh, *.expected                        transcript.c
//   *.md                     fenced examples                         docs.c
//   test_*                   programs with cmocka tests              unit.c
#ifndef LSYSC_GOLDEN_H
#define LSYSC_GOLDEN_H

#include "support/vec.h"

#include <stdbool.h>
#include <stdio.h>

typedef VEC(const char *) Strings;

// One case: where it is, what runs it, what came out. Everything lives in the arena.
typedef struct Case {
  Arena *arena;
  const char *path;    // absolute
  const char *lsysc;   // absolute
  const char *folder;  // a fresh, empty folder that is removed afterwards
  bool bless;          // rewrite what is expected
  FILE *report;        // what failed, and why
  size_t passed, failed;
} Case;

// Counts a check; a failed one is reported as "path:line: why" (line 0: the whole file).
void case_pass(Case *test);
void case_fail(Case *test, unsigned line, const char *format, ...) __attribute__((format(printf, 3, 4)));

void derive_run(Case *test);  // a *.lsys with expectations
void derive_text(Case *test, const char *grammar,
                 unsigned line);  // expectations of a grammar that stands in a document
void errors_run(Case *test);
void cli_run(Case *test);
void docs_run(Case *test);
void unit_run(Case *test);

// ---- processes ---------------------------------------------------------------

typedef struct Result {
  int status;       // exit status, 128 + signal
  bool late;        // killed after the time that is allowed
  const char *out;  // standard output, NUL behind it
  const char *err;  // standard error; NULL when merged into out
  size_t size;      // of out
} Result;

// What a process may take of a processor, and by the clock, which other work slows down.
enum { PROCESS_SECONDS = 100, WALL_SECONDS = 900 };

// Runs argv in folder (NULL: here) without standard input. merge: standard error goes where standard output goes.
Result process_run(Arena *arena, const Strings *argv, const char *folder, bool merge);

// ---- texts ---------------------------------------------------------------------

// A whole file, NULL when it cannot be read.
char *text_read(Arena *arena, const char *path);
bool text_write(const char *path, const char *text, size_t size);

// Words compared as LANGUAGE.md section 9 says: white space does not count, numbers in parentheses to 9 digits.
bool text_same_word(const char *a, const char *b);

// Numbers to 9 digits, other text exactly.
bool text_same_value(const char *a, const char *b);

// Reports the first line in which two texts differ. A line "..." in expected stands for any number of lines.
bool text_same_lines(const char *expected, const char *found, bool ellipsis);
void text_report_difference(FILE *out, const char *expected, const char *found);

void text_split(Arena *arena, Strings *words, const char *text);

#endif
