// keywords.h -- what statements begin with: keywords.def and the settings as one table.
#ifndef LSYSC_FRONTEND_KEYWORDS_H
#define LSYSC_FRONTEND_KEYWORDS_H

#include "frontend/notation.h"
#include "frontend/scan.h"

typedef enum KeywordColon { COLON_NEEDS, COLON_TAKES, COLON_LACKS } KeywordColon;

typedef struct Keyword {
  int token;                 // TOK_...
  const char *spellings[2];  // separated by blanks, `_` for a blank
  KeywordColon colon;
  ScanMode rest;
  unsigned setting;  // TOK_SETTING, TOK_PAGE: index in settings.def
} Keyword;

// Where a keyword stands.
typedef struct KeywordMatch {
  const Keyword *keyword;  // NULL: none
  const char *end;         // behind its letters
  const char *colon;       // its colon, NULL: none
  const char *rest;        // behind both
} KeywordMatch;

// The keyword that [at, end) begins with, whatever stands behind it.
KeywordMatch keyword_find(const char *at, const char *end, const Notation *notation);

// The same, if it has the colon that it needs.
KeywordMatch keyword_match(const char *at, const char *end, const Notation *notation);

// #if, #ifdef, #ifndef, #elif, #else or #endif.
bool keyword_is_conditional(const Keyword *keyword);

// The spelling nearest to a word that is no keyword; NULL if none is near.
const char *keyword_nearest(Arena *arena, const char *word);

#endif
