// births.h -- derivations in which every module knows the step of its birth.
#ifndef LSYS_CORE_BIRTHS_H
#define LSYS_CORE_BIRTHS_H

#include "core/stream.h"

typedef struct LsysBirths LsysBirths;

// Can births be told of the grammar's words, in what --colour-by age draws? False after printing why not.
bool lsys_births_possible(const LsysGrammar *grammar);

// Derives the packed word by worker->run.steps steps into sink, in parts as LsysRun.births has them. The grammar has
// expand. *place holds what is to be closed, also after a longjmp to worker->stop. False after an error.
bool lsys_births_run(LsysBirths **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink);
void lsys_births_close(LsysBirths *births);

#endif
