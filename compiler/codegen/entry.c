// entry.c -- the descriptor's functions that take a packed word: a loop over
// its modules, each handed to the function of its kind or copied.
//
//   expand(out, in, steps)       homomorphism(run, in, out)
#include "codegen/ir.h"

typedef struct Reader {
  LLVMValueRef arg, key;            // where the next module's arguments and key stand
  LLVMBasicBlockRef next;           // the loop's latch,
  LLVMValueRef next_arg, next_key;  //   and its phis
} Reader;

// Leaves for the loop's latch, having read arity arguments and perhaps a key.
static void leave(Ir *ir, Reader *reader, uint32_t arity, bool keyed) {
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMValueRef arg = ir_advance(ir, ir->types.f64, reader->arg, ir_int(ir, arity));
  LLVMValueRef key = ir_advance(ir, ir->types.i64, reader->key, ir_int(ir, keyed));
  LLVMBuildBr(ir->builder, reader->next);
  LLVMAddIncoming(reader->next_arg, &arg, &here, 1);
  LLVMAddIncoming(reader->next_key, &key, &here, 1);
}

static void read(Ir *ir, const Reader *reader, uint32_t arity, bool keyed, Derived *module) {
  module->args = arena_array(ir->arena, arity, sizeof *module->args);
  for (uint32_t i = 0; i < arity; i++) {
    LLVMValueRef at = ir_advance(ir, ir->types.f64, reader->arg, ir_int(ir, i));
    module->args[i] = LLVMBuildLoad2(ir->builder, ir->types.f64, at, "");
  }
  module->key = keyed ? LLVMBuildLoad2(ir->builder, ir->types.i64, reader->key, "key") : NULL;
}

static void rewrite_module(Rewrite *rewrite, Reader *reader, KindId kind) {
  Ir *ir = rewrite->scope.ir;
  uint32_t arity = ir->program->kinds[kind].arity;
  bool keyed = walk_has_key(rewrite, kind);
  Derived module = {.kind = kind};
  read(ir, reader, arity, keyed, &module);
  LLVMValueRef *values = arena_array(ir->arena, arity + (size_t)3, sizeof *values);
  unsigned n = 0;
  values[n++] = rewrite->way == WAY_EXPAND ? rewrite->steps : rewrite->depth;
  for (uint32_t i = 0; i < arity; i++) values[n++] = module.args[i];
  if (ir->facts->kinds[kind].key)
    values[n++] = rewrite->way == WAY_INTERPRET ? image_key(ir, 0, module.key) : module.key;
  line_resume(rewrite, expand_call(rewrite, rewrite->way, kind, values, n));
  leave(ir, reader, arity, keyed);
}

// Copies modules of arity arguments that nothing rewrites.
static void copy_module(Rewrite *rewrite, Reader *reader, LLVMValueRef symbol, uint32_t arity, bool keyed) {
  Ir *ir = rewrite->scope.ir;
  Derived module = {0};
  read(ir, reader, arity, keyed, &module);
  LLVMValueRef key = rewrite->silent ? NULL : module.key;
  if (key && rewrite->way == WAY_EXPAND)
    key = key_chain(ir, key, LLVMBuildSub(ir->builder, rewrite->steps, expand_stop(ir, rewrite->out), ""));
  line_copy(rewrite, symbol, module.args, arity, key);
  leave(ir, reader, arity, keyed);
}

typedef struct Copier {  // the block that copies kinds of one shape
  uint32_t arity;
  bool keyed;
  LLVMBasicBlockRef block;
} Copier;
typedef VEC(Copier) Copiers;

static LLVMBasicBlockRef copier(Rewrite *rewrite, Reader *reader, LLVMValueRef symbol, Copiers *copiers, KindId kind) {
  Ir *ir = rewrite->scope.ir;
  uint32_t arity = ir->program->kinds[kind].arity;
  bool keyed = walk_has_key(rewrite, kind);
  for (size_t i = 0; i < copiers->count; i++)
    if (copiers->at[i].arity == arity && copiers->at[i].keyed == keyed) return copiers->at[i].block;
  LLVMBasicBlockRef block = ir_block(ir, "copy");
  *VEC_PUSH(ir->arena, copiers) = (Copier){arity, keyed, block};
  ir_at(ir, block);
  copy_module(rewrite, reader, symbol, arity, keyed);
  return block;
}

// The body of the loop: what happens to the module with this symbol.
static void dispatch(Rewrite *rewrite, Reader *reader, LLVMValueRef symbol) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef unknown = ir_block(ir, "unknown");
  LLVMValueRef choice = LLVMBuildSwitch(ir->builder, symbol, unknown, (unsigned)ir->program->kind_count);
  Copiers copiers = {0};
  for (KindId kind = 0; kind < ir->program->kind_count; kind++) {
    LLVMBasicBlockRef block;
    if (expand_function(ir, rewrite->way, 0, kind)) {
      block = ir_block(ir, "kind");
      ir_at(ir, block);
      rewrite_module(rewrite, reader, kind);
    } else {
      block = copier(rewrite, reader, symbol, &copiers, kind);
    }
    LLVMAddCase(choice, LLVMConstInt(ir->types.symbol, kind, false), block);
  }
  ir_at(ir, unknown);
  LLVMBuildUnreachable(ir->builder);
}

static LLVMValueRef loop_variable(Ir *ir, LLVMTypeRef type, LLVMValueRef first, LLVMBasicBlockRef from) {
  LLVMValueRef phi = LLVMBuildPhi(ir->builder, type, "");
  LLVMAddIncoming(phi, &first, &from, 1);
  return phi;
}

static void word_loop(Rewrite *rewrite, LLVMValueRef in) {
  Ir *ir = rewrite->scope.ir;
  LLVMTypeRef ptr = ir->types.ptr, word = ir->types.word;
  LLVMValueRef first_sym = ir_load(ir, ptr, in, word, WORD_SYM), first_arg = ir_load(ir, ptr, in, word, WORD_ARG);
  LLVMValueRef first_key = ir_load(ir, ptr, in, word, WORD_KEY);
  LLVMValueRef end = ir_advance(ir, ir->types.symbol, first_sym, ir_load(ir, ir->types.i64, in, word, WORD_NSYM));
  LLVMBasicBlockRef entry = LLVMGetInsertBlock(ir->builder);
  LLVMBasicBlockRef head = ir_block(ir, "head"), body = ir_block(ir, "body"), done = ir_block(ir, "done");
  Reader reader = {.next = ir_block(ir, "next")};
  LLVMBuildBr(ir->builder, head);
  ir_at(ir, reader.next);
  reader.next_arg = LLVMBuildPhi(ir->builder, ptr, "arg.next");
  reader.next_key = LLVMBuildPhi(ir->builder, ptr, "key.next");

  ir_at(ir, head);
  LLVMValueRef sym = loop_variable(ir, ptr, first_sym, entry);
  reader.arg = loop_variable(ir, ptr, first_arg, entry);
  reader.key = loop_variable(ir, ptr, first_key, entry);
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, sym, end, ""), done, body);

  ir_at(ir, body);
  LLVMValueRef symbol = LLVMBuildLoad2(ir->builder, ir->types.symbol, sym, "symbol");
  LLVMSetAlignment(symbol, 1);
  dispatch(rewrite, &reader, symbol);

  ir_at(ir, reader.next);
  LLVMValueRef sym_next = ir_advance(ir, ir->types.symbol, sym, ir_int(ir, 1));
  LLVMBuildBr(ir->builder, head);
  LLVMAddIncoming(sym, &sym_next, &reader.next, 1);
  LLVMAddIncoming(reader.arg, &reader.next_arg, &reader.next, 1);
  LLVMAddIncoming(reader.key, &reader.next_key, &reader.next, 1);
  ir_at(ir, done);
  line_settle(rewrite);
  LLVMBuildRetVoid(ir->builder);
}

static LLVMValueRef create(Ir *ir, const char *name, LLVMTypeRef *types) {
  LLVMValueRef function = LLVMAddFunction(ir->module, name, LLVMFunctionType(ir->types.none, types, 3, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  debug_function(ir, function, (Span){0, 0});
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  return function;
}

LLVMValueRef entry_expand(Ir *ir) {
  if (!ir->facts->context_free) return NULL;
  LLVMValueRef function = create(ir, "expand", (LLVMTypeRef[]){ir->types.ptr, ir->types.ptr, ir->types.i64});
  ir_attribute(ir, function, 1, "noalias");
  Rewrite rewrite = {.scope = {.ir = ir}, .way = WAY_EXPAND, .silent = !ir->shown_keys};
  rewrite.out = LLVMGetParam(function, 0);
  rewrite.steps = LLVMGetParam(function, 2);
  line_hold(&rewrite);
  word_loop(&rewrite, LLVMGetParam(function, 1));
  return function;
}

LLVMValueRef entry_homomorphism(Ir *ir) {
  uint32_t flags = ir->description->flags;
  if (!(flags & LSYS_GRAMMAR_HOMOMORPHISM) || flags & LSYS_GRAMMAR_WHOLE) return NULL;
  LLVMValueRef function = create(ir, "homomorphism", (LLVMTypeRef[]){ir->types.ptr, ir->types.ptr, ir->types.ptr});
  ir_attribute(ir, function, 3, "noalias");
  Rewrite rewrite = {.scope = {.ir = ir}, .way = WAY_INTERPRET, .silent = true};
  rewrite.out = LLVMGetParam(function, 2);
  rewrite.depth = expand_depth(ir, WAY_INTERPRET, 0);
  line_hold(&rewrite);
  word_loop(&rewrite, LLVMGetParam(function, 1));
  return function;
}
