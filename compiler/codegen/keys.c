// keys.c -- LANGUAGE.md 5.8 in instructions: lsys/keys.h, operation for operation.
#include "codegen/ir.h"

static LLVMValueRef xor_shift(Ir *ir, LLVMValueRef z, unsigned bits) {
  return LLVMBuildXor(ir->builder, z, LLVMBuildLShr(ir->builder, z, ir_int(ir, bits), ""), "");
}

static LLVMValueRef mix64(Ir *ir, LLVMValueRef z) {
  z = LLVMBuildMul(ir->builder, xor_shift(ir, z, 30), ir_int(ir, UINT64_C(0xBF58476D1CE4E5B9)), "");
  z = LLVMBuildMul(ir->builder, xor_shift(ir, z, 27), ir_int(ir, UINT64_C(0x94D049BB133111EB)), "");
  return xor_shift(ir, z, 31);
}

LLVMValueRef key_split(Ir *ir, LLVMValueRef key, uint64_t child) {
  return mix64(ir, LLVMBuildAdd(ir->builder, key, ir_int(ir, (child + 1) * LSYS_GOLDEN), ""));
}

LLVMValueRef key_bits(Ir *ir, LLVMValueRef key, LLVMValueRef number) {
  LLVMValueRef salted = mix64(ir, LLVMBuildAdd(ir->builder, number, ir_int(ir, LSYS_DRAW_SALT), ""));
  return mix64(ir, LLVMBuildXor(ir->builder, key, salted, ""));
}

LLVMValueRef key_draw(Ir *ir, LLVMValueRef key, LLVMValueRef number) {
  LLVMValueRef high = LLVMBuildLShr(ir->builder, key_bits(ir, key, number), ir_int(ir, 11), "");
  // 53 bits: the signed conversion is exact and cheaper than the unsigned one.
  LLVMValueRef whole = LLVMBuildSIToFP(ir->builder, high, ir->types.f64, "");
  return LLVMBuildFMul(ir->builder, whole, ir_double(ir, 0x1p-53), "draw");
}

bool key_exceeds(double sum) {
  return sum > 1e-300 && sum < 1e300;
}

// A draw is n 2^-53, and its product with the sum, rounded, never falls as n grows: so the n whose products are below
// the bound are those below the least one whose product is not.
LLVMValueRef key_below(Ir *ir, LLVMValueRef bits, double sum, double bound) {
  const uint64_t all = UINT64_C(1) << 53;
  uint64_t low = 0, high = all;
  while (low < high) {
    uint64_t n = low + (high - low) / 2;
    if ((double)n * 0x1p-53 * sum < bound)
      low = n + 1;
    else
      high = n;
  }
  if (low == all) return LLVMConstInt(ir->types.i1, 1, false);
  return LLVMBuildICmp(ir->builder, LLVMIntULT, bits, ir_int(ir, low << 11), "");
}

// A helper function, so that the loop stands once in the module.
static LLVMValueRef chain_function(Ir *ir) {
  LLVMValueRef function = LLVMGetNamedFunction(ir->module, "key.chain");
  if (function) return function;
  LLVMTypeRef i64 = ir->types.i64;
  LLVMBasicBlockRef here = LLVMGetInsertBlock(ir->builder);
  function = LLVMAddFunction(ir->module, "key.chain", LLVMFunctionType(i64, (LLVMTypeRef[]){i64, i64}, 2, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  LLVMBasicBlockRef entry = LLVMAppendBasicBlockInContext(ir->context, function, "entry");
  ir_at(ir, entry);
  LLVMBasicBlockRef head = ir_block(ir, "head"), body = ir_block(ir, "body"), done = ir_block(ir, "done");
  LLVMBuildBr(ir->builder, head);

  ir_at(ir, head);
  LLVMValueRef key = LLVMBuildPhi(ir->builder, i64, "key"), steps = LLVMBuildPhi(ir->builder, i64, "steps");
  ir_branch(ir, LLVMBuildICmp(ir->builder, LLVMIntEQ, steps, ir_int(ir, 0), ""), done, body);

  ir_at(ir, body);
  LLVMValueRef key_next = key_split(ir, key, 0);
  LLVMValueRef steps_next = LLVMBuildSub(ir->builder, steps, ir_int(ir, 1), "");
  LLVMBuildBr(ir->builder, head);
  LLVMAddIncoming(key, (LLVMValueRef[]){LLVMGetParam(function, 0), key_next}, (LLVMBasicBlockRef[]){entry, body}, 2);
  LLVMAddIncoming(steps, (LLVMValueRef[]){LLVMGetParam(function, 1), steps_next}, (LLVMBasicBlockRef[]){entry, body},
                  2);

  ir_at(ir, done);
  LLVMBuildRet(ir->builder, key);
  ir_at(ir, here);
  return function;
}

LLVMValueRef key_chain(Ir *ir, LLVMValueRef key, LLVMValueRef steps) {
  return ir_call(ir, chain_function(ir), (LLVMValueRef[]){key, steps}, 2);
}
