// range.h -- a stretch of a word (--range A:LEN): by descending to it where the
// lengths of words follow from their kinds, else by passing over what is before.
#ifndef LSYS_CORE_RANGE_H
#define LSYS_CORE_RANGE_H

#include "core/options.h"
#include "core/stream.h"

typedef unsigned __int128 LsysLength;  // of words: up to 10^38 modules; longer ones count as endless

typedef struct LsysRange {
  LsysLength first, length;  // in modules, from 0
} LsysRange;

// Reads "A:LEN". False after printing what is wrong.
bool lsys_range_parse(const LsysOptionValue *value, LsysRange *range);

// A sink that lets only a range through, and stops the derivation behind it.
typedef struct LsysWindow {
  LsysSink sink;
  LsysSink *inner;
  const LsysGrammar *grammar;
  LsysLength skip, left;  // modules still to pass over, then to let through
  bool done;              // the range is complete: take has returned false for no other reason
} LsysWindow;

void lsys_window_open(LsysWindow *window, const LsysGrammar *grammar, LsysRange range, LsysSink *inner);

typedef struct LsysDescent LsysDescent;

// Derives the range of the packed word's derivation into the window, which passes over nothing more. The
// grammar has expand and a growth matrix. *place holds what is to be closed, also after a longjmp to
// worker->stop. False after printing that there is no memory.
bool lsys_descent_run(LsysDescent **place, LsysWorker *worker, const LsysWord *word, LsysWindow *window);
void lsys_descent_close(LsysDescent *descent);

#endif
