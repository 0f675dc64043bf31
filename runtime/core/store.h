// store.h -- a whole packed word in memory, as a sink: what the step engine
// rewrites from and to.
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
} LsysStore;

void lsys_store_open(LsysStore *store, const LsysGrammar *grammar, LsysMemory *memory);
void lsys_store_close(LsysStore *store);

// Room for a word of that size in all; false after printing that there is no memory.
bool lsys_store_reserve(LsysStore *store, uint64_t sym_bytes, uint64_t narg, uint64_t nkey);

// Makes it the empty word; the memory is kept.
void lsys_store_clear(LsysStore *store);

// The word, as long as the store is not written to.
LsysWord lsys_store_word(const LsysStore *store);

#endif
