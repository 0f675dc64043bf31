// derive.h -- deriving a compiled grammar's word into memory, or into a sum.
#ifndef LSYSC_BENCHMARKS_DERIVE_H
#define LSYSC_BENCHMARKS_DERIVE_H

#include "baselines/baseline.h"
#include "lsys/abi.h"

// Sizes of the word after some steps; prints what is wrong and exits on failure, as all of these.
void word_size(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, size_t *nsym, size_t *narg);

// Writes the word into out, which has room for it.
void word_store(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, Packed *out);

// The sum of bytes, as the sink of streamed words takes it.
uint64_t sum_bytes(const uint8_t *at, size_t count);

// The sum of all bytes of the word, as it streams by.
uint64_t word_sum(const LsysGrammar *grammar, uint64_t steps, uint64_t seed);

#endif
