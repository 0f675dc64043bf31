// whole.c -- decomposition and homomorphism of a whole word where what becomes
// of a module depends on more than the module: on its neighbours, on the
// L-system around it, on what happened before.
//
//   decompose(scan, out)    interpret(scan, out)
//
// Each module is handed to the function of its kind or copied.
#include "codegen/ir.h"

LLVMValueRef image_key(Ir *ir, size_t system, LLVMValueRef key) {
  if (!key) return ir_int(ir, 0);
  const Rewriting *section = &ir->program->lsystems[system].homomorphism;
  key = key_split(ir, key, LSYS_VALUES_CHILD);
  return section->has_seed ? LLVMBuildXor(ir->builder, key, ir_int(ir, lsys_mix64(section->seed)), "") : key;
}

static void hand_over(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  uint32_t arity = ir->program->kinds[rewrite->kind].arity;
  LLVMValueRef *values = arena_array(ir->arena, arity + (size_t)4, sizeof *values), key = rewrite->scope.key;
  bool shows = rewrite->way == WAY_INTERPRET;
  unsigned n = 0;
  values[n++] = shows ? rewrite->walk->scans[0] : rewrite->steps;
  values[n++] = expand_depth(ir, rewrite->way, rewrite->system);
  for (uint32_t i = 0; i < arity; i++) values[n++] = rewrite->args[i];
  if (ir->facts->kinds[rewrite->kind].key) values[n++] = shows ? image_key(ir, rewrite->system, key) : key;
  if (rewrite->walk->right) walk_store(rewrite);
  line_resume(rewrite, expand_call(rewrite, rewrite->way, rewrite->kind, values, n));
}

static void replace_module(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  if (expand_function(ir, rewrite->way, rewrite->system, rewrite->kind)) {
    hand_over(rewrite);
  } else {
    line_add(rewrite, rewrite->kind, rewrite->args, rewrite->scope.key);
    line_flush(rewrite);
  }
  walk_pass(rewrite, &rewrite->kind, 1);
}

LLVMValueRef whole_decompose(Ir *ir) {
  bool any = false;
  for (size_t s = 0; s < ir->program->lsystem_count; s++)
    any |= ir->program->lsystems[s].decomposition.productions.count;
  return ir->apart && any ? walk_emit(ir, "decompose", WAY_DECOMPOSE, NULL, replace_module) : NULL;
}

LLVMValueRef whole_interpret(Ir *ir) {
  bool whole = ir->description->flags & LSYS_GRAMMAR_WHOLE;
  return whole ? walk_emit(ir, "interpret", WAY_INTERPRET, NULL, replace_module) : NULL;
}
