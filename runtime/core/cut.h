// cut.h -- where to cut a derivation, and a word, into stretches for threads.
#ifndef LSYS_CORE_CUT_H
#define LSYS_CORE_CUT_H

#include "core/stream.h"

// A word that is taken apart from its beginning.
typedef struct LsysCut {
  const LsysGrammar *grammar;
  LsysWord rest;
} LsysCut;

void lsys_cut_begin(LsysCut *cut, const LsysGrammar *grammar, const LsysWord *word);

// The next stretch of at most `modules` modules.
LsysWord lsys_cut_take(LsysCut *cut, uint64_t modules);

// What threads could do beside deriving: nothing, what the sink does with any part, or with blocks of a word only.
typedef enum LsysCutWork { LSYS_CUT_ALONE, LSYS_CUT_PARTS, LSYS_CUT_BLOCKS } LsysCutWork;

// How many of the worker's steps are the last ones, that threads derive stretch by
// stretch, and how many modules of the word before them make a stretch. All of
// the steps: threads would not help, or there is no telling. Words that consist of
// blocks cost nothing to derive: for them threads help only a sink that shares its
// work. Derives samples.
// Returns 0 after printing that there is no memory.
uint64_t lsys_cut_choose(const LsysWorker *worker, const LsysWord *word, LsysCutWork work, uint64_t *modules);

#endif
