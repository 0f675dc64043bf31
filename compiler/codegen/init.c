// init.c -- the descriptor's init (values, then settings) and axiom (arguments
// of start words that are no constants).
#include "codegen/ir.h"

// `init(run, given)` and `axiom(run, which, arg, key)`.
static LLVMValueRef create(Ir *ir, const char *name, LLVMTypeRef *types, unsigned count) {
  LLVMValueRef function = LLVMAddFunction(ir->module, name, LLVMFunctionType(ir->types.none, types, count, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  debug_function(ir, function, (Span){0, 0});
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  return function;
}

static void set_value(Scope *scope, uint32_t slot, LLVMValueRef value) {
  LLVMBuildStore(scope->ir->builder, value, expr_value_address(scope, slot));
}

// Param number `param` unless the command line set it.
static void init_param(Scope *scope, LLVMValueRef given, uint32_t param, uint32_t slot, const Expr *init) {
  Ir *ir = scope->ir;
  LLVMValueRef flag =
    LLVMBuildLoad2(ir->builder, ir->types.i8, ir_advance(ir, ir->types.i8, given, ir_int(ir, param)), "");
  LLVMValueRef absent = LLVMBuildICmp(ir->builder, LLVMIntEQ, flag, LLVMConstInt(ir->types.i8, 0, false), "");
  LLVMBasicBlockRef set = ir_block(ir, "default"), next = ir_block(ir, "next");
  ir_branch(ir, absent, set, next);
  ir_at(ir, set);
  set_value(scope, slot, expr_value(scope, init));
  LLVMBuildBr(ir->builder, next);
  ir_at(ir, next);
}

static uint32_t param_number(const Ir *ir, uint32_t slot) {
  uint32_t param = 0;
  while (ir->description->params[param].value != slot) param++;
  return param;
}

static void init_values(Scope *scope, LLVMValueRef given) {
  const Program *program = scope->ir->program;
  for (size_t i = 0; i < program->value_count; i++) {
    uint32_t v = program->value_order[i], slot = LSYS_SETTING_COUNT + v;
    const Value *value = &program->values[v];
    if (value->kind == VALUE_PARAM)
      init_param(scope, given, param_number(scope->ir, slot), slot, value->init);
    else
      set_value(scope, slot, value->init ? expr_value(scope, value->init) : ir_double(scope->ir, 0));
  }
}

// Most settings are constants: those are copied at once.
static void init_settings(Scope *scope) {
  Ir *ir = scope->ir;
  const Program *program = ir->program;
  LLVMValueRef values[LSYS_SETTING_COUNT];
  bool known[LSYS_SETTING_COUNT];
  for (uint32_t s = 0; s < LSYS_SETTING_COUNT; s++) {
    double value = lsys_settings[s].value;
    known[s] = !program->settings[s] || expr_constant(program, program->settings[s], &value);
    values[s] = ir_double(ir, value);
  }
  LLVMValueRef data = ir_data(ir, LLVMConstArray2(ir->types.f64, values, LSYS_SETTING_COUNT), "settings");
  uint64_t size = LSYS_SETTING_COUNT * sizeof(double);
  LLVMBuildMemCpy(ir->builder, expr_value_address(scope, 0), 8, data, 8, ir_int(ir, size));
  for (uint32_t s = 0; s < LSYS_SETTING_COUNT; s++)
    if (!known[s]) set_value(scope, s, expr_value(scope, program->settings[s]));
}

void init_arrays(Scope *scope) {
  Ir *ir = scope->ir;
  for (size_t i = 0; i < ir->program->array_count; i++) {
    const Array *array = &ir->program->arrays[i];
    size_t count = 1;
    for (uint32_t d = 0; d < array->dimensions; d++) count *= array->sizes[d];
    LLVMValueRef *values = arena_array(ir->arena, count, sizeof *values);
    for (size_t v = 0; v < count; v++) values[v] = ir_double(ir, array->values[v]);
    LLVMValueRef data = ir_data(ir, LLVMConstArray2(ir->types.f64, values, count), "array");
    LLVMBuildMemCpy(ir->builder, expr_value_address(scope, array->slot), 8, data, 8, ir_int(ir, 8 * count));
  }
}

// All repetition counters count over the whole initialisation.
LLVMValueRef init_emit(Ir *ir) {
  LLVMValueRef function = create(ir, "init", (LLVMTypeRef[]){ir->types.ptr, ir->types.ptr}, 2);
  Scope scope = {.ir = ir, .run = LLVMGetParam(function, 0)};
  LLVMValueRef root = ir_load(ir, ir->types.i64, scope.run, ir->types.run, RUN_ROOT);
  scope.key = key_split(ir, root, LSYS_VALUES_CHILD);
  if (ir->counters) {
    scope.counters = counters_create(ir);
    counters_clear(ir, scope.counters);
  }
  init_arrays(&scope);
  init_values(&scope, LLVMGetParam(function, 1));
  init_settings(&scope);
  LLVMBuildRetVoid(ir->builder);
  return function;
}

// ---- axioms --------------------------------------------------------------------

static bool varies(const Ir *ir, const Word *word) {
  double value;
  for (size_t i = 0; i < word->count; i++)
    for (uint32_t a = 0; a < ir->program->kinds[word->at[i].kind].arity; a++)
      if (!expr_constant(ir->program, word->at[i].args[a], &value)) return true;
  return false;
}

static void axiom_word(Scope *scope, const Word *word, LLVMValueRef arg, LLVMValueRef keys) {
  Ir *ir = scope->ir;
  size_t place = 0;
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    scope->key = NULL;
    for (uint32_t a = 0; a < ir->program->kinds[module->kind].arity; a++, place++) {
      double value;
      if (expr_constant(ir->program, module->args[a], &value)) continue;
      if (!scope->key && expr_draws(ir->program, module->args[a])) {
        LLVMValueRef at = ir_advance(ir, ir->types.i64, keys, ir_int(ir, i));
        scope->key = LLVMBuildLoad2(ir->builder, ir->types.i64, at, "key");
        if (scope->counters) counters_clear(ir, scope->counters);
      }
      LLVMBuildStore(ir->builder, expr_value(scope, module->args[a]),
                     ir_advance(ir, ir->types.f64, arg, ir_int(ir, place)));
    }
  }
}

LLVMValueRef axiom_emit(Ir *ir) {
  const Program *program = ir->program;
  bool any = false, counts = false;
  for (size_t i = 0; i < program->axiom_count; i++) {
    any |= varies(ir, &program->axioms[i]);
    counts |= counters_needed_word(ir, &program->axioms[i]);
  }
  if (!any) return NULL;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.i32, ir->types.ptr, ir->types.ptr};
  LLVMValueRef function = create(ir, "axiom", types, 4);
  Scope scope = {.ir = ir, .run = LLVMGetParam(function, 0)};
  if (counts) scope.counters = counters_create(ir);
  LLVMBasicBlockRef done = ir_block(ir, "done");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, LLVMGetParam(function, 1), done, (unsigned)program->axiom_count);
  for (size_t i = 0; i < program->axiom_count; i++) {
    if (!varies(ir, &program->axioms[i])) continue;
    LLVMBasicBlockRef block = ir_block(ir, "axiom");
    LLVMAddCase(choice, LLVMConstInt(ir->types.i32, i, false), block);
    ir_at(ir, block);
    axiom_word(&scope, &program->axioms[i], LLVMGetParam(function, 2), LLVMGetParam(function, 3));
    LLVMBuildBr(ir->builder, done);
  }
  ir_at(ir, done);
  LLVMBuildRetVoid(ir->builder);
  return function;
}
