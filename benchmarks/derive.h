// derive.h -- deriving a compiled grammar's word into memory, a sum, or a sink.
#ifndef LSYSC_BENCHMARKS_DERIVE_H
#define LSYSC_BENCHMARKS_DERIVE_H

#include "baselines/baseline.h"
#include "lsys/lsys.h"
#include "sinks/sink.h"

// Lets the word after some steps flow into a sink of one pass, through the grammar's homomorphism if shown (which then
// destroys the sink); prints what is wrong and exits on failure, as all of these.
void word_flow(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, bool shown, LsysSink *sink);

// Sizes of the word.
void word_size(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, size_t *nsym, size_t *narg);

// Writes the word into memory as users of the library do (lsys/lsys.h).
void word_store(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, LsysWhole *whole);

// The sum of bytes, as the sink of streamed words takes it.
uint64_t sum_bytes(const uint8_t *at, size_t count);

// What was seen of a word that streamed by: its sizes, and the sum of all its bytes.
typedef struct Streamed {
  uint64_t nsym, narg, sum;
} Streamed;

Streamed word_stream(const LsysGrammar *grammar, uint64_t steps, uint64_t seed);

#endif
