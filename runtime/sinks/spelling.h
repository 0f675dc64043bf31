// spelling.h -- how the modules of a grammar are written, and which of them need
// care because what follows them could be read as a part of them.
#ifndef LSYS_SINKS_SPELLING_H
#define LSYS_SINKS_SPELLING_H

#include "core/memory.h"
#include "lsys/abi.h"

enum { LSYS_SHORT_SYMBOL = 8 };  // symbols up to this length are copied as one 8-byte store

typedef struct LsysSpelling {
  char padded[LSYS_SHORT_SYMBOL];  // the symbol, if it is short
  const char *symbol;
  uint32_t length;
  uint32_t most;  // bytes that a module can take, numbers and slack included
  uint16_t arity;
  bool careful;            // a blank may have to follow
  bool empty_parentheses;  // `,()`: a bare comma would separate start words
} LsysSpelling;

// The spelling of each kind, kind_count of them; NULL after printing why not.
LsysSpelling *lsys_spelling_create(const LsysGrammar *grammar, LsysMemory *memory);

// How many of the bytes of text, the symbols and arguments of modules without
// blanks, the scanner takes as its first symbol (LANGUAGE.md section 2).
size_t lsys_spelling_scan(const LsysSpelling *spelling, uint32_t count, const char *text, size_t size);

#endif
