// passes.h -- the steps of facts_find, each in a file of its own, in the order
// in which they run, and what they share.
#ifndef LSYSC_ANALYSIS_PASSES_H
#define LSYSC_ANALYSIS_PASSES_H

#include "analysis/facts.h"
#include "analysis/uses.h"

typedef struct Analysis {
  Arena *arena;
  const Program *program;
  Facts *facts;
  Uses uses;
  Productions *rewrites;  // per kind: every L-system's productions and decompositions of it
  Productions *images;    // per kind: every L-system's homomorphism productions of it
} Analysis;

// productions.c: Facts.systems, .views, KindFacts.own, .decompositions, .homomorphisms, and the lists above.
void find_productions(Analysis *analysis);

// True if a production applies to every module of its kind, whatever its arguments, neighbours and the step.
bool production_always(const Program *program, const Production *production);

// True if it never does: its guard is a constant that does not hold.
bool production_never(const Program *program, const Production *production);

// reach.c: KindFacts.reachable, .terminal, .key, .fixed. Needs the lists.
void find_reachable(Analysis *analysis);
void find_keys(Analysis *analysis);
void find_fixed(Analysis *analysis);

// balance.c: Facts.balanced. Needs the lists and KindFacts.reachable.
void find_balance(Analysis *analysis);

// matrix.c: Facts.counts_by_kind and .growth. Needs the lists.
void find_growth(Analysis *analysis);

#endif
