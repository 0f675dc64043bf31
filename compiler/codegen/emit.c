// emit.c -- a finished module -> optimised -> bytes of the kind asked for.
#include "codegen/ir.h"

#include <llvm-c/Analysis.h>
#include <llvm-c/BitWriter.h>
#include <llvm-c/Transforms/PassBuilder.h>
#include <string.h>

static const Span nowhere = {0, 0};

// What -O0 to -O3 mean. The emitted code needs no inliner and has few loops: variables to be lifted into registers and
// what is computed twice are all that is worth looking for. default<O2> takes ten times as long and gains nothing on
// the rows of benchmarks/ (docs/PERFORMANCE.md). Most of the time goes into selecting instructions, which -O1 does
// quickly.
static const struct {
  const char *passes;
  LLVMCodeGenOptLevel selection;
} levels[] = {
  {NULL, LLVMCodeGenLevelNone},
  {"function(sroa,early-cse,simplifycfg)", LLVMCodeGenLevelNone},
  {"function(sroa,early-cse,simplifycfg,instcombine<no-verify-fixpoint>,gvn,simplifycfg)", LLVMCodeGenLevelLess},
  {"default<O3>", LLVMCodeGenLevelDefault},
};

LLVMCodeGenOptLevel emit_selection(unsigned optimise) {
  return levels[optimise].selection;
}

static bool verify(Ir *ir) {
  char *why = NULL;
  bool broken = LLVMVerifyModule(ir->module, LLVMReturnStatusAction, &why);
  if (broken) diag_error(ir->diag, nowhere, "internal error: the generated code is not well formed: %s", why);
  LLVMDisposeMessage(why);
  return !broken;
}

bool emit_passes(Ir *ir, LLVMTargetMachineRef machine) {
#ifdef NDEBUG
  bool checked = ir->options->verify;
#else
  bool checked = true;
#endif
  if (checked && !verify(ir)) return false;
  const char *passes = levels[ir->options->optimise].passes;
  if (!passes) return true;
  LLVMPassBuilderOptionsRef options = LLVMCreatePassBuilderOptions();
  LLVMErrorRef error = LLVMRunPasses(ir->module, passes, machine, options);
  LLVMDisposePassBuilderOptions(options);
  if (!error) return true;
  char *why = LLVMGetErrorMessage(error);
  diag_error(ir->diag, nowhere, "internal error: %s", why);
  LLVMDisposeErrorMessage(why);
  return false;
}

LLVMMemoryBufferRef emit_buffer(Ir *ir, LLVMTargetMachineRef machine, EmitKind kind) {
  if (kind == EMIT_BITCODE) return LLVMWriteBitcodeToMemoryBuffer(ir->module);
  if (kind == EMIT_LLVM) {
    char *text = LLVMPrintModuleToString(ir->module);
    LLVMMemoryBufferRef buffer = LLVMCreateMemoryBufferWithMemoryRangeCopy(text, strlen(text), "ir");
    LLVMDisposeMessage(text);
    return buffer;
  }
  LLVMMemoryBufferRef buffer = NULL;
  char *why = NULL;
  LLVMCodeGenFileType type = kind == EMIT_OBJECT ? LLVMObjectFile : LLVMAssemblyFile;
  if (!LLVMTargetMachineEmitToMemoryBuffer(machine, ir->module, type, &why, &buffer)) return buffer;
  diag_error(ir->diag, nowhere, "cannot generate code: %s", why);
  LLVMDisposeMessage(why);
  return NULL;
}
