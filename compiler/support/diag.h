// diag.h -- messages to the user: "file:line:col: error: ...", the source
// line, a caret range, notes and fix-its behind it (LANGUAGE.md section 8).
//
// A message is lower case, names the thing, and says what was wanted. After
// an error the passes go on as far as they safely can; between passes the
// driver stops if diag_errors() is not 0.
#ifndef LSYSC_SUPPORT_DIAG_H
#define LSYSC_SUPPORT_DIAG_H

#include "support/source.h"

#include <stdio.h>

typedef enum WarningId {
#define WARNING(id, name, on, doc) WARN_##id,
#include "support/warnings.def"
#undef WARNING
  WARN_COUNT
} WarningId;

typedef enum ColourMode { COLOUR_AUTO, COLOUR_ALWAYS, COLOUR_NEVER } ColourMode;

typedef struct DiagOptions {
  ColourMode colour;
  bool warnings_are_errors;  // -Werror
  bool no_warnings;          // -w
  bool on[WARN_COUNT];       // -Wname, -Wno-name
  unsigned max_errors;       // 20
  FILE *out;                 // stderr
} DiagOptions;

typedef struct Diag Diag;

void diag_options_default(DiagOptions *options);

// -W argument without the "-W": "name", "no-name", "all", "error". False: unknown.
bool diag_option(DiagOptions *options, const char *argument);

Diag *diag_create(Arena *arena, const Sources *sources, const DiagOptions *options);

#define DIAG_FORMAT __attribute__((format(printf, 3, 4)))
void diag_error(Diag *diag, Span span, const char *format, ...) DIAG_FORMAT;
void diag_warning(Diag *diag, WarningId id, Span span, const char *format, ...) __attribute__((format(printf, 4, 5)));

// Belong to the message before them and vanish with it when it is not shown.
void diag_note(Diag *diag, Span span, const char *format, ...) DIAG_FORMAT;
void diag_hint(Diag *diag, const char *format, ...) __attribute__((format(printf, 2, 3)));

// "replace span by text"; an empty span inserts.
void diag_fix(Diag *diag, Span span, const char *text);

// A note of its own, such as "read as a cpfg file" (not counted, -w hides it).
void diag_remark(Diag *diag, Span span, const char *format, ...) DIAG_FORMAT;

size_t diag_errors(const Diag *diag);

// The texts that its messages point into.
const Sources *diag_sources(const Diag *diag);

// The candidate nearest to name by edit distance, or NULL when none is near
// enough (a third of the length, at least 1) to be what was meant.
const char *diag_nearest(const char *name, const char *const *candidates, size_t count);

#endif
