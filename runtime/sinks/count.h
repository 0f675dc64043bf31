// count.h -- what counting by streaming (count.c) and by growth matrix (growth.c) share: the rows they print.
#ifndef LSYS_SINKS_COUNT_H
#define LSYS_SINKS_COUNT_H

#include "core/formats.h"

// The line `axiom K` above the block of a start word, where there are several.
bool lsys_count_heading(LsysOut *out, bool several, uint32_t axiom);

// The first kind with the symbol of kind: its row counts all of them.
uint32_t lsys_count_first(const LsysGrammar *grammar, uint32_t kind);

#endif
