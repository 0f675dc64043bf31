// expr.c -- questions about checked expressions: is it constant, can it draw,
// are two the same. The checker limits how deep a tree is, so these recurse.
#include "frontend/expr.h"

#include <math.h>
#include <string.h>

// ---- evaluation -----------------------------------------------------------

double expr_unary(Operator op, double x) {
  return op == OP_NOT ? !lsys_holds(x) : -x;
}

double expr_binary(Operator op, double x, double y) {
  switch (op) {
  case OP_OR:
    return lsys_holds(x) || lsys_holds(y);
  case OP_AND:
    return lsys_holds(x) && lsys_holds(y);
  case OP_EQ:
    return x == y;
  case OP_NE:
    return x != y;
  case OP_LT:
    return x < y;
  case OP_LE:
    return x <= y;
  case OP_GT:
    return x > y;
  case OP_GE:
    return x >= y;
  case OP_ADD:
    return x + y;
  case OP_SUB:
    return x - y;
  case OP_MUL:
    return x * y;
  case OP_DIV:
    return x / y;
  case OP_MOD:
    return lsys_mod(x, y);
  case OP_POW:
    return lsys_pow(x, y);
  default:
    return NAN;
  }
}

static double pairwise(double (*function)(double, double), const double *args, uint32_t count) {
  double result = args[0];
  for (uint32_t i = 1; i < count; i++) result = function(result, args[i]);
  return result;
}

double expr_pure(LsysFunction function, const double *args, uint32_t count) {
  switch (function) {
  case LSYS_FN_SIN:
    return lsys_sin(args[0]);
  case LSYS_FN_COS:
    return lsys_cos(args[0]);
  case LSYS_FN_TAN:
    return lsys_tan(args[0]);
  case LSYS_FN_ASIN:
    return lsys_asin(args[0]);
  case LSYS_FN_ACOS:
    return lsys_acos(args[0]);
  case LSYS_FN_ATAN:
    return count == 2 ? lsys_atan2(args[0], args[1]) : lsys_atan(args[0]);
  case LSYS_FN_ATAN2:
    return lsys_atan2(args[0], args[1]);
  case LSYS_FN_SQRT:
    return lsys_sqrt(args[0]);
  case LSYS_FN_EXP:
    return lsys_exp(args[0]);
  case LSYS_FN_LOG:
    return lsys_log(args[0]);
  case LSYS_FN_POW:
    return lsys_pow(args[0], args[1]);
  case LSYS_FN_FABS:
    return lsys_fabs(args[0]);
  case LSYS_FN_ABS:
    return lsys_abs(args[0]);
  case LSYS_FN_FLOOR:
    return lsys_floor(args[0]);
  case LSYS_FN_CEIL:
    return lsys_ceil(args[0]);
  case LSYS_FN_TRUNC:
    return lsys_trunc(args[0]);
  case LSYS_FN_ROUND:
    return lsys_round(args[0]);
  case LSYS_FN_SIGN:
    return lsys_sign(args[0]);
  case LSYS_FN_MIN:
    return pairwise(lsys_min, args, count);
  case LSYS_FN_MAX:
    return pairwise(lsys_max, args, count);
  default:
    return NAN;
  }
}

// ---- constants --------------------------------------------------------------

// values: the program's, NULL if no name may be followed.
static bool constant(const Value *values, const Expr *expr, double *value);

// Only min and max take more than two arguments; they are folded pairwise from the left.
static bool constant_call(const Value *values, const Expr *expr, double *value) {
  double pair[2];
  if (lsys_functions[expr->function].how != LSYS_FN_PURE) return false;
  if (!constant(values, expr->args[0], &pair[0])) return false;
  if (expr->count == 1) return *value = expr_pure(expr->function, pair, 1), true;
  for (uint32_t i = 1; i < expr->count; i++) {
    if (!constant(values, expr->args[i], &pair[1])) return false;
    pair[0] = expr_pure(expr->function, pair, 2);
  }
  return *value = pair[0], true;
}

static bool constant_binary(const Value *values, const Expr *expr, double *value) {
  double x, y;
  if (!constant(values, expr->args[0], &x)) return false;
  bool decided = (expr->op == OP_OR && lsys_holds(x)) || (expr->op == OP_AND && !lsys_holds(x));
  if (decided) return *value = expr->op == OP_OR, true;
  if (!constant(values, expr->args[1], &y)) return false;
  *value = expr_binary(expr->op, x, y);
  return true;
}

static bool constant(const Value *values, const Expr *expr, double *value) {
  double x;
  switch (expr->kind) {
  case EXPR_NUMBER:
    *value = expr->number;
    return true;
  case EXPR_VALUE:
    if (!values || expr->slot < LSYS_SETTING_COUNT || !values[expr->slot - LSYS_SETTING_COUNT].known) return false;
    *value = values[expr->slot - LSYS_SETTING_COUNT].number;
    return true;
  case EXPR_UNARY:
    if (!constant(values, expr->args[0], &x)) return false;
    *value = expr_unary(expr->op, x);
    return true;
  case EXPR_BINARY:
    return constant_binary(values, expr, value);
  case EXPR_CHOICE:
    if (!constant(values, expr->args[0], &x)) return false;
    return constant(values, expr->args[lsys_holds(x) ? 1 : 2], value);
  case EXPR_CALL:
    return constant_call(values, expr, value);
  default:
    return false;
  }
}

bool expr_constant(const Program *program, const Expr *expr, double *value) {
  return constant(program->values, expr, value);
}

bool expr_literal(const Expr *expr, double *value) {
  return constant(NULL, expr, value);
}

Expr *expr_number(Arena *arena, double value, Span span) {
  Expr *expr = ARENA_NEW(arena, Expr);
  *expr = (Expr){.kind = EXPR_NUMBER, .number = value, .span = span};
  return expr;
}

// ---- randomness ---------------------------------------------------------------

bool expr_draws(const Program *program, const Expr *expr) {
  if (!expr) return false;
  if (expr->kind == EXPR_CALL && lsys_functions[expr->function].how == LSYS_FN_RANDOM) return true;
  if (expr->kind == EXPR_APPLY && program->functions[expr->slot].draws) return true;
  for (uint32_t i = 0; i < expr->count; i++)
    if (expr_draws(program, expr->args[i])) return true;
  return false;
}

// ---- identity -------------------------------------------------------------------

bool expr_equal(const Expr *a, const Expr *b) {
  if (a == b) return true;
  if (!a || !b || a->kind != b->kind || a->op != b->op || a->function != b->function || a->slot != b->slot)
    return false;
  if (a->site != b->site || a->count != b->count || memcmp(&a->number, &b->number, sizeof a->number) != 0) return false;
  if (a->kind == EXPR_STRING && strcmp(a->text, b->text) != 0) return false;
  for (uint32_t i = 0; i < a->count; i++)
    if (!expr_equal(a->args[i], b->args[i])) return false;
  return true;
}

static uint64_t mixed(uint64_t hash, uint64_t with) {
  hash = (hash ^ with) * UINT64_C(0x9E3779B97F4A7C15);
  return hash ^ (hash >> 29);
}

uint64_t expr_hash(const Expr *expr) {
  if (!expr) return 1;
  uint64_t number, hash = mixed((uint64_t)expr->kind + 2, (uint64_t)expr->op);
  memcpy(&number, &expr->number, sizeof number);
  hash = mixed(mixed(hash, (uint64_t)expr->function), expr->slot);
  hash = mixed(mixed(hash, expr->site), number);
  for (uint32_t i = 0; i < expr->count; i++) hash = mixed(hash, expr_hash(expr->args[i]));
  return hash;
}

// ---- words --------------------------------------------------------------------------

size_t word_arguments(const Program *program, const Word *word) {
  size_t count = 0;
  for (size_t i = 0; i < word->count; i++) count += program->kinds[word->at[i].kind].arity;
  return count;
}
