// growth.h -- counts of modules without deriving, where they depend on kinds alone (LsysGrammar.growth).
#ifndef LSYS_CORE_GROWTH_H
#define LSYS_CORE_GROWTH_H

#include "core/bigint.h"
#include "core/derive.h"
#include "core/out.h"

// counts[k] += the exact number of modules of kind k in start word `axiom` after `steps` steps, for kind_count
// numbers that are 0. The grammar has a growth matrix. False after printing that there is no memory.
bool lsys_growth_counts(const LsysGrammar *grammar, uint32_t axiom, uint64_t steps, LsysMemory *memory,
                        LsysBig *counts);

// size[k] = how many modules a module of kind k becomes in `steps` steps, modulo 2^64, for kind_count numbers. The
// grammar has a growth matrix. False after printing that there is no memory.
bool lsys_growth_sizes(const LsysGrammar *grammar, uint64_t steps, LsysMemory *memory, uint64_t *size);

// Prints what the count sink would print for a start word.
bool lsys_growth_print(const LsysDerivation *derivation, uint32_t axiom, LsysOut *out);

#endif
