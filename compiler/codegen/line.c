// line.c -- a row of modules written with one check for room.
//
// The symbols are constants, copied from a constant of rounded-up size: the
// stores behind the last symbol hit room that the check includes and that the
// next line overwrites. Arguments and keys are stored one by one.
#include "codegen/ir.h"

#include <string.h>

// Longer rows are cut, so that a chunk need not hold a whole long successor.
#define LONGEST_LINE 256

typedef struct Cursors {
  LLVMValueRef sym, arg, key;
} Cursors;

static LLVMTypeRef element(const Ir *ir, unsigned stream) {
  return stream == STREAM_SYM ? ir->types.symbol : stream == STREAM_ARG ? ir->types.f64 : ir->types.i64;
}

static uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

// i1: the stream has less than count elements' room.
static LLVMValueRef lacks(Rewrite *rewrite, unsigned stream, LLVMValueRef cursor, uint32_t count) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef limit = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, STREAM_SYM_LIMIT + stream);
  LLVMValueRef room = LLVMBuildPtrDiff2(ir->builder, element(ir, stream), limit, cursor, "");
  return LLVMBuildICmp(ir->builder, LLVMIntSLT, room, ir_int(ir, count), "");
}

// The cursors, where each stream has the room asked for; unused ones are NULL.
static Cursors room(Rewrite *rewrite, const uint32_t *counts) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef before[3] = {0}, after[3] = {0}, full = NULL;
  for (unsigned s = 0; s < 3; s++) {
    if (!counts[s]) continue;
    before[s] = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, s);
    LLVMValueRef lack = lacks(rewrite, s, before[s], counts[s]);
    full = full ? LLVMBuildOr(ir->builder, full, lack, "") : lack;
  }
  LLVMBasicBlockRef check = LLVMGetInsertBlock(ir->builder), flush = ir_block(ir, "flush"), go = ir_block(ir, "room");
  ir_branch_unlikely(ir, full, flush, go);
  ir_at(ir, flush);
  LLVMValueRef lsys_flush = ir_runtime(ir, "lsys_flush", ir->types.none, &ir->types.ptr, 1, IR_ANY);
  ir_call(ir, lsys_flush, &rewrite->out, 1);
  for (unsigned s = 0; s < 3; s++)
    if (counts[s]) after[s] = ir_load(ir, ir->types.ptr, rewrite->out, ir->types.stream, s);
  LLVMBuildBr(ir->builder, go);
  ir_at(ir, go);
  LLVMValueRef cursor[3] = {0};
  for (unsigned s = 0; s < 3; s++) {
    if (!counts[s]) continue;
    cursor[s] = LLVMBuildPhi(ir->builder, ir->types.ptr, "");
    LLVMAddIncoming(cursor[s], (LLVMValueRef[]){before[s], after[s]}, (LLVMBasicBlockRef[]){check, flush}, 2);
  }
  return (Cursors){cursor[0], cursor[1], cursor[2]};
}

// The size that is copied for count symbols: a power of two, then a multiple of 16 bytes.
static uint32_t rounded(uint32_t count, uint32_t width) {
  uint32_t bytes = count * width, size = 1;
  while (size < bytes && size < 16) size *= 2;
  if (bytes > 16) size = (bytes + 15) / 16 * 16;
  return size / width;
}

static void store_symbols(Rewrite *rewrite, LLVMValueRef cursor, uint32_t room_sym, uint32_t width) {
  Ir *ir = rewrite->scope.ir;
  const Line *line = &rewrite->line;
  LLVMValueRef *symbols = arena_array(ir->arena, room_sym, sizeof *symbols);
  for (uint32_t i = 0; i < room_sym; i++)
    symbols[i] = LLVMConstInt(ir->types.symbol, i < line->kinds.count ? line->kinds.at[i] : 0, false);
  LLVMValueRef data = ir_data(ir, LLVMConstArray2(ir->types.symbol, symbols, room_sym), "symbols");
  LLVMBuildMemCpy(ir->builder, cursor, width, data, width, ir_int(ir, (uint64_t)room_sym * width));
}

static void store_row(Rewrite *rewrite, unsigned stream, LLVMValueRef cursor, LLVMValueRef *values, size_t count) {
  Ir *ir = rewrite->scope.ir;
  LLVMTypeRef type = element(ir, stream);
  for (size_t i = 0; i < count; i++)
    LLVMBuildStore(ir->builder, values[i], ir_advance(ir, type, cursor, ir_int(ir, i)));
}

static void advance(Rewrite *rewrite, unsigned stream, LLVMValueRef cursor, size_t count) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef end = ir_advance(ir, element(ir, stream), cursor, ir_int(ir, count));
  ir_store(ir, end, rewrite->out, ir->types.stream, stream);
}

// Room for counts, remembered as what the descriptor must promise.
static Cursors reserve(Rewrite *rewrite, const uint32_t *counts) {
  Ir *ir = rewrite->scope.ir;
  ir->room_sym = larger(ir->room_sym, counts[0]);
  ir->room_arg = larger(ir->room_arg, counts[1]);
  ir->room_key = larger(ir->room_key, counts[2]);
  return room(rewrite, counts);
}

void line_flush(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  Line *line = &rewrite->line;
  if (line->kinds.count == 0) return;
  uint32_t width = ir->description->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
  uint32_t counts[3] = {rounded((uint32_t)line->kinds.count, width), (uint32_t)line->args.count,
                        (uint32_t)line->keys.count};
  Cursors at = reserve(rewrite, counts);
  store_symbols(rewrite, at.sym, counts[0], width);
  store_row(rewrite, STREAM_ARG, at.arg, line->args.at, line->args.count);
  store_row(rewrite, STREAM_KEY, at.key, line->keys.at, line->keys.count);
  advance(rewrite, STREAM_SYM, at.sym, line->kinds.count);
  if (counts[1]) advance(rewrite, STREAM_ARG, at.arg, counts[1]);
  if (counts[2]) advance(rewrite, STREAM_KEY, at.key, counts[2]);
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

void line_copy(Rewrite *rewrite, LLVMValueRef symbol, LLVMValueRef *args, uint32_t arity, LLVMValueRef key) {
  Ir *ir = rewrite->scope.ir;
  bool keyed = key && !rewrite->silent;
  uint32_t counts[3] = {1, arity, keyed};
  Cursors at = reserve(rewrite, counts);
  LLVMSetAlignment(LLVMBuildStore(ir->builder, symbol, at.sym), 1);
  store_row(rewrite, STREAM_ARG, at.arg, args, arity);
  store_row(rewrite, STREAM_KEY, at.key, &key, keyed);
  advance(rewrite, STREAM_SYM, at.sym, 1);
  if (arity) advance(rewrite, STREAM_ARG, at.arg, arity);
  if (keyed) advance(rewrite, STREAM_KEY, at.key, 1);
}
