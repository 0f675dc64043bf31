// expand.c -- a native function for each kind that runs down the derivation
// tree and writes the modules of the last step only, in order (DESIGN, engine
// expand); and its siblings for decomposition and homomorphism, which differ
// in what becomes of a successor's modules.
//
//   expand.A(out, cursors, steps, args..., key)            one rewriting, then each module with steps-1
//   decompose.A(out, cursors, steps, depth, args..., key)  as deep as depth, then expand with steps
//   interpret.A(out, cursors, depth, args..., key)         as deep as depth, then written without key
//   interpret.A(out, cursors, scan, depth, args..., key)   the same where its contexts look at the scanned word
//
// They return the cursors. Those in `out` are out of date meanwhile.
#include "analysis/passes.h"
#include "codegen/ir.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>

bool expand_takes_scan(const Ir *ir, Way way) {
  return way == WAY_INTERPRET && ir->description->flags & LSYS_GRAMMAR_WHOLE;
}

static unsigned leads(const Ir *ir, Way way) {  // parameters between the cursors and the module's arguments
  return way == WAY_DECOMPOSE || expand_takes_scan(ir, way) ? 2 : 1;
}

const Productions *expand_productions(const Ir *ir, Way way, size_t system, KindId kind) {
  const SystemFacts *facts = &ir->facts->systems[system];
  if (way == WAY_EXPAND || way == WAY_STEP) return &facts->own[kind];
  return way == WAY_DECOMPOSE ? &facts->decompositions[kind] : &facts->homomorphisms[kind];
}

LLVMValueRef expand_function(const Ir *ir, Way way, size_t system, KindId kind) {
  return ir->ways[way][system * ir->program->kind_count + kind];
}

static bool wanted(const Ir *ir, Way way, size_t system, KindId kind) {
  const KindFacts *facts = &ir->facts->kinds[kind];
  const Productions *productions = expand_productions(ir, way, system, kind);
  if (way == WAY_INTERPRET) return productions->count;
  if (!facts->reachable || way == WAY_STEP) return false;
  return way == WAY_EXPAND ? !ir->stepping && !facts->terminal : productions->count;
}

// ---- declarations ------------------------------------------------------------

static const char *way_name(Ir *ir, Way way, size_t system, KindId kind) {
  static const char *const names[] = {"expand", "decompose", "interpret"};
  const Kind *k = &ir->program->kinds[kind];
  if (system) return arena_printf(ir->arena, "%s.kind%u.system%zu", names[way], kind, system);
  for (const char *c = k->symbol; *c; c++)
    if (!isalnum((unsigned char)*c) && *c != '_') return arena_printf(ir->arena, "%s.kind%u", names[way], kind);
  return arena_printf(ir->arena, "%s.%s.%u", names[way], k->symbol, k->arity);
}

static LLVMValueRef declare(Ir *ir, Way way, size_t system, KindId kind) {
  uint32_t arity = ir->program->kinds[kind].arity;
  LLVMTypeRef *types = arena_array(ir->arena, arity + (size_t)7, sizeof *types);
  unsigned n = 0;
  types[n++] = ir->types.ptr;
  n += line_cursor_types(ir, types + n);
  unsigned first = n;
  if (expand_takes_scan(ir, way)) types[n++] = ir->types.ptr;
  while (n < first + leads(ir, way)) types[n++] = ir->types.i64;
  for (uint32_t i = 0; i < arity; i++) types[n++] = ir->types.f64;
  if (ir->facts->kinds[kind].key) types[n++] = ir->types.i64;
  LLVMTypeRef type = LLVMFunctionType(line_result_type(ir), types, n, false);
  LLVMValueRef function = LLVMAddFunction(ir->module, way_name(ir, way, system, kind), type);
  LLVMSetLinkage(function, LLVMInternalLinkage);
  LLVMSetFunctionCallConv(function, ir->tail_convention);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  ir_attribute(ir, function, 1, "noalias");  // nothing else points at the stream while this runs
  return function;
}

void expand_declare(Ir *ir) {
  size_t kinds = ir->program->kind_count, systems = ir->program->lsystem_count;
  for (Way way = 0; way < WAY_COUNT; way++) {
    ir->ways[way] = arena_array(ir->arena, systems * kinds, sizeof *ir->ways[way]);
    for (size_t s = 0; s < systems; s++)
      for (KindId k = 0; k < kinds; k++)
        if (wanted(ir, way, s, k)) ir->ways[way][s * kinds + k] = declare(ir, way, s, k);
  }
}

// The steps that are left where modules are written.
LLVMValueRef expand_stop(Ir *ir, LLVMValueRef out) {
  return ir_load(ir, ir->types.i64, out, ir->types.stream, STREAM_STOP);
}

LLVMValueRef expand_call(const Rewrite *rewrite, Way way, KindId kind, LLVMValueRef *rest, unsigned count) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef *values = arena_array(ir->arena, count + (size_t)4, sizeof *values);
  values[0] = rewrite->out;
  unsigned n = 1 + line_cursors(rewrite, values + 1);
  memcpy(values + n, rest, count * sizeof *rest);
  return ir_call(ir, expand_function(ir, way, rewrite->system, kind), values, n + count);
}

// ---- definitions -----------------------------------------------------------------------

// The loop head: the function's parameters behind the cursors become its variables.
static void begin(Rewrite *rewrite, LLVMValueRef function) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef entry = LLVMAppendBasicBlockInContext(ir->context, function, "entry");
  ir_at(ir, entry);
  rewrite->out = LLVMGetParam(function, 0);
  rewrite->scope.run = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, STREAM_RUN);
  ir_mark_invariant(ir, rewrite->scope.run);
  line_begin(rewrite, function, 1);
  rewrite->again = ir_block(ir, "again");
  LLVMBuildBr(ir->builder, rewrite->again);
  ir_at(ir, rewrite->again);
  LLVMTypeRef types[3];
  for (unsigned i = 1 + line_cursor_types(ir, types); i < LLVMCountParams(function); i++) {
    LLVMValueRef param = LLVMGetParam(function, i), phi = LLVMBuildPhi(ir->builder, LLVMTypeOf(param), "");
    LLVMAddIncoming(phi, &param, &entry, 1);
    *VEC_PUSH(ir->arena, &rewrite->variables) = phi;
  }
  LLVMValueRef *at = rewrite->variables.at;
  if (rewrite->walk) rewrite->walk->scans = walk_scans(ir, *at++);
  if (rewrite->way != WAY_INTERPRET) rewrite->steps = *at++;
  if (rewrite->way != WAY_EXPAND) rewrite->depth = *at++;
  rewrite->args = at;
  if (ir->facts->kinds[rewrite->kind].key) rewrite->scope.key = at[ir->program->kinds[rewrite->kind].arity];
}

// if (ahead < run->block_levels[kind]) { append run->block[kind][ahead]; return; }
static void use_blocks(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef kind = ir_int(ir, rewrite->kind), run = rewrite->scope.run;
  LLVMValueRef levels = ir_load(ir, ir->types.ptr, run, ir->types.run, RUN_BLOCK_LEVELS);
  LLVMValueRef known =
    LLVMBuildLoad2(ir->builder, ir->types.i64, ir_advance(ir, ir->types.i64, levels, kind), "levels");
  LLVMBasicBlockRef block = ir_block(ir, "block"), more = ir_block(ir, "more");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntULT, rewrite->ahead, known, ""), block, more);
  ir_at(ir, block);
  LLVMValueRef table = ir_load(ir, ir->types.ptr, run, ir->types.run, RUN_BLOCK);
  LLVMValueRef row = LLVMBuildLoad2(ir->builder, ir->types.ptr, ir_advance(ir, ir->types.ptr, table, kind), "row");
  LLVMValueRef at = ir_advance(ir, ir->types.block, row, rewrite->ahead);
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr, ir->types.i64, ir->types.ptr, ir->types.i64};
  LLVMValueRef append = ir_runtime(ir, "lsys_append", ir->types.none, types, 5, IR_ANY);
  LLVMValueRef args[] = {rewrite->out, ir_load(ir, ir->types.ptr, at, ir->types.block, BLOCK_SYM),
                         ir_load(ir, ir->types.i64, at, ir->types.block, BLOCK_NSYM),
                         ir_load(ir, ir->types.ptr, at, ir->types.block, BLOCK_ARG),
                         ir_load(ir, ir->types.i64, at, ir->types.block, BLOCK_NARG)};
  line_settle(rewrite);
  ir_call(ir, append, args, 5);
  line_fetch(rewrite);
  line_return(rewrite);
  ir_at(ir, more);
}

static void stop_at_zero(Rewrite *rewrite, LLVMValueRef count, LLVMBasicBlockRef end) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef some = ir_block(ir, "some");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, count, ir_int(ir, 0), ""), end, some);
  ir_at(ir, some);
}

static void tell_cut(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.i32};
  LLVMValueRef args[] = {rewrite->scope.run, LLVMConstInt(ir->types.i32, rewrite->way == WAY_INTERPRET, false)};
  ir_call(ir, ir_runtime(ir, "lsys_cut_short", ir->types.none, types, 2, IR_ANY), args, 2);
  LLVMBuildBr(ir->builder, rewrite->self);
}

// `: warnings`: where the maximum depth leaves a module that some production would replace, the user is told.
static void define_limit(Rewrite *rewrite, LLVMBasicBlockRef limit, const Productions *productions) {
  Ir *ir = rewrite->scope.ir;
  ir_at(ir, limit);
  select_any(rewrite, productions, tell_cut);
  LLVMBuildBr(ir->builder, rewrite->self);
}

static bool tells_limit(const Rewrite *rewrite) {
  const LSystem *lsystem = &rewrite->scope.ir->program->lsystems[rewrite->system];
  return (rewrite->way == WAY_DECOMPOSE && lsystem->decomposition.warnings)
      || (rewrite->way == WAY_INTERPRET && lsystem->homomorphism.warnings);
}

// The table of this step: schedule[(run->steps - steps) % count].
static LLVMValueRef table_now(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef total = ir_load(ir, ir->types.i64, rewrite->scope.run, ir->types.run, RUN_STEPS);
  LLVMValueRef step = LLVMBuildSub(ir->builder, total, rewrite->steps, "");
  LLVMValueRef count = ir_int(ir, ir->program->lsystems[0].schedule_count);
  LLVMValueRef at = ir_advance(ir, ir->types.i32, ir->schedules[0], LLVMBuildURem(ir->builder, step, count, ""));
  return LLVMBuildLoad2(ir->builder, ir->types.i32, at, "table");
}

LLVMValueRef expand_depth(Ir *ir, Way way, size_t system) {
  const LSystem *lsystem = &ir->program->lsystems[system];
  const Rewriting *section = way == WAY_INTERPRET ? &lsystem->homomorphism : &lsystem->decomposition;
  double depth = 1;
  if (section->depth) expr_constant(ir->program, section->depth, &depth);
  return ir_int(ir, depth > 0 ? depth < 0x1p62 ? (uint64_t)depth : UINT64_C(1) << 62 : 0);
}

// What all productions of the function share: counts of what is left, the step's table, counters at 0.
static void prepare(Rewrite *rewrite, const Productions *productions) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef one = ir_int(ir, 1);
  bool tables = false, counts = false;
  for (size_t i = 0; i < productions->count; i++) {
    tables |= productions->at[i]->table >= 0;
    counts |= counters_needed(ir, productions->at[i]);
  }
  if (rewrite->way == WAY_EXPAND) {
    rewrite->left = LLVMBuildSub(ir->builder, rewrite->steps, one, "left");
    rewrite->deeper = expand_depth(ir, WAY_DECOMPOSE, rewrite->system);
  } else {
    rewrite->left = rewrite->steps;
    rewrite->deeper = LLVMBuildSub(ir->builder, rewrite->depth, one, "deeper");
  }
  if (tables) rewrite->table = table_now(rewrite);
  if (counts) {
    rewrite->scope.counters = counters_create(ir);
    counters_clear(ir, rewrite->scope.counters);
  }
}

// With one step to go, nothing branches.
static void define_leaf(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef leaf = ir_block(ir, "leaf"), more = ir_block(ir, "more");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, rewrite->steps, ir_int(ir, 1), ""), leaf, more);
  ir_at(ir, leaf);
  leaf_write(rewrite, &(Derived){.kind = rewrite->kind, .args = rewrite->args, .key = rewrite->scope.key});
  flow_finish(rewrite);
  ir_at(ir, more);
}

static void choose(Rewrite *rewrite, const Productions *productions) {
  if (select_production(rewrite, productions, flow_take)) flow_stay(rewrite);
}

// With few steps left, up to the most that are straight-line code, the choice stands apart, so that a module with more
// of them passes one comparison. Where modules are written before the end (out->stop), steps only seem to be few.
static void choose_near(Rewrite *rewrite, const Productions *productions, unsigned levels) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef most = ir_int(ir, levels);
  LLVMBasicBlockRef near = ir_block(ir, "near"), far = ir_block(ir, "far"), last = ir_block(ir, "last");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntUGT, rewrite->ahead, most, ""), far, near);
  ir_at(ir, near);
  stop_at_zero(rewrite, rewrite->ahead, rewrite->self);
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntULE, rewrite->steps, most, ""), last, far);
  ir_at(ir, last);
  rewrite->near = levels;
  if (leaf_kind(ir, rewrite->kind)) define_leaf(rewrite);
  choose(rewrite, productions);
  rewrite->near = 0;
  ir_at(ir, far);
}

// The derivation of a module by rewrite->steps. Code that is to be there soon has the choice once.
static void derive(Rewrite *rewrite, const Productions *productions) {
  Ir *ir = rewrite->scope.ir;
  unsigned levels = flow_levels(ir, rewrite->kind);
  rewrite->ahead = LLVMBuildSub(ir->builder, rewrite->steps, expand_stop(ir, rewrite->out), "ahead");
  if (ir->facts->kinds[rewrite->kind].fixed) use_blocks(rewrite);
  prepare(rewrite, productions);
  if (levels && ir->options->optimise >= 2) {
    choose_near(rewrite, productions, levels);
  } else {
    stop_at_zero(rewrite, rewrite->ahead, rewrite->self);
    if (leaf_kind(ir, rewrite->kind)) define_leaf(rewrite);
    rewrite->near = levels ? UINT_MAX : 0;
  }
  choose(rewrite, productions);
}

// Decomposition, homomorphism: down to rewrite->depth levels.
static void replace(Rewrite *rewrite, const Productions *productions) {
  LLVMBasicBlockRef end = tells_limit(rewrite) ? ir_block(rewrite->scope.ir, "limit") : rewrite->self;
  stop_at_zero(rewrite, rewrite->depth, end);
  prepare(rewrite, productions);
  choose(rewrite, productions);
  if (end != rewrite->self) define_limit(rewrite, end, productions);
}

static void define(Ir *ir, Way way, size_t system, KindId kind) {
  Rewrite rewrite = {.scope = {.ir = ir, .constant_values = !ir->state}, .way = way, .kind = kind, .system = system};
  Walk walk = {0};
  if (expand_takes_scan(ir, way)) rewrite.walk = &walk;
  rewrite.silent = way == WAY_INTERPRET || (!ir->stepping && !ir->shown_keys);
  LLVMValueRef function = expand_function(ir, way, system, kind);
  const Productions *productions = expand_productions(ir, way, system, kind);
  debug_function(ir, function, productions->count ? productions->at[0]->head : (Span){0, 0});
  begin(&rewrite, function);
  if (productions->count) debug_arguments(&rewrite, productions->at[0]);
  rewrite.self = ir_block(ir, "self");
  (way == WAY_EXPAND ? derive : replace)(&rewrite, productions);
  flow_settle(&rewrite);
}

static LLVMValueRef schedule(Ir *ir, const LSystem *lsystem) {
  if (!lsystem->schedule) return NULL;
  LLVMValueRef *tables = arena_array(ir->arena, lsystem->schedule_count, sizeof *tables);
  for (size_t i = 0; i < lsystem->schedule_count; i++)
    tables[i] = LLVMConstInt(ir->types.i32, lsystem->schedule[i], false);
  return ir_data(ir, LLVMConstArray2(ir->types.i32, tables, lsystem->schedule_count), "schedule");
}

static bool images_draw(const Ir *ir) {
  Uses uses = uses_find(ir->arena, ir->program);
  for (size_t s = 0; s < ir->program->lsystem_count; s++) {
    const Productions *images = &ir->program->lsystems[s].homomorphism.productions;
    for (size_t i = 0; i < images->count; i++)
      if (uses_production(&uses, images->at[i]) & USES_DRAW) return true;
  }
  return false;
}

void expand_define(Ir *ir) {
  size_t systems = ir->program->lsystem_count;
  ir->schedules = arena_array(ir->arena, systems, sizeof *ir->schedules);
  for (size_t s = 0; s < systems; s++) ir->schedules[s] = schedule(ir, &ir->program->lsystems[s]);
  ir->shown_keys = images_draw(ir);
  for (Way way = 0; way < WAY_COUNT; way++)
    for (size_t s = 0; s < systems; s++)
      for (KindId k = 0; k < ir->program->kind_count; k++)
        if (expand_function(ir, way, s, k)) define(ir, way, s, k);
}
