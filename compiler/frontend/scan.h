// scan.h -- a statement's text as tokens (scan.l).
//
// Words and expressions have different tokens: in a word `-` is a module, in
// an expression an operator. The statement comes as pieces, each with the way
// it is to be scanned (split.h finds them), so the scanner never guesses.
#ifndef LSYSC_FRONTEND_SCAN_H
#define LSYSC_FRONTEND_SCAN_H

#include "frontend/notation.h"
#include "support/diag.h"
#include "support/source.h"
#include "support/trie.h"

typedef enum ScanMode {
  SCAN_TOKEN,       // not scanned: the piece is one token
  SCAN_WORD,        // modules; expressions inside their parentheses
  SCAN_AXIOM,       // the same, where a bare `,` separates words
  SCAN_EXPRESSION,  // an expression
  SCAN_BLOCK,       // the same, with actions in braces
  SCAN_PARAM,       // NAME = expression in expression..expression
  SCAN_DEFINE,      // NAME or NAME(a,b), then an expression
  SCAN_NAMES,       // names, ( ) and ,
  SCAN_SURFACE,     // NAME: form
  SCAN_FORM,        // a call, a name, or a file's name
  SCAN_COLOURS,     // #rrggbb and names
  SCAN_PAGE,        // one text, as an option of pictures has it
  SCAN_LINE         // not scanned: the reader's business
} ScanMode;

typedef struct Piece {
  ScanMode mode;
  int token;         // SCAN_TOKEN
  unsigned setting;  // TOK_SETTING, TOK_PAGE: index in settings.def
  const char *text;  // length bytes
  size_t length;
  Span span;
} Piece;

typedef struct Scanner Scanner;
union SYNTAX_STYPE;

// symbols: the interner; declared: names that are symbols, besides the turtle's own (`@Gs`).
Scanner *scanner_create(Arena *arena, Diag *diag, const Notation *notation, Trie *symbols, Trie *declared);
void scanner_destroy(Scanner *scanner);

// Tokens come from these pieces next. The pieces stay the caller's.
void scanner_start(Scanner *scanner, const Piece *pieces, size_t count, Span end);

// The next token (TOK_...), 0 at the end, TOK_SYNTAX_error after a lexical error was reported.
int scanner_next(Scanner *scanner, union SYNTAX_STYPE *value, Span *span);

#endif
