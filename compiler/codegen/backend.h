// backend.h -- the way into code generation. The back end is a module of its
// own (lsysc-llvm) that the driver loads only when code is generated, because
// starting LLVM costs 20 to 30 ms; a static build links it in.
#ifndef LSYSC_CODEGEN_BACKEND_H
#define LSYSC_CODEGEN_BACKEND_H

#include "analysis/facts.h"

typedef enum EmitKind { EMIT_LLVM, EMIT_BITCODE, EMIT_ASSEMBLY, EMIT_OBJECT } EmitKind;

typedef struct BackendOptions {
  EmitKind emit;
  unsigned optimise;   // 0..3
  bool debug;          // -g
  const char *target;  // triple, NULL: this machine
  const char *cpu;     // NULL: baseline; "native"
  const char *symbol;  // name of the exported descriptor, "lsys_grammar"
  bool split;          // EMIT_OBJECT: there may be several objects, to be linked together
  bool verify;         // run LLVM's verifier (always in debug builds)
  struct Laps *laps;   // NULL: nobody asks
} BackendOptions;

typedef struct Jit Jit;

// As many objects as threads that make them.
enum { BACKEND_PARTS = 2 };

typedef struct Backend {
  const char *(*version)(void);  // "LLVM 19.1.7"

  // Writes the module to out[0], and with options->split perhaps a part of it to each of out; nothing is written to
  // those that are not needed. False after reporting through diag.
  bool (*emit)(const Program *program, const Facts *facts, const LsysGrammar *description,
               const BackendOptions *options, FILE *out[BACKEND_PARTS], struct Diag *diag);

  // Compiles in memory for this machine; symbols are the run time's functions in this process.
  // NULL after reporting. The grammar lives until jit_free.
  Jit *(*jit)(const Program *program, const Facts *facts, const LsysGrammar *description, const BackendOptions *options,
              const LsysSymbol *symbols, size_t symbol_count, struct Diag *diag);
  const LsysGrammar *(*jit_grammar)(Jit *jit);
  void (*jit_free)(Jit *jit);
} Backend;

// The module's one exported object.
extern const Backend lsysc_backend;

#endif
