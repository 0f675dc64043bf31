// fit.h -- sizes that are known before work starts (LANGUAGE.md section 8).
#ifndef LSYS_CORE_FIT_H
#define LSYS_CORE_FIT_H

#include "core/derive.h"

// The number of modules of the words asked for, as far as counts depend on
// kinds alone and it takes little time to tell; else 0. Infinite beyond 10^300.
double lsys_fit_modules(const LsysDerivation *derivation);

// False after printing that so many modules, of a byte or more each, do not fit
// on the disk of the file at path.
bool lsys_fit_disk(double modules, const char *path);

#endif
