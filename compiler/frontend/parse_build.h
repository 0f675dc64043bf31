// parse_build.h -- what the grammar's rules make: statements, productions, actions.
#ifndef LSYSC_FRONTEND_PARSE_BUILD_H
#define LSYSC_FRONTEND_PARSE_BUILD_H

#include "frontend/parser.h"

typedef struct Predecessor {
  AstWord left, strict, right;
} Predecessor;

typedef struct Guard {
  AstActions before, after;
  bool has_before, has_after;
  AstExpr *condition;
} Guard;

// A new statement of the parser's output, with the span of the one being parsed.
AstStatement *build_statement(Parser *parser, AstStatementKind kind);
AstStatement *build_named(Parser *parser, AstStatementKind kind, const char *name, Span span);

// `decomposition: warnings`, `homomorphism: no warnings`.
void build_section(Parser *parser, AstStatementKind kind, AstSymbols options);

// Adds a symbol to those of `ignore:` or `consider:`.
AstSymbols build_symbol(Parser *parser, AstSymbols symbols, const char *name, Span span);

// The empty word for a word of `*` alone; an empty context has no span.
AstWord build_unless_star(AstWord word, bool context);

AstProduction *build_production(Parser *parser, Predecessor predecessor, Guard guard);

// Lists of one action.
AstActions build_assignment(Parser *parser, Span span, AstExpr *target, AstExpr *value);
AstActions build_evaluation(Parser *parser, Span span, AstExpr *value);
AstActions build_if(Parser *parser, Span span, AstExpr *value, AstActions then, AstActions otherwise);
AstActions build_loop(Parser *parser, AstActionKind kind, Span span, AstExpr *value, AstActions body);

// `&x`, what fscanf writes to. The function knows which of its arguments those are.
AstExpr *build_reference(Parser *parser, Span span, AstExpr *expr);

AstExprs build_append(Parser *parser, AstExprs list, AstExprs more);
AstActions build_append_actions(Parser *parser, AstActions list, AstActions more);

#endif
