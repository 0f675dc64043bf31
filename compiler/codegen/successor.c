// successor.c -- what a production writes: the one emission of the arguments
// and keys of a successor's modules, left to right (LANGUAGE.md 5.8).
#include "codegen/ir.h"

Derived *successor_derive(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  const Word *word = &production->successor;
  Derived *modules = arena_array(ir->arena, word->count, sizeof *modules);
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    uint32_t arity = ir->program->kinds[module->kind].arity;
    LLVMValueRef *args = arena_array(ir->arena, arity, sizeof *args);
    for (uint32_t a = 0; a < arity; a++) args[a] = expr_value(&rewrite->scope, module->args[a]);
    modules[i] = (Derived){.kind = module->kind, .args = args, .parent = rewrite->scope.key, .child = i};
  }
  return modules;
}

LLVMValueRef derived_key(Ir *ir, const Derived *module) {
  if (!ir->facts->kinds[module->kind].key) return NULL;
  // An image of a module without a key never draws, whatever its kind does in the derivation.
  if (!module->key && !module->parent) return ir_int(ir, 0);
  return module->key ? module->key : key_split(ir, module->parent, module->child);
}
