// split.c -- finds where each statement ends, and in it the arrow and the
// colons that stand outside parentheses, blocks and strings.
//
// One walk over the bytes. A line that begins a statement, or holds an arrow
// where none can stand, ends a statement whose `(` or `{` was never closed, so
// that a forgotten one costs its own statement and not the rest of the file.
#include "frontend/split.h"

#include "frontend/parse.tab.h"
#include "support/utf8.h"

typedef struct Walk {
  Splitter *in;
  Statement *s;
  const char *at, *end;
  const char *solid;              // behind the last byte that is neither blank nor comment
  const char *line, *line_solid;  // begin of the line that `at` is in, and `solid` there
  const char *held;               // the opening that made the statement go on in this line; NULL: none
  unsigned braces;                // of those in `open`
  bool expression;                // strings and blocks can stand here
  bool directive, done;
} Walk;

void splitter_init(Splitter *splitter, Arena *arena, Diag *diag, const Notation *notation, const SourceFile *file) {
  *splitter = (Splitter){arena, diag, notation, file, file->text, file->text + file->length, {0}};
}

// ---- white space -----------------------------------------------------------

// Behind the comment that begins at `at`; NULL if it never ends.
static const char *comment_end(const char *at, const char *end) {
  const char *close = memmem(at + 2, (size_t)(end - at - 2), "*/", 2);
  return close ? close + 2 : NULL;
}

// Behind blanks and comments, and line ends too if lines is set; stops at a comment that never ends.
static const char *skip_space(const char *at, const char *end, bool lines) {
  for (;;) {
    size_t blank = utf8_blank(at, end);
    const char *behind;
    if (blank)
      at += blank;
    else if (lines && at < end && *at == '\n')
      at++;
    else if (utf8_starts(at, end, "/*") && (behind = comment_end(at, end)) != NULL)
      at = behind;
    else
      return at;
  }
}

static const char *line_end(const char *at, const char *end) {
  const char *newline = memchr(at, '\n', (size_t)(end - at));
  return newline ? newline : end;
}

// ---- what a line holds -----------------------------------------------------

static size_t minus_length(const char *at, const char *end) {
  size_t length;
  if ((length = utf8_starts(at, end, "-")) || (length = utf8_starts(at, end, "−"))) return length;
  return utf8_starts(at, end, "–");
}

// Length of the arrow at `at`, the longer one if there are two; 0: none.
static size_t arrow_length(const char *at, const char *end, const Notation *notation) {
  size_t length;
  if ((length = utf8_starts(at, end, "→")) || (length = utf8_starts(at, end, "⟶"))) return length;
  size_t one = minus_length(at, end);
  if (!one) return 0;
  size_t two = one + minus_length(at + one, end);
  if (two > one && utf8_starts(at + two, end, ">")) return two + 1;
  if (notation->object_arrows && utf8_starts(at, end, "-o>")) return 3;
  return notation->short_arrows && utf8_starts(at + one, end, ">") ? one + 1 : 0;
}

static bool line_holds_arrow(const char *at, const char *end, const Notation *notation) {
  while (at < end && *at != '\n') {
    if (arrow_length(at, end, notation)) return true;
    const char *behind = utf8_starts(at, end, "/*") ? comment_end(at, end) : NULL;
    at = behind ? behind : at + 1;
  }
  return false;
}

static bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Does this line begin with a keyword that is no letter of a word or an expression?
static bool begins_statement(const char *at, const char *end, const Notation *notation) {
  KeywordMatch match = keyword_match(at, end, notation);
  if (!match.keyword || match.end - at <= 2) return false;
  if (match.colon || *at == '#') return true;
  const char *next = skip_space(match.end, end, false);
  return next == end || *next == '\n' || is_name_byte(*next);
}

// ---- the walk --------------------------------------------------------------

static Span at_span(const Walk *w, const char *at, size_t length) {
  uint32_t begin = statement_offset(w->s, at);
  return (Span){begin, begin + (uint32_t)length};
}

static void finish(Walk *w, const char *next) {
  w->at = next;
  w->done = true;
}

// Ends the statement before the line that `at` is in.
static void finish_before_line(Walk *w) {
  w->solid = w->line_solid;
  finish(w, w->line);
}

// Is reported when the statement is parsed, so that messages come in the order of the file.
static void note_unclosed(Walk *w, const char *opening, const char *next) {
  w->s->unclosed = opening;
  w->s->unclosed_before = next && next < w->end ? next : NULL;
}

static void go_on(Walk *w, const char *line, const char *held) {
  w->at = w->line = line;
  w->line_solid = w->solid;
  w->held = held;
}

static void newline(Walk *w) {
  const Splitter *in = w->in;
  const Notation *notation = in->notation;
  const char *next = skip_space(w->at, w->end, true);
  if (notation->tabs_join && utf8_starts(w->at + 1, w->end, "\t")) {
    go_on(w, w->at + 1, NULL);
    return;
  }
  if (in->open.count) {
    const char *innermost = in->open.at[in->open.count - 1];
    if (next < w->end && !begins_statement(next, w->end, notation)) {
      go_on(w, next, innermost);
      return;
    }
    note_unclosed(w, innermost, next);
  } else if (next < w->end) {
    bool bare_arrow = w->s->arrow && w->solid == w->s->arrow_end;
    if (bare_arrow && !begins_statement(next, w->end, notation) && !line_holds_arrow(next, w->end, notation)) {
      go_on(w, next, NULL);
      return;
    }
    const Keyword *keyword = w->s->first.keyword;
    if (keyword && keyword->rest == SCAN_BLOCK && w->solid == w->s->first.rest && *next == '{') {
      go_on(w, next, NULL);
      return;
    }
  }
  finish(w, w->at);
}

static void comment(Walk *w) {
  const char *behind = comment_end(w->at, w->end);
  if (!behind) diag_error(w->in->diag, at_span(w, w->at, 2), "this comment is never closed; it ends with `*/`");
  w->at = behind ? behind : w->end;
}

// Skips a string; a quote that nothing closes in its line is the scanner's to report.
static void string(Walk *w) {
  const char *at = w->at + 1;
  while (at < w->end && *at != '"' && *at != '\n') at += *at == '\\' && at + 1 < w->end && at[1] != '\n' ? 2 : 1;
  w->at = w->solid = at < w->end && *at == '"' ? at + 1 : w->at + 1;
}

// A `\` with white space before it (in C's preprocessor: any) and nothing behind it joins the next line.
static bool joined(Walk *w) {
  if (w->solid == w->at && w->at != w->s->begin && !w->in->notation->line_comments) return false;
  const char *behind = skip_space(w->at + 1, w->end, false);
  if (behind < w->end && *behind != '\n') return false;
  if (behind < w->end)
    go_on(w, behind + 1, w->held);
  else
    finish(w, behind);
  return true;
}

static bool in_expression(const Walk *w) {
  return w->expression || w->in->open.count;
}

// Passes over a comment to the end of its line, if one begins here.
static bool line_comment(Walk *w) {
  const Notation *notation = w->in->notation;
  char before = w->at == w->in->file->text ? '\n' : w->at[-1];
  bool block = w->braces && utf8_starts(w->at, w->end, "//");
  if (notation->line_comments ? !starts_line_comment(before, w->at, w->end, in_expression(w)) : !block) return false;
  const char *begin = w->at;
  w->at = line_end(begin, w->end);
  *VEC_PUSH(w->in->arena, &w->s->line_comments) = (Stretch){begin, w->at};
  return true;
}

static void opening(Walk *w) {
  bool brace = *w->at == '{';
  if (!brace || w->braces || (w->expression && !w->in->open.count)) {
    *VEC_PUSH(w->in->arena, &w->in->open) = w->at;
    w->braces += brace;
  }
  w->solid = ++w->at;
}

static void closing(Walk *w) {
  Splitter *in = w->in;
  if (*w->at == ')') {
    if (in->open.count && *in->open.at[in->open.count - 1] == '(') in->open.count--;
  } else if (w->braces) {  // with the parentheses in it that were not closed
    while (*in->open.at[in->open.count - 1] != '{') in->open.count--;
    in->open.count--;
    w->braces--;
  }
  w->solid = ++w->at;
}

static void colon(Walk *w) {
  Statement *s = w->s;
  if (w->in->open.count == 0 && !w->directive) {
    if (s->arrow) {
      if (!s->weight) s->weight = w->at;
      w->expression = true;
    } else if (!s->colons[0]) {
      s->colons[0] = w->at;
      w->expression = !w->in->notation->labels || !statement_label(s->begin, w->at);
    } else if (!s->colons[1]) {
      s->colons[1] = w->at;
      w->expression = true;
    }
  }
  w->solid = ++w->at;
}

static void arrow(Walk *w, size_t length) {
  Splitter *in = w->in;
  Statement *s = w->s;
  if (in->open.count) {  // no expression holds an arrow
    const char *innermost = in->open.at[in->open.count - 1];
    note_unclosed(w, innermost, innermost < w->line ? w->line : NULL);
    in->open.count = w->braces = 0;
    if (innermost < w->line) {
      finish_before_line(w);
      return;
    }
  } else if (w->held && (s->arrow || s->first.keyword)) {  // the line is a production of its own
    note_unclosed(w, w->held, w->line);
    finish_before_line(w);
    return;
  }
  if (!s->arrow) {
    s->arrow = w->at;
    s->arrow_end = w->at + length;
    w->expression = false;
  }
  w->solid = w->at += length;
}

static void step(Walk *w) {
  char c = *w->at;
  size_t length = utf8_blank(w->at, w->end);
  if (length) {
    w->at += length;
  } else if (c == '\n') {
    newline(w);
  } else if (utf8_starts(w->at, w->end, "/*")) {
    comment(w);
  } else if (c == '/' && line_comment(w)) {
    // nothing of it is looked at
  } else if (c == '"' && in_expression(w)) {
    string(w);
  } else if (c == '(' || c == '{') {
    opening(w);
  } else if (c == ')' || c == '}') {
    closing(w);
  } else if (c == ':') {
    colon(w);
  } else if (!w->directive && (length = arrow_length(w->at, w->end, w->in->notation)) > 0) {
    arrow(w, length);
  } else if (c != '\\' || !joined(w)) {
    w->solid = ++w->at;
  }
}

// A line that is not looked into: #include's, and every directive of a notation with macros.
static void walk_line(Walk *w) {
  while (w->at < w->end && *w->at != '\n') {
    if (utf8_starts(w->at, w->end, "\\\n")) {
      w->at += 2;
      continue;
    }
    if (utf8_starts(w->at, w->end, "/*")) {
      comment(w);
      continue;
    }
    if (w->in->notation->line_comments && line_comment(w)) return;
    size_t blank = utf8_blank(w->at, w->end);
    w->at += blank ? blank : 1;
    if (!blank) w->solid = w->at;
  }
}

// Reads the statement that begins at splitter->at, with that keyword or none.
static void read_with(Splitter *splitter, Statement *s, KeywordMatch first) {
  *s = (Statement){.file = splitter->file, .begin = splitter->at, .notation = splitter->notation, .first = first};
  const Keyword *keyword = first.keyword;
  Walk w = {.in = splitter, .s = s, .at = splitter->at, .end = splitter->end};
  if (keyword) {
    w.at = s->first.rest;
    w.expression = keyword->rest != SCAN_WORD && keyword->rest != SCAN_AXIOM;
    w.directive = *s->begin == '#';
    if (!w.directive) s->colons[0] = s->first.colon;
  }
  w.line = s->begin;
  w.solid = w.line_solid = w.at;
  splitter->open.count = 0;
  bool line = keyword && (keyword->rest == SCAN_LINE || (w.directive && splitter->notation->macros));
  if (line || splitter->notation->lines) {
    walk_line(&w);
  } else {
    while (!w.done && w.at < w.end) step(&w);
    if (!w.done && splitter->open.count) note_unclosed(&w, splitter->open.at[splitter->open.count - 1], NULL);
  }
  s->end = w.solid;
  splitter->at = w.at;
}

static void read_statement(Splitter *splitter, Statement *s) {
  const char *begin = splitter->at;
  KeywordMatch first = keyword_match(begin, splitter->end, splitter->notation);
  read_with(splitter, s, first);
  if (!splitter->notation->tight_colons || !s->arrow || !first.colon || first.colon == first.end) return;
  splitter->at = begin;
  read_with(splitter, s, (KeywordMatch){0});
}

// Reports and skips a comment that never ends.
static void skip_endless_comment(Splitter *splitter) {
  Statement here = {.file = splitter->file};
  if (!utf8_starts(splitter->at, splitter->end, "/*")) return;
  diag_error(splitter->diag, statement_span(&here, splitter->at, splitter->at + 2),
             "this comment is never closed; it ends with `*/`");
  splitter->at = splitter->end;
}

bool splitter_next(Splitter *splitter, Statement *statement) {
  for (;;) {
    splitter->at = skip_space(splitter->at, splitter->end, true);
    skip_endless_comment(splitter);
    if (splitter->at == splitter->end) return false;
    if (!utf8_starts(splitter->at, splitter->end, "//")) break;
    splitter->at = line_end(splitter->at, splitter->end);
  }
  read_statement(splitter, statement);
  return true;
}

bool splitter_next_conditional(Splitter *splitter, Statement *statement) {
  for (;;) {
    splitter->at = skip_space(splitter->at, splitter->end, true);
    skip_endless_comment(splitter);
    if (splitter->at == splitter->end) return false;
    const Keyword *keyword = keyword_match(splitter->at, splitter->end, splitter->notation).keyword;
    if (*splitter->at == '#' && keyword && keyword_is_conditional(keyword)) {
      read_statement(splitter, statement);
      return true;
    }
    while (splitter->at < splitter->end && *splitter->at != '\n') {
      const char *behind =
        utf8_starts(splitter->at, splitter->end, "/*") ? comment_end(splitter->at, splitter->end) : NULL;
      splitter->at = behind ? behind : splitter->at + 1;
    }
  }
}
