// line.c -- a row of modules written with one check for room.
//
// A rewriting function returns with room for SPARE modules, so that what its
// caller writes up to the next call needs no check.
//
// The symbols are constants, copied from a constant of rounded-up size: the
// stores behind the last symbol hit room that the check includes and that the
// next line overwrites. Arguments and keys are stored one by one.
#include "codegen/ir.h"

#include <string.h>

// Longer rows are cut, so that a chunk need not hold a whole long successor.
#define LONGEST_LINE 256

#define SPARE 16

static LLVMTypeRef element(const Ir *ir, unsigned stream) {
  return stream == STREAM_SYM ? ir->types.symbol : stream == STREAM_ARG ? ir->types.f64 : ir->types.i64;
}

// Where the cursor of a stream stands.
static LLVMValueRef place(const Rewrite *rewrite, unsigned stream) {
  Ir *ir = rewrite->scope.ir;
  if (rewrite->cursor[stream]) return rewrite->cursor[stream];
  return LLVMBuildStructGEP2(ir->builder, ir->types.stream, rewrite->out, stream, "");
}

static LLVMValueRef cursor_now(const Rewrite *rewrite, unsigned stream) {
  Ir *ir = rewrite->scope.ir;
  return LLVMBuildLoad2(ir->builder, ir->types.ptr, place(rewrite, stream), "");
}

void line_fetch(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  for (unsigned s = 0; s < 3; s++)
    if (rewrite->cursor[s])
      LLVMBuildStore(ir->builder, ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, s), rewrite->cursor[s]);
}

void line_settle(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  for (unsigned s = 0; s < 3; s++)
    if (rewrite->cursor[s]) ir_store(ir, cursor_now(rewrite, s), rewrite->out, ir->types.stream, s);
}

// ---- cursors between functions -------------------------------------------------

unsigned line_cursor_types(const Ir *ir, LLVMTypeRef *types) {
  unsigned n = 0;
  for (unsigned s = 0; s < 3; s++)
    if (ir->uses_stream[s]) types[n++] = ir->types.ptr;
  return n;
}

LLVMTypeRef line_result_type(const Ir *ir) {
  LLVMTypeRef types[3];
  unsigned n = line_cursor_types(ir, types);
  return LLVMStructTypeInContext(ir->context, types, n, false);
}

unsigned line_cursors(const Rewrite *rewrite, LLVMValueRef *values) {
  unsigned n = 0;
  for (unsigned s = 0; s < 3; s++)
    if (rewrite->scope.ir->uses_stream[s]) values[n++] = cursor_now(rewrite, s);
  return n;
}

void line_begin(Rewrite *rewrite, LLVMValueRef function, unsigned first) {
  Ir *ir = rewrite->scope.ir;
  for (unsigned s = 0; s < 3; s++) {
    if (!ir->uses_stream[s]) continue;
    rewrite->cursor[s] = ir_local(ir, ir->types.ptr, 1, "out");
    LLVMBuildStore(ir->builder, LLVMGetParam(function, first++), rewrite->cursor[s]);
  }
}

void line_hold(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  for (unsigned s = 0; s < 3; s++)
    if (ir->uses_stream[s]) rewrite->cursor[s] = ir_local(ir, ir->types.ptr, 1, "out");
  line_fetch(rewrite);
}

static void give_back(const Rewrite *rewrite) {
  LLVMValueRef values[3];
  unsigned n = line_cursors(rewrite, values);
  LLVMBuildAggregateRet(rewrite->scope.ir->builder, values, n);
}

static void take_back(const Rewrite *rewrite, LLVMValueRef result) {
  Ir *ir = rewrite->scope.ir;
  unsigned n = 0;
  for (unsigned s = 0; s < 3; s++)
    if (ir->uses_stream[s])
      LLVMBuildStore(ir->builder, LLVMBuildExtractValue(ir->builder, result, n++, ""), place(rewrite, s));
}

// ---- room ------------------------------------------------------------------------

// cursors.flush(out) calls lsys_flush and leaves the caller's registers alone: next to never called, it must not make
// others keep what they need in memory.
static LLVMValueRef flush_function(Ir *ir) {
  LLVMValueRef function = LLVMGetNamedFunction(ir->module, "cursors.flush");
  if (function) return function;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  LLVMMetadataRef location = LLVMGetCurrentDebugLocation2(ir->builder);
  LLVMTypeRef types[] = {ir->types.ptr};
  function = LLVMAddFunction(ir->module, "cursors.flush", LLVMFunctionType(ir->types.none, types, 1, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  LLVMSetFunctionCallConv(function, ir->flush_convention);
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "nounwind");
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "cold");
  ir_attribute(ir, function, LLVMAttributeFunctionIndex, "noinline");
  LLVMSetCurrentDebugLocation2(ir->builder, NULL);
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  LLVMValueRef out = LLVMGetParam(function, 0);
  ir_call(ir, ir_runtime(ir, "lsys_flush", ir->types.none, types, 1, IR_ANY), &out, 1);
  LLVMBuildRetVoid(ir->builder);
  ir_at(ir, here);
  LLVMSetCurrentDebugLocation2(ir->builder, location);
  return function;
}

void line_write_out(const Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  line_settle(rewrite);
  ir_call(ir, flush_function(ir), (LLVMValueRef[]){rewrite->out}, 1);
  line_fetch(rewrite);
}

// Lines are rounded up.
uint64_t line_most(uint64_t n) {
  return n + 16 * (n / LONGEST_LINE + 1);
}

// From here to the end of the block there is room for that many modules.
static void set_spare(Rewrite *rewrite, uint32_t count) {
  rewrite->spare = count;
  rewrite->spare_in = LLVMGetInsertBlock(rewrite->scope.ir->builder);
}

static bool has_spare(const Rewrite *rewrite, uint32_t count) {
  return rewrite->spare_in == LLVMGetInsertBlock(rewrite->scope.ir->builder) && rewrite->spare >= count;
}

// Makes sure that there is room for count modules. What is asked for is remembered: the descriptor must promise it.
static void ask_room(Rewrite *rewrite, uint32_t count) {
  Ir *ir = rewrite->scope.ir;
  if (ir->room_sym < count) ir->room_sym = count;
  LLVMValueRef at = cursor_now(rewrite, STREAM_SYM);
  LLVMValueRef limit = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, STREAM_SYM_LIMIT);
  LLVMValueRef end = ir_advance(ir, ir->types.symbol, at, ir_int(ir, count));
  LLVMBasicBlockRef full = ir_block(ir, "full"), room = ir_block(ir, "room");
  ir_branch_unlikely(ir, LLVMBuildICmp(ir->builder, LLVMIntUGT, end, limit, ""), full, room);
  ir_at(ir, full);
  line_write_out(rewrite);
  LLVMBuildBr(ir->builder, room);
  ir_at(ir, room);
  set_spare(rewrite, count);
}

// Room for count modules and what is to be spare behind them.
static void reserve(Rewrite *rewrite, uint32_t count) {
  if (!rewrite->roomy && !has_spare(rewrite, count)) ask_room(rewrite, count + SPARE);
}

static void use_room(Rewrite *rewrite, uint32_t count) {
  rewrite->spare -= rewrite->roomy ? 0 : count;
}

void line_return(Rewrite *rewrite) {
  if (!has_spare(rewrite, SPARE)) ask_room(rewrite, SPARE);
  give_back(rewrite);
}

void line_resume(Rewrite *rewrite, LLVMValueRef result) {
  take_back(rewrite, result);
  set_spare(rewrite, SPARE);
}

// The size that is copied for count symbols: a power of two, then a multiple of 16 bytes.
static uint32_t rounded(uint32_t count, uint32_t width) {
  uint32_t bytes = count * width, size = 1;
  while (size < bytes && size < 16) size *= 2;
  if (bytes > 16) size = (bytes + 15) / 16 * 16;
  return size / width;
}

uint32_t line_symbol_bytes(const Ir *ir) {
  return ir->description->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
}

// In the target's byte order.
LLVMValueRef line_symbols(Ir *ir, const KindId *kinds, size_t count, uint32_t places) {
  uint32_t width = line_symbol_bytes(ir), all = rounded(places, width);
  bool little = LLVMByteOrder(LLVMGetModuleDataLayout(ir->module)) == LLVMLittleEndian;
  uint64_t word = 0;
  for (uint32_t i = 0; i < count; i++) word |= (uint64_t)kinds[i] << 8 * width * (little ? i : all - 1 - i);
  return LLVMConstInt(LLVMIntTypeInContext(ir->context, 8 * width * all), word, false);
}

// Up to 8 bytes are one integer, more are copied from a constant.
static void store_symbols(const Rewrite *rewrite, LLVMValueRef cursor, uint32_t count, uint32_t width) {
  Ir *ir = rewrite->scope.ir;
  const Line *line = &rewrite->line;
  uint32_t bytes = count * width;
  if (bytes <= 8) {
    LLVMValueRef value = line_symbols(ir, line->kinds.at, line->kinds.count, count);
    LLVMSetAlignment(LLVMBuildStore(ir->builder, value, cursor), width);
    return;
  }
  LLVMValueRef *symbols = arena_array(ir->arena, count, sizeof *symbols);
  for (uint32_t i = 0; i < count; i++)
    symbols[i] = LLVMConstInt(ir->types.symbol, i < line->kinds.count ? line->kinds.at[i] : 0, false);
  LLVMValueRef data = ir_data(ir, LLVMConstArray2(ir->types.symbol, symbols, count), "symbols");
  LLVMBuildMemCpy(ir->builder, cursor, width, data, width, ir_int(ir, bytes));
}

static void advance(const Rewrite *rewrite, unsigned stream, LLVMValueRef cursor, size_t count) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef end = ir_advance(ir, element(ir, stream), cursor, ir_int(ir, count));
  LLVMBuildStore(ir->builder, end, place(rewrite, stream));
}

// Arguments or keys.
static void store_row(const Rewrite *rewrite, unsigned stream, LLVMValueRef *values, size_t count) {
  Ir *ir = rewrite->scope.ir;
  if (count == 0) return;
  LLVMValueRef cursor = cursor_now(rewrite, stream);
  for (size_t i = 0; i < count; i++)
    LLVMBuildStore(ir->builder, values[i], ir_advance(ir, element(ir, stream), cursor, ir_int(ir, i)));
  advance(rewrite, stream, cursor, count);
}

void line_flush(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  Line *line = &rewrite->line;
  if (line->kinds.count == 0) return;
  uint32_t width = line_symbol_bytes(ir);
  uint32_t copied = rounded((uint32_t)line->kinds.count, width);
  reserve(rewrite, copied);
  LLVMValueRef cursor = cursor_now(rewrite, STREAM_SYM);
  store_symbols(rewrite, cursor, copied, width);
  advance(rewrite, STREAM_SYM, cursor, line->kinds.count);
  use_room(rewrite, (uint32_t)line->kinds.count);
  store_row(rewrite, STREAM_ARG, line->args.at, line->args.count);
  store_row(rewrite, STREAM_KEY, line->keys.at, line->keys.count);
  line->kinds.count = line->args.count = line->keys.count = 0;
}

void line_add(Rewrite *rewrite, KindId kind, LLVMValueRef *args, LLVMValueRef key) {
  Ir *ir = rewrite->scope.ir;
  Line *line = &rewrite->line;
  if (line->kinds.count == LONGEST_LINE) line_flush(rewrite);
  *VEC_PUSH(ir->arena, &line->kinds) = kind;
  for (uint32_t i = 0; i < ir->program->kinds[kind].arity; i++) *VEC_PUSH(ir->arena, &line->args) = args[i];
  if (key && !rewrite->silent) *VEC_PUSH(ir->arena, &line->keys) = key;
}

void line_reserve(Rewrite *rewrite, uint32_t count) {
  line_flush(rewrite);
  reserve(rewrite, count);
}

void line_copy_row(Rewrite *rewrite, LLVMValueRef symbols, uint32_t bytes, LLVMValueRef length, uint32_t longest) {
  Ir *ir = rewrite->scope.ir;
  line_flush(rewrite);
  reserve(rewrite, bytes);
  LLVMValueRef cursor = cursor_now(rewrite, STREAM_SYM);
  LLVMBuildMemCpy(ir->builder, cursor, 1, symbols, 1, ir_int(ir, bytes));
  LLVMBuildStore(ir->builder, ir_advance(ir, ir->types.symbol, cursor, length), place(rewrite, STREAM_SYM));
  use_room(rewrite, longest);
}

void line_pick(Rewrite *rewrite, LLVMValueRef symbols, LLVMValueRef count, uint32_t longest, LLVMValueRef *args,
               uint32_t arguments, LLVMValueRef arg_count) {
  Ir *ir = rewrite->scope.ir;
  uint32_t width = line_symbol_bytes(ir);
  line_flush(rewrite);
  reserve(rewrite, rounded(longest, width));
  LLVMValueRef cursor = cursor_now(rewrite, STREAM_SYM);
  LLVMSetAlignment(LLVMBuildStore(ir->builder, symbols, cursor), width);
  LLVMBuildStore(ir->builder, ir_advance(ir, ir->types.symbol, cursor, count), place(rewrite, STREAM_SYM));
  use_room(rewrite, longest);
  if (!arguments) return;
  LLVMValueRef arg = cursor_now(rewrite, STREAM_ARG);
  for (uint32_t i = 0; i < arguments; i++)
    LLVMBuildStore(ir->builder, args[i], ir_advance(ir, ir->types.f64, arg, ir_int(ir, i)));
  LLVMBuildStore(ir->builder, ir_advance(ir, ir->types.f64, arg, arg_count), place(rewrite, STREAM_ARG));
}

void line_copy(Rewrite *rewrite, LLVMValueRef symbol, LLVMValueRef *args, uint32_t arity, LLVMValueRef key) {
  Ir *ir = rewrite->scope.ir;
  reserve(rewrite, 1);
  LLVMValueRef cursor = cursor_now(rewrite, STREAM_SYM);
  LLVMSetAlignment(LLVMBuildStore(ir->builder, symbol, cursor), 1);
  advance(rewrite, STREAM_SYM, cursor, 1);
  use_room(rewrite, 1);
  store_row(rewrite, STREAM_ARG, args, arity);
  store_row(rewrite, STREAM_KEY, &key, key && !rewrite->silent);
}
