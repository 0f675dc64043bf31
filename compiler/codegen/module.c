// module.c -- an empty LLVM module that knows the run time's structs, and the
// small instructions that every emitter needs.
//
// The mirrors of abi.h stand here and nowhere else. The static assertions say
// that field N of a mirror is the C field of that name: both list only
// pointers and fixed-width integers in natural alignment, so that equal
// offsets on this machine mean equal order everywhere.
#include "codegen/ir.h"

#include <stddef.h>
#include <string.h>

#define TAILCC 18u  // llvm::CallingConv::Tail
#define FASTCC 8u   // llvm::CallingConv::Fast
#define KEEPCC 14u  // llvm::CallingConv::PreserveMost: PreserveAll loses upper halves of AVX registers to vzeroupper

#define MIRROR(Type, field, place) _Static_assert(offsetof(Type, field) == (place), #Type "." #field " moved")
MIRROR(LsysStream, sym, 8 * STREAM_SYM);
MIRROR(LsysStream, arg, 8 * STREAM_ARG);
MIRROR(LsysStream, key, 8 * STREAM_KEY);
MIRROR(LsysStream, sym_limit, 8 * STREAM_SYM_LIMIT);
MIRROR(LsysStream, run, 8 * STREAM_RUN);
MIRROR(LsysStream, stop, 8 * STREAM_STOP);
MIRROR(LsysStream, stack_limit, 8 * STREAM_STACK_LIMIT);
MIRROR(LsysWord, sym, 8 * WORD_SYM);
MIRROR(LsysWord, arg, 8 * WORD_ARG);
MIRROR(LsysWord, key, 8 * WORD_KEY);
MIRROR(LsysWord, nsym, 8 * WORD_NSYM);
MIRROR(LsysWord, narg, 8 * WORD_NARG);
MIRROR(LsysWord, nkey, 8 * WORD_NKEY);
MIRROR(LsysBlock, sym, 8 * BLOCK_SYM);
MIRROR(LsysBlock, arg, 8 * BLOCK_ARG);
MIRROR(LsysBlock, nsym, 8 * BLOCK_NSYM);
MIRROR(LsysBlock, narg, 8 * BLOCK_NARG);
MIRROR(LsysScan, sym, 8 * SCAN_SYM);
MIRROR(LsysScan, end, 8 * SCAN_END);
MIRROR(LsysScan, arg, 8 * SCAN_ARG);
MIRROR(LsysScan, key, 8 * SCAN_KEY);
MIRROR(LsysScan, left, 8 * SCAN_LEFT);
MIRROR(LsysScan, run, 8 * SCAN_RUN);
MIRROR(LsysScan, step, 8 * SCAN_STEP);
MIRROR(LsysScan, depth, 8 * SCAN_DEPTH);
MIRROR(LsysScan, fresh, 8 * SCAN_FRESH);
MIRROR(LsysScan, ahead_known, 8 * SCAN_FRESH + 4);
MIRROR(LsysScan, passed, 8 * SCAN_FRESH + 8);
MIRROR(LsysScan, system, 8 * SCAN_FRESH + 12);
MIRROR(LsysScan, other, 8 * SCAN_FRESH + 16);
MIRROR(LsysScan, whole, 8 * SCAN_FRESH + 24);
MIRROR(LsysNeighbour, wrap, 4);
MIRROR(LsysNeighbour, arg, 8);
MIRROR(LsysCursor, found, 8 * CURSOR_FOUND);
MIRROR(LsysCursor, segment, 8 * CURSOR_SEGMENT);
MIRROR(LsysRun, grammar, 8 * RUN_GRAMMAR);
MIRROR(LsysRun, value, 8 * RUN_VALUE);
MIRROR(LsysRun, root, 8 * RUN_ROOT);
MIRROR(LsysRun, steps, 8 * RUN_STEPS);
MIRROR(LsysRun, block, 8 * RUN_BLOCK);
MIRROR(LsysRun, block_levels, 8 * RUN_BLOCK_LEVELS);
MIRROR(LsysRun, table, 8 * RUN_TABLE);
MIRROR(LsysRun, stopped, 8 * RUN_STOPPED);

static LLVMTypeRef mirror(LLVMContextRef context, const char *name, LLVMTypeRef *fields, unsigned count) {
  LLVMTypeRef type = LLVMStructCreateNamed(context, name);
  LLVMStructSetBody(type, fields, count, false);
  return type;
}

#define MIRROR_TYPE(name, ...)                                                                                         \
  mirror(context, name, (LLVMTypeRef[]){__VA_ARGS__}, sizeof((LLVMTypeRef[]){__VA_ARGS__}) / sizeof(LLVMTypeRef))

static void make_types(IrTypes *t, LLVMContextRef context, bool wide) {
  t->none = LLVMVoidTypeInContext(context);
  t->i1 = LLVMInt1TypeInContext(context);
  t->i8 = LLVMInt8TypeInContext(context);
  t->i16 = LLVMInt16TypeInContext(context);
  t->i32 = LLVMInt32TypeInContext(context);
  t->i64 = LLVMInt64TypeInContext(context);
  t->f64 = LLVMDoubleTypeInContext(context);
  t->ptr = LLVMPointerTypeInContext(context, 0);
  t->symbol = wide ? t->i16 : t->i8;
  LLVMTypeRef ptr = t->ptr, i64 = t->i64, i32 = t->i32, f64 = t->f64;
  t->word = MIRROR_TYPE("word", ptr, ptr, ptr, i64, i64, i64);
  t->stream = MIRROR_TYPE("stream", ptr, ptr, ptr, ptr, ptr, i64, i64);
  t->block = MIRROR_TYPE("block", ptr, ptr, i64, i64);
  t->run = MIRROR_TYPE("run", ptr, ptr, i64, i64, ptr, ptr, i64, i64);
  t->kind = MIRROR_TYPE("kind", ptr, t->i16, t->i8, t->i8);
  t->param = MIRROR_TYPE("param", ptr, i32, f64, f64, ptr);
  t->axiom = MIRROR_TYPE("axiom", t->word);
  t->growth = MIRROR_TYPE("growth", ptr, ptr, ptr);
  t->scan = MIRROR_TYPE("scan", ptr, ptr, ptr, ptr, ptr, ptr, i64, i64, i32, i32, i32, i32, ptr, ptr);
  t->neighbour = MIRROR_TYPE("neighbour", i32, i32, ptr);
  t->cursor = MIRROR_TYPE("cursor", ptr, ptr, ptr, ptr, i32, i32);
}

// True if x86-64 hands all parameters of all rewriting functions over in registers. Then optimised code jumps to a last
// callee under the ordinary convention, too, and saves what TAILCC costs there: functions that return by `ret 8`, and
// callers that put the stack pointer back.
static bool in_registers(const Ir *ir) {
  enum { INTEGERS = 6, NUMBERS = 8, STREAM_AND_COUNTS = 3 };
  unsigned integers = STREAM_AND_COUNTS;
  for (unsigned s = 0; s < 3; s++) integers += ir->uses_stream[s];
  if (integers + (ir->uses_stream[STREAM_KEY] ? 1 : 0) > INTEGERS) return false;
  for (KindId k = 0; k < ir->program->kind_count; k++)
    if (ir->program->kinds[k].arity > NUMBERS) return false;
  return true;
}

void ir_create(Ir *ir, LLVMContextRef context, LLVMTargetMachineRef machine) {
  ir->uses_stream[STREAM_SYM] = true;
  for (KindId k = 0; k < ir->program->kind_count; k++) ir->uses_stream[STREAM_ARG] |= ir->program->kinds[k].arity > 0;
  ir->uses_stream[STREAM_KEY] = ir->description->flags & LSYS_GRAMMAR_RANDOM;
  ir->context = context;
  ir->module = LLVMModuleCreateWithNameInContext(ir->program->name, context);
  ir->builder = LLVMCreateBuilderInContext(context);
  char *triple = LLVMGetTargetMachineTriple(machine);
  LLVMSetTarget(ir->module, triple);
  LLVMTargetDataRef layout = LLVMCreateTargetDataLayout(machine);
  LLVMSetModuleDataLayout(ir->module, layout);
  LLVMDisposeTargetData(layout);
  // Chains of last successors must take constant stack at every -O: only these back ends promise it.
  bool promised = strncmp(triple, "x86_64", 6) == 0 || strncmp(triple, "aarch64", 7) == 0;
  bool plain = !promised || (ir->options->optimise >= 2 && strncmp(triple, "x86_64", 6) == 0 && in_registers(ir));
  ir->tail_convention = plain ? FASTCC : TAILCC;
  ir->tail_kind = plain ? LLVMTailCallKindTail : LLVMTailCallKindMustTail;
  ir->flush_convention = promised && ir->options->optimise >= 2 ? KEEPCC : LLVMCCallConv;
  LLVMDisposeMessage(triple);
  make_types(&ir->types, context, ir->description->flags & LSYS_GRAMMAR_WIDE);
}

void ir_destroy(Ir *ir) {
  LLVMDisposeBuilder(ir->builder);
  LLVMDisposeModule(ir->module);
}

// ---- constants -------------------------------------------------------------

LLVMValueRef ir_int(const Ir *ir, uint64_t value) {
  return LLVMConstInt(ir->types.i64, value, false);
}

LLVMValueRef ir_double(const Ir *ir, double value) {
  return LLVMConstReal(ir->types.f64, value);
}

bool ir_is_double(LLVMValueRef value, double *number) {
  if (!LLVMIsAConstantFP(value)) return false;
  LLVMBool lossy;
  *number = LLVMConstRealGetDouble(value, &lossy);
  return true;
}

LLVMValueRef ir_data(Ir *ir, LLVMValueRef constant, const char *name) {
  LLVMValueRef global = LLVMAddGlobal(ir->module, LLVMTypeOf(constant), name);
  LLVMSetInitializer(global, constant);
  LLVMSetGlobalConstant(global, true);
  LLVMSetLinkage(global, LLVMPrivateLinkage);
  LLVMSetUnnamedAddress(global, LLVMGlobalUnnamedAddr);
  return global;
}

// ---- memory ----------------------------------------------------------------

static LLVMValueRef field_address(Ir *ir, LLVMValueRef object, LLVMTypeRef object_type, unsigned field) {
  return field ? LLVMBuildStructGEP2(ir->builder, object_type, object, field, "") : object;
}

LLVMValueRef ir_load(Ir *ir, LLVMTypeRef type, LLVMValueRef object, LLVMTypeRef object_type, unsigned field) {
  return LLVMBuildLoad2(ir->builder, type, field_address(ir, object, object_type, field), "");
}

void ir_store(Ir *ir, LLVMValueRef value, LLVMValueRef object, LLVMTypeRef object_type, unsigned field) {
  LLVMBuildStore(ir->builder, value, field_address(ir, object, object_type, field));
}

void ir_mark(Ir *ir, LLVMValueRef instruction, const char *name) {
  LLVMMetadataRef empty = LLVMMDNodeInContext2(ir->context, NULL, 0);
  unsigned kind = LLVMGetMDKindIDInContext(ir->context, name, (unsigned)strlen(name));
  LLVMSetMetadata(instruction, kind, LLVMMetadataAsValue(ir->context, empty));
}

void ir_mark_invariant(Ir *ir, LLVMValueRef load) {
  ir_mark(ir, load, "invariant.load");
}

LLVMValueRef ir_advance(Ir *ir, LLVMTypeRef element, LLVMValueRef pointer, LLVMValueRef count) {
  if (LLVMIsNull(count)) return pointer;
  return LLVMBuildInBoundsGEP2(ir->builder, element, pointer, &count, 1, "");
}

// The start of the function being built: where variables of every path live.
static void at_entry(Ir *ir) {
  LLVMValueRef function = LLVMGetBasicBlockParent(LLVMGetInsertBlock(ir->builder));
  LLVMBasicBlockRef entry = LLVMGetEntryBasicBlock(function);
  LLVMValueRef first = LLVMGetFirstInstruction(entry);
  if (first)
    LLVMPositionBuilderBefore(ir->builder, first);
  else
    LLVMPositionBuilderAtEnd(ir->builder, entry);
}

LLVMValueRef ir_local(Ir *ir, LLVMTypeRef type, uint64_t count, const char *name) {
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  at_entry(ir);
  LLVMValueRef variable = count == 1 ? LLVMBuildAlloca(ir->builder, type, name)
                                     : LLVMBuildArrayAlloca(ir->builder, type, ir_int(ir, count), name);
  ir_at(ir, here);
  return variable;
}

// ---- control ---------------------------------------------------------------

LLVMBasicBlockRef ir_block(Ir *ir, const char *name) {
  LLVMValueRef function = LLVMGetBasicBlockParent(LLVMGetInsertBlock(ir->builder));
  return LLVMAppendBasicBlockInContext(ir->context, function, name);
}

void ir_at(Ir *ir, LLVMBasicBlockRef block) {
  LLVMPositionBuilderAtEnd(ir->builder, block);
}

void ir_branch(Ir *ir, LLVMValueRef condition, LLVMBasicBlockRef yes, LLVMBasicBlockRef no) {
  LLVMBuildCondBr(ir->builder, condition, yes, no);
}

void ir_branch_unlikely(Ir *ir, LLVMValueRef condition, LLVMBasicBlockRef yes, LLVMBasicBlockRef no) {
  LLVMValueRef branch = LLVMBuildCondBr(ir->builder, condition, yes, no);
  LLVMMetadataRef weights[] = {
    LLVMMDStringInContext2(ir->context, "branch_weights", strlen("branch_weights")),
    LLVMValueAsMetadata(LLVMConstInt(ir->types.i32, 1, false)),
    LLVMValueAsMetadata(LLVMConstInt(ir->types.i32, 2000, false)),
  };
  unsigned kind = LLVMGetMDKindIDInContext(ir->context, "prof", 4);
  LLVMSetMetadata(branch, kind, LLVMMetadataAsValue(ir->context, LLVMMDNodeInContext2(ir->context, weights, 3)));
}

// ---- functions -------------------------------------------------------------

LLVMValueRef ir_call(Ir *ir, LLVMValueRef function, LLVMValueRef *args, unsigned count) {
  LLVMValueRef call = LLVMBuildCall2(ir->builder, LLVMGlobalGetValueType(function), function, args, count, "");
  LLVMSetInstructionCallConv(call, LLVMGetFunctionCallConv(function));
  return call;
}

// Places: LLVMAttributeFunctionIndex, or 1 + a parameter's number. An attribute that this LLVM does not know is left
// out.
void ir_attribute(Ir *ir, LLVMValueRef function, unsigned place, const char *name) {
  unsigned kind = LLVMGetEnumAttributeKindForName(name, strlen(name));
  if (kind) LLVMAddAttributeAtIndex(function, place, LLVMCreateEnumAttribute(ir->context, kind, 0));
}

LLVMValueRef ir_runtime(Ir *ir, const char *name, LLVMTypeRef result, LLVMTypeRef *params, unsigned count,
                        IrEffect effect) {
  LLVMValueRef function = LLVMGetNamedFunction(ir->module, name);
  if (function) return function;
  function = LLVMAddFunction(ir->module, name, LLVMFunctionType(result, params, count, false));
  unsigned all = LLVMAttributeFunctionIndex;
  ir_attribute(ir, function, all, "nounwind");
  if (effect == IR_PURE) {
    ir_attribute(ir, function, all, "willreturn");
    ir_attribute(ir, function, all, "memory");  // value 0 is memory(none)
  } else {
    ir_attribute(ir, function, all, "cold");
    ir_attribute(ir, function, all, "noinline");
  }
  if (effect == IR_STOPS) ir_attribute(ir, function, all, "noreturn");
  return function;
}

LLVMValueRef ir_intrinsic(Ir *ir, const char *name, LLVMTypeRef type) {
  unsigned id = LLVMLookupIntrinsicID(name, strlen(name));
  return LLVMGetIntrinsicDeclaration(ir->module, id, &type, 1);
}
