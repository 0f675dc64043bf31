// fit.h -- sizes that are known before work starts (LANGUAGE.md section 8).
#ifndef LSYS_CORE_FIT_H
#define LSYS_CORE_FIT_H

#include "core/derive.h"

#define LSYS_FIT_MINUTES 1e11  // a word of more modules takes minutes to walk through

// The number of modules of the words asked for, as far as counts depend on
// kinds alone and it takes little time to tell; else 0. Infinite beyond 10^300.
double lsys_fit_modules(const LsysDerivation *derivation);

// Adds the modules of a start word to the counts of each kind; returns how many there are.
double lsys_fit_axiom(const LsysGrammar *grammar, uint32_t which, double *counts);

// next = what one step makes of counts; returns the sum. The grammar has a growth matrix.
double lsys_fit_step(const LsysGrammar *grammar, const double *counts, double *next);

// False after printing that so many modules, of a byte or more each, do not fit
// on the disk of the file at path.
bool lsys_fit_disk(double modules, const char *path);

#endif
