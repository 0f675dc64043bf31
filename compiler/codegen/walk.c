// walk.c -- a loop over a word whose modules see their neighbours (DESIGN,
// engine step):
//
//   name(scan, out)    goes from scan->sym to scan->end, or beyond it where a predecessor or a cut does
//
// The cursors into the word are variables of the loop; they are stored to the
// scan where something looks around (lsys/scan.h). Contexts that ignore other
// symbols look at other scans of the same word, all of which are kept up.
// Which L-system a module belongs to is asked only where it matters: of kinds
// that more than one L-system treats in a way of its own.
#include "codegen/ir.h"

#include <string.h>

static uint8_t class_of(const Ir *ir, uint32_t view, KindId kind) {
  return ir->description->views[view].context_class[kind];
}

static uint32_t views(const Ir *ir) {
  return ir->description->view_count;
}

LLVMValueRef *walk_scans(Ir *ir, LLVMValueRef first) {
  LLVMValueRef *scans = arena_array(ir->arena, views(ir), sizeof *scans);
  scans[0] = first;
  for (uint32_t i = 1; i < views(ir); i++)
    scans[i] = ir_load(ir, ir->types.ptr, scans[i - 1], ir->types.scan, SCAN_OTHER);
  return scans;
}

bool walk_has_key(const Rewrite *rewrite, KindId kind) {
  const Ir *ir = rewrite->scope.ir;
  return ir->facts->kinds[kind].key && (rewrite->way != WAY_INTERPRET || ir->shown_keys);
}

LLVMValueRef walk_scan(const Rewrite *rewrite) {
  return rewrite->walk->scans[rewrite->scope.ir->facts->systems[rewrite->system].view];
}

// ---- going on ----------------------------------------------------------------

// Ends the block: on to the latch with the cursors given.
static void go_on(Rewrite *rewrite, LLVMValueRef sym, LLVMValueRef arg, LLVMValueRef key) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, walk->next);
  LLVMAddIncoming(walk->next_sym, &sym, &here, 1);
  LLVMAddIncoming(walk->next_arg, &arg, &here, 1);
  LLVMAddIncoming(walk->next_key, &key, &here, 1);
}

static void scan_call(Ir *ir, LLVMValueRef scan, const char *name) {
  ir_call(ir, ir_runtime(ir, name, ir->types.none, &ir->types.ptr, 1, IR_ANY), &scan, 1);
}

static void set_flag(Ir *ir, LLVMValueRef scan, unsigned field, unsigned value) {
  ir_store(ir, LLVMConstInt(ir->types.i32, value, false), scan, ir->types.scan, field);
}

// In a ring: one more module of the root's axis, if this one is.
static void count_passed(Ir *ir, LLVMValueRef scan) {
  LLVMValueRef depth = ir_load(ir, ir->types.i64, scan, ir->types.scan, SCAN_DEPTH);
  LLVMValueRef root = LLVMBuildICmp(ir->builder, LLVMIntEQ, depth, ir_int(ir, 0), "");
  LLVMValueRef passed = ir_load(ir, ir->types.i32, scan, ir->types.scan, SCAN_PASSED);
  passed = LLVMBuildAdd(ir->builder, passed, LLVMBuildZExt(ir->builder, root, ir->types.i32, ""), "");
  ir_store(ir, passed, scan, ir->types.scan, SCAN_PASSED);
}

// A seen module comes up.
static void reach(Rewrite *rewrite, uint32_t view) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  if (walk->right) set_flag(ir, walk->scans[view], SCAN_AHEAD_KNOWN, 0);
  if (walk->left && ir->description->views[view].ring) count_passed(ir, walk->scans[view]);
}

// ---- the window ----------------------------------------------------------------

static LLVMTypeRef field_type(const Ir *ir, unsigned field) {
  return field == NEIGHBOUR_ARG ? ir->types.ptr : ir->types.i32;
}

static LLVMValueRef in_scan(const Rewrite *rewrite, uint32_t view, uint32_t j, unsigned field) {
  Ir *ir = rewrite->scope.ir;
  LLVMTypeRef type = ir->types.neighbour;
  LLVMValueRef left = ir_load(ir, ir->types.ptr, rewrite->walk->scans[view], ir->types.scan, SCAN_LEFT);
  return LLVMBuildStructGEP2(ir->builder, type, ir_advance(ir, type, left, ir_int(ir, j)), field, "");
}

// Where a field of a left neighbour is kept up.
static LLVMValueRef neighbour(const Rewrite *rewrite, uint32_t view, uint32_t j, unsigned field) {
  if (!rewrite->walk->window) return in_scan(rewrite, view, j, field);
  return rewrite->walk
    ->window[((size_t)view * rewrite->scope.ir->description->left_window + j) * NEIGHBOUR_FIELDS + field];
}

static void copy_field(Ir *ir, LLVMValueRef from, LLVMValueRef to, unsigned field) {
  LLVMBuildStore(ir->builder, LLVMBuildLoad2(ir->builder, field_type(ir, field), from, ""), to);
}

LLVMValueRef walk_left(const Rewrite *rewrite, uint32_t j, unsigned field) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef at = neighbour(rewrite, ir->facts->systems[rewrite->system].view, j, field);
  return LLVMBuildLoad2(ir->builder, field_type(ir, field), at, "");
}

static void load_window(const Rewrite *rewrite, uint32_t view) {
  if (!rewrite->walk->window) return;
  for (uint32_t j = 0; j < rewrite->scope.ir->description->left_window; j++)
    for (unsigned f = 0; f < NEIGHBOUR_FIELDS; f++)
      copy_field(rewrite->scope.ir, in_scan(rewrite, view, j, f), neighbour(rewrite, view, j, f), f);
}

static void store_window(const Rewrite *rewrite, uint32_t view) {
  if (!rewrite->walk->window) return;
  for (uint32_t j = 0; j < rewrite->scope.ir->description->left_window; j++)
    for (unsigned f = 0; f < NEIGHBOUR_FIELDS; f++)
      copy_field(rewrite->scope.ir, neighbour(rewrite, view, j, f), in_scan(rewrite, view, j, f), f);
}

// Variables for the windows.
static void make_window(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  size_t count = (size_t)views(ir) * ir->description->left_window * NEIGHBOUR_FIELDS;
  rewrite->walk->window = arena_array(ir->arena, count, sizeof(LLVMValueRef));
  for (size_t i = 0; i < count; i++)
    rewrite->walk->window[i] = ir_local(ir, field_type(ir, (unsigned)(i % NEIGHBOUR_FIELDS)), 1, "left");
  for (uint32_t view = 0; view < views(ir); view++) load_window(rewrite, view);
}

// A seen module becomes the nearest one on the left.
static void move_window(Rewrite *rewrite, uint32_t view, KindId kind, LLVMValueRef arg) {
  Ir *ir = rewrite->scope.ir;
  if (rewrite->walk->begins) set_flag(ir, rewrite->walk->scans[view], SCAN_FRESH, 0);
  uint32_t window = ir->description->left_window;
  if (!window) return;
  for (uint32_t j = window; j-- > 1;)
    for (unsigned f = 0; f < NEIGHBOUR_FIELDS; f++)
      copy_field(ir, neighbour(rewrite, view, j - 1, f), neighbour(rewrite, view, j, f), f);
  LLVMValueRef fields[] = {[NEIGHBOUR_KIND] = LLVMConstInt(ir->types.i32, kind, false),
                           [NEIGHBOUR_WRAP] = LLVMConstInt(ir->types.i32, 0, false),
                           [NEIGHBOUR_ARG] = arg};
  for (unsigned f = 0; f < NEIGHBOUR_FIELDS; f++)
    LLVMBuildStore(ir->builder, fields[f], neighbour(rewrite, view, 0, f));
}

// ---- passing -------------------------------------------------------------------

// One view passes a module.
static void pass(Rewrite *rewrite, uint32_t view, KindId kind, LLVMValueRef arg) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  uint8_t class = class_of(ir, view, kind);
  if (class == LSYS_CLASS_SEEN && walk->left) move_window(rewrite, view, kind, arg);
  if (!walk->left && !walk->right) return;
  if (class == LSYS_CLASS_OPEN) {
    store_window(rewrite, view);
    scan_call(ir, walk->scans[view], "lsys_scan_open");
  }
  if (class == LSYS_CLASS_CLOSE) {
    scan_call(ir, walk->scans[view], "lsys_scan_close");
    load_window(rewrite, view);
  }
}

void walk_pass(Rewrite *rewrite, const KindId *kinds, size_t count) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  uint32_t args = 0, keys = 0;
  for (size_t i = 0; i < count; i++) {
    LLVMValueRef arg = ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, args));
    for (uint32_t view = 0; view < views(ir); view++) {
      if (i > 0 && class_of(ir, view, kinds[i]) == LSYS_CLASS_SEEN) reach(rewrite, view);
      pass(rewrite, view, kinds[i], arg);
    }
    args += ir->program->kinds[kinds[i]].arity;
    keys += walk_has_key(rewrite, kinds[i]);
  }
  go_on(rewrite, ir_advance(ir, ir->types.symbol, walk->sym, ir_int(ir, count)),
        ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, args)),
        ir_advance(ir, ir->types.i64, walk->key, ir_int(ir, keys)));
}

static void store_place(const Rewrite *rewrite, LLVMValueRef sym, LLVMValueRef arg, LLVMValueRef key) {
  Ir *ir = rewrite->scope.ir;
  for (uint32_t view = 0; view < views(ir); view++) {
    LLVMValueRef scan = rewrite->walk->scans[view];
    ir_store(ir, sym, scan, ir->types.scan, SCAN_SYM);
    ir_store(ir, arg, scan, ir->types.scan, SCAN_ARG);
    ir_store(ir, key, scan, ir->types.scan, SCAN_KEY);
  }
}

void walk_store(const Rewrite *rewrite) {
  const Walk *walk = rewrite->walk;
  store_place(rewrite, walk->sym, walk->arg, walk->key);
}

void walk_cut(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  LLVMValueRef scan = walk->scans[0];
  store_place(rewrite, ir_advance(ir, ir->types.symbol, walk->sym, ir_int(ir, 1)),
              ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, ir->program->kinds[rewrite->kind].arity)),
              ir_advance(ir, ir->types.i64, walk->key, ir_int(ir, walk_has_key(rewrite, rewrite->kind))));
  for (uint32_t view = 0; view < views(ir); view++) scan_call(ir, walk->scans[view], "lsys_cut");
  go_on(rewrite, ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_SYM),
        ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_ARG),
        ir_load(ir, ir->types.ptr, scan, ir->types.scan, SCAN_KEY));
}

// ---- the module at hand ------------------------------------------------------

// The number of the L-system that the module belongs to, once the scan has seen its delimiter.
static LLVMValueRef find_system(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  const Kind *kind = &ir->program->kinds[rewrite->kind];
  LLVMValueRef scan = rewrite->walk->scans[0];
  if (strcmp(kind->symbol, "$") == 0) scan_call(ir, scan, "lsys_scan_leave");
  LLVMValueRef system = ir_load(ir, ir->types.i32, scan, ir->types.scan, SCAN_SYSTEM);
  if (strcmp(kind->symbol, "?") == 0 && kind->arity) {
    LLVMTypeRef types[] = {ir->types.ptr, ir->types.f64};
    LLVMValueRef args[] = {scan, rewrite->args[0]};
    ir_call(ir, ir_runtime(ir, "lsys_scan_enter", ir->types.none, types, 2, IR_ANY), args, 2);
  }
  return system;
}

// One L-system without productions for the kind stands for all of them; if all have some, the main one is the rest.
static void dispatch_systems(Rewrite *rewrite, Each each) {
  Ir *ir = rewrite->scope.ir;
  size_t count = ir->program->lsystem_count, rest = count;
  rewrite->system = 0;
  if (count > 1) {
    LLVMValueRef system = find_system(rewrite);
    while (rest > 0 && expand_productions(ir, rewrite->way, rest - 1, rewrite->kind)->count) rest--;
    rest = rest ? rest - 1 : 0;
    LLVMBasicBlockRef others = ir_block(ir, "others");
    LLVMValueRef choice = LLVMBuildSwitch(ir->builder, system, others, (unsigned)count);
    for (size_t s = 0; s < count; s++) {
      if (s == rest || !expand_productions(ir, rewrite->way, s, rewrite->kind)->count) continue;
      LLVMBasicBlockRef block = ir_block(ir, "system");
      LLVMAddCase(choice, LLVMConstInt(ir->types.i32, s, false), block);
      ir_at(ir, block);
      rewrite->system = s;
      each(rewrite);
    }
    ir_at(ir, others);
    rewrite->system = rest;
  }
  each(rewrite);
}

static void rewrite_kind(Rewrite *rewrite, KindId kind, Each each) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  uint32_t arity = ir->program->kinds[kind].arity;
  rewrite->kind = kind;
  rewrite->args = arena_array(ir->arena, arity, sizeof *rewrite->args);
  for (uint32_t i = 0; i < arity; i++) {
    LLVMValueRef at = ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, i));
    rewrite->args[i] = LLVMBuildLoad2(ir->builder, ir->types.f64, at, "");
  }
  bool keyed = walk_has_key(rewrite, kind);
  rewrite->scope.key = keyed ? LLVMBuildLoad2(ir->builder, ir->types.i64, walk->key, "key") : NULL;
  for (uint32_t view = 0; view < views(ir); view++)
    if (class_of(ir, view, kind) == LSYS_CLASS_SEEN) reach(rewrite, view);
  dispatch_systems(rewrite, each);
}

// ---- the loop ------------------------------------------------------------------

static void dispatch(Rewrite *rewrite, LLVMValueRef symbol, Each each) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef unknown = ir_block(ir, "unknown");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, symbol, unknown, (unsigned)ir->program->kind_count);
  for (KindId kind = 0; kind < ir->program->kind_count; kind++) {
    if (!ir->facts->kinds[kind].reachable) continue;
    LLVMBasicBlockRef block = ir_block(ir, "kind");
    LLVMAddCase(choice, LLVMConstInt(ir->types.symbol, kind, false), block);
    ir_at(ir, block);
    rewrite_kind(rewrite, kind, each);
  }
  ir_at(ir, unknown);
  LLVMBuildUnreachable(ir->builder);
}

// How many modules there is room for, whatever they become, of those that are left.
static LLVMValueRef count_room(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  LLVMTypeRef symbol = ir->types.symbol;
  LLVMValueRef limit = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, STREAM_SYM_LIMIT);
  LLVMValueRef at = LLVMBuildLoad2(ir->builder, ir->types.ptr, rewrite->cursor[STREAM_SYM], "");
  LLVMValueRef room = LLVMBuildPtrDiff2(ir->builder, symbol, limit, at, "");
  LLVMValueRef most = ir_int(ir, line_most(ir->facts->longest_successor));
  LLVMValueRef args[] = {LLVMBuildPtrDiff2(ir->builder, symbol, walk->end, walk->sym, ""),
                         LLVMBuildUDiv(ir->builder, room, most, "")};
  return ir_call(ir, ir_intrinsic(ir, "llvm.umin", ir->types.i64), args, 2);
}

// One check for many modules: on to the head with walk->stop behind them, or to done.
static void make_room(Rewrite *rewrite, LLVMBasicBlockRef head, LLVMBasicBlockRef done) {
  Ir *ir = rewrite->scope.ir;
  Walk *walk = rewrite->walk;
  LLVMBasicBlockRef more = ir_block(ir, "more"), full = ir_block(ir, "full");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntUGE, walk->sym, walk->end, ""), done, more);
  ir_at(ir, more);
  LLVMValueRef n = count_room(rewrite);
  LLVMBuildStore(ir->builder, ir_advance(ir, ir->types.symbol, walk->sym, n), walk->stop);
  ir_branch_unlikely(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, n, ir_int(ir, 0), ""), full, head);
  LLVMAddIncoming(walk->sym, &walk->sym, &more, 1);
  LLVMAddIncoming(walk->arg, &walk->arg, &more, 1);
  LLVMAddIncoming(walk->key, &walk->key, &more, 1);
  ir_at(ir, full);
  line_write_out(rewrite);
  LLVMBuildBr(ir->builder, more);
}

static LLVMValueRef phi(Ir *ir, const char *name) {
  return LLVMBuildPhi(ir->builder, ir->types.ptr, name);
}

static void run_loop(Rewrite *rewrite, Each each) {
  Ir *ir = rewrite->scope.ir;
  Walk *walk = rewrite->walk;
  LLVMTypeRef ptr = ir->types.ptr, scan = ir->types.scan;
  LLVMValueRef first[] = {ir_load(ir, ptr, walk->scans[0], scan, SCAN_SYM),
                          ir_load(ir, ptr, walk->scans[0], scan, SCAN_ARG),
                          ir_load(ir, ptr, walk->scans[0], scan, SCAN_KEY)};
  walk->end = ir_load(ir, ptr, walk->scans[0], scan, SCAN_END);
  LLVMBasicBlockRef entry = LLVMGetInsertBlock(ir->builder);
  LLVMBasicBlockRef head = ir_block(ir, "head"), body = ir_block(ir, "body"), done = ir_block(ir, "done");
  walk->next = ir_block(ir, "next");
  LLVMBuildBr(ir->builder, head);
  ir_at(ir, walk->next);
  walk->next_sym = phi(ir, "sym.next");
  walk->next_arg = phi(ir, "arg.next");
  walk->next_key = phi(ir, "key.next");
  LLVMBuildBr(ir->builder, head);
  LLVMValueRef latch[] = {walk->next_sym, walk->next_arg, walk->next_key};
  LLVMValueRef *variables[] = {&walk->sym, &walk->arg, &walk->key};
  ir_at(ir, head);
  for (int i = 0; i < 3; i++) {
    *variables[i] = phi(ir, "");
    LLVMAddIncoming(*variables[i], (LLVMValueRef[]){first[i], latch[i]}, (LLVMBasicBlockRef[]){entry, walk->next}, 2);
  }
  if (walk->stop) {
    LLVMBasicBlockRef refill = ir_block(ir, "refill");
    LLVMValueRef stop = LLVMBuildLoad2(ir->builder, ptr, walk->stop, "stop");
    ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntULT, walk->sym, stop, ""), body, refill);
    ir_at(ir, refill);
    make_room(rewrite, head, done);
  } else {
    ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntUGE, walk->sym, walk->end, ""), done, body);
  }
  ir_at(ir, body);
  LLVMValueRef symbol = LLVMBuildLoad2(ir->builder, ir->types.symbol, walk->sym, "symbol");
  LLVMSetAlignment(symbol, 1);
  dispatch(rewrite, symbol, each);
  ir_at(ir, done);
  walk_store(rewrite);
  for (uint32_t view = 0; view < views(ir); view++) store_window(rewrite, view);  // a scan may go on from here
  line_settle(rewrite);
  LLVMBuildRetVoid(ir->builder);
}

// Whether any production that is tried looks left, or right.
static void find_contexts(const Rewrite *rewrite) {
  const Program *program = rewrite->scope.ir->program;
  Walk *walk = rewrite->walk;
  for (size_t s = 0; s < program->lsystem_count; s++) {
    const LSystem *lsystem = &program->lsystems[s];
    const Productions *productions = rewrite->way == WAY_STEP      ? &lsystem->productions
                                   : rewrite->way == WAY_DECOMPOSE ? &lsystem->decomposition.productions
                                                                   : &lsystem->homomorphism.productions;
    for (size_t i = 0; i < productions->count; i++) {
      walk->left |= productions->at[i]->left.count;
      for (size_t p = 0; p < productions->at[i]->left.count; p++)
        walk->begins |= productions->at[i]->left.at[p].what == PATTERN_OPEN;
      walk->right |= productions->at[i]->right.count;
    }
  }
}

// Whether nothing but the loop itself writes to the stream and looks around: what it keeps up can be variables.
static bool alone(const Ir *ir) {
  for (size_t s = 0; s < ir->program->lsystem_count; s++)
    if (ir->program->lsystems[s].decomposition.productions.count) return false;
  return true;
}

// Among few kinds, branches on the symbol are foretold better than a jump through a table: a fifth of the time of a
// word whose modules come in rows of unforeseen length.
static void prefer_branches(Ir *ir, LLVMValueRef function) {
  enum { FEW = 8 };
  static const char name[] = "no-jump-tables", value[] = "true";
  uint32_t kinds = 0;
  for (KindId kind = 0; kind < ir->program->kind_count; kind++) kinds += ir->facts->kinds[kind].reachable;
  if (kinds > FEW) return;
  LLVMAttributeRef attribute = LLVMCreateStringAttribute(ir->context, name, sizeof name - 1, value, sizeof value - 1);
  LLVMAddAttributeAtIndex(function, LLVMAttributeFunctionIndex, attribute);
}

LLVMValueRef walk_emit(Ir *ir, const char *name, Way way, Each begin, Each each) {
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr};
  LLVMValueRef function = LLVMAddFunction(ir->module, name, LLVMFunctionType(ir->types.none, types, 2, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  ir_attribute(ir, function, 2, "noalias");
  prefer_branches(ir, function);
  debug_function(ir, function, (Span){0, 0});
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  Walk walk = {.scans = walk_scans(ir, LLVMGetParam(function, 0))};
  Rewrite rewrite = {.scope = {.ir = ir, .constant_values = !ir->state}, .way = way, .walk = &walk};
  rewrite.out = LLVMGetParam(function, 1);
  rewrite.scope.run = ir_load(ir, ir->types.ptr, walk.scans[0], ir->types.scan, SCAN_RUN);
  rewrite.silent = way == WAY_INTERPRET;
  rewrite.left = rewrite.steps = ir_int(ir, 0);
  find_contexts(&rewrite);
  if (way == WAY_STEP && alone(ir)) {
    if (walk.left) make_window(&rewrite);
    line_hold(&rewrite);
    walk.stop = ir_local(ir, ir->types.ptr, 1, "stop");
    LLVMBuildStore(ir->builder, LLVMConstNull(ir->types.ptr), walk.stop);
    rewrite.roomy = true;
    uint64_t most = line_most(ir->facts->longest_successor);
    if (ir->room_sym < most) ir->room_sym = (uint32_t)most;
  }
  if (begin) begin(&rewrite);
  run_loop(&rewrite, each);
  return function;
}
