// parallel.c -- expand on several threads.
//
// The derivation is cut at a step k: its first k steps, derived here, give the
// frontier; stretches of the frontier are written by whoever is free
// (pipeline.h). Keys are functions of their place (LANGUAGE.md 5.8), so who
// derives what changes no bit.
#include "core/parallel.h"

#include "core/cut.h"
#include "core/growth.h"
#include "core/pipeline.h"
#include "core/store.h"

enum { ALONE = 16 };  // stretches that this thread derives before it starts others

struct LsysParallel {
  LsysWorker *worker;  // of this thread, with all steps
  LsysTeam team;
  LsysPipeline *pipeline;
  LsysWorker frontier;  // of this thread, while it makes the frontier
  LsysSink splitter;    // takes the frontier
  LsysWriter writer;    // into splitter
  uint64_t last_steps;
  uint64_t modules_a_stretch;
  uint64_t filled;     // number of the stretch that gets modules now
  uint64_t place;      //   and how many modules of the last word stand before it,
  uint64_t *size;      //   where it is known how many each kind becomes; else NULL
  LsysStore *stretch;  // number i stands in stretch[i % most]
  uint64_t most;
};

static LsysStore *stretch(const LsysParallel *p, uint64_t i) {
  return &p->stretch[i % p->most];
}

static void expand(LsysMember *member, void *data, uint64_t i, LsysStream *out) {
  const LsysParallel *p = data;
  LsysWord word = lsys_store_word(stretch(p, i));
  member->worker.run.grammar->expand(out, &word, p->last_steps);
  lsys_flush(out);
}

// The modules that the stretch becomes.
static uint64_t length(const LsysParallel *p, const LsysStore *store) {
  uint64_t sum = 0;
  for (uint64_t i = 0; i < store->nsym; i++)
    sum += p->size[store->width == 1 ? store->sym[i] : store->sym[2 * i] | store->sym[2 * i + 1] << 8];
  return sum;
}

static bool submit(LsysParallel *p) {
  uint64_t modules = p->size ? length(p, stretch(p, p->filled)) : 0;
  if (!lsys_pipeline_add(p->pipeline, p->size ? &p->place : NULL)) return false;
  p->place += modules;
  lsys_store_clear(stretch(p, ++p->filled));
  return true;
}

// Cuts a part of the frontier into stretches.
static bool take_frontier(LsysSink *sink, const LsysWord *part) {
  LsysParallel *p = (LsysParallel *)((char *)sink - offsetof(LsysParallel, splitter));
  LsysCut cut;
  lsys_cut_begin(&cut, p->worker->run.grammar, part);
  while (cut.rest.nsym) {
    LsysStore *store = stretch(p, p->filled);
    LsysWord next = lsys_cut_take(&cut, p->modules_a_stretch - store->nsym);
    if (!store->sink.take(&store->sink, &next)) return false;
    if (store->nsym == p->modules_a_stretch && !submit(p)) return false;
  }
  return true;
}

static bool find_sizes(LsysParallel *p) {
  const LsysGrammar *grammar = p->worker->run.grammar;
  if (!grammar->growth.row) return true;
  p->size = lsys_memory_alloc(p->worker->memory, grammar->kind_count, sizeof *p->size);
  return p->size && lsys_growth_sizes(grammar, p->last_steps, p->worker->memory, p->size);
}

static bool choose_cut(LsysParallel *p, const LsysWord *word, const LsysSink *sink) {
  bool known = p->worker->run.grammar->growth.row;
  LsysCutWork work = !sink->prepare ? LSYS_CUT_ALONE : !sink->block ? LSYS_CUT_PARTS : LSYS_CUT_BLOCKS;
  if (work == LSYS_CUT_BLOCKS && !known) work = LSYS_CUT_ALONE;
  p->last_steps = lsys_cut_choose(p->worker, word, work, &p->modules_a_stretch);
  return p->last_steps && find_sizes(p);
}

static bool set_up(LsysParallel *p, LsysSink *sink, unsigned threads) {
  LsysWorker *worker = p->worker;
  if (!lsys_team_open(&p->team, worker, threads)) return false;
  p->most = lsys_pipeline_most(&p->team);
  p->stretch = lsys_memory_alloc(worker->memory, p->most, sizeof *p->stretch);
  if (!p->stretch) return false;
  for (uint64_t i = 0; i < p->most; i++) lsys_store_open(&p->stretch[i], worker->run.grammar, worker->memory);
  p->splitter = (LsysSink){.passes = 1, .take = take_frontier};
  p->frontier = (LsysWorker){.run = worker->run, .memory = worker->memory};
  p->frontier.stack_limit = worker->stack_limit;
  p->frontier.stack_bytes = worker->stack_bytes;
  return lsys_writer_open(&p->writer, &p->frontier, &p->splitter)
      && lsys_pipeline_open(&p->pipeline, &p->team, sink, ALONE, expand, p);
}

bool lsys_parallel_run(LsysParallel **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink,
                       unsigned threads) {
  LsysParallel *p = *place = lsys_memory_alloc(worker->memory, 1, sizeof *p);
  if (!p) return false;
  p->worker = worker;
  if (!choose_cut(p, word, sink) || !set_up(p, sink, threads)) return false;
  if (setjmp(p->frontier.stop)) return false;
  uint64_t steps = worker->run.steps;
  lsys_writer_advance(&p->writer, word, steps, steps, p->last_steps);
  return (!stretch(p, p->filled)->nsym || submit(p)) && lsys_pipeline_finish(p->pipeline);
}

void lsys_parallel_close(LsysParallel *p) {
  if (!p) return;
  LsysMemory *memory = p->worker->memory;
  lsys_pipeline_close(p->pipeline);
  if (p->team.worker) lsys_team_close(&p->team);
  for (uint64_t i = 0; p->stretch && i < p->most; i++) lsys_store_close(&p->stretch[i]);
  lsys_memory_free(memory, p->stretch, p->most, sizeof *p->stretch);
  lsys_memory_free(memory, p->size, p->worker->run.grammar->kind_count, sizeof *p->size);
  if (p->writer.stream.run) lsys_writer_close(&p->writer);
  lsys_memory_free(memory, p, 1, sizeof *p);
}
