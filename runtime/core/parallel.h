// parallel.h -- the expand engine on several threads: same words, same order, bounded memory.
#ifndef LSYS_CORE_PARALLEL_H
#define LSYS_CORE_PARALLEL_H

#include "core/stream.h"

typedef struct LsysParallel LsysParallel;

// Derives the packed word by the worker's number of steps into the sink, which is
// called on this thread only. *place holds what is to be closed, also after a
// longjmp to worker->stop. False after printing why it stopped.
bool lsys_parallel_run(LsysParallel **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink,
                       unsigned threads);

// Stops the threads and releases everything; NULL is fine.
void lsys_parallel_close(LsysParallel *parallel);

#endif
