// store.c -- three arrays that double; memory is kept from word to word.
#include "core/store.h"

#include "core/message.h"
#include "core/pages.h"
#include "core/stream.h"

#include <string.h>

enum {
  CACHED = 1 << 23,   // bytes: a word up to here is likely still in a cache when it is read
  DECIDED = 1 << 21,  // bytes between two looks at pages, which are huge ones at best
  LEAST_PAST = 1 << 12,
};

static bool make_room(LsysMemory *memory, void **at, size_t *room, size_t wanted, size_t size) {
  while (*room < wanted) {
    void *grown = lsys_memory_grow(memory, *at, room, size);
    if (!grown) return false;
    *at = grown;
  }
  return true;
}

bool lsys_store_reserve(LsysStore *store, uint64_t sym_bytes, uint64_t narg, uint64_t nkey) {
  if (store->fixed) {
    if (sym_bytes <= store->sym_bytes && narg <= store->arg_room && nkey <= store->key_room) return true;
    lsys_error("the word does not fit into the memory that was given for it: %zu bytes of symbols, %zu arguments",
               store->sym_bytes, store->arg_room);
    return false;
  }
  void *sym = store->sym, *arg = store->arg, *key = store->key;
  bool well = make_room(store->memory, &sym, &store->sym_bytes, sym_bytes, 1)
           && make_room(store->memory, &arg, &store->arg_room, narg, sizeof(double))
           && make_room(store->memory, &key, &store->key_room, nkey, sizeof(uint64_t));
  store->sym = sym;
  store->arg = arg;
  store->key = key;
  return well;
}

// Decides how what follows is written: by a page ahead in the array where the greater part of the word grows, which
// what was written so far has not brought along.
static void look_ahead(LsysStore *store) {
  size_t symbols = store->nsym * store->width, arguments = store->narg * sizeof(double);
  bool arg = arguments > symbols;
  const char *array = arg ? (const char *)store->arg : (const char *)store->sym;
  size_t at = arg ? arguments : symbols, room = arg ? store->arg_room * sizeof(double) : store->sym_bytes;
  if (at < store->looked) return;
  store->looked = at + DECIDED;
  size_t ahead = at + DECIDED < room ? at + DECIDED : room - 1;
  store->past = symbols + arguments > CACHED && !lsys_page_fresh(array + ahead);
}

// What was written in the store's place stands there already.
static void append(const LsysStore *store, void *array, size_t used, const void *from, size_t bytes) {
  if (bytes == 0) return;
  char *to = (char *)array + used;
  if (to == from) return;
  if (store->past && bytes >= LEAST_PAST)
    lsys_copy_past(to, from, bytes);
  else
    memcpy(to, from, bytes);
}

static bool take(LsysSink *sink, const LsysWord *part) {
  LsysStore *store = (LsysStore *)sink;
  size_t at = store->nsym * store->width, bytes = part->nsym * store->width;
  if (!lsys_store_reserve(store, at + bytes, store->narg + part->narg, store->nkey + part->nkey)) return false;
  look_ahead(store);
  append(store, store->sym, at, part->sym, bytes);
  append(store, store->arg, store->narg * sizeof(double), part->arg, part->narg * sizeof(double));
  append(store, store->key, store->nkey * sizeof(uint64_t), part->key, part->nkey * sizeof(uint64_t));
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

void lsys_store_open_at(LsysStore *store, const LsysGrammar *grammar, const LsysLoan *place) {
  lsys_store_open(store, grammar, NULL);
  store->fixed = true;
  store->sym = place->sym;
  store->arg = place->arg;
  store->sym_bytes = place->sym_bytes;
  store->arg_room = place->arg_room;
}

bool lsys_store_lend(LsysStore *store, LsysLoan *place) {
  if (!store->sym) return false;
  size_t used = store->nsym * store->width;
  *place = (LsysLoan){.sym = store->sym + used, .sym_bytes = store->sym_bytes - used};
  if (store->arg) {
    place->arg = store->arg + store->narg;
    place->arg_room = store->arg_room - store->narg;
  }
  return true;
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
  store->looked = 0;
}

LsysWord lsys_store_word(const LsysStore *store) {
  return (LsysWord){.sym = store->sym,
                    .arg = store->arg,
                    .key = store->key,
                    .nsym = store->nsym,
                    .narg = store->narg,
                    .nkey = store->nkey};
}
