// step.h -- the step engine's driver: word after word in memory, each written
// by the grammar's `step` from the one before, or by its `expand` where no
// module looks at others.
#ifndef LSYS_CORE_STEP_H
#define LSYS_CORE_STEP_H

#include "core/spread.h"
#include "core/store.h"
#include "core/stream.h"
#include "core/walk.h"

typedef struct LsysStepper {
  LsysWorker *worker;
  uint64_t steps;
  LsysWalk walk;       // through the word that is read; unused where `expand` makes the steps
  LsysStore words[2];  // take turns: one is read while the other one is written
  LsysWriter writer;   // into a store, or the sink
  unsigned now;        // the store that holds the word, unless
  bool is_spread;      //   it is spread over threads
  LsysSpread *spread;  // NULL until it was
  unsigned threads;
  uint64_t stretch;
} LsysStepper;

// Derives the packed word by the worker's number of steps; the last word flows
// into the sink as it is written. Up to `threads` threads work on words of some stretches of so many modules, where
// the grammar allows that. False after printing why it stopped; a run that
// stops inside of a step goes to worker->stop. Close it in either case.
bool lsys_stepper_run(LsysStepper *stepper, LsysWorker *worker, const LsysWord *axiom, LsysSink *sink, unsigned threads,
                      uint64_t stretch);

// Releases what a stepper holds; one that is all zeros holds nothing.
void lsys_stepper_close(LsysStepper *stepper);

#endif
