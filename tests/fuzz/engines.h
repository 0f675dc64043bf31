// engines.h -- one random grammar through all engines.
#ifndef LSYSC_FUZZ_ENGINES_H
#define LSYSC_FUZZ_ENGINES_H

#include "grammar.h"

#include "codegen/backend.h"

typedef enum Verdict {
  VERDICT_AGREE,
  VERDICT_REFUSED,      // the checker does not take the grammar
  VERDICT_UNSUPPORTED,  // the code generator says that it cannot do it
  VERDICT_DIFFER,
  VERDICT_CRASH,  // of the process, found by its parent
  VERDICT_LATE,   // the same: it took too long
  VERDICTS
} Verdict;

extern const char *const verdict_names[VERDICTS];

// Modules by the interpreter: of the word, and of what the homomorphism makes of it.
typedef struct Lengths {
  uint64_t word, figure;
} Lengths;

typedef struct Engines {
  const Backend *backend;
  const char *lsysc;   // path; NULL: no executables
  const char *folder;  // where executables are made
  FILE *nowhere;       // /dev/null
} Engines;

// Derives by the interpreter and by the JIT, with and without homomorphism, and by the interpreter again after the
// grammar was printed by fmt, and compares modules and argument bits; if thorough, also executables of -O0 and -O2,
// and long words on one and on seven threads. Prints what differs. lengths may be NULL.
Verdict engines_compare(const Engines *engines, const FuzzGrammar *grammar, bool thorough, Lengths *lengths);

// The same in a process of its own, so that a crash is a verdict; lengths must be shared memory. Silent unless `loud`.
Verdict engines_compare_apart(const Engines *engines, const FuzzGrammar *grammar, bool thorough, Lengths *lengths,
                              bool loud);

#endif
