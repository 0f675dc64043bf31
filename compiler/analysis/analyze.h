// analyze.h -- the report of `lsysc analyze`.
#ifndef LSYSC_ANALYSIS_ANALYZE_H
#define LSYSC_ANALYSIS_ANALYZE_H

#include "analysis/facts.h"

// Prints class, engine and the reason for it, kinds, growth matrix, growth
// rate, and the predicted modules and bytes of each step.
void analyze_print(const Program *program, const Facts *facts, FILE *out);

#endif
