// message.c -- messages on standard error, and the nearest spelling.
#include "core/message.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

// A process has one name, like its signal handlers.
static const char *program = "lsys";
static int is_quiet;
static _Thread_local LsysMessage *caught;  // NULL: errors are printed

void lsys_message_program(const char *name) {
  program = name;
}

const char *lsys_message_name(void) {
  return program;
}

static void print(const char *severity, const char *format, va_list args) {
  fprintf(stderr, "%s: %s: ", program, severity);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
}

LsysMessage *lsys_message_catch(LsysMessage *message) {
  LsysMessage *before = caught;
  caught = message;
  return before;
}

void lsys_verror(const char *format, va_list args) {
  if (!caught)
    print("error", format, args);
  else if (!*caught->text)
    vsnprintf(caught->text, sizeof caught->text, format, args);
}

void lsys_error(const char *format, ...) {
  va_list args;
  va_start(args, format);
  lsys_verror(format, args);
  va_end(args);
}

void lsys_message_quiet(int quiet) {
  is_quiet = quiet;
}

void lsys_warning(const char *format, ...) {
  if (is_quiet) return;
  va_list args;
  va_start(args, format);
  print("warning", format, args);
  va_end(args);
}

void lsys_note(const char *format, ...) {
  if (is_quiet) return;
  va_list args;
  va_start(args, format);
  print("note", format, args);
  va_end(args);
}

// Levenshtein's distance, in one row; words longer than the row are never near.
static unsigned distance(const char *a, const char *b) {
  enum { LONGEST = 31 };
  size_t n = strlen(a), m = strlen(b);
  if (n > LONGEST || m > LONGEST) return LONGEST;
  unsigned row[LONGEST + 1];
  for (unsigned j = 0; j <= m; j++) row[j] = j;
  for (size_t i = 1; i <= n; i++) {
    unsigned diagonal = row[0];
    row[0] = (unsigned)i;
    for (size_t j = 1; j <= m; j++) {
      unsigned replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      unsigned inserted = row[j - 1] + 1, deleted = row[j] + 1;
      unsigned least = inserted < deleted ? inserted : deleted;
      row[j] = replaced < least ? replaced : least;
    }
  }
  return row[m];
}

const char *lsys_nearest(const char *word, const char *const *candidates, unsigned count) {
  const char *best = NULL;
  unsigned least = (unsigned)strlen(word) / 3 + 2;  // the first distance that is too far
  for (unsigned i = 0; i < count; i++) {
    size_t length = strlen(word);
    bool begins = length > 1 && strncmp(word, candidates[i], length) == 0;
    unsigned d = begins ? 1 : distance(word, candidates[i]);
    if (d < least) least = d, best = candidates[i];
  }
  return best;
}
