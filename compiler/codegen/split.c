// split.c -- a module -> the part of it that one thread compiles.
//
// Each thread emits the whole module in a context of its own, which takes a
// fraction of what optimising it does, and then removes from it what falls to the
// others. Who gets what depends on the module alone: the same grammar gives the
// same objects on every machine.
// Ensures: each function has its body in exactly one part, and each part finds
// the functions of the others by hidden names; the descriptor, and what it points at, are in
// the first part.
#include "codegen/ir.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

typedef struct Share {
  LLVMValueRef function;
  size_t place, size;  // in the module; instructions
  unsigned part;
} Share;

typedef VEC(Share) Shares;

static size_t size_of(LLVMValueRef function) {
  size_t size = 0;
  for (LLVMBasicBlockRef b = LLVMGetFirstBasicBlock(function); b; b = LLVMGetNextBasicBlock(b))
    for (LLVMValueRef i = LLVMGetFirstInstruction(b); i; i = LLVMGetNextInstruction(i)) size++;
  return size;
}

static bool is_entry(const Entries *entries, LLVMValueRef function) {
  const LLVMValueRef all[] = {entries->init,  entries->axiom,     entries->expand,       entries->step,
                              entries->block, entries->decompose, entries->homomorphism, entries->interpret};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (all[i] == function) return true;
  return false;
}

static int by_size(const void *a, const void *b) {
  const Share *x = a, *y = b;
  if (x->size != y->size) return x->size < y->size ? 1 : -1;
  return x->place < y->place ? -1 : x->place > y->place;
}

// The greatest first, each to the part that has least.
static Shares share_out(Ir *ir, const Entries *entries) {
  Shares shares = {0};
  size_t load[BACKEND_PARTS] = {0}, place = 0;
  for (LLVMValueRef f = LLVMGetFirstFunction(ir->module); f; f = LLVMGetNextFunction(f)) {
    if (LLVMCountBasicBlocks(f) == 0) continue;
    if (is_entry(entries, f))
      load[0] += size_of(f);
    else
      *VEC_PUSH(ir->arena, &shares) = (Share){.function = f, .place = place++, .size = size_of(f)};
  }
  qsort(shares.at, shares.count, sizeof *shares.at, by_size);
  for (size_t i = 0; i < shares.count; i++) {
    unsigned least = 0;
    for (unsigned part = 1; part < BACKEND_PARTS; part++)
      if (load[part] < load[least]) least = part;
    shares.at[i].part = least;
    load[least] += shares.at[i].size;
  }
  return shares;
}

// Leaves a declaration. Values are replaced before they go, whoever uses them: the order in which blocks stand is none
// of execution.
static void remove_body(LLVMValueRef function) {
  for (LLVMBasicBlockRef b = LLVMGetFirstBasicBlock(function); b; b = LLVMGetNextBasicBlock(b))
    for (LLVMValueRef i = LLVMGetFirstInstruction(b), next; i; i = next) {
      next = LLVMGetNextInstruction(i);
      LLVMTypeRef type = LLVMTypeOf(i);
      if (LLVMGetTypeKind(type) != LLVMVoidTypeKind) LLVMReplaceAllUsesWith(i, LLVMGetPoison(type));
      LLVMInstructionEraseFromParent(i);
    }
  for (LLVMBasicBlockRef b; (b = LLVMGetFirstBasicBlock(function));) LLVMDeleteBasicBlock(b);
}

static void remove_unused_data(Ir *ir) {
  for (LLVMValueRef g = LLVMGetFirstGlobal(ir->module), next; g; g = next) {
    next = LLVMGetNextGlobal(g);
    if (LLVMGetLinkage(g) == LLVMPrivateLinkage && !LLVMGetFirstUse(g)) LLVMDeleteGlobal(g);
  }
}

void split_keep(Ir *ir, const Entries *entries, unsigned part) {
  Shares shares = share_out(ir, entries);
  for (size_t i = 0; i < shares.count; i++) {
    LLVMValueRef function = shares.at[i].function;
    size_t length;
    // No name of C has a dot in it, so that none of the run time's or the system's is meant.
    assert(strchr(LLVMGetValueName2(function, &length), '.'));
    LLVMSetLinkage(function, LLVMExternalLinkage);
    LLVMSetVisibility(function, LLVMHiddenVisibility);
    if (shares.at[i].part != part) remove_body(function);
  }
  for (LLVMValueRef f = LLVMGetFirstFunction(ir->module), next; part > 0 && f; f = next) {
    next = LLVMGetNextFunction(f);
    if (is_entry(entries, f)) LLVMDeleteFunction(f);
  }
  remove_unused_data(ir);
}
