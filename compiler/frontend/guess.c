// guess.c -- the commonest slips: a colon or an arrow forgotten, an arrow of
// another kind, a keyword misspelled.
#include "frontend/guess.h"

#include "support/utf8.h"

// Where `sign` stands outside parentheses; NULL: nowhere.
static const char *find_sign(const Statement *s, const char *sign) {
  unsigned depth = 0;
  for (const char *at = s->begin; at < s->end; at++) {
    depth += *at == '(';
    depth -= *at == ')' && depth;
    if (!depth && utf8_starts(at, s->end, sign)) return at;
  }
  return NULL;
}

// What stands for an arrow; NULL: nothing. The last two do only where no guard can hold them.
static const char *other_arrow(const Statement *s, size_t *length) {
  static const char *const signs[] = {"=>", "⇒", "⟹", "↦", "—>", "::=", ":=", "=", ">"};
  enum { SIGNS = sizeof signs / sizeof *signs };
  for (int i = 0; i < (s->colons[0] ? SIGNS - 2 : SIGNS); i++) {
    const char *at = find_sign(s, signs[i]);
    *length = strlen(signs[i]);
    if (at) return at;
  }
  return NULL;
}

// The words before the first colon, or the first word.
static Span first_words(const Statement *s) {
  const char *end = s->colons[0];
  if (end)
    while (end > s->begin && (end[-1] == ' ' || end[-1] == '\t')) end--;
  else
    for (end = s->begin; end < s->end && !strchr(" \t\r\n(", *end);) end++;
  return statement_span(s, s->begin, end);
}

// The text of span, which the statement begins with; not more than a message can hold.
static const char *quotable(Parser *parser, const Statement *s, Span span) {
  enum { LONGEST = 60 };
  size_t length = span.end - span.begin;
  const char *word = arena_copy(parser->build.arena, s->begin, length < LONGEST ? length : LONGEST);
  return length < LONGEST ? word : arena_printf(parser->build.arena, "%s...", word);
}

static const char comments[] = "a comment is written `// ...` or `/* ... */`";

static void unknown_directive(Parser *parser, const Statement *s) {
  Span span = first_words(s);
  const char *word = quotable(parser, s, span);
  const char *nearest = keyword_nearest(parser->build.arena, word);
  diag_error(parser->diag, span, "unknown directive `%s`%s%s%s", word, nearest ? "; did you mean `" : "",
             nearest ? nearest : "", nearest ? "`?" : "");
  if (!nearest) diag_hint(parser->diag, comments);
}

// What other programs call a statement; NULL: nothing known.
static const char *foreign_hint(const char *word) {
  static const struct {
    const char *words, *hint;
  } foreign[] = {
    {" start init initial initiator ", "the start word is given by `axiom:`"},
    {" n order level levels generation generations iteration iterations recursion recursions ",
     "the number of derivation steps is given by `steps:`"},
    {" rule rules ", "productions need no heading; each is a line such as `F --> F+F`"},
    {" alphabet constants symbols variables ", "symbols need no declaration"},
    {" tropism ", "a vector is given by `tropism_x:`, `tropism_y:` and `tropism_z:`"},
  };
  char key[16];
  size_t length = strlen(word);
  if (length + 3 > sizeof key) return NULL;
  key[0] = ' ';
  for (size_t i = 0; i < length; i++) key[i + 1] = word[i] >= 'A' && word[i] <= 'Z' ? (char)(word[i] + 32) : word[i];
  memcpy(key + 1 + length, " ", 2);
  for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
    if (strstr(foreign[i].words, key)) return foreign[i].hint;
  return NULL;
}

static bool is_block(const Statement *s) {
  const char *at = s->colons[0] + 1;
  while (at < s->end && (*at == ' ' || *at == '\t')) at++;
  return at < s->end && *at == '{';
}

static void unknown_statement(Parser *parser, const Statement *s) {
  Span span = first_words(s);
  const char *word = quotable(parser, s, span);
  const char *hint = is_block(s) ? NULL : foreign_hint(word);
  const char *nearest = hint ? NULL : keyword_nearest(parser->build.arena, word);
  diag_error(parser->diag, span, "unknown statement `%s:`%s%s%s", word, nearest ? "; did you mean `" : "",
             nearest ? nearest : "", nearest ? "`?" : "");
  if (!nearest && !hint && utf8_length(s->begin, s->end) == span.end - span.begin)
    hint = "a production has an arrow, as in `F --> F+F`";
  if (hint) diag_hint(parser->diag, "%s", hint);
}

// Does the statement begin as comments do elsewhere: a sign, and white space behind it?
static bool looks_like_comment(const Statement *s) {
  static const char *const signs[] = {"#", ";", "--", "%", "'", "\"", "!", "*"};
  for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
    size_t length = strlen(signs[i]);
    if (utf8_starts(s->begin, s->end, signs[i]) && s->begin + length < s->end && strchr(" \t", s->begin[length]))
      return true;
  }
  return false;
}

static void missing_arrow(Parser *parser, const Statement *s) {
  size_t length;
  const char *arrow = other_arrow(s, &length);
  if (arrow) {
    Span span = statement_span(s, arrow, arrow + length);
    diag_error(parser->diag, span, "a production's arrow is written `->`, not `%.*s`", (int)length, arrow);
    diag_fix(parser->diag, span, "->");
    return;
  }
  if (s->colons[0])
    diag_error(parser->diag, statement_span(s, s->begin, s->end), "this production has no arrow");
  else
    diag_error(parser->diag, statement_span(s, s->begin, s->end), "this is neither a statement nor a production");
  diag_hint(parser->diag, looks_like_comment(s) ? comments : "an arrow `->` stands between predecessor and successor");
}

void guess_statement(Parser *parser, const Statement *s) {
  KeywordMatch match = keyword_find(s->begin, s->end, parser->notation);
  bool letter = match.keyword && (size_t)(match.end - s->begin) == utf8_length(s->begin, s->end);
  if (*s->begin == '#' && s->begin + 1 < s->end && !match.keyword && s->begin[1] >= 'a' && s->begin[1] <= 'z') {
    unknown_directive(parser, s);
  } else if (match.keyword && !letter) {
    diag_error(parser->diag, statement_span(s, s->begin, match.end), "`%.*s` needs a `:` behind it",
               (int)(match.end - s->begin), s->begin);
    diag_fix(parser->diag, statement_span(s, match.end, match.end), ":");
  } else if (s->colons[0] && !statement_label(s->begin, s->colons[0])) {
    size_t length;
    if (other_arrow(s, &length) || memchr(s->begin, '(', (size_t)(s->colons[0] - s->begin)))
      missing_arrow(parser, s);
    else
      unknown_statement(parser, s);
  } else {
    missing_arrow(parser, s);
  }
}
