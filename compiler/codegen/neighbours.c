// neighbours.c -- whether a production's surroundings fit: the modules of a
// pseudo-production's predecessor, left and right contexts (LANGUAGE.md 5.4).
//
// The left context is read from the scan's window. The right one is a row of
// calls that move a cursor: past the next seen module, into the next branch.
// `[...]` becomes a loop over the branches at its place; `]` and `=` skip the
// rest of a branch, so that whatever is asked for behind them is not there.
#include "codegen/ir.h"

typedef struct Matcher {
  Rewrite *rewrite;
  const Production *production;
  Slot *slots;
  LLVMBasicBlockRef fail;
} Matcher;

static void require(Matcher *m, LLVMValueRef test) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMBasicBlockRef next = ir_block(ir, "fits");
  ir_branch(ir, test, next, m->fail);
  ir_at(ir, next);
}

static void require_kind(Matcher *m, LLVMValueRef kind, uint32_t wanted) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef number = LLVMConstInt(ir->types.i32, wanted, false);
  require(m, LLVMBuildICmp(ir->builder, LLVMIntEQ, kind, number, ""));
}

// Binds a pattern's parameters to the arguments at arg.
static void bind(Matcher *m, const Pattern *pattern, LLVMValueRef arg) {
  Ir *ir = m->rewrite->scope.ir;
  for (uint32_t i = 0; i < ir->program->kinds[pattern->kind].arity; i++) {
    LLVMValueRef at = ir_advance(ir, ir->types.f64, arg, ir_int(ir, i));
    LLVMValueRef value = LLVMBuildLoad2(ir->builder, ir->types.f64, at, "");
    slot_bind(ir, &m->slots[pattern->slot + i], value);
  }
}

// ---- the rest of a pseudo-production's predecessor ----------------------------

static void match_strict(Matcher *m) {
  Ir *ir = m->rewrite->scope.ir;
  const Walk *walk = m->rewrite->walk;
  const Context *strict = &m->production->strict;
  if (strict->count == 1) return;
  LLVMValueRef end = ir_advance(ir, ir->types.symbol, walk->sym, ir_int(ir, strict->count));
  LLVMValueRef whole = ir_load(ir, ir->types.ptr, walk->scans[0], ir->types.scan, SCAN_WHOLE);
  require(m, LLVMBuildICmp(ir->builder, LLVMIntULE, end, whole, ""));
  uint32_t args = ir->program->kinds[strict->at[0].kind].arity;
  for (size_t i = 1; i < strict->count; i++) {
    LLVMValueRef at = ir_advance(ir, ir->types.symbol, walk->sym, ir_int(ir, i));
    LLVMValueRef symbol = LLVMBuildLoad2(ir->builder, ir->types.symbol, at, "");
    LLVMSetAlignment(symbol, 1);
    require_kind(m, LLVMBuildZExt(ir->builder, symbol, ir->types.i32, ""), strict->at[i].kind);
    bind(m, &strict->at[i], ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, args)));
    args += ir->program->kinds[strict->at[i].kind].arity;
  }
}

// ---- left ----------------------------------------------------------------------

// Seen modules of the strict predecessor behind its first, which `passed` does not count yet.
static uint32_t seen_behind_first(const Matcher *m) {
  const Ir *ir = m->rewrite->scope.ir;
  const Context *strict = &m->production->strict;
  const uint8_t *class = ir->description->views[ir->facts->systems[m->rewrite->system].view].context_class;
  uint32_t seen = 0;
  for (size_t i = 1; i < strict->count; i++) seen += class[strict->at[i].kind] == LSYS_CLASS_SEEN;
  return seen;
}

// Seen modules of the root's axis up to the end of the strict predecessor, if it stands there.
static LLVMValueRef passed_with_strict(Matcher *m) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef scan = walk_scan(m->rewrite);
  LLVMValueRef passed = ir_load(ir, ir->types.i32, scan, ir->types.scan, SCAN_PASSED);
  uint32_t more = seen_behind_first(m);
  if (!more) return passed;
  LLVMValueRef depth = ir_load(ir, ir->types.i64, scan, ir->types.scan, SCAN_DEPTH);
  LLVMValueRef root = LLVMBuildICmp(ir->builder, LLVMIntEQ, depth, ir_int(ir, 0), "");
  LLVMValueRef all = LLVMBuildAdd(ir->builder, passed, LLVMConstInt(ir->types.i32, more, false), "");
  return LLVMBuildSelect(ir->builder, root, all, passed, "");
}

// In a ring, a neighbour from around the end of the word stands behind the strict predecessor.
static void require_behind(Matcher *m, uint32_t j) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef zero = LLVMConstInt(ir->types.i32, 0, false), passed = passed_with_strict(m);
  LLVMValueRef wrap = walk_left(m->rewrite, j, NEIGHBOUR_WRAP);
  LLVMValueRef near = LLVMBuildICmp(ir->builder, LLVMIntEQ, wrap, zero, "");
  LLVMValueRef behind = LLVMBuildICmp(ir->builder, LLVMIntUGT, wrap, passed, "");
  require(m, LLVMBuildOr(ir->builder, near, behind, ""));
}

static void match_left(Matcher *m) {
  Ir *ir = m->rewrite->scope.ir;
  const Context *left = &m->production->left;
  if (!left->count) return;
  LLVMValueRef scan = walk_scan(m->rewrite);
  bool ring = ir->program->lsystems[m->rewrite->system].ring;
  uint32_t j = 0;
  for (size_t p = left->count; p-- > 0;) {
    if (left->at[p].what == PATTERN_OPEN) {
      require_kind(m, ir_load(ir, ir->types.i32, scan, ir->types.scan, SCAN_FRESH), 1);
      continue;
    }
    require_kind(m, walk_left(m->rewrite, j, NEIGHBOUR_KIND), left->at[p].kind);
    if (ring) require_behind(m, j);
    bind(m, &left->at[p], walk_left(m->rewrite, j++, NEIGHBOUR_ARG));
  }
}

// ---- right ---------------------------------------------------------------------

static LLVMValueRef call(Matcher *m, const char *name, LLVMTypeRef result, LLVMValueRef *args, unsigned count) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMTypeRef types[4];
  for (unsigned i = 0; i < count; i++) types[i] = LLVMTypeOf(args[i]);
  return ir_call(ir, ir_runtime(ir, name, result, types, count, IR_ANY), args, count);
}

static LLVMValueRef make_cursor(Matcher *m) {
  return ir_local(m->rewrite->scope.ir, m->rewrite->scope.ir->types.cursor, 1, "cursor");
}

// The kind of the next seen module; first: directly behind a strict predecessor of one module.
static LLVMValueRef ahead(Matcher *m, LLVMValueRef cursor, bool first) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef args[] = {walk_scan(m->rewrite), cursor};
  return call(m, first ? "lsys_right" : "lsys_ahead", ir->types.i32, args, 2);
}

static void put_behind(Matcher *m, LLVMValueRef cursor) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef modules = LLVMConstInt(ir->types.i32, m->production->strict.count, false);
  LLVMValueRef values[] = {walk_scan(m->rewrite), cursor, modules};
  call(m, "lsys_behind", ir->types.none, values, 3);
}

static bool closes(const Matcher *m, const Pattern *pattern) {
  return pattern->what == PATTERN_CLOSE
      || (pattern->what == PATTERN_MODULE && pattern->kind == m->rewrite->scope.ir->program->close);
}

// The pattern's index behind the ] that closes the group before p.
static size_t group_end(const Matcher *m, size_t p) {
  const Context *right = &m->production->right;
  for (unsigned depth = 1; p < right->count && depth; p++) {
    if (right->at[p].what == PATTERN_OPEN) depth++;
    if (closes(m, &right->at[p])) depth--;
  }
  return p;
}

static void never(Matcher *m) {
  require(m, LLVMConstInt(m->rewrite->scope.ir->types.i1, 0, false));
}

static void match_axis(Matcher *m, size_t p, size_t end, LLVMValueRef cursor, bool first);

// [...]: the first branch at the cursor that the group p..end fits.
static void match_group(Matcher *m, size_t p, size_t end, LLVMValueRef cursor) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef inside = make_cursor(m);
  LLVMBasicBlockRef again = ir_block(ir, "branch"), fail = m->fail;
  LLVMBuildBr(ir->builder, again);
  ir_at(ir, again);
  LLVMValueRef args[] = {walk_scan(m->rewrite), cursor, inside};
  require(m, LLVMBuildTrunc(ir->builder, call(m, "lsys_branch", ir->types.i8, args, 3), ir->types.i1, ""));
  m->fail = again;
  match_axis(m, p, end, inside, false);
  m->fail = fail;
}

static void match_module(Matcher *m, const Pattern *pattern, LLVMValueRef cursor, bool first) {
  Ir *ir = m->rewrite->scope.ir;
  require_kind(m, ahead(m, cursor, first), pattern->kind);
  bind(m, pattern, ir_load(ir, ir->types.ptr, cursor, ir->types.cursor, CURSOR_FOUND));
}

static void require_closes(Matcher *m, LLVMValueRef cursor) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef args[] = {walk_scan(m->rewrite), cursor};
  require(m, LLVMBuildTrunc(ir->builder, call(m, "lsys_closes", ir->types.i8, args, 2), ir->types.i1, ""));
}

static void require_end(Matcher *m, LLVMValueRef cursor) {
  Ir *ir = m->rewrite->scope.ir;
  LLVMValueRef copy = make_cursor(m);
  LLVMBuildMemCpy(ir->builder, copy, 8, cursor, 8, LLVMSizeOf(ir->types.cursor));
  require_kind(m, ahead(m, copy, false), LSYS_NO_MODULE);
}

// Patterns p..end against what stands ahead of the cursor.
static void match_axis(Matcher *m, size_t p, size_t end, LLVMValueRef cursor, bool first) {
  const Context *right = &m->production->right;
  bool rest = false;  // the rest of the branch was skipped
  for (; p < end; p++, first = false) {
    const Pattern *pattern = &right->at[p];
    bool literal_close = closes(m, pattern) && pattern->what == PATTERN_MODULE;
    if (literal_close && !rest) require_closes(m, cursor);
    if (pattern->what == PATTERN_END && !rest) require_end(m, cursor);
    if (pattern->what == PATTERN_OPEN || (pattern->what == PATTERN_MODULE && !literal_close)) {
      if (rest) never(m);
      if (pattern->what == PATTERN_MODULE) match_module(m, pattern, cursor, first);
    }
    if (pattern->what == PATTERN_OPEN) {
      size_t behind = group_end(m, p + 1);
      match_group(m, p + 1, behind, cursor);
      p = behind - 1;
    }
    rest |= pattern->what == PATTERN_REST || closes(m, pattern);
  }
}

static bool direct(const Matcher *m) {
  const Context *right = &m->production->right;
  return m->production->strict.count == 1 && right->at[0].what == PATTERN_MODULE && !closes(m, &right->at[0]);
}

// ---- one module on the right -----------------------------------------------------
//
// The most frequent right context. Behind a seen module, the next one mostly stands there at once or behind a few
// ignored modules: the loop looks there itself, and calls where a branch or the end of the word is in between.

static uint8_t class_of(const Rewrite *rewrite, KindId kind) {
  const Ir *ir = rewrite->scope.ir;
  return ir->description->views[ir->facts->systems[rewrite->system].view].context_class[kind];
}

static bool looks_itself(const Rewrite *rewrite, const Production *production) {
  const Matcher m = {.rewrite = (Rewrite *)rewrite, .production = production};
  return rewrite->walk->sym && production->right.count == 1 && direct(&m)
      && class_of(rewrite, rewrite->kind) == LSYS_CLASS_SEEN;
}

typedef struct Look {
  LLVMValueRef sym, arg, kind, found;  // phis: of the place looked at; of the result
  LLVMBasicBlockRef again, done;
} Look;

static void look_further(Rewrite *rewrite, Look *look, uint32_t arity) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMValueRef sym = ir_advance(ir, ir->types.symbol, look->sym, ir_int(ir, 1));
  LLVMValueRef arg = ir_advance(ir, ir->types.f64, look->arg, ir_int(ir, arity));
  LLVMBuildBr(ir->builder, look->again);
  LLVMAddIncoming(look->sym, &sym, &here, 1);
  LLVMAddIncoming(look->arg, &arg, &here, 1);
}

static void look_done(Rewrite *rewrite, Look *look, LLVMValueRef kind, LLVMValueRef found) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMBuildBr(ir->builder, look->done);
  LLVMAddIncoming(look->kind, &kind, &here, 1);
  LLVMAddIncoming(look->found, &found, &here, 1);
}

// By the run time.
static void look_by_call(Rewrite *rewrite, Look *look) {
  Ir *ir = rewrite->scope.ir;
  Matcher m = {.rewrite = rewrite};
  LLVMValueRef cursor = make_cursor(&m);
  walk_store(rewrite);
  LLVMValueRef kind = ahead(&m, cursor, true);
  look_done(rewrite, look, kind, ir_load(ir, ir->types.ptr, cursor, ir->types.cursor, CURSOR_FOUND));
}

// What stands at look->sym: the neighbour, or something that lies in between.
static void look_at(Rewrite *rewrite, Look *look, LLVMBasicBlockRef call) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef symbol = LLVMBuildLoad2(ir->builder, ir->types.symbol, look->sym, "");
  LLVMSetAlignment(symbol, 1);
  LLVMBasicBlockRef seen = ir_block(ir, "seen");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, symbol, seen, (unsigned)ir->program->kind_count);
  for (KindId kind = 0; kind < ir->program->kind_count; kind++) {
    uint8_t class = class_of(rewrite, kind);
    if (class == LSYS_CLASS_SEEN || !ir->facts->kinds[kind].reachable) continue;
    LLVMBasicBlockRef block = class == LSYS_CLASS_OPEN ? call : ir_block(ir, "between");
    LLVMAddCase(choice, LLVMConstInt(ir->types.symbol, kind, false), block);
    if (class == LSYS_CLASS_OPEN) continue;
    ir_at(ir, block);
    if (class == LSYS_CLASS_IGNORED)
      look_further(rewrite, look, ir->program->kinds[kind].arity);
    else
      look_done(rewrite, look, LLVMConstInt(ir->types.i32, LSYS_NO_MODULE, false), look->arg);
  }
  ir_at(ir, seen);
  look_done(rewrite, look, LLVMBuildZExt(ir->builder, symbol, ir->types.i32, ""), look->arg);
}

// The kind and the arguments of the next seen module behind the one at hand.
static void look(Rewrite *rewrite, LLVMValueRef *kind, LLVMValueRef *found) {
  Ir *ir = rewrite->scope.ir;
  const Walk *walk = rewrite->walk;
  Look look = {.again = ir_block(ir, "look"), .done = ir_block(ir, "looked")};
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder), at = ir_block(ir, "at"), call = ir_block(ir, "call");
  LLVMValueRef sym = ir_advance(ir, ir->types.symbol, walk->sym, ir_int(ir, 1));
  LLVMValueRef arg = ir_advance(ir, ir->types.f64, walk->arg, ir_int(ir, ir->program->kinds[rewrite->kind].arity));
  LLVMBuildBr(ir->builder, look.again);
  ir_at(ir, look.done);
  look.kind = LLVMBuildPhi(ir->builder, ir->types.i32, "ahead");
  look.found = LLVMBuildPhi(ir->builder, ir->types.ptr, "found");
  ir_at(ir, look.again);
  look.sym = LLVMBuildPhi(ir->builder, ir->types.ptr, "");
  look.arg = LLVMBuildPhi(ir->builder, ir->types.ptr, "");
  LLVMAddIncoming(look.sym, &sym, &here, 1);
  LLVMAddIncoming(look.arg, &arg, &here, 1);
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, look.sym, walk->end, ""), call, at);
  ir_at(ir, call);
  look_by_call(rewrite, &look);
  ir_at(ir, at);
  look_at(rewrite, &look, call);
  ir_at(ir, look.done);
  *kind = look.kind;
  *found = look.found;
}

void neighbours_prepare(Rewrite *rewrite, const Productions *productions) {
  Walk *walk = rewrite->walk;
  size_t looking = 0, others = 0;
  for (size_t i = 0; i < productions->count; i++) {
    const Production *production = productions->at[i];
    if (!production->right.count) continue;
    looks_itself(rewrite, production) ? looking++ : others++;
  }
  walk->ahead = NULL;
  if (others) walk_store(rewrite);
  if (looking > 1) look(rewrite, &walk->ahead, &walk->found);  // once for all of them
}

static void match_one(Matcher *m) {
  LLVMValueRef kind = m->rewrite->walk->ahead, found = m->rewrite->walk->found;
  if (!kind) look(m->rewrite, &kind, &found);
  require_kind(m, kind, m->production->right.at[0].kind);
  bind(m, &m->production->right.at[0], found);
}

static void match_right(Matcher *m) {
  const Context *right = &m->production->right;
  if (!right->count) return;
  if (looks_itself(m->rewrite, m->production)) {
    match_one(m);
    return;
  }
  LLVMValueRef cursor = make_cursor(m);
  bool first = direct(m);
  if (!first) put_behind(m, cursor);
  match_axis(m, 0, right->count, cursor, first);
}

void neighbours_require(Rewrite *rewrite, const Production *production, Slot *slots, LLVMBasicBlockRef fail) {
  Matcher matcher = {rewrite, production, slots, fail};
  match_strict(&matcher);
  match_left(&matcher);
  match_right(&matcher);
}
