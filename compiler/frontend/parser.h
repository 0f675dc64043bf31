// parser.h -- one logical statement -> its AST (parse.y).
//
// Statements are parsed one at a time, so an error in one cannot reach into
// the next, and the reader can have `#if` conditions parsed when it meets them.
#ifndef LSYSC_FRONTEND_PARSER_H
#define LSYSC_FRONTEND_PARSER_H

#include "frontend/ast_build.h"
#include "frontend/split.h"

typedef struct Parser {
  AstBuilder build;
  const Notation *notation;
  Diag *diag;
  const Sources *sources;
  Trie *symbols;   // the interner
  Trie *declared;  // names that are symbols
  Scanner *scanner;
  const Statement *statement;  // that is being parsed
  AstStatements *out;          // what it means goes there
  AstExpr *condition;          // of an #if
} Parser;

void parser_init(Parser *parser, Arena *arena, Diag *diag, const Sources *sources, const Notation *notation);
void parser_finish(Parser *parser);

// Parses a statement into statement->ast before its turn has come.
void parser_ahead(Parser *parser, Statement *statement);

// Appends what a statement means to out; nothing if there is an error in it.
void parser_statement(Parser *parser, const Statement *statement, AstStatements *out);

// The condition of an `#if` or `#elif`; NULL after an error.
AstExpr *parser_condition(Parser *parser, const Statement *statement);

// The statement's tokens, one a line.
void parser_tokens(Parser *parser, const Statement *statement, FILE *out);

// What messages call a token.
const char *parser_token_name(int token);

#endif
