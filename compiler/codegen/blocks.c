// blocks.c -- the statement blocks of a grammar as one function:
//
//   block(run, which)     Start, StartEach, EndEach or End (LSYS_BLOCK_*)
//
// Start begins a derivation: globals are 0, arrays as declared, no table is
// chosen, nothing has stopped. Draws have the key split(root, 2^63) and count
// their repetitions over the whole derivation, in counters that stand behind
// the program's values.
#include "codegen/ir.h"

uint32_t blocks_values(const Ir *ir) {
  return ir->state ? ir->counters : 0;
}

static void reset(Scope *scope) {
  Ir *ir = scope->ir;
  const Program *program = ir->program;
  for (uint32_t v = 0; v < program->value_count; v++)
    if (program->values[v].kind == VALUE_GLOBAL)
      LLVMBuildStore(ir->builder, ir_double(ir, 0), expr_value_address(scope, LSYS_SETTING_COUNT + v));
  init_arrays(scope);
  ir_store(ir, ir_int(ir, (uint64_t)-1), scope->run, ir->types.run, RUN_TABLE);
  ir_store(ir, ir_int(ir, 0), scope->run, ir->types.run, RUN_STOPPED);
  if (scope->counters) counters_clear(ir, scope->counters);
}

LLVMValueRef blocks_emit(Ir *ir) {
  if (!ir->state) return NULL;
  const Program *program = ir->program;
  const Actions *blocks[] = {&program->start, &program->start_each, &program->end_each, &program->end};
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.i32};
  LLVMValueRef function = LLVMAddFunction(ir->module, "block", LLVMFunctionType(ir->types.none, types, 2, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  debug_function(ir, function, (Span){0, 0});
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  Scope scope = {.ir = ir, .run = LLVMGetParam(function, 0)};
  LLVMValueRef root = ir_load(ir, ir->types.i64, scope.run, ir->types.run, RUN_ROOT);
  scope.key = key_split(ir, root, LSYS_VALUES_CHILD);
  if (ir->counters) scope.counters = expr_value_address(&scope, (uint32_t)program->total_values);
  LLVMBasicBlockRef done = ir_block(ir, "done");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, LLVMGetParam(function, 1), done, 4);
  for (unsigned which = LSYS_BLOCK_START; which <= LSYS_BLOCK_END; which++) {
    LLVMBasicBlockRef block = ir_block(ir, "block");
    LLVMAddCase(choice, LLVMConstInt(ir->types.i32, which, false), block);
    ir_at(ir, block);
    if (which == LSYS_BLOCK_START) reset(&scope);
    actions_run(&scope, blocks[which]);
    LLVMBuildBr(ir->builder, done);
  }
  ir_at(ir, done);
  LLVMBuildRetVoid(ir->builder);
  return function;
}
