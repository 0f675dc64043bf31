// machine.c -- the names of a target and a processor -> LLVM's description of the machine.
// Ensures: what LLVM would take for something else, or stop the program for, is refused before any code is made.
#include "codegen/ir.h"

#include <llvm-c/Target.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const Span nowhere = {0, 0};

static void initialise(bool all_targets) {
  if (all_targets) {
    LLVMInitializeAllTargetInfos();
    LLVMInitializeAllTargets();
    LLVMInitializeAllTargetMCs();
    LLVMInitializeAllAsmPrinters();
  } else {
    LLVMInitializeNativeTarget();
    LLVMInitializeNativeAsmPrinter();
  }
}

// LLVM has no function that tells: it prints to standard error that it ignores the name. So that is a file meanwhile.
static bool knows_processor(LLVMTargetRef target, const char *triple, const char *cpu) {
  FILE *said = *cpu ? tmpfile() : NULL;
  int kept = said ? dup(STDERR_FILENO) : -1;
  bool known = true;
  if (kept >= 0 && dup2(fileno(said), STDERR_FILENO) >= 0) {
    char line[256];
    LLVMDisposeTargetMachine(
      LLVMCreateTargetMachine(target, triple, cpu, "", LLVMCodeGenLevelNone, LLVMRelocPIC, LLVMCodeModelDefault));
    dup2(kept, STDERR_FILENO);
    rewind(said);
    while (known && fgets(line, sizeof line, said)) known = !strstr(line, "is not a recognized processor");
  }
  if (kept >= 0) close(kept);
  if (said) fclose(said);
  return known;
}

// Words are little-endian arrays, and the grammar is laid out as abi.h has it on this machine.
static bool fits_runtime(LLVMTargetMachineRef machine) {
  LLVMTargetDataRef layout = LLVMCreateTargetDataLayout(machine);
  bool fits = LLVMPointerSize(layout) == sizeof(void *) && LLVMByteOrder(layout) == LLVMLittleEndian;
  LLVMDisposeTargetData(layout);
  return fits;
}

static LLVMTargetMachineRef create(const BackendOptions *options, const char *triple, const char *cpu,
                                   const char *features, struct Diag *diag) {
  char *why = NULL;
  LLVMTargetRef target;
  if (LLVMGetTargetFromTriple(triple, &target, &why)) {
    diag_error(diag, nowhere, "cannot generate code for %s: %s", triple, why);
    LLVMDisposeMessage(why);
    return NULL;
  }
  if (!*features && !knows_processor(target, triple, cpu)) {  // features come with this machine's own name
    diag_error(diag, nowhere, "unknown processor `%s`: %s has none of that name", cpu, LLVMGetTargetName(target));
    return NULL;
  }
  LLVMTargetMachineRef machine = LLVMCreateTargetMachine(
    target, triple, cpu, features, emit_selection(options->optimise), LLVMRelocPIC, LLVMCodeModelDefault);
  if (machine && fits_runtime(machine)) return machine;
  if (machine) LLVMDisposeTargetMachine(machine);
  diag_error(diag, nowhere, "cannot generate code for %s: the run time needs a 64-bit, little-endian machine", triple);
  return NULL;
}

LLVMTargetMachineRef machine_create(const BackendOptions *options, bool this_machine, struct Diag *diag) {
  initialise(options->target && !this_machine);
  bool native = this_machine || (options->cpu && strcmp(options->cpu, "native") == 0);
  char *triple =
    options->target && !this_machine ? LLVMNormalizeTargetTriple(options->target) : LLVMGetDefaultTargetTriple();
  char *cpu = native ? LLVMGetHostCPUName() : LLVMCreateMessage(options->cpu ? options->cpu : "");
  char *features = native ? LLVMGetHostCPUFeatures() : LLVMCreateMessage("");
  LLVMTargetMachineRef machine = create(options, triple, cpu, features, diag);
  LLVMDisposeMessage(features);
  LLVMDisposeMessage(cpu);
  LLVMDisposeMessage(triple);
  return machine;
}
