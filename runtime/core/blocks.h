// blocks.h -- what fixed kinds become after the last few steps, ready to be copied (LsysRun.block).
#ifndef LSYS_CORE_BLOCKS_H
#define LSYS_CORE_BLOCKS_H

#include "core/stream.h"

typedef struct LsysBlocks LsysBlocks;

// Derives the blocks of every fixed kind with the grammar's own expand and enters them into the worker's run.
// Runs on the engine's thread. NULL after printing that there is no memory; a grammar without expand has
// blocks too: none for each kind.
LsysBlocks *lsys_blocks_build(LsysWorker *worker);
void lsys_blocks_free(LsysBlocks *blocks, LsysMemory *memory);

#endif
