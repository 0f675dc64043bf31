// derive.h -- one derivation: a grammar with its values, seed and number of
// steps, whose words flow into sinks.
#ifndef LSYS_CORE_DERIVE_H
#define LSYS_CORE_DERIVE_H

#include "core/blocks.h"
#include "core/options.h"
#include "core/range.h"
#include "core/stream.h"

typedef struct LsysDerivation {
  LsysWorker worker;   // the run, and what belongs to its thread
  LsysBlocks *blocks;  // made when first needed
  bool has_range;      // only these modules of each word are wanted
  LsysRange range;
  bool expands;                     // by the expand engine, else by the step engine
  uint32_t told;                    // what lsys_cut_short has told
  unsigned threads;                 // that may work on a derivation
  uint64_t stretch;                 // modules: the step engine cuts words into pieces of about so many for them
  uint32_t first_axiom, axiom_end;  // the start words that are asked for
} LsysDerivation;

// Takes values, seed, steps and start words from the options and the grammar's
// defaults. False after printing what is wrong.
bool lsys_derivation_open(LsysDerivation *derivation, const LsysGrammar *grammar, const LsysOptions *options,
                          LsysMemory *memory);
void lsys_derivation_close(LsysDerivation *derivation);

// Lets the word of start word `axiom` flow into the sink once: begin, takes, end. False after printing why it stopped.
bool lsys_derivation_run(LsysDerivation *derivation, uint32_t axiom, LsysSink *sink, unsigned pass);

// Makes the blocks of the run's fixed kinds, for those who need no word. False after printing why not.
bool lsys_derivation_blocks(LsysDerivation *derivation);

#endif
