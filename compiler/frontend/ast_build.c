// ast_build.c -- expression nodes with their depth.
#include "frontend/ast_build.h"

#include "support/diag.h"

static AstExpr *node(AstBuilder build, AstExprKind kind, Span span) {
  AstExpr *expr = ARENA_NEW(build.arena, AstExpr);
  expr->kind = kind;
  expr->span = span;
  expr->depth = 1;
  return expr;
}

// Takes an operand in. One that was reported poisons the whole, so that it is not reported again.
static void hold(AstExpr *expr, const AstExpr *operand) {
  if (operand->depth >= expr->depth) expr->depth = operand->depth + 1;
  if (operand->kind == AST_POISON) expr->kind = AST_POISON;
}

static AstExpr *checked(AstBuilder build, AstExpr *expr) {
  if (expr->kind != AST_POISON) {
    if (expr->depth <= AST_DEEPEST) return expr;
    diag_error(build.diag, expr->span,
               "this expression is nested too deep; at most %d operators in one another are read", AST_DEEPEST);
  }
  *expr = (AstExpr){.kind = AST_POISON, .span = expr->span, .depth = 1};
  return expr;
}

AstExpr *ast_number(AstBuilder build, Span span, double number) {
  AstExpr *expr = node(build, AST_NUMBER, span);
  expr->number = number;
  return expr;
}

AstExpr *ast_string(AstBuilder build, Span span, const char *text) {
  AstExpr *expr = node(build, AST_STRING, span);
  expr->text = text;
  return expr;
}

AstExpr *ast_name(AstBuilder build, Span span, const char *name) {
  AstExpr *expr = node(build, AST_NAME, span);
  expr->name = name;
  expr->name_span = span;
  return expr;
}

AstExpr *ast_unary(AstBuilder build, Span span, Operator op, AstExpr *a) {
  AstExpr *expr = node(build, AST_UNARY, span);
  expr->op = op;
  expr->a = a;
  hold(expr, a);
  return checked(build, expr);
}

AstExpr *ast_binary(AstBuilder build, Operator op, AstExpr *a, AstExpr *b) {
  AstExpr *expr = node(build, AST_BINARY, span_join(a->span, b->span));
  expr->op = op;
  expr->a = a;
  expr->b = b;
  hold(expr, a);
  hold(expr, b);
  return checked(build, expr);
}

AstExpr *ast_choice(AstBuilder build, AstExpr *a, AstExpr *b, AstExpr *c) {
  AstExpr *expr = node(build, AST_CHOICE, span_join(a->span, c->span));
  expr->a = a;
  expr->b = b;
  expr->c = c;
  hold(expr, a);
  hold(expr, b);
  hold(expr, c);
  return checked(build, expr);
}

static AstExpr *applied(AstBuilder build, AstExprKind kind, Span span, Span name_span, const char *name,
                        AstExprs args) {
  AstExpr *expr = node(build, kind, span);
  expr->name = name;
  expr->name_span = name_span;
  expr->args = args;
  for (size_t i = 0; i < args.count; i++) hold(expr, args.at[i]);
  return checked(build, expr);
}

AstExpr *ast_call(AstBuilder build, Span span, Span name_span, const char *name, AstExprs args) {
  return applied(build, AST_CALL, span, name_span, name, args);
}

AstExpr *ast_index(AstBuilder build, Span span, Span name_span, const char *name, AstExprs args) {
  return applied(build, AST_INDEX, span, name_span, name, args);
}

AstExpr *ast_parenthesized(AstExpr *expr, Span span) {
  expr->parenthesized = true;
  expr->span = span;
  return expr;
}
