// interp.h -- the reference interpreter: a plain evaluation of the Program,
// written for the reader, that every engine is compared with bit for bit.
#ifndef LSYSC_INTERP_INTERP_H
#define LSYSC_INTERP_INTERP_H

#include "analysis/facts.h"

// Completes a description with the interpreter's init, axiom, derive and homomorphism; the result runs
// under lsys_main like a compiled grammar. program and description must outlive it.
LsysGrammar *interp_grammar(Arena *arena, const Program *program, const LsysGrammar *description);

// Releases the words that the last runs left behind (a run that was stopped in
// the middle leaves them too). The grammar can be run again.
void interp_release(const LsysGrammar *grammar);

#endif
