// evaluate.c -- expressions and blocks, evaluated strictly as written.
// Requires: a checked Program: every slot exists. Ensures: the frames are as
// before the call. Draws are the functions of LANGUAGE.md 5.8: no state but
// the counts of evaluations.
#include "interp/evaluate.h"

#include "interp/word.h"

#include <stdlib.h>

// Deeper nesting of calls and operands ends the run: the stack has an end.
enum { DEEPEST = 5000 };

Scope scope_create(Arena *arena, const Program *program) {
  return (Scope){.program = program, .table = -1, .site = arena_array(arena, program->sites + 1u, sizeof(SiteCount))};
}

void scope_free(Scope *scope) {
  free(scope->slot);
  scope->slot = NULL;
  scope->slots = scope->slot_capacity = 0;
}

void scope_start(Scope *scope, uint64_t key) {
  scope->key = key;
  scope->rewriting++;
  scope->slots = scope->base = 0;
  scope->nested = 0;
}

static void push_slot(Scope *scope, double value) {
  BOXES_RESERVE(scope->run, scope->slot, scope->slots, scope->slot_capacity);
  scope->slot[scope->slots++] = value;
}

void scope_push(Scope *scope, size_t count) {
  scope->base = scope->slots;
  for (size_t i = 0; i < count; i++) push_slot(scope, 0);
}

void scope_pop(Scope *scope) {
  scope->slots = scope->base;
}

static double unary(Operator op, double x) {
  switch (op) {
  case OP_NEG:
    return -x;
  case OP_NOT:
    return !lsys_holds(x);
  default:
    abort();
  }
}

static double binary(Operator op, double x, double y) {
  switch (op) {
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
    abort();
  }
}

static double evaluate_binary(Scope *scope, const Expr *expr) {
  double x = evaluate(scope, expr->args[0]);
  if (expr->op == OP_AND) return lsys_holds(x) && evaluate_holds(scope, expr->args[1]);
  if (expr->op == OP_OR) return lsys_holds(x) || evaluate_holds(scope, expr->args[1]);
  return binary(expr->op, x, evaluate(scope, expr->args[1]));
}

// The number of this call's draw: its site and how often that was evaluated before.
static uint64_t draw_number(Scope *scope, uint32_t site) {
  SiteCount *count = &scope->site[site];
  if (count->rewriting != scope->rewriting) *count = (SiteCount){scope->rewriting, 0};
  return site + (count->evaluations++ << LSYS_SITE_BITS);
}

static double random_call(Scope *scope, const Expr *expr, double x, double y) {
  uint64_t number = draw_number(scope, expr->site);
  switch (expr->function) {
  case LSYS_FN_RAN:
    return lsys_ran(scope->key, number, x);
  case LSYS_FN_NRAN:
    return lsys_nran(scope->key, number, x, y);
  case LSYS_FN_BRAN:
    return lsys_bran(scope->key, number, x, y);
  case LSYS_FN_BIRAN:
    return lsys_biran(scope->key, number, x, y);
  default:
    abort();
  }
}

// min and max of any number of arguments, pairwise from the left.
static double fold(Scope *scope, const Expr *expr, double (*combine)(double, double)) {
  double result = evaluate(scope, expr->args[0]);
  for (uint32_t i = 1; i < expr->count; i++) result = combine(result, evaluate(scope, expr->args[i]));
  return result;
}

// printf(format, ...), fprintf(file, format, ...): values stand on the frames' stack while they are collected.
static void print(Scope *scope, const Expr *expr) {
  bool to_file = expr->function == LSYS_FN_FPRINTF;
  double file = to_file ? evaluate(scope, expr->args[0]) : 0;
  const char *format = expr->args[to_file]->text;
  size_t first = scope->slots;
  for (uint32_t i = 1 + to_file; i < expr->count; i++) {
    double value = evaluate(scope, expr->args[i]);
    push_slot(scope, value);
  }
  if (to_file)
    lsys_print_to(scope->run, file, format, scope->slot + first, expr->count - 2);
  else
    lsys_print(scope->run, format, scope->slot + first, expr->count - 1);
  scope->slots = first;
}

static double call(Scope *scope, const Expr *expr) {
  if (expr->function == LSYS_FN_MIN) return fold(scope, expr, lsys_min);
  if (expr->function == LSYS_FN_MAX) return fold(scope, expr, lsys_max);
  if (expr->function == LSYS_FN_PRINTF || expr->function == LSYS_FN_FPRINTF) return print(scope, expr), 0;
  if (expr->function == LSYS_FN_FOPEN) return lsys_fopen(scope->run, expr->args[0]->text, expr->args[1]->text);
  double x = expr->count > 0 ? evaluate(scope, expr->args[0]) : 0;
  double y = expr->count > 1 ? evaluate(scope, expr->args[1]) : 0;
  switch (expr->function) {
  case LSYS_FN_SIN:
    return lsys_sin(x);
  case LSYS_FN_COS:
    return lsys_cos(x);
  case LSYS_FN_TAN:
    return lsys_tan(x);
  case LSYS_FN_ASIN:
    return lsys_asin(x);
  case LSYS_FN_ACOS:
    return lsys_acos(x);
  case LSYS_FN_ATAN:
    return expr->count == 2 ? lsys_atan2(x, y) : lsys_atan(x);
  case LSYS_FN_ATAN2:
    return lsys_atan2(x, y);
  case LSYS_FN_SQRT:
    return lsys_sqrt(x);
  case LSYS_FN_EXP:
    return lsys_exp(x);
  case LSYS_FN_LOG:
    return lsys_log(x);
  case LSYS_FN_POW:
    return lsys_pow(x, y);
  case LSYS_FN_FABS:
    return lsys_fabs(x);
  case LSYS_FN_ABS:
    return lsys_abs(x);
  case LSYS_FN_FLOOR:
    return lsys_floor(x);
  case LSYS_FN_CEIL:
    return lsys_ceil(x);
  case LSYS_FN_TRUNC:
    return lsys_trunc(x);
  case LSYS_FN_ROUND:
    return lsys_round(x);
  case LSYS_FN_SIGN:
    return lsys_sign(x);
  case LSYS_FN_FCLOSE:
    lsys_fclose(scope->run, x);
    return 0;
  case LSYS_FN_FSCANF:
    return lsys_fscanf(scope->run, x);
  case LSYS_FN_STOP:
    scope->stopped |= expr->count == 0 || lsys_holds(x);
    return 0;
  default:
    return random_call(scope, expr, x, y);
  }
}

// A user function: its arguments become a frame on top, its body sees only them.
static double apply(Scope *scope, const Expr *expr) {
  size_t caller = scope->base, frame = scope->slots;
  for (uint32_t i = 0; i < expr->count; i++) {
    double value = evaluate(scope, expr->args[i]);
    push_slot(scope, value);
  }
  scope->base = frame;
  double value = evaluate(scope, scope->program->functions[expr->slot].body);
  scope->base = caller;
  scope->slots = frame;
  return value;
}

// The place of an array's element in the run's values, row by row.
static size_t element(Scope *scope, uint32_t array_number, Expr *const *index, uint32_t count) {
  const Array *array = &scope->program->arrays[array_number];
  size_t place = 0;
  for (uint32_t d = 0; d < count; d++) {
    double i = lsys_trunc(evaluate(scope, index[d]));
    if (!(i >= 0 && i < array->sizes[d])) {
      lsys_fail(scope->run, "array %s: index %.17g is not in 0..%u", array->name, i, array->sizes[d] - 1);
    }
    place = place * array->sizes[d] + (size_t)i;
  }
  return array->slot + place;
}

double evaluate(Scope *scope, const Expr *expr) {
  if (++scope->nested > DEEPEST) lsys_fail(scope->run, "an expression is nested more than %d levels deep", DEEPEST);
  double value = 0;
  switch (expr->kind) {
  case EXPR_NUMBER:
    value = expr->number;
    break;
  case EXPR_PARAMETER:
    value = scope->slot[scope->base + expr->slot];
    break;
  case EXPR_VALUE:
    value = scope->run->value[expr->slot];
    break;
  case EXPR_ELEMENT:
    value = scope->run->value[element(scope, expr->slot, expr->args, expr->count)];
    break;
  case EXPR_UNARY:
    value = unary(expr->op, evaluate(scope, expr->args[0]));
    break;
  case EXPR_BINARY:
    value = evaluate_binary(scope, expr);
    break;
  case EXPR_CHOICE:
    value = evaluate(scope, expr->args[evaluate_holds(scope, expr->args[0]) ? 1 : 2]);
    break;
  case EXPR_CALL:
    value = call(scope, expr);
    break;
  case EXPR_APPLY:
    value = apply(scope, expr);
    break;
  case EXPR_STRING:
    break;
  }
  scope->nested--;
  return value;
}

bool evaluate_holds(Scope *scope, const Expr *expr) {
  return lsys_holds(evaluate(scope, expr));
}

static void execute_one(Scope *scope, const Action *action) {
  switch (action->kind) {
  case ACTION_SET_LOCAL: {
    double value = evaluate(scope, action->value);
    scope->slot[scope->base + action->slot] = value;
    break;
  }
  case ACTION_SET_VALUE:
    scope->run->value[action->slot] = evaluate(scope, action->value);
    break;
  case ACTION_SET_ELEMENT: {
    size_t place = element(scope, action->slot, action->index, action->index_count);
    scope->run->value[place] = evaluate(scope, action->value);
    break;
  }
  case ACTION_IF:
    execute(scope, evaluate_holds(scope, action->value) ? &action->then : &action->otherwise);
    break;
  case ACTION_WHILE:
    while (evaluate_holds(scope, action->value)) execute(scope, &action->then);
    break;
  case ACTION_DO:
    do execute(scope, &action->then);
    while (evaluate_holds(scope, action->value));
    break;
  case ACTION_EVALUATE:
    evaluate(scope, action->value);
    break;
  case ACTION_USE_TABLE:
    scope->table = action->slot;
    break;
  }
}

void execute(Scope *scope, const Actions *actions) {
  for (size_t i = 0; i < actions->count; i++) execute_one(scope, &actions->at[i]);
}
