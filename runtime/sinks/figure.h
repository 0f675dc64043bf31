// figure.h -- figures of words that are never derived.
#ifndef LSYS_SINKS_FIGURE_H
#define LSYS_SINKS_FIGURE_H

#include "core/derive.h"
#include "core/out.h"

// Prints the counts and the figure of all start words that are asked for, if the grammar is such that parts of it are
// always alike; *known says whether. False after an error. Requires a growth matrix.
bool lsys_figure_print(LsysDerivation *derivation, LsysOut *out, bool *known);

#endif
