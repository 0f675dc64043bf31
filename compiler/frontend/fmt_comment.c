// fmt_comment.c -- what stands between and inside statements: comments above all.
//
// The Ast knows nothing of comments, but its spans say where statements are:
// what is left of the text is printed here. A text that this file printed
// comes out of it unchanged.
#include "frontend/fmt_comment.h"

#include "frontend/mws.h"

#include <ctype.h>
#include <string.h>

void fmt_end_line(FmtLines *lines) {
  if (lines->line) fputc('\n', lines->out);
  lines->line = false;
}

void fmt_begin_line(FmtLines *lines) {
  fmt_end_line(lines);
  if (lines->blank && lines->any) fputc('\n', lines->out);
  lines->blank = false;
  lines->line = lines->any = true;
}

static const char *line_end(const char *at, const char *end) {
  const char *newline = memchr(at, '\n', (size_t)(end - at));
  return newline ? newline : end;
}

static const char *skip_blanks(const char *at, const char *end) {
  while (at < end && isspace((unsigned char)*at)) at++;
  return at;
}

static const char *trim(const char *at, const char *end) {
  while (end > at && isspace((unsigned char)end[-1])) end--;
  return end;
}

static bool starts(const char *at, const char *end, const char *mark) {
  size_t length = strlen(mark);
  return (size_t)(end - at) >= length && memcmp(at, mark, length) == 0;
}

static void print(FmtLines *lines, const char *at, const char *end) {
  fwrite(at, 1, (size_t)(end - at), lines->out);
}

// Is a comment that began before or in this line still open at its end?
static bool leaves_comment(const char *at, const char *end, bool inside) {
  if (!inside && starts(skip_blanks(at, end), end, "//")) return false;
  while (at < end) {
    const char *mark = inside ? "*/" : "/*";
    bool found = starts(at, end, mark);
    at += found ? 2 : 1;
    if (found) inside = !inside;
  }
  return inside;
}

void fmt_native_gap(FmtLines *lines, const char *at, const char *end) {
  bool inside = false;
  while (at < end) {
    const char *stop = line_end(at, end);
    const char *text = inside ? at : skip_blanks(at, stop), *text_end = trim(text, stop);
    bool trailing = lines->line;  // behind a statement, on its line
    if (text == text_end && !inside && !trailing) {
      lines->blank = true;
    } else if (text < text_end || inside) {
      if (trailing && !inside)
        fputs("  ", lines->out);
      else
        fmt_begin_line(lines);
      print(lines, text, text_end);
    }
    inside = leaves_comment(at, stop, inside);
    if (stop < end || text < text_end) fmt_end_line(lines);
    at = stop < end ? stop + 1 : end;
  }
}

// ---- comments of other dialects ----------------------------------------------

// Prints lines of a comment's text as `//` lines, or behind a statement in `/* */`.
static void print_comment(FmtLines *lines, const char *at, const char *end) {
  while (at <= end) {
    const char *stop = line_end(at, end), *text = skip_blanks(at, stop), *text_end = trim(text, stop);
    at = stop + 1;
    if (text == text_end) continue;
    bool closes = false;
    for (const char *c = text; c + 1 < text_end; c++) closes |= starts(c, text_end, "*/");
    if (lines->line && !closes) {
      fputs("  /* ", lines->out);
      print(lines, text, text_end);
      fputs(" */", lines->out);
      fmt_end_line(lines);
    } else {
      fmt_begin_line(lines);
      fputs("// ", lines->out);
      print(lines, text, text_end);
      fmt_end_line(lines);
    }
  }
}

// In mws a comment is a whole line, and not every line with `#`.
static void mws_gap(FmtLines *lines, const char *at, const char *end) {
  while (at < end) {
    const char *stop = line_end(at, end);
    MwsLine what = mws_line(at, stop);
    lines->blank |= what == MWS_EMPTY && !lines->line;
    fmt_end_line(lines);
    if (what == MWS_COMMENT) print_comment(lines, skip_blanks(at, stop) + 1, stop);
    at = stop < end ? stop + 1 : end;
  }
}

void fmt_foreign_gap(FmtLines *lines, const char *dialect, const char *at, const char *end) {
  const char *mark = strcmp(dialect, "fractint") == 0 ? ";" : "//";
  bool blocks = *mark == '/';
  bool any = false;           // the line is not empty
  bool alone = *mark == ';';  // the statements between the comments are printed behind them
  if (strcmp(dialect, "mws") == 0) {
    mws_gap(lines, at, end);
    return;
  }
  while (at < end) {
    if (*at == '\n') {
      lines->blank |= !lines->line && !alone && !any;
      any = false;
      fmt_end_line(lines);
      at++;
    } else if (blocks && starts(at, end, "/*")) {
      const char *stop = memmem(at + 2, (size_t)(end - at - 2), "*/", 2);
      print_comment(lines, at + 2, stop ? stop : end);
      any = true;
      at = stop ? stop + 2 : end;
    } else if (starts(at, end, mark)) {
      const char *stop = line_end(at, end);
      print_comment(lines, at + strlen(mark), stop);
      any = true;
      at = stop;
    } else {
      any |= !isspace((unsigned char)*at++);
    }
  }
}

void fmt_inner_comments(FmtLines *lines, const char *at, const char *end) {
  bool string = false;
  for (; at < end; at++) {
    if (*at == '"') string = !string;
    if (string || !starts(at, end, "/*")) continue;
    const char *stop = memmem(at + 2, (size_t)(end - at - 2), "*/", 2);
    if (!stop) return;
    fputs("  ", lines->out);
    print(lines, at, stop + 2);
    at = stop + 1;
  }
}
