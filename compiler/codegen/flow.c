// flow.c -- where modules go: what a chosen production wrote is handed to the
// functions of its kinds, or written if nothing rewrites it any more; a module
// to which no production applies stays.
//
// A last module is reached by a jump (same function) or a tail call, so that a
// chain of 10^6 steps takes constant stack. Other calls check the stack first.
#include "analysis/passes.h"
#include "codegen/ir.h"

// Goes on with the same function from its head.
static void jump(Rewrite *rewrite, LLVMValueRef *values) {
  LLVMBasicBlockRef here = LLVMGetInsertBlock(rewrite->scope.ir->builder);
  LLVMBuildBr(rewrite->scope.ir->builder, rewrite->again);
  for (size_t i = 0; i < rewrite->variables.count; i++) LLVMAddIncoming(rewrite->variables.at[i], &values[i], &here, 1);
}

static void leave(Rewrite *rewrite) {
  if (rewrite->done)
    LLVMBuildBr(rewrite->scope.ir->builder, rewrite->done);
  else
    line_return(rewrite);
}

// Hands a module to the function of its way. A last one ends the block.
static void pass(Rewrite *rewrite, Way way, const Derived *module, bool last) {
  Ir *ir = rewrite->scope.ir;
  uint32_t arity = ir->program->kinds[module->kind].arity;
  line_flush(rewrite);
  LLVMValueRef *values = arena_array(ir->arena, arity + (size_t)4, sizeof *values);
  unsigned n = 0;
  if (expand_takes_scan(ir, way)) values[n++] = rewrite->walk->scans[0];
  if (way != WAY_INTERPRET) values[n++] = rewrite->left;
  if (way != WAY_EXPAND) values[n++] = rewrite->deeper;
  for (uint32_t i = 0; i < arity; i++) values[n++] = module->args[i];
  LLVMValueRef key = derived_key(ir, module);
  if (key) values[n++] = key;
  if (last && way == rewrite->way && module->kind == rewrite->kind) {
    jump(rewrite, values);
    return;
  }
  LLVMValueRef call = expand_call(rewrite, way, module->kind, values, n);
  if (last && !rewrite->done) {
    LLVMSetTailCallKind(call, ir->tail_kind);
    LLVMBuildRet(ir->builder, call);
    return;
  }
  line_resume(rewrite, call);
  if (last) leave(rewrite);
}

void flow_finish(Rewrite *rewrite) {
  line_flush(rewrite);
  leave(rewrite);
}

// Writes a module of a kind that stays. Only homomorphisms can give it a key, which it keeps up to the stop.
static void write(Rewrite *rewrite, const Derived *module, bool last) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef key = rewrite->silent ? NULL : derived_key(ir, module);
  if (key && !ir->stepping) {
    LLVMValueRef steps = LLVMBuildSub(ir->builder, rewrite->left, expand_stop(ir, rewrite->out), "");
    key = key_chain(ir, key, steps);
  }
  line_add(rewrite, module->kind, module->args, key);
  if (last) flow_finish(rewrite);
}

// A module in the derivation with rewrite->left steps to go.
static void derive(Rewrite *rewrite, const Derived *module, bool last) {
  const Ir *ir = rewrite->scope.ir;
  if (ir->stepping || ir->facts->kinds[module->kind].terminal)
    write(rewrite, module, last);
  else
    pass(rewrite, WAY_EXPAND, module, last);
}

// A module that a rewriting produced.
void flow_hand_on(Rewrite *rewrite, const Derived *module, bool last) {
  const Ir *ir = rewrite->scope.ir;
  const SystemFacts *facts = &ir->facts->systems[rewrite->system];
  bool later = rewrite->way == WAY_STEP && ir->apart;  // in an order of its own, behind the step
  if (rewrite->way == WAY_INTERPRET) {
    if (facts->homomorphisms[module->kind].count)
      pass(rewrite, WAY_INTERPRET, module, last);
    else
      write(rewrite, module, last);
  } else if (facts->decompositions[module->kind].count && !later) {
    pass(rewrite, WAY_DECOMPOSE, module, last);
  } else {
    derive(rewrite, module, last);
  }
}

// ---- a chosen production -----------------------------------------------------------

// True if a module before the last is handed to a function: that call needs stack.
static bool recurs(const Rewrite *rewrite, const Word *word) {
  const Ir *ir = rewrite->scope.ir;
  for (size_t i = 0; i + 1 < word->count; i++) {
    KindId kind = word->at[i].kind;
    bool shown = ir->facts->systems[rewrite->system].homomorphisms[kind].count;
    if (rewrite->way == WAY_INTERPRET ? shown : !ir->facts->kinds[kind].terminal) return true;
  }
  return false;
}

static LLVMBasicBlockRef deep_block(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  if (rewrite->deep) return rewrite->deep;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  rewrite->deep = ir_block(ir, "deep");
  ir_at(ir, rewrite->deep);
  LLVMValueRef too_deep = ir_runtime(ir, "lsys_too_deep", ir->types.none, &ir->types.ptr, 1, IR_STOPS);
  ir_call(ir, too_deep, &rewrite->out, 1);
  LLVMBuildUnreachable(ir->builder);
  ir_at(ir, here);
  return rewrite->deep;
}

// Where the stack stands. Its pointer costs nothing, where the frame's address makes functions keep one; but it is not
// known to the quick selection of instructions below -O2.
static LLVMValueRef stack_now(Ir *ir) {
  LLVMValueRef zero = LLVMConstInt(ir->types.i32, 0, false);
  if (ir->options->optimise >= 2) return ir_call(ir, ir_intrinsic(ir, "llvm.stacksave", ir->types.ptr), NULL, 0);
  return ir_call(ir, ir_intrinsic(ir, "llvm.frameaddress", ir->types.ptr), &zero, 1);
}

static void check_stack(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef frame = stack_now(ir);
  LLVMValueRef at = LLVMBuildPtrToInt(ir->builder, frame, ir->types.i64, "");
  LLVMValueRef limit = ir_load(ir, ir->types.i64, rewrite->out, ir->types.stream, STREAM_STACK_LIMIT);
  LLVMBasicBlockRef deep = deep_block(rewrite), go = ir_block(ir, "go");
  ir_branch_unlikely(ir, LLVMBuildICmp(ir->builder, LLVMIntULT, at, limit, ""), deep, go);
  ir_at(ir, go);
}

// ---- the last steps --------------------------------------------------------------

// What is straight-line of a production: so many steps, the last of which may be its kind's, the last two those of
// the successor's leaves.
typedef struct Straight {
  unsigned levels;
  uint32_t room;  // of leaves two steps before the end; 0: they are written otherwise
} Straight;

static Straight straight(Ir *ir, const Production *production) {
  Straight s = {.levels = fuse_levels(ir, production)};
  if (s.levels < 2 && (s.room = leaf_room(ir, &production->successor)) != 0) s.levels = 2;
  return s;
}

unsigned flow_levels(Ir *ir, KindId kind) {
  const KindFacts *facts = &ir->facts->kinds[kind];
  unsigned levels = leaf_kind(ir, kind);
  if (facts->fixed) return 0;
  for (size_t i = 0; i < facts->own.count; i++) {
    unsigned own = straight(ir, facts->own.at[i]).levels;
    if (levels < own) levels = own;
  }
  return levels;
}

// Cases of a switch on the steps that are left. False if there is no other case.
static bool write_last(Rewrite *rewrite, const Production *production, const Derived *modules) {
  Ir *ir = rewrite->scope.ir;
  size_t count = production->successor.count;
  Straight s = straight(ir, production);
  unsigned first = leaf_kind(ir, rewrite->kind) ? 2 : 1;
  if (s.levels < first) return true;
  LLVMBasicBlockRef more = ir_block(ir, "more");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, rewrite->steps, more, s.levels + 1);
  for (unsigned level = first; level <= s.levels; level++) {
    LLVMBasicBlockRef block = ir_block(ir, "last");
    LLVMAddCase(choice, ir_int(ir, level), block);
    ir_at(ir, block);
    if (level == 2 && s.room)
      leaf_write_word(rewrite, modules, count, s.room);
    else
      fuse_write(rewrite, modules, count, level - 1);
    flow_finish(rewrite);
  }
  ir_at(ir, more);
  if (s.levels < rewrite->near) return true;
  LLVMBuildUnreachable(ir->builder);
  return false;
}

// The last steps straight-line, any others by calls.
void flow_take(Rewrite *rewrite, const Production *production) {
  size_t count = production->successor.count;
  const Derived *modules = successor_derive(rewrite, production);
  if (rewrite->near && !write_last(rewrite, production, modules)) return;
  if (recurs(rewrite, &production->successor)) check_stack(rewrite);
  for (size_t i = 0; i < count; i++) flow_hand_on(rewrite, &modules[i], i + 1 == count);
  if (count == 0) flow_finish(rewrite);
}

// ---- where no production applies -----------------------------------------------------

// True if what did not apply to a module now never will: its arguments stay, and nothing else decides.
static bool stays_for_ever(const Ir *ir, KindId kind) {
  const KindFacts *facts = &ir->facts->kinds[kind];
  if (facts->decompositions.count) return false;
  for (size_t i = 0; i < facts->own.count; i++) {
    const Production *p = facts->own.at[i];
    if (p->table >= 0 || p->before.count) return false;
    if ((p->guard && expr_draws(ir->program, p->guard)) || (p->weight && expr_draws(ir->program, p->weight)))
      return false;
  }
  return true;
}

void flow_stay(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  if (rewrite->way != WAY_EXPAND || stays_for_ever(ir, rewrite->kind)) {
    LLVMBuildBr(ir->builder, rewrite->self);
    return;
  }
  LLVMValueRef key = rewrite->scope.key;
  Derived self = {.kind = rewrite->kind, .args = rewrite->args, .key = key ? key_split(ir, key, 0) : NULL};
  flow_hand_on(rewrite, &self, true);
}

// The key of a module that stays, with which it is written at the stop. In the last word it counts only if it is
// shown: otherwise the way there is not worth going.
static LLVMValueRef settled_key(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef key = rewrite->scope.key, ahead = rewrite->ahead;
  if (!key || rewrite->way == WAY_INTERPRET) return NULL;
  if (!ir->shown_keys) {
    LLVMValueRef stop = expand_stop(ir, rewrite->out);
    LLVMValueRef last = LLVMBuildICmp(ir->builder, LLVMIntEQ, stop, ir_int(ir, 0), "");
    ahead = LLVMBuildSelect(ir->builder, last, ir_int(ir, 0), ahead, "");
  }
  return key_chain(ir, key, ahead);
}

// With no step or level to go, or when nothing will ever apply, the module goes on as it is.
void flow_settle(Rewrite *rewrite) {
  Derived self = {.kind = rewrite->kind, .args = rewrite->args, .key = rewrite->scope.key};
  ir_at(rewrite->scope.ir, rewrite->self);
  if (rewrite->way == WAY_DECOMPOSE) {
    derive(rewrite, &self, true);
  } else {
    LLVMValueRef key = settled_key(rewrite);
    rewrite->silent = false;
    line_add(rewrite, self.kind, self.args, key);
    flow_finish(rewrite);
  }
}
