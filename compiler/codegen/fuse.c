// fuse.c -- the last steps of a derivation as one straight-line block.
//
// Where it is certain at compile time which production rewrites every module
// of a successor, the modules of one, two, ... steps later are known, and only
// their arguments remain to be computed. All of them are then written at once.
#include "analysis/passes.h"
#include "codegen/ir.h"

// Bounds on one block: what pays at run time against what code costs to compile.
enum { MOST_MODULES = 64, MOST_ARGUMENTS = 32, MOST_LEVELS = 6, MOST_VISITS = 1000 };

typedef struct Size {
  size_t modules, arguments;
  size_t visits;  // of modules on the way: those that vanish cost time here, too
} Size;

// The production that rewrites every module of this kind, NULL if that is not certain.
static const Production *certain(const Ir *ir, KindId kind) {
  const KindFacts *facts = &ir->facts->kinds[kind];
  for (size_t i = 0; i < facts->own.count; i++) {
    const Production *p = facts->own.at[i];
    if (production_never(ir->program, p)) continue;
    bool simple = !p->weight && p->before.count == 0 && p->after.count == 0 && !counters_needed(ir, p);
    return simple && production_always(ir->program, p) ? p : NULL;
  }
  return NULL;
}

// Adds the word after levels-1 more steps. False if it is not certain or too big.
static bool measure(const Ir *ir, const Word *word, unsigned levels, Size *size) {
  for (size_t i = 0; i < word->count; i++) {
    KindId kind = word->at[i].kind;
    const KindFacts *facts = &ir->facts->kinds[kind];
    if (facts->decompositions.count || ++size->visits > MOST_VISITS) return false;
    if (levels == 1 || facts->terminal) {
      size->modules++;
      size->arguments += ir->program->kinds[kind].arity;
      if (size->modules > MOST_MODULES || size->arguments > MOST_ARGUMENTS) return false;
    } else {
      const Production *p = certain(ir, kind);
      if (!p || !measure(ir, &p->successor, levels - 1, size)) return false;
    }
  }
  return true;
}

unsigned fuse_levels(Ir *ir, const Production *production) {
  unsigned levels = 0;
  Size last = {0};
  while (levels < MOST_LEVELS) {
    Size size = {0};
    if (!measure(ir, &production->successor, levels + 1, &size)) break;
    if (levels && size.modules == last.modules) break;  // no growth: nothing to gain
    last = size;
    levels++;
  }
  return levels;
}

static void fuse_module(Rewrite *rewrite, const Derived *module, unsigned steps) {
  Ir *ir = rewrite->scope.ir;
  if (steps == 0 || ir->facts->kinds[module->kind].terminal) {
    LLVMValueRef key = rewrite->silent ? NULL : derived_key(ir, module);
    for (unsigned s = 0; key && s < steps; s++) key = key_split(ir, key, 0);
    line_add(rewrite, module->kind, module->args, key);
    return;
  }
  const Production *p = certain(ir, module->kind);
  Scope scope = rewrite->scope;
  rewrite->scope.slots = arena_array(ir->arena, p->parameters, sizeof(Slot));
  for (uint32_t i = 0; i < ir->program->kinds[module->kind].arity; i++)
    rewrite->scope.slots[p->strict.at[0].slot + i].value = module->args[i];
  rewrite->scope.key = derived_key(ir, module);
  fuse_write(rewrite, successor_derive(rewrite, p), p->successor.count, steps - 1);
  rewrite->scope = scope;
}

void fuse_write(Rewrite *rewrite, const Derived *modules, size_t count, unsigned steps) {
  for (size_t i = 0; i < count; i++) fuse_module(rewrite, &modules[i], steps);
}
