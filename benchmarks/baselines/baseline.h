// baseline.h -- hand-written C for single grammars: what a row of the
// benchmark compares compiled grammars with. A baseline writes the same packed
// word (lsys/abi.h) into memory that has room for all of it.
#ifndef LSYSC_BENCHMARKS_BASELINE_H
#define LSYSC_BENCHMARKS_BASELINE_H

#include <stddef.h>
#include <stdint.h>

typedef struct Packed {
  uint8_t *sym;
  double *arg;
  size_t nsym, narg;
} Packed;

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
