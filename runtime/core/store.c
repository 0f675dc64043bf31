// store.c -- three arrays that double; memory is kept from word to word.
#include "core/store.h"

#include "core/stream.h"

#include <string.h>

static bool make_room(LsysMemory *memory, void **at, size_t *room, size_t wanted, size_t size) {
  while (*room < wanted) {
    void *grown = lsys_memory_grow(memory, *at, room, size);
    if (!grown) return false;
    *at = grown;
  }
  return true;
}

bool lsys_store_reserve(LsysStore *store, uint64_t sym_bytes, uint64_t narg, uint64_t nkey) {
  void *sym = store->sym, *arg = store->arg, *key = store->key;
  bool well = make_room(store->memory, &sym, &store->sym_bytes, sym_bytes, 1)
           && make_room(store->memory, &arg, &store->arg_room, narg, sizeof(double))
           && make_room(store->memory, &key, &store->key_room, nkey, sizeof(uint64_t));
  store->sym = sym;
  store->arg = arg;
  store->key = key;
  return well;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  LsysStore *store = (LsysStore *)sink;
  size_t at = store->nsym * store->width, bytes = part->nsym * store->width;
  if (!lsys_store_reserve(store, at + bytes, store->narg + part->narg, store->nkey + part->nkey)) return false;
  if (bytes) memcpy(store->sym + at, part->sym, bytes);
  if (part->narg) memcpy(store->arg + store->narg, part->arg, part->narg * sizeof(double));
  if (part->nkey) memcpy(store->key + store->nkey, part->key, part->nkey * sizeof(uint64_t));
  store->nsym += part->nsym;
  store->narg += part->narg;
  store->nkey += part->nkey;
  return true;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)axiom, (void)pass;
  lsys_store_clear((LsysStore *)sink);
  return true;
}

static bool end(LsysSink *sink) {
  (void)sink;
  return true;
}

void lsys_store_open(LsysStore *store, const LsysGrammar *grammar, LsysMemory *memory) {
  *store = (LsysStore){.sink = {.passes = 1, .begin = begin, .take = take, .end = end},
                       .memory = memory,
                       .width = lsys_symbol_width(grammar)};
}

void lsys_store_close(LsysStore *store) {
  lsys_memory_free(store->memory, store->sym, store->sym_bytes, 1);
  lsys_memory_free(store->memory, store->arg, store->arg_room, sizeof(double));
  lsys_memory_free(store->memory, store->key, store->key_room, sizeof(uint64_t));
  store->sym = NULL;
  store->arg = NULL;
  store->key = NULL;
  store->sym_bytes = store->arg_room = store->key_room = 0;
}

void lsys_store_clear(LsysStore *store) {
  store->nsym = store->narg = store->nkey = 0;
}

LsysWord lsys_store_word(const LsysStore *store) {
  return (LsysWord){.sym = store->sym,
                    .arg = store->arg,
                    .key = store->key,
                    .nsym = store->nsym,
                    .narg = store->narg,
                    .nkey = store->nkey};
}
