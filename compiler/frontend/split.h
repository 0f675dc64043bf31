// split.h -- one file's text as logical statements, and a statement as the
// pieces that the scanner reads (LANGUAGE.md section 1).
//
// A statement ends with its line, unless a parenthesis or a block is open, an
// arrow stands last, or a `\` joins the next line. Where words end and
// expressions begin is decided here, by colons and the arrow.
#ifndef LSYSC_FRONTEND_SPLIT_H
#define LSYSC_FRONTEND_SPLIT_H

#include "frontend/ast.h"
#include "frontend/keywords.h"

typedef struct Stretch {
  const char *at, *end;
} Stretch;

typedef struct Statement {
  const SourceFile *file;
  const char *begin, *end;        // its text without white space around it
  KeywordMatch first;             // what it begins with
  const char *colons[2];          // of a label, of a guard: before the arrow; NULL: none
  const char *arrow, *arrow_end;  // outside parentheses, blocks and strings; NULL: none
  const char *weight;             // the colon behind the successor; NULL: none
  VEC(Stretch) line_comments;     // `//` to the end of a line, in file order
  const char *unclosed;           // a `(` or `{` that is never closed; NULL: none
  const char *unclosed_before;    // the line that showed it; NULL: the end of the file, or its own line
  bool overridden;                // the #define of a -D whose value a param took over
  bool parsed;                    // ahead of the others; `ast` holds what it means
  AstStatements ast;
  const Notation *notation;
} Statement;

typedef struct Splitter {
  Arena *arena;
  Diag *diag;
  const Notation *notation;
  const SourceFile *file;
  const char *at, *end;    // what is left
  VEC(const char *) open;  // the `(` and `{` that are not closed yet, outermost first
} Splitter;

void splitter_init(Splitter *splitter, Arena *arena, Diag *diag, const Notation *notation, const SourceFile *file);

// The next statement; false at the end of the file.
bool splitter_next(Splitter *splitter, Statement *statement);

// The next of #if, #ifdef, #ifndef, #elif, #else, #endif; everything else is skipped unread.
bool splitter_next_conditional(Splitter *splitter, Statement *statement);

// A production rather than a keyword's statement.
bool statement_is_production(const Statement *statement, const Trie *declared);

// Length of the label that stands before a statement's first colon: `p`, or a name with a digit; 0: none.
size_t statement_label(const char *begin, const char *colon);

enum { MOST_PIECES = 12 };

// The pieces of a statement that has a keyword or an arrow; their number.
size_t statement_pieces(const Statement *statement, const Trie *declared, Piece pieces[MOST_PIECES]);

// The global offset of a place in the statement's file.
static inline uint32_t statement_offset(const Statement *statement, const char *at) {
  return statement->file->base + (uint32_t)(at - statement->file->text);
}

static inline Span statement_span(const Statement *statement, const char *begin, const char *end) {
  return (Span){statement_offset(statement, begin), statement_offset(statement, end)};
}

#endif
