// step.c -- what one derivation step does with a module (DESIGN, engine step):
//
//   step(scan, out)    rewrites the modules from scan->sym to scan->end
//
// What the choice of a production and the writing of a successor look like is
// select.c's and successor.c's business, as for every engine.
#include "codegen/ir.h"

static void take(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  const Context *strict = &production->strict;
  rewrite->done = ir_block(ir, "rewritten");
  const Derived *modules = successor_derive(rewrite, production);
  size_t count = production->successor.count;
  for (size_t i = 0; i < count; i++) flow_hand_on(rewrite, &modules[i], i + 1 == count);
  if (count == 0) LLVMBuildBr(ir->builder, rewrite->done);
  ir_at(ir, rewrite->done);
  KindId *kinds = arena_array(ir->arena, strict->count, sizeof *kinds);
  for (size_t i = 0; i < strict->count; i++) kinds[i] = strict->at[i].kind;
  walk_pass(rewrite, kinds, strict->count);
}

static void stay(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef key = rewrite->scope.key;
  if (rewrite->kind == ir->program->cut) {  // it goes, with the rest of its branch
    walk_cut(rewrite);
    return;
  }
  Derived self = {.kind = rewrite->kind, .args = rewrite->args, .key = key ? key_split(ir, key, 0) : NULL};
  rewrite->done = ir_block(ir, "stays");
  flow_hand_on(rewrite, &self, true);
  ir_at(ir, rewrite->done);
  walk_pass(rewrite, &rewrite->kind, 1);
}

// The table of this step: schedule[step % count], or what useTable chose, which is the main L-system's; -1: all apply.
static LLVMValueRef table_now(const Rewrite *rewrite, size_t system) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef schedule = ir->schedules[system];
  if (!schedule && (system || !ir->state)) return LLVMConstAllOnes(ir->types.i32);
  if (!schedule) {
    LLVMValueRef table = ir_load(ir, ir->types.i64, rewrite->scope.run, ir->types.run, RUN_TABLE);
    return LLVMBuildTrunc(ir->builder, table, ir->types.i32, "table");
  }
  LLVMValueRef number = ir_load(ir, ir->types.i64, rewrite->walk->scans[0], ir->types.scan, SCAN_STEP);
  LLVMValueRef count = ir_int(ir, ir->program->lsystems[system].schedule_count);
  LLVMValueRef at = ir_advance(ir, ir->types.i32, schedule, LLVMBuildURem(ir->builder, number, count, ""));
  return LLVMBuildLoad2(ir->builder, ir->types.i32, at, "table");
}

// Tables and counters, once for all modules.
static void begin(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  size_t systems = ir->program->lsystem_count;
  rewrite->walk->tables = arena_array(ir->arena, systems, sizeof(LLVMValueRef));
  for (size_t s = 0; s < systems; s++) rewrite->walk->tables[s] = table_now(rewrite, s);
  if (ir->counters) rewrite->walk->counters = counters_create(ir);
}

static void prepare(Rewrite *rewrite, const Productions *productions) {
  Ir *ir = rewrite->scope.ir;
  bool tables = false, counts = false;
  for (size_t i = 0; i < productions->count; i++) {
    tables |= productions->at[i]->table >= 0;
    counts |= counters_needed(ir, productions->at[i]);
  }
  rewrite->table = tables ? rewrite->walk->tables[rewrite->system] : NULL;
  rewrite->scope.counters = NULL;
  if (counts) {
    rewrite->scope.counters = rewrite->walk->counters;
    counters_clear(ir, rewrite->scope.counters);
  }
  neighbours_prepare(rewrite, productions);
}

static void rewrite_module(Rewrite *rewrite) {
  const Productions *own = expand_productions(rewrite->scope.ir, WAY_STEP, rewrite->system, rewrite->kind);
  rewrite->deeper = expand_depth(rewrite->scope.ir, WAY_DECOMPOSE, rewrite->system);
  prepare(rewrite, own);
  if (select_production(rewrite, own, take)) stay(rewrite);
}

LLVMValueRef step_emit(Ir *ir) {
  if (!ir->stepping) return NULL;
  LLVMValueRef by_table = letters_emit(ir);
  return by_table ? by_table : walk_emit(ir, "step", WAY_STEP, begin, rewrite_module);
}
