// fmt_comment.h -- what stands between and inside statements: comments above all.
#ifndef LSYSC_FRONTEND_FMT_COMMENT_H
#define LSYSC_FRONTEND_FMT_COMMENT_H

#include "frontend/ast.h"

// Where the printer is in its output's lines.
typedef struct FmtLines {
  FILE *out;
  bool line;   // a line has been begun
  bool blank;  // an empty line is due before the next one, if any stands before it
  bool any;    // something was printed
} FmtLines;

// Begins a new line, behind an empty one if it is due.
void fmt_begin_line(FmtLines *lines);
void fmt_end_line(FmtLines *lines);

// The text between two statements of a native file: its lines as they are, but for white space at
// their ends and more than one empty line.
void fmt_native_gap(FmtLines *lines, const char *at, const char *end);

// The comments of a text of another dialect, as native ones.
void fmt_foreign_gap(FmtLines *lines, const char *dialect, const char *at, const char *end);

// Comments inside a native or cpfg statement, behind it on its line.
void fmt_inner_comments(FmtLines *lines, const char *at, const char *end);

#endif
