// spread.h -- the step engine on several threads: a word that is spread over
// segments, each of which is rewritten by whatever thread is free.
#ifndef LSYS_CORE_SPREAD_H
#define LSYS_CORE_SPREAD_H

#include "core/store.h"
#include "core/stream.h"

typedef struct LsysSpread LsysSpread;

// Modules that a segment has at least, but the word's last one, and at most when it is cut.
enum { LSYS_STRETCH = 1 << 14 };

// Whether nothing in a step of the grammar depends on what happened before in that step.
bool lsys_spread_applies(const LsysGrammar *grammar);

// *place holds what is to be closed, also after a longjmp to worker->stop, to which all of these may go. All return
// false after printing why they stopped.
bool lsys_spread_open(LsysSpread **place, LsysWorker *worker, unsigned threads, uint64_t stretch);

// Cuts a word, which has to stay where it is until the first step is over.
void lsys_spread_begin(LsysSpread *spread, const LsysWord *word);

// Rewrites every module of the word; `step` is the number of that step.
bool lsys_spread_step(LsysSpread *spread, uint64_t step);

// The same for the last step: what is written flows into the sink.
bool lsys_spread_finish(LsysSpread *spread, uint64_t step, LsysSink *sink);

uint64_t lsys_spread_modules(const LsysSpread *spread);

// Hands the word to a sink as it is, segment by segment: on this thread alone, or with what threads can prepare.
bool lsys_spread_each(const LsysSpread *spread, LsysSink *sink);
bool lsys_spread_show(LsysSpread *spread, LsysSink *sink);

// Stops the threads and releases everything; NULL is fine.
void lsys_spread_close(LsysSpread *spread);

#endif
