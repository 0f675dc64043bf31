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
  bool careful;      // a blank may have to follow
  bool parentheses;  // arguments, a label's text, or `,()`: a bare comma would separate start words
  char *quoted;      // a label's text in quotes; NULL: none
  size_t quoted_size;
} LsysSpelling;

// A name that the scanner takes as one symbol.
typedef struct LsysName {
  const char *at;
  size_t length;
} LsysName;

typedef struct LsysSpeller {
  LsysMemory *memory;
  LsysSpelling *kinds;
  uint32_t kind_count;
  LsysName *symbols;  // of the kinds, sorted
  LsysName *names;    // of kinds, declared, and of the turtle, longer than a byte, sorted
  size_t name_count, name_room;
  size_t longest;                    // bytes of a name
  bool letter_begins, digit_begins;  // some kind's symbol
} LsysSpeller;

// False after printing why not; closed in either case.
bool lsys_speller_open(LsysSpeller *speller, const LsysGrammar *grammar, LsysMemory *memory);
void lsys_speller_close(LsysSpeller *speller);

// How many of the bytes of text, the symbols and arguments of modules without
// blanks, the scanner takes as its first symbol (LANGUAGE.md section 2).
size_t lsys_speller_scan(const LsysSpeller *speller, const char *text, size_t size);

#endif
