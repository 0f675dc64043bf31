// ast_dump.c -- prints an Ast, one statement a line, expressions as prefix
// forms, so that tests can see exactly what was read.
#include "frontend/ast.h"
#include "lsys/settings.h"

#include <stdlib.h>
#include <string.h>

static const char *const operators[OP_COUNT] = {
#define BINARY(id, spelling, precedence, right, doc) [OP_##id] = spelling,
#define UNARY(id, spelling, precedence, doc) [OP_##id] = spelling,
#include "lsys/operators.def"
};

static void dump_number(double number, FILE *out) {
  char text[40];
  if (number > -1e9 && number < 1e9 && number == (double)(int)number) {
    fprintf(out, "%d", (int)number);
    return;
  }
  for (int digits = 1; digits <= 17; digits++) {
    snprintf(text, sizeof text, "%.*g", digits, number);
    if (strtod(text, NULL) == number) break;
  }
  fputs(text, out);
}

static void dump_expr(const AstExpr *expr, FILE *out);

static void dump_exprs(const char *head, const AstExprs *exprs, FILE *out) {
  fprintf(out, "(%s", head);
  for (size_t i = 0; i < exprs->count; i++) {
    fputc(' ', out);
    dump_expr(exprs->at[i], out);
  }
  fputc(')', out);
}

static void dump_expr(const AstExpr *expr, FILE *out) {
  AstExpr *operands[] = {expr->a, expr->b, expr->c};
  AstExprs list = {operands, expr->kind == AST_UNARY ? 1 : expr->kind == AST_BINARY ? 2 : 3, 3};
  switch (expr->kind) {
  case AST_NUMBER:
    dump_number(expr->number, out);
    break;
  case AST_STRING:
    fprintf(out, "\"%s\"", expr->text);
    break;
  case AST_NAME:
    fputs(expr->name, out);
    break;
  case AST_UNARY:
  case AST_BINARY:
    dump_exprs(operators[expr->op], &list, out);
    break;
  case AST_CHOICE:
    dump_exprs("?", &list, out);
    break;
  case AST_CALL:
    dump_exprs(expr->name, &expr->args, out);
    break;
  case AST_INDEX:
    dump_exprs("[]", &expr->args, out), fprintf(out, "@%s", expr->name);
    break;
  case AST_POISON:
    fputs("<poison>", out);
    break;
  }
}

static void dump_word(const char *what, const AstWord *word, FILE *out) {
  fprintf(out, " %s", what);
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    fputc(' ', out);
    if (module->parens)
      dump_exprs(module->symbol, &module->args, out);
    else
      fputs(module->symbol, out);
  }
}

static void dump_labelled(const char *what, const AstExpr *expr, FILE *out) {
  if (!expr) return;
  fprintf(out, " %s ", what);
  dump_expr(expr, out);
}

static void dump_actions(const char *what, const AstActions *actions, FILE *out) {
  static const char *const kinds[] = {"=", "if", "while", "do", "eval"};
  fprintf(out, " %s {", what);
  for (size_t i = 0; i < actions->count; i++) {
    const AstAction *a = actions->at[i];
    fprintf(out, " (%s", kinds[a->kind]);
    dump_labelled("target", a->target, out);
    dump_labelled("value", a->value, out);
    if (a->then.count) dump_actions("then", &a->then, out);
    if (a->otherwise.count) dump_actions("else", &a->otherwise, out);
    fputc(')', out);
  }
  fputs(" }", out);
}

static void dump_production(const AstProduction *p, FILE *out) {
  if (p->label) fprintf(out, " label %s", p->label);
  if (p->left.span.end) dump_word("left", &p->left, out);
  dump_word("strict", &p->strict, out);
  if (p->right.span.end) dump_word("right", &p->right, out);
  if (p->has_before) dump_actions("before", &p->before, out);
  dump_labelled("guard", p->guard, out);
  if (p->has_after) dump_actions("after", &p->after, out);
  dump_word("successor", &p->successor, out);
  dump_labelled("weight", p->weight, out);
}

static void dump_array(const AstArray *array, FILE *out) {
  fprintf(out, " %s ", array->name);
  dump_exprs("sizes", &array->sizes, out);
  if (array->values.count) fputc(' ', out), dump_exprs("values", &array->values, out);
}

static void dump_statement(const AstStatement *s, FILE *out) {
  static const char *const kinds[] = {
    "axiom",       "production", "define", "undef",         "param",        "modules",     "setting",  "ignore",
    "consider",    "block",      "arrays", "decomposition", "homomorphism", "productions", "warnings", "maximum-depth",
    "seed",        "table",      "tables", "ring",          "lsystem",      "endlsystem",  "surface",  "colours",
    "environment", "function",   "curve",  "contour",       "page"};
  fputs(kinds[s->kind], out);
  if (s->kind == AST_PAGE) fprintf(out, " %s", lsys_page_settings[s->setting].keyword);
  if (s->kind == AST_SETTING)
    fprintf(out, " %s", lsys_settings[s->setting].keyword);
  else if (s->name)
    fprintf(out, " %s", s->name);
  if (s->has_params) fputs(" parameters", out);
  for (size_t i = 0; i < s->symbols.count; i++) fprintf(out, " %s", s->symbols.at[i].name);
  for (size_t i = 0; i < s->words.count; i++) dump_word("word", &s->words.at[i], out);
  if (s->production) dump_production(s->production, out);
  dump_labelled("value", s->value, out);
  dump_labelled("low", s->low, out);
  dump_labelled("high", s->high, out);
  if (s->kind == AST_BLOCK) dump_actions("actions", &s->actions, out);
  for (size_t i = 0; i < s->arrays.count; i++) dump_array(&s->arrays.at[i], out);
  fputc('\n', out);
}

void ast_dump(const Ast *ast, FILE *out) {
  for (size_t i = 0; i < ast->statements.count; i++) dump_statement(&ast->statements.at[i], out);
}
