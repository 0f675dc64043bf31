// jit.c -- objects in memory -> a grammar that runs in this process (ORC LLJIT).
// The only names that the code may refer to are those given as symbols and the
// memory functions that LLVM itself calls.
#include "codegen/ir.h"

#include <llvm-c/LLJIT.h>
#include <llvm-c/Orc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct Jit {
  LLVMOrcLLJITRef engine;
  const LsysGrammar *grammar;
};

// Functions that LLVM may call where an instruction has no counterpart on the machine.
static const LsysSymbol helpers[] = {
  {"memcpy", (void *)memcpy}, {"memmove", (void *)memmove}, {"memset", (void *)memset},
  {"floor", (void *)floor},   {"ceil", (void *)ceil},       {"trunc", (void *)trunc},
};
enum { HELPERS = sizeof helpers / sizeof helpers[0] };

static bool failed(LLVMErrorRef error, struct Diag *diag) {
  if (!error) return false;
  char *why = LLVMGetErrorMessage(error);
  diag_error(diag, (Span){0, 0}, "cannot run the generated code: %s", why);
  LLVMDisposeErrorMessage(why);
  return true;
}

static LLVMOrcCSymbolMapPair pair(LLVMOrcLLJITRef engine, const LsysSymbol *symbol) {
  LLVMOrcCSymbolMapPair result = {LLVMOrcLLJITMangleAndIntern(engine, symbol->name),
                                  {(LLVMOrcExecutorAddress)(uintptr_t)symbol->address,
                                   {LLVMJITSymbolGenericFlagsExported | LLVMJITSymbolGenericFlagsCallable, 0}}};
  return result;
}

static bool bind(LLVMOrcLLJITRef engine, const LsysSymbol *symbols, size_t count, struct Diag *diag) {
  LLVMOrcCSymbolMapPair *pairs = malloc((count + HELPERS) * sizeof *pairs);
  if (!pairs) {
    diag_error(diag, (Span){0, 0}, "out of memory");
    return false;
  }
  for (size_t i = 0; i < HELPERS; i++) pairs[i] = pair(engine, &helpers[i]);
  for (size_t i = 0; i < count; i++) pairs[HELPERS + i] = pair(engine, &symbols[i]);
  LLVMOrcMaterializationUnitRef unit = LLVMOrcAbsoluteSymbols(pairs, HELPERS + count);
  free(pairs);
  return !failed(LLVMOrcJITDylibDefine(LLVMOrcLLJITGetMainJITDylib(engine), unit), diag);
}

static bool load(Jit *jit, LLVMMemoryBufferRef *objects, size_t count, const char *symbol, struct Diag *diag) {
  LLVMOrcJITDylibRef library = LLVMOrcLLJITGetMainJITDylib(jit->engine);
  LLVMOrcExecutorAddress address = 0;
  for (size_t i = 0; i < count; i++) {
    LLVMMemoryBufferRef object = objects[i];
    objects[i] = NULL;
    if (failed(LLVMOrcLLJITAddObjectFile(jit->engine, library, object), diag)) return false;
  }
  if (failed(LLVMOrcLLJITLookup(jit->engine, &address, symbol), diag)) return false;
  jit->grammar = (const LsysGrammar *)(uintptr_t)address;
  return true;
}

Jit *jit_create(LLVMTargetMachineRef machine, LLVMMemoryBufferRef *objects, size_t object_count, const char *symbol,
                const LsysSymbol *symbols, size_t symbol_count, struct Diag *diag) {
  LLVMOrcLLJITBuilderRef builder = LLVMOrcCreateLLJITBuilder();
  LLVMOrcLLJITBuilderSetJITTargetMachineBuilder(builder,
                                                LLVMOrcJITTargetMachineBuilderCreateFromTargetMachine(machine));
  LLVMOrcLLJITRef engine = NULL;
  if (failed(LLVMOrcCreateLLJIT(&engine, builder), diag)) return NULL;
  Jit *jit = calloc(1, sizeof *jit);
  if (jit) jit->engine = engine;
  if (jit && bind(engine, symbols, symbol_count, diag) && load(jit, objects, object_count, symbol, diag)) return jit;
  failed(LLVMOrcDisposeLLJIT(engine), diag);
  free(jit);
  return NULL;
}

const LsysGrammar *jit_grammar(Jit *jit) {
  return jit->grammar;
}

void jit_free(Jit *jit) {
  LLVMConsumeError(LLVMOrcDisposeLLJIT(jit->engine));
  free(jit);
}
