// sink.h -- what a derivation flows into: the word as text, counts, a hash,
// a turtle that draws.
//
// A driver calls begin once per start word and pass, take for each part of
// the word in order, end behind the last part. A sink with two passes gets the
// same words twice: the first pass over all start words comes before the second
// (the first to measure, the second to draw them on one page).
#ifndef LSYS_SINKS_SINK_H
#define LSYS_SINKS_SINK_H

#include "lsys/abi.h"

#include <stdbool.h>

typedef struct LsysSink LsysSink;

struct LsysSink {
  unsigned passes;  // 1 or 2
  bool (*begin)(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass);
  bool (*take)(LsysSink *sink, const LsysWord *part);  // false: stop, an error was printed
  bool (*end)(LsysSink *sink);
  bool (*finish)(LsysSink *sink);  // after the last start word: writes what is left
  void (*destroy)(LsysSink *sink);
};

#endif
