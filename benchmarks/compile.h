// compile.h -- a grammar file, compiled in this process for this machine.
#ifndef LSYSC_BENCHMARKS_COMPILE_H
#define LSYSC_BENCHMARKS_COMPILE_H

#include "lsys/abi.h"

typedef struct Compiled Compiled;

// Reads, checks and compiles the file at -O2; prints what is wrong and exits on failure.
// home: the folder that holds lsysc-llvm.so.
Compiled *compile_grammar(const char *path, const char *home);
const LsysGrammar *compiled_grammar(const Compiled *compiled);
void compile_release(Compiled *compiled);

#endif
