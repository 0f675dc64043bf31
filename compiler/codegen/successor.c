// successor.c -- what a production writes: the one emission of arguments and
// keys of a successor's modules, left to right (LANGUAGE.md 5.8).
#include "codegen/ir.h"

void successor_emit(Rewrite *rewrite, const Production *production, Handle handle, unsigned steps) {
  Ir *ir = rewrite->scope.ir;
  const Word *word = &production->successor;
  Scope scope = rewrite->scope;  // handling a module may emit other productions
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    uint32_t arity = ir->program->kinds[module->kind].arity;
    LLVMValueRef *args = arena_array(ir->arena, arity, sizeof *args);
    for (uint32_t a = 0; a < arity; a++) args[a] = expr_value(&scope, module->args[a]);
    LLVMValueRef key = NULL;
    // An image of a module without a key never draws, whatever its kind does in the derivation.
    if (ir->facts->kinds[module->kind].key) key = scope.key ? key_split(ir, scope.key, i) : ir_int(ir, 0);
    Derived derived = {module->kind, args, key, i + 1 == word->count};
    handle(rewrite, &derived, steps);
    rewrite->scope = scope;
  }
}
