// step.c -- one derivation step as a loop over a word (DESIGN, engine step):
//
//   step(scan, out)    rewrites the modules from scan->sym to scan->end
//
// The cursors into the word are variables of the loop; they are stored to the
// scan where something looks around (lsys/scan.h). What the choice of a
// production and the writing of a successor look like is select.c's and
// successor.c's business, as for every engine.
#include "codegen/ir.h"

typedef struct Loop {
  Rewrite *rewrite;
  Step *step;
  LLVMBasicBlockRef next;                     // the latch,
  LLVMValueRef next_sym, next_arg, next_key;  //   and its phis
  bool looks, left, right;                    // the grammar has contexts; left ones; right ones
} Loop;

// What a rewriting of one kind needs behind the callbacks of select.c.
static Loop *loop_of(Rewrite *rewrite) {
  return rewrite->step->loop;
}

static uint8_t class_of(const Ir *ir, KindId kind) {
  return ir->description->context_class[kind];
}

LLVMValueRef step_on_root_axis(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef depth = ir_load(ir, ir->types.i64, rewrite->step->scan, ir->types.scan, SCAN_DEPTH);
  LLVMValueRef root = LLVMBuildICmp(ir->builder, LLVMIntEQ, depth, ir_int(ir, 0), "");
  return LLVMBuildZExt(ir->builder, root, ir->types.i32, "");
}

// ---- going on ----------------------------------------------------------------

// Ends the block: on to the latch with the cursors given.
static void go_on(Loop *loop, LLVMValueRef sym, LLVMValueRef arg, LLVMValueRef key) {
  Ir *ir = loop->rewrite->scope.ir;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, loop->next);
  LLVMAddIncoming(loop->next_sym, &sym, &here, 1);
  LLVMAddIncoming(loop->next_arg, &arg, &here, 1);
  LLVMAddIncoming(loop->next_key, &key, &here, 1);
}

static void scan_call(Loop *loop, const char *name) {
  Ir *ir = loop->rewrite->scope.ir;
  ir_call(ir, ir_runtime(ir, name, ir->types.none, &ir->types.ptr, 1, IR_ANY), &loop->step->scan, 1);
}

static void set_flag(Loop *loop, unsigned field, unsigned value) {
  Ir *ir = loop->rewrite->scope.ir;
  ir_store(ir, LLVMConstInt(ir->types.i32, value, false), loop->step->scan, ir->types.scan, field);
}

// In a ring: one more module of the root's axis, if this one is.
static void count_passed(Loop *loop) {
  Ir *ir = loop->rewrite->scope.ir;
  LLVMValueRef passed = ir_load(ir, ir->types.i32, loop->step->scan, ir->types.scan, SCAN_PASSED);
  passed = LLVMBuildAdd(ir->builder, passed, step_on_root_axis(loop->rewrite), "");
  ir_store(ir, passed, loop->step->scan, ir->types.scan, SCAN_PASSED);
}

// A seen module becomes the nearest one on the left.
static void move_window(Loop *loop, KindId kind, LLVMValueRef arg) {
  Ir *ir = loop->rewrite->scope.ir;
  set_flag(loop, SCAN_FRESH, 0);
  bool ring = ir->description->flags & LSYS_GRAMMAR_RING;
  if (ring) count_passed(loop);
  uint32_t window = ir->description->left_window;
  if (!window) return;
  LLVMTypeRef type = ir->types.neighbour;
  LLVMValueRef left = ir_load(ir, ir->types.ptr, loop->step->scan, ir->types.scan, SCAN_LEFT);
  for (uint32_t i = window; i-- > 1;) {
    LLVMValueRef from = ir_advance(ir, type, left, ir_int(ir, i - 1)), to = ir_advance(ir, type, left, ir_int(ir, i));
    ir_store(ir, ir_load(ir, ir->types.i32, from, type, NEIGHBOUR_KIND), to, type, NEIGHBOUR_KIND);
    if (ring) ir_store(ir, ir_load(ir, ir->types.i32, from, type, NEIGHBOUR_WRAP), to, type, NEIGHBOUR_WRAP);
    ir_store(ir, ir_load(ir, ir->types.ptr, from, type, NEIGHBOUR_ARG), to, type, NEIGHBOUR_ARG);
  }
  if (ring) ir_store(ir, LLVMConstInt(ir->types.i32, 0, false), left, type, NEIGHBOUR_WRAP);
  ir_store(ir, LLVMConstInt(ir->types.i32, kind, false), left, type, NEIGHBOUR_KIND);
  ir_store(ir, arg, left, type, NEIGHBOUR_ARG);
}

// The scan passes `count` modules of the word, of these kinds.
static void pass_modules(Loop *loop, const KindId *kinds, size_t count) {
  Ir *ir = loop->rewrite->scope.ir;
  uint32_t args = 0, keys = 0;
  for (size_t i = 0; i < count; i++) {
    LLVMValueRef arg = ir_advance(ir, ir->types.f64, loop->step->arg, ir_int(ir, args));
    uint8_t class = class_of(ir, kinds[i]);
    if (class == LSYS_CLASS_SEEN && loop->left) move_window(loop, kinds[i], arg);
    if (class == LSYS_CLASS_SEEN && loop->right && i > 0) set_flag(loop, SCAN_AHEAD_KNOWN, 0);
    if (class == LSYS_CLASS_OPEN && loop->looks) scan_call(loop, "lsys_scan_open");
    if (class == LSYS_CLASS_CLOSE && loop->looks) scan_call(loop, "lsys_scan_close");
    args += ir->program->kinds[kinds[i]].arity;
    keys += ir->facts->kinds[kinds[i]].key;
  }
  go_on(loop, ir_advance(ir, ir->types.symbol, loop->step->sym, ir_int(ir, count)),
        ir_advance(ir, ir->types.f64, loop->step->arg, ir_int(ir, args)),
        ir_advance(ir, ir->types.i64, loop->step->key, ir_int(ir, keys)));
}

static void store_place(Loop *loop, LLVMValueRef sym, LLVMValueRef arg, LLVMValueRef key) {
  Ir *ir = loop->rewrite->scope.ir;
  LLVMValueRef scan = loop->step->scan;
  ir_store(ir, sym, scan, ir->types.scan, SCAN_SYM);
  ir_store(ir, arg, scan, ir->types.scan, SCAN_ARG);
  ir_store(ir, key, scan, ir->types.scan, SCAN_KEY);
}

// A cut that no production rewrites goes, with the rest of its branch.
static void cut(Loop *loop) {
  Ir *ir = loop->rewrite->scope.ir;
  LLVMValueRef scan = loop->step->scan;
  const Kind *kind = &ir->program->kinds[ir->program->cut];
  store_place(loop, ir_advance(ir, ir->types.symbol, loop->step->sym, ir_int(ir, 1)),
              ir_advance(ir, ir->types.f64, loop->step->arg, ir_int(ir, kind->arity)),
              ir_advance(ir, ir->types.i64, loop->step->key, ir_int(ir, ir->facts->kinds[ir->program->cut].key)));
  scan_call(loop, "lsys_cut");
  go_on(loop, ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_SYM),
        ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_ARG),
        ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_KEY));
}

// ---- one kind ----------------------------------------------------------------

static void take(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  const Context *strict = &production->strict;
  rewrite->done = ir_block(ir, "rewritten");
  successor_emit(rewrite, production, module_hand_on, 0);
  if (production->successor.count == 0) LLVMBuildBr(ir->builder, rewrite->done);
  ir_at(ir, rewrite->done);
  KindId *kinds = arena_array(ir->arena, strict->count, sizeof *kinds);
  for (size_t i = 0; i < strict->count; i++) kinds[i] = strict->at[i].kind;
  pass_modules(loop_of(rewrite), kinds, strict->count);
}

static void stay(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  Derived self = {rewrite->kind, rewrite->args, rewrite->scope.key, true};
  if (rewrite->kind == ir->program->cut) {
    cut(loop_of(rewrite));
    return;
  }
  if (self.key) self.key = key_split(ir, self.key, 0);
  rewrite->done = ir_block(ir, "stays");
  module_hand_on(rewrite, &self, 0);
  ir_at(ir, rewrite->done);
  pass_modules(loop_of(rewrite), &rewrite->kind, 1);
}

static bool looks_ahead(const Productions *productions) {
  for (size_t i = 0; i < productions->count; i++)
    if (productions->at[i]->right.count) return true;
  return false;
}

static void prepare(Rewrite *rewrite, const Productions *productions) {
  Ir *ir = rewrite->scope.ir;
  const Loop *loop = loop_of(rewrite);
  bool tables = false, counts = false;
  for (size_t i = 0; i < productions->count; i++) {
    tables |= productions->at[i]->table >= 0;
    counts |= counters_needed(ir, productions->at[i]);
  }
  rewrite->table = tables ? rewrite->step->table : NULL;
  rewrite->scope.counters = NULL;
  if (counts) {
    rewrite->scope.counters = rewrite->step->counters;
    counters_clear(ir, rewrite->scope.counters);
  }
  if (loop->right && class_of(ir, rewrite->kind) == LSYS_CLASS_SEEN) set_flag(loop_of(rewrite), SCAN_AHEAD_KNOWN, 0);
  if (looks_ahead(productions)) store_place(loop_of(rewrite), loop->step->sym, loop->step->arg, loop->step->key);
}

static void rewrite_kind(Rewrite *rewrite, KindId kind) {
  Ir *ir = rewrite->scope.ir;
  const Step *step = rewrite->step;
  const Productions *own = &ir->facts->kinds[kind].own;
  uint32_t arity = ir->program->kinds[kind].arity;
  rewrite->kind = kind;
  rewrite->args = arena_array(ir->arena, arity, sizeof *rewrite->args);
  for (uint32_t i = 0; i < arity; i++) {
    LLVMValueRef at = ir_advance(ir, ir->types.f64, step->arg, ir_int(ir, i));
    rewrite->args[i] = LLVMBuildLoad2(ir->builder, ir->types.f64, at, "");
  }
  bool keyed = ir->facts->kinds[kind].key;
  rewrite->scope.key = keyed ? LLVMBuildLoad2(ir->builder, ir->types.i64, step->key, "key") : NULL;
  prepare(rewrite, own);
  if (select_production(rewrite, own, take)) stay(rewrite);
}

// ---- the loop ------------------------------------------------------------------

static void dispatch(Rewrite *rewrite, LLVMValueRef symbol) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef unknown = ir_block(ir, "unknown");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, symbol, unknown, (unsigned)ir->program->kind_count);
  for (KindId kind = 0; kind < ir->program->kind_count; kind++) {
    if (!ir->facts->kinds[kind].reachable) continue;
    LLVMBasicBlockRef block = ir_block(ir, "kind");
    LLVMAddCase(choice, LLVMConstInt(ir->types.symbol, kind, false), block);
    ir_at(ir, block);
    rewrite_kind(rewrite, kind);
  }
  ir_at(ir, unknown);
  LLVMBuildUnreachable(ir->builder);
}

static LLVMValueRef phi(Ir *ir, const char *name) {
  return LLVMBuildPhi(ir->builder, ir->types.ptr, name);
}

static void run_loop(Loop *loop) {
  Ir *ir = loop->rewrite->scope.ir;
  Step *step = loop->step;
  LLVMTypeRef ptr = ir->types.ptr, scan = ir->types.scan;
  LLVMValueRef first[] = {ir_load(ir, ptr, step->scan, scan, SCAN_SYM), ir_load(ir, ptr, step->scan, scan, SCAN_ARG),
                          ir_load(ir, ptr, step->scan, scan, SCAN_KEY)};
  step->end = ir_load(ir, ptr, step->scan, scan, SCAN_END);
  LLVMBasicBlockRef entry = LLVMGetInsertBlock(ir->builder);
  LLVMBasicBlockRef head = ir_block(ir, "head"), body = ir_block(ir, "body"), done = ir_block(ir, "done");
  loop->next = ir_block(ir, "next");
  LLVMBuildBr(ir->builder, head);
  ir_at(ir, loop->next);
  loop->next_sym = phi(ir, "sym.next");
  loop->next_arg = phi(ir, "arg.next");
  loop->next_key = phi(ir, "key.next");
  LLVMBuildBr(ir->builder, head);
  LLVMValueRef latch[] = {loop->next_sym, loop->next_arg, loop->next_key};
  LLVMValueRef *variables[] = {&step->sym, &step->arg, &step->key};
  ir_at(ir, head);
  for (int i = 0; i < 3; i++) {
    *variables[i] = phi(ir, "");
    LLVMAddIncoming(*variables[i], (LLVMValueRef[]){first[i], latch[i]}, (LLVMBasicBlockRef[]){entry, loop->next}, 2);
  }
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, step->sym, step->end, ""), done, body);
  ir_at(ir, body);
  LLVMValueRef symbol = LLVMBuildLoad2(ir->builder, ir->types.symbol, step->sym, "symbol");
  LLVMSetAlignment(symbol, 1);
  dispatch(loop->rewrite, symbol);
  ir_at(ir, done);
  store_place(loop, step->sym, step->arg, step->key);
  LLVMBuildRetVoid(ir->builder);
}

// The table of this step: schedule[step % count], or what useTable chose.
static LLVMValueRef table_now(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef scan = rewrite->step->scan;
  if (!ir->schedule) {
    LLVMValueRef table = ir_load(ir, ir->types.i64, rewrite->scope.run, ir->types.run, RUN_TABLE);
    return LLVMBuildTrunc(ir->builder, table, ir->types.i32, "table");
  }
  LLVMValueRef number = ir_load(ir, ir->types.i64, scan, ir->types.scan, SCAN_STEP);
  LLVMValueRef count = ir_int(ir, ir->program->lsystems[0].schedule_count);
  LLVMValueRef at = ir_advance(ir, ir->types.i32, ir->schedule, LLVMBuildURem(ir->builder, number, count, ""));
  return LLVMBuildLoad2(ir->builder, ir->types.i32, at, "table");
}

static bool begins_branches(const Productions *productions) {
  for (size_t i = 0; i < productions->count; i++)
    for (size_t p = 0; p < productions->at[i]->left.count; p++)
      if (productions->at[i]->left.at[p].what == PATTERN_OPEN) return true;
  return false;
}

LLVMValueRef step_emit(Ir *ir) {
  if (!ir->stepping) return NULL;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr};
  LLVMValueRef function = LLVMAddFunction(ir->module, "step", LLVMFunctionType(ir->types.none, types, 2, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  ir_attribute(ir, function, 2, "noalias");
  debug_function(ir, function, (Span){0, 0});
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  Step step = {.scan = LLVMGetParam(function, 0)};
  Rewrite rewrite = {.scope = {.ir = ir, .constant_values = !ir->state}, .way = WAY_STEP, .step = &step};
  Loop loop = {.rewrite = &rewrite, .step = &step};
  step.loop = &loop;
  rewrite.out = LLVMGetParam(function, 1);
  rewrite.scope.run = ir_load(ir, ir->types.ptr, step.scan, ir->types.scan, SCAN_RUN);
  rewrite.left = ir_int(ir, 0);
  rewrite.deeper = expand_depth(ir, WAY_DECOMPOSE);
  loop.left = ir->description->left_window || begins_branches(&ir->program->lsystems[0].productions);
  loop.right = ir->description->flags & LSYS_GRAMMAR_RIGHT;
  loop.looks = loop.left || loop.right;
  if (ir->counters) step.counters = counters_create(ir);
  if (ir->schedule || ir->state) step.table = table_now(&rewrite);
  run_loop(&loop);
  return function;
}
