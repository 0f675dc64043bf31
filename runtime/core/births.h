// births.h -- derivations in which every module knows the step of its birth.
#ifndef LSYS_CORE_BIRTHS_H
#define LSYS_CORE_BIRTHS_H

#include "core/stream.h"

typedef struct LsysBirths LsysBirths;

// Derives the packed word by worker->run.steps steps into sink, in parts as LsysRun.births has them. The grammar has
// expand. *place holds what is to be closed, also after a longjmp to worker->stop. False after an error.
bool lsys_births_run(LsysBirths **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink);
void lsys_births_close(LsysBirths *births);

// The same with the grammar's step, and with its blocks. (births_step.c)
typedef struct LsysBirthsStep LsysBirthsStep;
bool lsys_births_step(LsysBirthsStep **place, LsysWorker *worker, const LsysWord *axiom, LsysSink *sink);
void lsys_births_step_close(LsysBirthsStep *births);

// Whether two words are the same but for their keys: a module that becomes itself alone is not born again.
bool lsys_births_same(const LsysGrammar *grammar, const LsysWord *a, const LsysWord *b);

#endif
