// baseline.h -- hand-written C for single grammars: what a row of the
// benchmark compares compiled grammars with. A baseline writes the same packed
// word (lsys/abi.h) into memory that has room for all of it.
#ifndef LSYSC_BENCHMARKS_BASELINE_H
#define LSYSC_BENCHMARKS_BASELINE_H

#include "core/pages.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct Packed {
  uint8_t *sym;
  double *arg;
  size_t nsym, narg;
  bool warm;  // the memory was written to before: blocks go past the caches, as lsysc's do
} Packed;

// Copies a block into the word, the fastest way for such pages.
static inline void put_block(void *to, const void *from, size_t bytes, bool warm) {
  if (warm && bytes >= 4096)
    lsys_copy_past(to, from, bytes);
  else
    memcpy(to, from, bytes);
}

typedef void (*Baseline)(Packed *out, unsigned steps, uint64_t seed);

void baseline_koch(Packed *out, unsigned steps, uint64_t seed);
void baseline_hilbert(Packed *out, unsigned steps, uint64_t seed);
void baseline_plant(Packed *out, unsigned steps, uint64_t seed);
void baseline_row_of_trees(Packed *out, unsigned steps, uint64_t seed);
void baseline_ternary_tree(Packed *out, unsigned steps, uint64_t seed);
void baseline_guards(Packed *out, unsigned steps, uint64_t seed);
void baseline_shrub(Packed *out, unsigned steps, uint64_t seed);
void baseline_random_tree(Packed *out, unsigned steps, uint64_t seed);
void baseline_heterocysts(Packed *out, unsigned steps, uint64_t seed);
void baseline_hogeweg(Packed *out, unsigned steps, uint64_t seed);
void baseline_signal(Packed *out, unsigned steps, uint64_t seed);

#endif
