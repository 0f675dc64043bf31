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
#include <stddef.h>

typedef struct LsysSink LsysSink;

// What `prepare` makes of a part, in memory of the driver's: data of any layout,
// and what the sink wants to keep from part to part on one thread. Reused.
typedef struct LsysPrepared {
  struct LsysMemory *memory;
  char *data;
  size_t used, room;
  void *scratch;  // booked, of scratch_bytes bytes; NULL at first
  size_t scratch_bytes;
  uint64_t place;  // modules of the word before the part, where the sink works by blocks
  bool declined;   // set by prepare: the part is to be taken as it is
} LsysPrepared;

// Room for size more bytes behind what is used; NULL after printing why not.
char *lsys_prepared_room(LsysPrepared *prepared, size_t size);

// Memory of a sink's own, in which the next part of the word may be written.
typedef struct LsysLoan {
  uint8_t *sym;
  double *arg;
  size_t sym_bytes, arg_room;
} LsysLoan;

struct LsysSink {
  unsigned passes;  // 1 or 2
  bool (*begin)(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass);
  bool (*take)(LsysSink *sink, const LsysWord *part);  // false: stop, an error was printed
  bool (*end)(LsysSink *sink);
  bool (*finish)(LsysSink *sink);  // after the last start word: writes what is left
  void (*destroy)(LsysSink *sink);

  // Both or neither: what take does, split into what other threads may do with a part alone, in any order (the sink is
  // only read), and what has to be done in the word's order. With a block, in modules, prepare is of use only where it
  // is known which parts a block consists of, and adds to what is prepared of the parts before.
  uint64_t block;
  bool (*prepare)(const LsysSink *sink, const LsysWord *part, LsysPrepared *prepared);
  bool (*accept)(LsysSink *sink, const LsysPrepared *prepared);

  // NULL, or: a place for the next part, which take then finds there and need not copy. A part may come from elsewhere
  // all the same: where the place is too small for the writer, or where this is false, because there is none.
  bool (*lend)(LsysSink *sink, LsysLoan *place);
};

#endif
