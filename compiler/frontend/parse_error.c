// parse_error.c -- "unexpected X; expected A, B or C", and what may help.
#include "frontend/parse_error.h"

#include "support/utf8.h"

enum { MOST_EXPECTED = 5, LONGEST_QUOTE = 40 };

// The distinct names as "a, b or c".
static const char *listed(Arena *arena, const char **names, size_t count) {
  const char *kept[MOST_EXPECTED];
  size_t n = 0;
  for (size_t i = 0; i < count && n < MOST_EXPECTED; i++) {
    size_t j = 0;
    while (j < n && strcmp(kept[j], names[i]) != 0) j++;
    if (j == n) kept[n++] = names[i];
  }
  const char *list = n ? kept[0] : "";
  for (size_t i = 1; i < n; i++) list = arena_printf(arena, "%s%s%s", list, i + 1 < n ? ", " : " or ", kept[i]);
  return list;
}

static bool is_expected(const char **expected, size_t count, const char *name) {
  for (size_t i = 0; i < count; i++)
    if (strcmp(expected[i], name) == 0) return true;
  return false;
}

// Is a parenthesis open behind [begin, end)?
static bool is_open(const char *begin, const char *end) {
  size_t depth = 0;
  for (; begin < end; begin++) {
    depth += *begin == '(';
    depth -= *begin == ')' && depth;
  }
  return depth > 0;
}

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static void hint(Parser *parser, const char *at, bool end, const char **expected, size_t count) {
  const Statement *s = parser->statement;
  bool module = is_expected(expected, count, "a module");
  bool behind_arrow = s->arrow && at >= s->arrow_end;
  if (module && *at == '>' && behind_arrow)
    diag_hint(parser->diag, "a production has one arrow, and contexts stand before it");
  else if (module && end && (behind_arrow || !s->arrow))
    diag_hint(parser->diag, "the empty word is written `ε` or `*`");
  else if (*at == '(' && s->first.keyword && s->first.keyword->rest == SCAN_WORD)
    diag_hint(parser->diag, "symbols stand alone here; any number of arguments is meant");
  else if (module && *at == '(')
    diag_hint(parser->diag, "parentheses hold a module's arguments and stand behind it");
  else if (at > s->begin && is_digit(at[-1]) && is_letter(*at) && is_expected(expected, count, "an operator"))
    diag_hint(parser->diag, "a product is written `2*x`");
  else if (*at == ',' && is_expected(expected, count, "an arrow"))
    diag_hint(parser->diag, "conditions that all hold are joined by `&&`");
  else if (*at == '=' && s->first.keyword && s->first.keyword->rest == SCAN_DEFINE)
    diag_hint(parser->diag, "a value stands behind its name, as in `#define k 3`");
  else if (*at == ')' && !is_open(s->begin, at))
    diag_hint(parser->diag, "no `(` is open that this could close");
}

void parse_error(Parser *parser, Span span, const char **expected, size_t count) {
  const Statement *s = parser->statement;
  const char *at = s->file->text + (span.begin - s->file->base);
  size_t length = span.end - span.begin;
  bool end = at >= s->end;
  static const char *module = "a module";
  if (is_expected(expected, count, "a label")) {  // at the begin of a production
    expected = &module;
    count = 1;
  }
  const char *list = listed(parser->build.arena, expected, count);
  const char * or = *list ? "; expected " : "";
  if (end)
    diag_error(parser->diag, span, "unexpected end of the statement%s%s", or, list);
  else if (length > LONGEST_QUOTE)
    diag_error(parser->diag, span, "unexpected text%s%s", or, list);
  else
    diag_error(parser->diag, span, "unexpected `%.*s`%s%s", (int)length, at, or, list);
  hint(parser, at, end, expected, count);
}
