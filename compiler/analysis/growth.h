// growth.h -- how many modules a derivation makes, without deriving: for
// grammars whose growth matrix exists (Facts.counts_by_kind).
#ifndef LSYSC_ANALYSIS_GROWTH_H
#define LSYSC_ANALYSIS_GROWTH_H

#include "analysis/facts.h"

#include <gmp.h>

typedef enum GrowthClass {
  GROWTH_DIES,         // every word is empty from some step on
  GROWTH_POLYNOMIAL,   // length in the order of n^degree; degree 0 is bounded
  GROWTH_EXPONENTIAL,  // in the order of n^degree rate^n
} GrowthClass;

typedef struct GrowthRate {
  GrowthClass kind;
  unsigned degree;
  double rate;  // spectral radius of the matrix: 0, 1, or more
} GrowthRate;

// The growth of the words from all axioms together. (rate.c)
GrowthRate growth_rate(const Program *program, const Facts *facts);

// The number of modules of each kind in the word at a step. counts:
// program->kind_count initialised integers. (growth.c)
void growth_counts(const Program *program, const Facts *facts, const Word *axiom, uint64_t step, mpz_t *counts);

#endif
