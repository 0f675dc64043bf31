// expr.c -- expression trees -> instructions, in the order and association written.
//
// Arithmetic, comparison, sqrt and rounding are IEEE instructions without
// fast-math flags; everything else calls the run time's own function, whose
// name LLVM does not know and so never folds. A condition is an i1 as long as
// it can be: comparisons and the lazy operators make no doubles.
#include "codegen/ir.h"

#include <math.h>
#include <string.h>

LLVMValueRef expr_holds(Ir *ir, LLVMValueRef value) {
  return LLVMBuildFCmp(ir->builder, LLVMRealONE, value, ir_double(ir, 0), "");  // ordered: nan does not hold
}

static LLVMValueRef truth(Ir *ir, LLVMValueRef test) {
  return LLVMBuildSelect(ir->builder, test, ir_double(ir, 1), ir_double(ir, 0), "");
}

bool expr_cheap(const Expr *expr, unsigned *budget) {
  enum { DIVISION = 8 };
  if (expr->kind == EXPR_CALL || expr->kind == EXPR_APPLY || expr->kind == EXPR_ELEMENT || expr->kind == EXPR_STRING)
    return false;
  bool operates = expr->kind == EXPR_BINARY;
  if (operates && (expr->op == OP_MOD || expr->op == OP_POW)) return false;
  unsigned cost = operates && expr->op == OP_DIV ? DIVISION : 1;
  if (*budget < cost) return false;
  *budget -= cost;
  for (uint32_t i = 0; i < expr->count; i++)
    if (!expr_cheap(expr->args[i], budget)) return false;
  return true;
}

// Less than a branch costs.
static bool is_cheap(const Expr *expr) {
  unsigned budget = 6;
  return expr_cheap(expr, &budget);
}

// ---- values of the run -------------------------------------------------------

LLVMValueRef expr_value_address(Scope *scope, uint32_t slot) {
  Ir *ir = scope->ir;
  LLVMValueRef values = ir_load(ir, ir->types.ptr, scope->run, ir->types.run, RUN_VALUE);
  ir_mark_invariant(ir, values);
  return ir_advance(ir, ir->types.f64, values, ir_int(ir, slot));
}

static bool is_global(const Program *program, uint32_t slot) {
  return slot >= LSYS_SETTING_COUNT && program->values[slot - LSYS_SETTING_COUNT].kind == VALUE_GLOBAL;
}

static LLVMValueRef run_value(Scope *scope, uint32_t slot) {
  Ir *ir = scope->ir;
  const Program *program = ir->program;
  if (slot >= LSYS_SETTING_COUNT && program->values[slot - LSYS_SETTING_COUNT].known)
    return ir_double(ir, program->values[slot - LSYS_SETTING_COUNT].number);
  LLVMValueRef load = LLVMBuildLoad2(ir->builder, ir->types.f64, expr_value_address(scope, slot), "");
  if (scope->constant_values && !is_global(program, slot)) ir_mark_invariant(ir, load);
  return load;
}

// An index counts if it is a whole number in the dimension; anything else ends the run.
static LLVMValueRef checked_index(Scope *scope, const Array *array, LLVMValueRef index, uint32_t size) {
  Ir *ir = scope->ir;
  LLVMBuilderRef b = ir->builder;
  LLVMValueRef low = LLVMBuildFCmp(b, LLVMRealOGT, index, ir_double(ir, -1), "");
  LLVMValueRef high = LLVMBuildFCmp(b, LLVMRealOLT, index, ir_double(ir, size), "");
  LLVMBasicBlockRef good = ir_block(ir, "index.good"), bad = ir_block(ir, "index.bad");
  ir_branch(ir, LLVMBuildAnd(b, low, high, ""), good, bad);
  ir_at(ir, bad);
  LLVMValueRef format = ir_data(ir,
                                LLVMConstStringInContext2(ir->context, "%s: index %g is not in 0..%g",
                                                          strlen("%s: index %g is not in 0..%g"), false),
                                "format");
  LLVMValueRef name =
    ir_data(ir, LLVMConstStringInContext2(ir->context, array->name, strlen(array->name), false), "name");
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr};
  LLVMValueRef fail = LLVMGetNamedFunction(ir->module, "lsys_fail");
  if (!fail) fail = LLVMAddFunction(ir->module, "lsys_fail", LLVMFunctionType(ir->types.none, types, 2, true));
  ir_call(ir, fail, (LLVMValueRef[]){scope->run, format, name, index, ir_double(ir, size - 1.0)}, 5);
  LLVMBuildUnreachable(b);
  ir_at(ir, good);
  return LLVMBuildFPToUI(b, LLVMBuildFAdd(b, index, ir_double(ir, 0), ""), ir->types.i64, "");
}

LLVMValueRef expr_element_address(Scope *scope, uint32_t number, Expr *const *index, uint32_t count) {
  Ir *ir = scope->ir;
  const Array *array = &ir->program->arrays[number];
  LLVMValueRef at = ir_int(ir, 0);
  for (uint32_t d = 0; d < count; d++) {
    LLVMValueRef i = checked_index(scope, array, expr_value(scope, index[d]), array->sizes[d]);
    at = LLVMBuildAdd(ir->builder, LLVMBuildMul(ir->builder, at, ir_int(ir, array->sizes[d]), ""), i, "");
  }
  return ir_advance(ir, ir->types.f64, expr_value_address(scope, array->slot), at);
}

// ---- calls -------------------------------------------------------------------

#define MOST_ARGUMENTS 8

static LLVMValueRef call_pure(Ir *ir, const char *name, LLVMValueRef *args, unsigned count) {
  char symbol[32] = "lsys_";
  strncat(symbol, name, sizeof symbol - strlen(symbol) - 1);
  LLVMTypeRef types[MOST_ARGUMENTS];
  for (unsigned i = 0; i < count; i++) types[i] = ir->types.f64;
  return ir_call(ir, ir_runtime(ir, symbol, ir->types.f64, types, count, IR_PURE), args, count);
}

static LLVMValueRef call_intrinsic(Ir *ir, const char *name, LLVMValueRef *args, unsigned count) {
  return ir_call(ir, ir_intrinsic(ir, name, ir->types.f64), args, count);
}

// lsys_min and lsys_max: the first nan, else the lesser; equal values keep the first.
static LLVMValueRef extreme(Ir *ir, LLVMRealPredicate beats, LLVMValueRef x, LLVMValueRef y) {
  LLVMBuilderRef b = ir->builder;
  LLVMValueRef nan = LLVMBuildFCmp(b, LLVMRealUNO, y, y, "");
  LLVMValueRef other = LLVMBuildSelect(b, LLVMBuildOr(b, nan, LLVMBuildFCmp(b, beats, y, x, ""), ""), y, x, "");
  return LLVMBuildSelect(b, LLVMBuildFCmp(b, LLVMRealUNO, x, x, ""), x, other, "");
}

static LLVMValueRef call_function(Ir *ir, LsysFunction function, LLVMValueRef *args, unsigned count) {
  LLVMValueRef value = args[0];
  switch (function) {
  case LSYS_FN_SQRT:
    return call_intrinsic(ir, "llvm.sqrt", args, 1);
  case LSYS_FN_FABS:
  case LSYS_FN_ABS:
    return call_intrinsic(ir, "llvm.fabs", args, 1);
  case LSYS_FN_FLOOR:
    return call_intrinsic(ir, "llvm.floor", args, 1);
  case LSYS_FN_CEIL:
    return call_intrinsic(ir, "llvm.ceil", args, 1);
  case LSYS_FN_TRUNC:
    return call_intrinsic(ir, "llvm.trunc", args, 1);
  case LSYS_FN_MIN:
    for (unsigned i = 1; i < count; i++) value = extreme(ir, LLVMRealOLT, value, args[i]);
    return value;
  case LSYS_FN_MAX:
    for (unsigned i = 1; i < count; i++) value = extreme(ir, LLVMRealOGT, value, args[i]);
    return value;
  case LSYS_FN_ATAN:
    return call_pure(ir, count == 2 ? "atan2" : "atan", args, count);
  default:
    return call_pure(ir, lsys_functions[function].name, args, count);
  }
}

// site + (repetition << LSYS_SITE_BITS); counts the repetition where the site can have one.
static LLVMValueRef draw_number(Scope *scope, uint32_t site) {
  Ir *ir = scope->ir;
  uint32_t counter = ir->counter[site];
  if (counter == NO_COUNTER) return ir_int(ir, site);
  LLVMValueRef address = ir_advance(ir, ir->types.i64, scope->counters, ir_int(ir, counter));
  LLVMValueRef repetition = LLVMBuildLoad2(ir->builder, ir->types.i64, address, "repetition");
  LLVMBuildStore(ir->builder, LLVMBuildAdd(ir->builder, repetition, ir_int(ir, 1), ""), address);
  LLVMValueRef shifted = LLVMBuildShl(ir->builder, repetition, ir_int(ir, LSYS_SITE_BITS), "");
  return LLVMBuildAdd(ir->builder, shifted, ir_int(ir, site), "");
}

static LLVMValueRef call_random(Scope *scope, const Expr *expr, LLVMValueRef *args) {
  Ir *ir = scope->ir;
  LLVMValueRef number = draw_number(scope, expr->site);
  if (expr->function == LSYS_FN_RAN) return LLVMBuildFMul(ir->builder, args[0], key_draw(ir, scope->key, number), "");
  LLVMTypeRef types[MOST_ARGUMENTS + 2] = {ir->types.i64, ir->types.i64};
  LLVMValueRef all[MOST_ARGUMENTS + 2] = {scope->key, number};
  for (uint32_t i = 0; i < expr->count; i++) {
    types[i + 2] = ir->types.f64;
    all[i + 2] = args[i];
  }
  char symbol[32] = "lsys_";
  strncat(symbol, lsys_functions[expr->function].name, sizeof symbol - strlen(symbol) - 1);
  LLVMValueRef function = ir_runtime(ir, symbol, ir->types.f64, types, expr->count + 2, IR_PURE);
  return ir_call(ir, function, all, expr->count + 2);
}

static LLVMValueRef literal(Ir *ir, const char *text) {
  return ir_data(ir, LLVMConstStringInContext2(ir->context, text, strlen(text), false), "text");
}

// printf(format, values...), fprintf(file, format, values...): the values in a row.
static LLVMValueRef call_printf(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  bool to_file = expr->function == LSYS_FN_FPRINTF;
  uint32_t first = to_file ? 2 : 1, count = expr->count - first;
  LLVMValueRef file = to_file ? expr_value(scope, expr->args[0]) : NULL;
  LLVMValueRef values = ir_local(ir, ir->types.f64, count + 1, "printed");
  for (uint32_t i = 0; i < count; i++)
    LLVMBuildStore(ir->builder, expr_value(scope, expr->args[first + i]),
                   ir_advance(ir, ir->types.f64, values, ir_int(ir, i)));
  LLVMValueRef format = literal(ir, expr->args[first - 1]->text);
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.f64, ir->types.ptr, ir->types.ptr, ir->types.i32};
  LLVMValueRef args[] = {scope->run, file, format, values, LLVMConstInt(ir->types.i32, count, false)};
  if (to_file) {
    ir_call(ir, ir_runtime(ir, "lsys_print_to", ir->types.none, types, 5, IR_ANY), args, 5);
  } else {
    types[1] = types[0];
    args[1] = args[0];
    ir_call(ir, ir_runtime(ir, "lsys_print", ir->types.none, types + 1, 4, IR_ANY), args + 1, 4);
  }
  return ir_double(ir, 0);
}

static LLVMValueRef call_fopen(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr, ir->types.ptr};
  LLVMValueRef args[] = {scope->run, literal(ir, expr->args[0]->text), literal(ir, expr->args[1]->text)};
  return ir_call(ir, ir_runtime(ir, "lsys_fopen", ir->types.f64, types, 3, IR_ANY), args, 3);
}

// fclose(f), fscanf(f)
static LLVMValueRef call_file(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  bool reads = expr->function == LSYS_FN_FSCANF;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.f64};
  LLVMValueRef args[] = {scope->run, expr_value(scope, expr->args[0])};
  LLVMValueRef function =
    ir_runtime(ir, reads ? "lsys_fscanf" : "lsys_fclose", reads ? ir->types.f64 : ir->types.none, types, 2, IR_ANY);
  LLVMValueRef value = ir_call(ir, function, args, 2);
  return reads ? value : ir_double(ir, 0);
}

// stop(), stop(n): n is any value that holds.
static LLVMValueRef call_stop(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  LLVMValueRef holds = expr->count ? expr_test(scope, expr->args[0]) : LLVMConstInt(ir->types.i1, 1, false);
  LLVMValueRef before = ir_load(ir, ir->types.i64, scope->run, ir->types.run, RUN_STOPPED);
  LLVMValueRef now = LLVMBuildOr(ir->builder, before, LLVMBuildZExt(ir->builder, holds, ir->types.i64, ""), "");
  ir_store(ir, now, scope->run, ir->types.run, RUN_STOPPED);
  return ir_double(ir, 0);
}

static LLVMValueRef call(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  double number;
  if (expr->function == LSYS_FN_PRINTF || expr->function == LSYS_FN_FPRINTF) return call_printf(scope, expr);
  if (expr->function == LSYS_FN_FOPEN) return call_fopen(scope, expr);
  if (expr->function == LSYS_FN_FCLOSE || expr->function == LSYS_FN_FSCANF) return call_file(scope, expr);
  if (expr->function == LSYS_FN_STOP) return call_stop(scope, expr);
  if (expr_constant(ir->program, expr, &number)) return ir_double(ir, number);
  LLVMValueRef *args = arena_array(ir->arena, expr->count, sizeof *args);
  for (uint32_t i = 0; i < expr->count; i++) args[i] = expr_value(scope, expr->args[i]);
  if (lsys_functions[expr->function].how == LSYS_FN_RANDOM) return call_random(scope, expr, args);
  return call_function(ir, expr->function, args, expr->count);
}

static LLVMValueRef apply(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  const UserFunction *function = &ir->program->functions[expr->slot];
  LLVMValueRef *args = arena_array(ir->arena, expr->count + 3, sizeof *args);
  unsigned n = 0;
  args[n++] = scope->run;
  if (function->draws) {
    args[n++] = scope->key;
    args[n++] = scope->counters;
  }
  for (uint32_t i = 0; i < expr->count; i++) args[n++] = expr_value(scope, expr->args[i]);
  return ir_call(ir, ir->functions[expr->slot], args, n);
}

// ---- operators ---------------------------------------------------------------

static LLVMValueRef power(Ir *ir, LLVMValueRef x, LLVMValueRef y) {
  double exponent = NAN;
  ir_is_double(y, &exponent);
  if (exponent == 1) return x;
  if (exponent == 0.5) return call_intrinsic(ir, "llvm.sqrt", &x, 1);
  if (exponent == 2 || exponent == 3) {
    LLVMValueRef square = LLVMBuildFMul(ir->builder, x, x, "");
    return exponent == 2 ? square : LLVMBuildFMul(ir->builder, square, x, "");
  }
  return call_pure(ir, "pow", (LLVMValueRef[]){x, y}, 2);
}

static bool comparison(Operator op, LLVMRealPredicate *predicate) {
  switch (op) {
  case OP_EQ:
    *predicate = LLVMRealOEQ;
    return true;
  case OP_NE:
    *predicate = LLVMRealUNE;
    return true;
  case OP_LT:
    *predicate = LLVMRealOLT;
    return true;
  case OP_LE:
    *predicate = LLVMRealOLE;
    return true;
  case OP_GT:
    *predicate = LLVMRealOGT;
    return true;
  case OP_GE:
    *predicate = LLVMRealOGE;
    return true;
  default:
    return false;
  }
}

static LLVMValueRef arithmetic(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  LLVMBuilderRef b = ir->builder;
  double number;
  if ((expr->op == OP_POW || expr->op == OP_MOD) && expr_constant(ir->program, expr, &number))
    return ir_double(ir, number);
  LLVMValueRef x = expr_value(scope, expr->args[0]), y = expr_value(scope, expr->args[1]);
  switch (expr->op) {
  case OP_ADD:
    return LLVMBuildFAdd(b, x, y, "");
  case OP_SUB:
    return LLVMBuildFSub(b, x, y, "");
  case OP_MUL:
    return LLVMBuildFMul(b, x, y, "");
  case OP_DIV:
    return LLVMBuildFDiv(b, x, y, "");
  case OP_MOD:
    return call_pure(ir, "mod", (LLVMValueRef[]){x, y}, 2);
  default:
    return power(ir, x, y);
  }
}

// Joins a value made in this block with `here`'s: the two ways into block `join`.
static LLVMValueRef joined(Ir *ir, LLVMTypeRef type, LLVMValueRef a, LLVMBasicBlockRef from_a, LLVMValueRef b,
                           LLVMBasicBlockRef from_b) {
  LLVMValueRef phi = LLVMBuildPhi(ir->builder, type, "");
  LLVMAddIncoming(phi, (LLVMValueRef[]){a, b}, (LLVMBasicBlockRef[]){from_a, from_b}, 2);
  return phi;
}

static LLVMValueRef lazy(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  bool and = expr->op == OP_AND;
  LLVMValueRef left = expr_test(scope, expr->args[0]);
  if (is_cheap(expr->args[1])) {
    LLVMValueRef right = expr_test(scope, expr->args[1]);
    return and? LLVMBuildAnd(ir->builder, left, right, "") : LLVMBuildOr(ir->builder, left, right, "");
  }
  LLVMBasicBlockRef from_left = LLVMGetInsertBlock(ir->builder);
  LLVMBasicBlockRef more = ir_block(ir, "lazy"), join = ir_block(ir, "joined");
  ir_branch(ir, left, and? more : join, and? join : more);
  ir_at(ir, more);
  LLVMValueRef right = expr_test(scope, expr->args[1]);
  LLVMBasicBlockRef from_right = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, join);
  ir_at(ir, join);
  LLVMValueRef known = LLVMConstInt(ir->types.i1, !and, false);
  return joined(ir, ir->types.i1, known, from_left, right, from_right);
}

static LLVMValueRef choice(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  LLVMValueRef test = expr_test(scope, expr->args[0]);
  if (is_cheap(expr->args[1]) && is_cheap(expr->args[2])) {
    LLVMValueRef yes = expr_value(scope, expr->args[1]), no = expr_value(scope, expr->args[2]);
    return LLVMBuildSelect(ir->builder, test, yes, no, "");
  }
  LLVMBasicBlockRef then = ir_block(ir, "then"), otherwise = ir_block(ir, "else"), join = ir_block(ir, "joined");
  ir_branch(ir, test, then, otherwise);
  ir_at(ir, then);
  LLVMValueRef yes = expr_value(scope, expr->args[1]);
  LLVMBasicBlockRef from_yes = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, join);
  ir_at(ir, otherwise);
  LLVMValueRef no = expr_value(scope, expr->args[2]);
  LLVMBasicBlockRef from_no = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, join);
  ir_at(ir, join);
  return joined(ir, ir->types.f64, yes, from_yes, no, from_no);
}

LLVMValueRef expr_test(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  LLVMRealPredicate predicate;
  if (expr->kind == EXPR_UNARY && expr->op == OP_NOT)
    return LLVMBuildNot(ir->builder, expr_test(scope, expr->args[0]), "");
  if (expr->kind == EXPR_BINARY && (expr->op == OP_AND || expr->op == OP_OR)) return lazy(scope, expr);
  if (expr->kind == EXPR_BINARY && comparison(expr->op, &predicate)) {
    LLVMValueRef x = expr_value(scope, expr->args[0]), y = expr_value(scope, expr->args[1]);
    return LLVMBuildFCmp(ir->builder, predicate, x, y, "");
  }
  return expr_holds(ir, expr_value(scope, expr));
}

static bool is_test(const Expr *expr) {
  LLVMRealPredicate predicate;
  if (expr->kind == EXPR_UNARY) return expr->op == OP_NOT;
  return expr->kind == EXPR_BINARY && (expr->op == OP_AND || expr->op == OP_OR || comparison(expr->op, &predicate));
}

static LLVMValueRef parameter(Scope *scope, uint32_t slot) {
  const Slot *at = &scope->slots[slot];
  if (!at->address) return at->value;
  return LLVMBuildLoad2(scope->ir->builder, scope->ir->types.f64, at->address, "");
}

LLVMValueRef expr_value(Scope *scope, const Expr *expr) {
  Ir *ir = scope->ir;
  if (is_test(expr)) return truth(ir, expr_test(scope, expr));
  switch (expr->kind) {
  case EXPR_NUMBER:
    return ir_double(ir, expr->number);
  case EXPR_PARAMETER:
    return parameter(scope, expr->slot);
  case EXPR_VALUE:
    return run_value(scope, expr->slot);
  case EXPR_ELEMENT: {
    LLVMValueRef address = expr_element_address(scope, expr->slot, expr->args, expr->count);
    return LLVMBuildLoad2(ir->builder, ir->types.f64, address, "");
  }
  case EXPR_UNARY:
    return LLVMBuildFNeg(ir->builder, expr_value(scope, expr->args[0]), "");
  case EXPR_BINARY:
    return arithmetic(scope, expr);
  case EXPR_CHOICE:
    return choice(scope, expr);
  case EXPR_CALL:
    return call(scope, expr);
  case EXPR_APPLY:
    return apply(scope, expr);
  case EXPR_STRING:
    break;
  }
  diag_error(ir->diag, expr->span, "this cannot be compiled yet; `lsysc interp` runs it");
  return ir_double(ir, NAN);
}
