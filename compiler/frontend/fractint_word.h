// fractint_word.h -- a string of Fractint's commands -> a word of our turtle's symbols.
#ifndef LSYSC_FRONTEND_FRACTINT_WORD_H
#define LSYSC_FRONTEND_FRACTINT_WORD_H

#include "frontend/ast_build.h"

// A rule may be written on several lines: the pieces are read as one string,
// so that a number may begin in one and end in the next.
typedef VEC(Span) FractintString;

typedef struct FractintWords {
  AstBuilder build;
  const SourceFile *file;
  unsigned angle;            // turns of `+` in a circle
  const char *symbols[256];  // by character, interned; NULL: not met yet
} FractintWords;

// The turtle's symbol for a character (lower case), the same pointer each time.
const char *fractint_symbol(FractintWords *words, unsigned char character);

AstWord fractint_word(FractintWords *words, const FractintString *string);

#endif
