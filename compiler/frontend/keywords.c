// keywords.c -- looking a statement's first words up, blanks between them free.
#include "frontend/keywords.h"

#include "frontend/parse.tab.h"
#include "lsys/settings.h"
#include "support/diag.h"
#include "support/utf8.h"

static const Keyword keywords[] = {
#define KEYWORD(token, spellings, colon, rest, form, doc) {TOK_##token, {spellings, ""}, COLON_##colon, SCAN_##rest, 0},
#include "frontend/keywords.def"
#undef KEYWORD
#define SETTING(id, keyword, others, value, unit, doc)                                                                 \
  {TOK_SETTING, {keyword, others}, COLON_NEEDS, SCAN_EXPRESSION, LSYS_SETTING_##id},
#define PAGE(id, keyword, others, form, option, doc)                                                                   \
  {TOK_PAGE, {keyword, others}, COLON_NEEDS, SCAN_PAGE, LSYS_PAGE_##id},
#include "lsys/settings.def"
};
enum { KEYWORDS = sizeof keywords / sizeof *keywords };

static const char *skip_blanks(const char *at, const char *end) {
  for (size_t n; (n = utf8_blank(at, end)) > 0;) at += n;
  return at;
}

static bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

static char lower(char c) {
  return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

// Where [at, end) leaves a spelling of the given length; NULL if it does not begin with it.
static const char *spelled(const char *at, const char *end, const char *spelling, size_t length, bool any_case) {
  for (size_t i = 0; i < length; i++) {
    if (spelling[i] == '_') {
      const char *next = at < end && *at == '_' ? at + 1 : skip_blanks(at, end);
      if (next == at && !any_case) return NULL;
      at = next;
    } else if (at == end || (*at != spelling[i] && (!any_case || lower(*at) != lower(spelling[i])))) {
      return NULL;
    } else {
      at++;
    }
  }
  return at < end && is_word(at[-1]) && is_word(*at) ? NULL : at;
}

// The end of the longest spelling in a list that [at, end) begins with, or NULL.
static const char *spelled_any(const char *at, const char *end, const char *spellings, const Notation *notation) {
  const char *longest = NULL;
  while (*spellings) {
    size_t length = strcspn(spellings, " ");
    bool letter = length == utf8_length(spellings, spellings + length);
    const char *found = letter && !notation->labels ? NULL : spelled(at, end, spellings, length, notation->any_case);
    if (found && (!longest || found > longest)) longest = found;
    spellings += length + (spellings[length] == ' ');
  }
  return longest;
}

static bool is_directive(const Keyword *keyword) {
  int token = keyword->token;
  return token == TOK_DEFINE || token == TOK_UNDEF || token == TOK_INCLUDE || keyword_is_conditional(keyword);
}

KeywordMatch keyword_find(const char *at, const char *end, const Notation *notation) {
  KeywordMatch best = {0};
  for (int i = 0; i < KEYWORDS; i++)
    for (int j = 0; j < 2 && (!notation->lines || is_directive(&keywords[i])); j++) {
      const char *found = spelled_any(at, end, keywords[i].spellings[j], notation);
      if (found && (!best.keyword || found > best.end)) best = (KeywordMatch){&keywords[i], found, NULL, found};
    }
  if (!best.keyword || best.keyword->colon == COLON_LACKS) return best;
  const char *colon = skip_blanks(best.end, end);
  if (colon < end && *colon == ':') {
    best.colon = colon;
    best.rest = colon + 1;
  }
  return best;
}

KeywordMatch keyword_match(const char *at, const char *end, const Notation *notation) {
  KeywordMatch match = keyword_find(at, end, notation);
  if (match.keyword && match.keyword->colon == COLON_NEEDS && !match.colon) return (KeywordMatch){0};
  return match;
}

bool keyword_is_conditional(const Keyword *keyword) {
  switch (keyword->token) {
  case TOK_HASH_IF:
  case TOK_IFDEF:
  case TOK_IFNDEF:
  case TOK_ELIF:
  case TOK_HASH_ELSE:
  case TOK_ENDIF:
    return true;
  default:
    return false;
  }
}

// The spelling of length bytes with blanks for `_`, as the user would write it.
static const char *as_written(Arena *arena, const char *spelling, size_t length) {
  char *copy = arena_copy(arena, spelling, length);
  for (char *c = copy; *c; c++)
    if (*c == '_') *c = ' ';
  return copy;
}

const char *keyword_nearest(Arena *arena, const char *word) {
  VEC(const char *) all = {0};
  for (int i = 0; i < KEYWORDS; i++)
    for (int j = 0; j < 2; j++)
      for (const char *s = keywords[i].spellings[j]; *s;) {
        size_t length = strcspn(s, " ");
        *VEC_PUSH(arena, &all) = as_written(arena, s, length);
        s += length + (s[length] == ' ');
      }
  return diag_nearest(word, all.at, all.count);
}
