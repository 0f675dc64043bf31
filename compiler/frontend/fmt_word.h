// fmt_word.h -- words and expressions in the native notation.
#ifndef LSYSC_FRONTEND_FMT_WORD_H
#define LSYSC_FRONTEND_FMT_WORD_H

#include "frontend/ast.h"
#include "support/trie.h"

typedef struct FmtWriter {
  Arena *arena;
  FILE *out;
  const SourceFile *file;
  Trie *names;    // symbols of more than one character: declared ones and the turtle's
  bool skips;     // in a right context, where `=` is no module
  Trie *renamed;  // cpfg: symbols that are none here, and what they become; else NULL
} FmtWriter;

// The text of a span, NULL if it is none of the file's.
const char *fmt_text(const FmtWriter *writer, Span span);

// A word; modules that were written apart stay apart, by one blank. The empty word is `*`.
void fmt_word(const FmtWriter *writer, const AstWord *word);

// A right context; cpfg's brackets in it are literal, which is said with `@]` here.
void fmt_right(const FmtWriter *writer, const AstWord *word);

// A start word: there a bare `,` would separate words.
void fmt_axiom(const FmtWriter *writer, const AstWord *word);

void fmt_expr(const FmtWriter *writer, const AstExpr *expr);

// An expression where a `:` may follow: in parentheses if it has a `:` of its own.
void fmt_closed_expr(const FmtWriter *writer, const AstExpr *expr);

// A range's end or another place where only an operand may stand.
void fmt_operand(const FmtWriter *writer, const AstExpr *expr);

void fmt_string(const FmtWriter *writer, const char *text);

#endif
