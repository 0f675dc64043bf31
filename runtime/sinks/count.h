// count.h -- what counting by streaming (count.c) and by growth matrix (growth.c) share: the rows they print.
#ifndef LSYS_SINKS_COUNT_H
#define LSYS_SINKS_COUNT_H

#include "core/formats.h"

// The line `axiom K` above the block of a start word, where there are several.
bool lsys_count_heading(LsysOut *out, bool several, uint32_t axiom);

// first[kind], the first kind with the same symbol: its row counts all of them. kind_count numbers, to be freed with
// lsys_memory_free; NULL after printing why not.
uint32_t *lsys_count_firsts(const LsysGrammar *grammar, LsysMemory *memory);

#endif
