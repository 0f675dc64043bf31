// condition.c -- a small evaluator over AST nodes: #if stands before any name is resolved.
#include "frontend/condition.h"

#include "lsys/functions.h"

#include <math.h>
#include <string.h>

enum { DEEPEST_DEFINE = 100, MOST_STEPS = 1000000 };

typedef struct Evaluator {
  Parser *parser;
  const Defines *defines;
  unsigned depth;  // of #defined names in one another
  unsigned steps;  // taken so far: definitions that double each other would never end
  bool failed;     // was reported
} Evaluator;

static double evaluate(Evaluator *e, const AstExpr *expr);

static double fail(Evaluator *e, Span span, const char *format, const char *name) {
  if (!e->failed) diag_error(e->parser->diag, span, format, name);
  e->failed = true;
  return NAN;
}

static double named(Evaluator *e, const AstExpr *expr) {
  if (strcmp(expr->name, "pi") == 0) return M_PI;
  if (strcmp(expr->name, "nan") == 0) return NAN;
  if (strcmp(expr->name, "inf") == 0) return INFINITY;
  Statement *define = trie_find(e->defines, expr->name, strlen(expr->name));
  if (!define) return fail(e, expr->span, "`%s` is not defined here; `#ifdef` asks whether a name is", expr->name);
  parser_ahead(e->parser, define);
  if (define->ast.count == 0) {  // was reported
    e->failed = true;
    return NAN;
  }
  if (define->ast.at[0].has_params)
    return fail(e, expr->span, "`%s` takes arguments: it has no value here", expr->name);
  if (e->depth == DEEPEST_DEFINE) return fail(e, expr->span, "`%s` is defined by itself", expr->name);
  e->depth++;
  double value = evaluate(e, define->ast.at[0].value);
  e->depth--;
  return value;
}

static double call(Evaluator *e, const AstExpr *expr) {
  if (strcmp(expr->name, "defined") != 0 || expr->args.count != 1 || expr->args.at[0]->kind != AST_NAME)
    return fail(e, expr->span, "`%s(...)` cannot stand in a condition; only defined(NAME) can", expr->name);
  const char *name = expr->args.at[0]->name;
  return trie_find(e->defines, name, strlen(name)) != NULL;
}

static double binary(Evaluator *e, const AstExpr *expr) {
  double a = evaluate(e, expr->a);
  if (expr->op == OP_AND) return lsys_holds(a) && lsys_holds(evaluate(e, expr->b));
  if (expr->op == OP_OR) return lsys_holds(a) || lsys_holds(evaluate(e, expr->b));
  double b = evaluate(e, expr->b);
  switch (expr->op) {
  case OP_EQ:
    return a == b;
  case OP_NE:
    return a != b;
  case OP_LT:
    return a < b;
  case OP_LE:
    return a <= b;
  case OP_GT:
    return a > b;
  case OP_GE:
    return a >= b;
  case OP_ADD:
    return a + b;
  case OP_SUB:
    return a - b;
  case OP_MUL:
    return a * b;
  case OP_DIV:
    return a / b;
  case OP_MOD:
    return lsys_mod(a, b);
  default:
    return lsys_pow(a, b);
  }
}

static double evaluate(Evaluator *e, const AstExpr *expr) {
  if (e->failed) return NAN;
  if (++e->steps > MOST_STEPS) return fail(e, expr->span, "%s takes too long to evaluate", "this condition");
  switch (expr->kind) {
  case AST_NUMBER:
    return expr->number;
  case AST_NAME:
    return named(e, expr);
  case AST_UNARY: {
    double a = evaluate(e, expr->a);
    return expr->op == OP_NEG ? -a : !lsys_holds(a);
  }
  case AST_BINARY:
    return binary(e, expr);
  case AST_CHOICE:
    return evaluate(e, lsys_holds(evaluate(e, expr->a)) ? expr->b : expr->c);
  case AST_CALL:
    return call(e, expr);
  case AST_POISON:
    e->failed = true;
    return NAN;
  default:
    return fail(e, expr->span, "%s cannot stand in a condition", "this");
  }
}

bool condition_holds(Parser *parser, const Defines *defines, Statement *statement) {
  const AstExpr *expr = parser_condition(parser, statement);
  Evaluator e = {.parser = parser, .defines = defines};
  return expr && lsys_holds(evaluate(&e, expr));
}
