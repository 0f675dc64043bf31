// births.c -- a depth-first derivation outside of `expand`, which does not tell
// when modules were written: what one module becomes in one step is a word of
// its own, a level, whose modules have one birth.
// Invariant: levels[0..depth) are the way from the start word to the module at
// hand; what is left of each stands behind its cursor.
#include "core/births.h"

#include "core/cut.h"
#include "core/store.h"
#include "lsys/number.h"

#include <string.h>

typedef struct Level {
  LsysStore store;
  LsysCut rest;  // what is still to be derived
  uint64_t born;
} Level;

struct LsysBirths {
  LsysSink collector;  // the writer's: appends to the innermost level
  LsysWorker *worker;
  LsysSink *sink;
  LsysWriter writer;
  Level **level;
  size_t depth, open, room;  // open: levels that have a store
};

static bool collect(LsysSink *sink, const LsysWord *part) {
  LsysBirths *b = (LsysBirths *)sink;
  LsysStore *store = &b->level[b->depth - 1]->store;
  return store->sink.take(&store->sink, part);
}

// An empty level on top. Its memory is that of the last one at this depth.
static Level *push(LsysBirths *b, uint64_t born) {
  LsysMemory *memory = b->worker->memory;
  if (b->depth == b->room) {
    Level **grown = lsys_memory_grow(memory, b->level, &b->room, sizeof *grown);
    if (!grown) return NULL;
    b->level = grown;
  }
  if (b->depth == b->open) {
    Level *new = lsys_memory_alloc(memory, 1, sizeof *new);
    if (!new) return NULL;
    lsys_store_open(&new->store, b->worker->run.grammar, memory);
    b->level[b->open++] = new;
  }
  Level *level = b->level[b->depth++];
  lsys_store_clear(&level->store);
  level->born = born;
  return level;
}

bool lsys_births_same(const LsysGrammar *grammar, const LsysWord *a, const LsysWord *b) {
  return a->nsym == b->nsym && a->narg == b->narg && !memcmp(a->sym, b->sym, a->nsym * lsys_symbol_width(grammar))
      && lsys_numbers_same(a->arg, b->arg, a->narg);
}

static uint32_t first_kind(const LsysGrammar *grammar, const LsysWord *word) {
  return grammar->flags & LSYS_GRAMMAR_WIDE ? word->sym[0] | (uint32_t)word->sym[1] << 8 : word->sym[0];
}

// The modules in front that stay for ever, and whose keys nobody asks for: those change with every step.
static uint64_t terminals(const LsysGrammar *grammar, LsysWord word) {
  unsigned width = lsys_symbol_width(grammar);
  uint64_t count = 0;
  for (; count < word.nsym; count++, word.sym += width) {
    uint8_t flags = grammar->kinds[first_kind(grammar, &word)].flags;
    if (!(flags & LSYS_KIND_TERMINAL) || flags & LSYS_KIND_KEY) break;
  }
  return count;
}

static bool hand_on(LsysBirths *b, uint64_t born, const LsysWord *part) {
  b->worker->run.born = born;
  return !part->nsym || b->sink->take(b->sink, part);
}

// What the module becomes in one of `left` steps is a new level.
static bool derive_one(LsysBirths *b, const Level *from, const LsysWord *module, uint64_t left) {
  uint64_t total = b->worker->run.steps, born = from->born;
  Level *level = push(b, total - left + 1);
  if (!level) return false;
  lsys_writer_advance(&b->writer, module, total, left, left - 1);
  b->worker->run.steps = total;
  LsysWord word = lsys_store_word(&level->store);
  if (lsys_births_same(b->worker->run.grammar, module, &word)) level->born = born;
  lsys_cut_begin(&level->rest, b->worker->run.grammar, &word);
  return true;
}

// Works off all levels but the start word's, which ends with them.
static bool derive_levels(LsysBirths *b) {
  const LsysGrammar *grammar = b->worker->run.grammar;
  const uint64_t total = b->worker->run.steps;
  while (b->depth) {
    Level *level = b->level[b->depth - 1];
    uint64_t left = total - (b->depth - 1);
    LsysWord stay = lsys_cut_take(&level->rest, left ? terminals(grammar, level->rest.rest) : UINT64_MAX);
    if (!hand_on(b, level->born, &stay)) return false;
    if (!level->rest.rest.nsym) {
      b->depth--;
      continue;
    }
    LsysWord module = lsys_cut_take(&level->rest, 1);
    if (!derive_one(b, level, &module, left)) return false;
  }
  return true;
}

bool lsys_births_run(LsysBirths **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink) {
  LsysBirths *b = lsys_memory_alloc(worker->memory, 1, sizeof *b);
  if (!b) return false;
  *place = b;
  b->collector = (LsysSink){.passes = 1, .take = collect};
  b->worker = worker;
  b->sink = sink;
  if (!lsys_writer_open(&b->writer, worker, &b->collector)) return false;
  Level *level = push(b, 0);
  if (!level) return false;
  lsys_cut_begin(&level->rest, worker->run.grammar, word);
  return derive_levels(b);
}

void lsys_births_close(LsysBirths *b) {
  if (!b) return;
  LsysMemory *memory = b->worker->memory;
  if (b->writer.stream.run) lsys_writer_close(&b->writer);
  for (size_t i = 0; i < b->open; i++) {
    lsys_store_close(&b->level[i]->store);
    lsys_memory_free(memory, b->level[i], 1, sizeof **b->level);
  }
  lsys_memory_free(memory, b->level, b->room, sizeof *b->level);
  lsys_memory_free(memory, b, 1, sizeof *b);
}
