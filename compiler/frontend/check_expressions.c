// check_expressions.c -- AstExpr -> Expr: names become slots, calls of random
// functions get their numbers, arithmetic of numbers is done at once.
//
// Expressions are read in file order, so sites count the calls of random
// functions in the order in which they stand in the grammar.
#include "frontend/check.h"

#include <math.h>
#include <string.h>

bool check_deeper(Check *check, Span span) {
  if (check->depth++ < MOST_DEPTH) return true;
  check->depth--;
  if (!check->failed) diag_error(check->diag, span, "nested too deep: more than %d levels", MOST_DEPTH);
  check->failed = true;
  return false;
}

// ---- nodes -------------------------------------------------------------------------

static Expr *node(Check *check, ExprKind kind, Span span) {
  Expr *expr = ARENA_NEW(check->arena, Expr);
  *expr = (Expr){.kind = kind, .span = span};
  return expr;
}

static Expr *number(Check *check, double value, Span span) {
  return expr_number(check->arena, value, span);
}

static Expr *with_operands(Check *check, Expr *expr, uint32_t count, Expr *const *operands) {
  expr->count = count;
  expr->args = arena_array(check->arena, count, sizeof(Expr *));
  for (uint32_t i = 0; i < count; i++) expr->args[i] = operands[i];
  return expr;
}

static bool is_number(const Expr *expr) {
  return expr->kind == EXPR_NUMBER;
}

static bool is_poison(const Check *check, const Expr *const *operands, uint32_t count) {
  for (uint32_t i = 0; i < count; i++)
    if (operands[i] == check->poison) return true;
  return false;
}

// ---- names -----------------------------------------------------------------------------

static void refer(Check *check, uint32_t index, bool function, Span span) {
  if (check->referring) *VEC_PUSH(check->arena, &check->referring->list) = (Reference){index, function, span};
}

static Expr *value_of(Check *check, uint32_t index, Span span) {
  Expr *expr = node(check, EXPR_VALUE, span);
  expr->slot = LSYS_SETTING_COUNT + index;
  refer(check, index, false, span);
  return expr;
}

static Expr *global(Check *check, const Name *name, Span span) {
  if (check->scope.kind != SCOPE_CONSTANT) return value_of(check, name->global, span);
  diag_error(check->diag, span, "`%s` has no value yet: this is evaluated before the derivation begins", name->text);
  diag_note(check->diag, check->values.at[name->global].span, "the variable is assigned here");
  diag_hint(check->diag, "use it in productions, blocks, start words, or in the body of a `#define NAME(x) ...`");
  return check->poison;
}

static Expr *constant_named(Check *check, const Name *name, Span span) {
  if (strcmp(name->text, "pi") == 0) return number(check, M_PI, span);
  if (strcmp(name->text, "nan") == 0) return number(check, NAN, span);
  if (strcmp(name->text, "inf") == 0) return number(check, INFINITY, span);
  return NULL;
}

LsysFunction function_named(const char *name) {
  for (int i = 0; i < LSYS_FN_COUNT; i++)
    if (strcmp(lsys_functions[i].name, name) == 0) return (LsysFunction)i;
  return LSYS_FN_COUNT;
}

static Expr *defined(Check *check, const Name *name, Definition *definition, Span span) {
  definition->used = true;
  if (!definition->function) return value_of(check, definition->index, span);
  diag_error(check->diag, span, "`%s` is a function and needs its arguments: `%s(...)`", name->text, name->text);
  diag_note(check->diag, definition->span, "it is defined here");
  return check->poison;
}

static Expr *named(Check *check, const AstExpr *ast) {
  Name *name = name_intern(check, ast->name);
  Slot *slot = check_bound(check, name);
  if (slot) {
    slot->used = true;
    Expr *expr = node(check, EXPR_PARAMETER, ast->span);
    expr->slot = name->slot;
    return expr;
  }
  if (name->global != NONE) return global(check, name, ast->span);
  if (name->array != NONE) {
    diag_error(check->diag, ast->span, "`%s` is an array and needs an index: `%s[0]`", name->text, name->text);
    return check->poison;
  }
  Definition *definition = name_definition(check, name);
  if (definition) return defined(check, name, definition, ast->span);
  Expr *constant = constant_named(check, name, ast->span);
  if (constant) return constant;
  if (function_named(name->text) != LSYS_FN_COUNT) {
    diag_error(check->diag, ast->span, "`%s` is a function and needs its arguments: `%s(...)`", name->text, name->text);
    return check->poison;
  }
  name_unknown(check, name, ast->span, false);
  return check->poison;
}

// ---- calls ---------------------------------------------------------------------------------

static const char *counted(Check *check, int count, const char *what) {
  return arena_printf(check->arena, "%d %s%s", count, what, count == 1 ? "" : "s");
}

const char *function_arguments(Check *check, const LsysFunctionInfo *info) {
  if (info->most < 0) return arena_printf(check->arena, "at least %s", counted(check, info->least, "argument"));
  if (info->least == info->most) return counted(check, info->least, "argument");
  return arena_printf(check->arena, "%d %s %s", info->least, info->most == info->least + 1 ? "or" : "to",
                      counted(check, info->most, "argument"));
}

Expr **check_arguments(Check *check, const AstExprs *args) {
  Expr **result = arena_array(check->arena, args->count, sizeof(Expr *));
  for (size_t i = 0; i < args->count; i++) result[i] = check_expression(check, args->at[i]);
  return result;
}

static uint32_t next_site(Check *check, Span span) {
  if (++check->sites == MOST_SITES)
    diag_error(check->diag, span, "more than %d calls of random functions", MOST_SITES - 1);
  return check->sites;
}

static Expr *call(Check *check, const AstExpr *ast, LsysFunction function) {
  const LsysFunctionInfo *info = &lsys_functions[function];
  uint32_t site = info->how == LSYS_FN_RANDOM ? next_site(check, ast->name_span) : 0;
  int count = (int)ast->args.count;
  bool file = info->how == LSYS_FN_FILE;
  Expr **args = file ? NULL : check_arguments(check, &ast->args);
  if (file) {
    diag_error(check->diag, ast->span, "`%s` can only be all of what a block assigns: `x = %s(...);`", info->name,
               info->name);
    return check->poison;
  }
  if (info->how == LSYS_FN_EFFECT) {
    diag_error(check->diag, ast->span, "`%s` has no value: it is a statement of a block { ... }", info->name);
    return check->poison;
  }
  if (count < info->least || (info->most >= 0 && count > info->most)) {
    diag_error(check->diag, ast->span, "`%s` takes %s, not %d", info->name, function_arguments(check, info), count);
    return check->poison;
  }
  if (is_poison(check, (const Expr *const *)args, (uint32_t)count)) return check->poison;
  Expr *expr = node(check, EXPR_CALL, ast->span);
  expr->function = function;
  expr->site = site;
  expr->args = args;
  expr->count = (uint32_t)count;
  return expr;
}

static Expr *apply(Check *check, const AstExpr *ast, Definition *definition) {
  definition->used = true;
  Expr **args = check_arguments(check, &ast->args);
  if (!definition->function) {
    diag_error(check->diag, ast->span, "`%s` is a number and takes no arguments", ast->name);
    diag_note(check->diag, definition->span, "it is defined here");
    diag_hint(check->diag, "for a product write `%s*(...)`", ast->name);
    return check->poison;
  }
  const UserFunction *function = &check->functions.at[definition->index];
  if (ast->args.count != function->arity) {
    diag_error(check->diag, ast->span, "`%s` takes %s, not %zu", ast->name,
               counted(check, (int)function->arity, "argument"), ast->args.count);
    diag_note(check->diag, definition->span, "it is defined here");
    return check->poison;
  }
  refer(check, definition->index, true, ast->name_span);
  if (is_poison(check, (const Expr *const *)args, function->arity)) return check->poison;
  Expr *expr = node(check, EXPR_APPLY, ast->span);
  expr->slot = definition->index;
  expr->args = args;
  expr->count = function->arity;
  return expr;
}

static Expr *called(Check *check, const AstExpr *call_ast) {
  const AstExpr *ast = functions_call(check, call_ast);
  if (!ast) return check->poison;
  if (ast->kind == AST_NUMBER) return number(check, ast->number, ast->span);
  Name *name = name_intern(check, ast->name);
  Definition *definition = name_definition(check, name);
  LsysFunction function = function_named(ast->name);
  if (function != LSYS_FN_COUNT) return call(check, ast, function);
  if (check_bound(check, name) || name->global != NONE) {
    diag_error(check->diag, ast->span, "`%s` is a number and takes no arguments", ast->name);
    diag_hint(check->diag, "for a product write `%s*(...)`", ast->name);
  } else if (definition) {
    return apply(check, ast, definition);
  } else {
    name_unknown(check, name, ast->name_span, true);
  }
  check_arguments(check, &ast->args);
  return check->poison;
}

// ---- arrays ---------------------------------------------------------------------------------

static bool index_fits(Check *check, const ArrayEntry *entry, const AstExprs *indices, Span span) {
  if (indices->count == entry->array->sizes.count) return true;
  diag_error(check->diag, span, "`%s` has %s, not %zu", entry->array->name,
             counted(check, (int)entry->array->sizes.count, "index"), indices->count);
  diag_note(check->diag, entry->span, "it is declared here");
  return false;
}

// The number of the array that an AST_INDEX names, NONE after an error; index gets its indices.
uint32_t check_element(Check *check, const AstExpr *ast, Expr ***index) {
  Name *name = name_intern(check, ast->name);
  *index = check_arguments(check, &ast->args);
  if (name->array == NONE) {
    diag_error(check->diag, ast->name_span, "`%s` is not an array", ast->name);
    diag_hint(check->diag, "declare it with `define: { array %s[10]; }`", ast->name);
    return NONE;
  }
  if (!index_fits(check, &check->arrays.at[name->array], &ast->args, ast->span)) return NONE;
  return is_poison(check, (const Expr *const *)*index, (uint32_t)ast->args.count) ? NONE : name->array;
}

static Expr *element(Check *check, const AstExpr *ast) {
  Expr **index;
  uint32_t array = check_element(check, ast, &index);
  if (array == NONE) return check->poison;
  if (check->scope.kind == SCOPE_CONSTANT) {
    diag_error(check->diag, ast->span, "`%s` has no value yet: this is evaluated before the derivation begins",
               ast->name);
    return check->poison;
  }
  Expr *expr = node(check, EXPR_ELEMENT, ast->span);
  expr->slot = array;
  expr->args = index;
  expr->count = (uint32_t)ast->args.count;
  return expr;
}

// ---- operators ----------------------------------------------------------------------------

// A power is arithmetic only where it is so by definition (LANGUAGE.md section 4); elsewhere it is libm's.
static bool is_arithmetic(Operator op, double right) {
  return op != OP_POW || right == 1 || right == 2 || right == 3 || right == 0.5;
}

static Expr *operation(Check *check, const AstExpr *ast, ExprKind kind, const AstExpr *const *parts, uint32_t count) {
  Expr *operands[3];
  for (uint32_t i = 0; i < count; i++) operands[i] = check_expression(check, parts[i]);
  if (is_poison(check, (const Expr *const *)operands, count)) return check->poison;
  Expr *expr = with_operands(check, node(check, kind, ast->span), count, operands);
  expr->op = ast->op;
  if (ast->op == OP_DIV || ast->op == OP_MOD) *VEC_PUSH(check->arena, &check->divisions) = expr;
  if (kind == EXPR_UNARY && is_number(operands[0]))
    return number(check, expr_unary(ast->op, operands[0]->number), ast->span);
  if (kind == EXPR_BINARY && is_number(operands[0]) && is_number(operands[1])
      && is_arithmetic(ast->op, operands[1]->number))
    return number(check, expr_binary(ast->op, operands[0]->number, operands[1]->number), ast->span);
  return expr;
}

static bool is_order(Operator op) {
  return op == OP_LT || op == OP_LE || op == OP_GT || op == OP_GE;
}

// `1 < x < 5` is (1 < x) < 5, which always holds.
static void warn_chain(Check *check, const AstExpr *ast) {
  const AstExpr *left = ast->a;
  if (left->kind != AST_BINARY || left->parenthesized) return;
  if (!(is_order(ast->op) && is_order(left->op)) && !(ast->op == OP_EQ && left->op == OP_EQ)) return;
  diag_warning(check->diag, WARN_COMPARISON, ast->span, "this compares the result of a comparison, which is 0 or 1");
  diag_hint(check->diag, "two comparisons that both hold are joined by `&&`, as in `1 < x && x < 5`");
}

static Expr *expression(Check *check, const AstExpr *ast) {
  switch (ast->kind) {
  case AST_NUMBER:
    return number(check, ast->number, ast->span);
  case AST_NAME:
    return named(check, ast);
  case AST_UNARY:
    return operation(check, ast, EXPR_UNARY, (const AstExpr *[]){ast->a}, 1);
  case AST_BINARY:
    warn_chain(check, ast);
    return operation(check, ast, EXPR_BINARY, (const AstExpr *[]){ast->a, ast->b}, 2);
  case AST_CHOICE:
    return operation(check, ast, EXPR_CHOICE, (const AstExpr *[]){ast->a, ast->b, ast->c}, 3);
  case AST_CALL:
    return called(check, ast);
  case AST_INDEX:
    return element(check, ast);
  case AST_STRING:
    diag_error(check->diag, ast->span,
               "a text in quotes is no number; `printf`, `useTable` and the label `@L` take one");
    return check->poison;
  case AST_POISON:
    return check->poison;
  }
  return check->poison;
}

Expr *check_expression(Check *check, const AstExpr *ast) {
  if (!check_deeper(check, ast->span)) return check->poison;
  Expr *expr = expression(check, ast);
  check->depth--;
  return expr;
}
