// ast_build.h -- making expression nodes, as every dialect's parser does.
//
// A node that would nest deeper than AST_DEEPEST is reported once and becomes poison.
#ifndef LSYSC_FRONTEND_AST_BUILD_H
#define LSYSC_FRONTEND_AST_BUILD_H

#include "frontend/ast.h"

typedef struct AstBuilder {
  Arena *arena;
  struct Diag *diag;
} AstBuilder;

// Strings are kept, not copied.
AstExpr *ast_number(AstBuilder build, Span span, double number);
AstExpr *ast_string(AstBuilder build, Span span, const char *text);
AstExpr *ast_name(AstBuilder build, Span span, const char *name);
AstExpr *ast_unary(AstBuilder build, Span span, Operator op, AstExpr *a);
AstExpr *ast_binary(AstBuilder build, Operator op, AstExpr *a, AstExpr *b);
AstExpr *ast_choice(AstBuilder build, AstExpr *a, AstExpr *b, AstExpr *c);
AstExpr *ast_call(AstBuilder build, Span span, Span name_span, const char *name, AstExprs args);
AstExpr *ast_index(AstBuilder build, Span span, Span name_span, const char *name, AstExprs args);

// The same expression in parentheses, which span covers.
AstExpr *ast_parenthesized(AstExpr *expr, Span span);

#endif
