// store.h -- a whole packed word in memory, as a sink: what the step engine
// rewrites from and to, and where a word goes that is wanted in one piece.
#ifndef LSYS_CORE_STORE_H
#define LSYS_CORE_STORE_H

#include "core/memory.h"
#include "sinks/sink.h"

typedef struct LsysStore {
  LsysSink sink;  // take appends
  LsysMemory *memory;
  uint8_t *sym;
  double *arg;
  uint64_t *key;
  size_t sym_bytes, arg_room, key_room;
  uint64_t nsym, narg, nkey;
  unsigned width;
  bool fixed;     // the arrays are somebody else's and do not grow
  bool past;      // long parts from elsewhere are copied past the caches:
  size_t looked;  //   decided up to so many bytes of an array
} LsysStore;

void lsys_store_open(LsysStore *store, const LsysGrammar *grammar, LsysMemory *memory);
void lsys_store_close(LsysStore *store);

// A store in these arrays, of so many bytes and arguments, which has no keys: what does not fit is refused.
void lsys_store_open_at(LsysStore *store, const LsysGrammar *grammar, const LsysLoan *place);

// Room for a word of that size in all; false after printing that there is no memory.
bool lsys_store_reserve(LsysStore *store, uint64_t sym_bytes, uint64_t narg, uint64_t nkey);

// For a sink's lend: the room behind the word. False where there is none yet.
bool lsys_store_lend(LsysStore *store, LsysLoan *place);

// Makes it the empty word; the memory is kept.
void lsys_store_clear(LsysStore *store);

// The word, as long as the store is not written to.
LsysWord lsys_store_word(const LsysStore *store);

#endif
