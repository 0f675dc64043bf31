// press.c -- see press.h. A block is a stretch of a pipeline, which takes it for a part of a word whose symbols are the
// block's bytes; the sink behind the pipeline prepares parts on all threads and accepts them in order.
// Invariant: block number i stands in block[i % most] until the output has it.
#include "sinks/press.h"

#include "core/pipeline.h"

#include <string.h>

enum { ALONE = 4 };  // blocks that are made here before other threads start

typedef struct Block {
  char *data;
  size_t used, room;
} Block;

struct LsysPress {
  LsysMemory *memory;
  LsysPressWork *work;
  LsysPressWrite *write;
  void *data;
  LsysPrepared own;  // what this thread made
  Block *block;
  uint64_t most, filled;  // filled: number of the block that is being collected
  // Of several threads:
  LsysSink sink;
  LsysWorker worker;
  LsysTeam team;
  LsysPipeline *pipeline;
};

// Chunks of words are as small as that of a grammar with nothing in it: none is written.
static const LsysGrammar nothing = {.name = "press"};

static LsysPress *press_of(const LsysSink *sink) {
  return (LsysPress *)((const char *)sink - offsetof(LsysPress, sink));
}

static bool prepare(const LsysSink *sink, const LsysWord *part, LsysPrepared *prepared) {
  const LsysPress *p = press_of(sink);
  return p->work(p->data, part->sym, (size_t)part->nsym, prepared);
}

static bool accept(LsysSink *sink, const LsysPrepared *prepared) {
  LsysPress *p = press_of(sink);
  return p->write(p->data, prepared);
}

static bool take(LsysSink *sink, const LsysWord *part) {
  LsysPress *p = press_of(sink);
  p->own.used = 0;
  return prepare(sink, part, &p->own) && accept(sink, &p->own);
}

static Block *block(const LsysPress *p, uint64_t i) {
  return &p->block[i % p->most];
}

static LsysWord part_of(const LsysPress *p, uint64_t i) {
  const Block *b = block(p, i);
  return (LsysWord){.sym = (const uint8_t *)b->data, .nsym = b->used};
}

static void write_block(LsysMember *member, void *data, uint64_t i, LsysStream *out) {
  (void)member;
  LsysWord part = part_of(data, i);
  lsys_writer_pass((LsysWriter *)out, &part);
}

static bool share(LsysPress *p, unsigned threads) {
  p->worker = (LsysWorker){.memory = p->memory, .run = {.grammar = &nothing, .memory = p->memory}};
  if (!lsys_team_open(&p->team, &p->worker, threads)) return false;
  p->most = lsys_pipeline_most(&p->team);
  return lsys_pipeline_open(&p->pipeline, &p->team, &p->sink, ALONE, write_block, p);
}

LsysPress *lsys_press_open(LsysMemory *memory, unsigned threads, LsysPressWork *work, LsysPressWrite *write,
                           void *data) {
  LsysPress *p = lsys_memory_alloc(memory, 1, sizeof *p);
  if (!p) return NULL;
  p->memory = p->own.memory = memory;
  p->work = work;
  p->write = write;
  p->data = data;
  p->most = 1;
  p->sink = (LsysSink){.passes = 1, .take = take, .prepare = prepare, .accept = accept};
  bool well = threads <= 1 || share(p, threads);
  if (well && (p->block = lsys_memory_alloc(memory, p->most, sizeof *p->block))) return p;
  lsys_press_close(p);
  return NULL;
}

void *lsys_press_add(LsysPress *p, size_t size) {
  Block *b = block(p, p->filled);
  if (!lsys_memory_fit(p->memory, &b->data, &b->room, b->used + size, 1)) return NULL;
  b->used += size;
  return b->data + b->used - size;
}

bool lsys_press_send(LsysPress *p) {
  LsysWord part = part_of(p, p->filled);
  if (!part.nsym) return true;
  if (!(p->pipeline ? lsys_pipeline_add(p->pipeline, NULL) : take(&p->sink, &part))) return false;
  block(p, ++p->filled)->used = 0;
  return true;
}

bool lsys_press_finish(LsysPress *p) {
  return lsys_press_send(p) && (!p->pipeline || lsys_pipeline_finish(p->pipeline));
}

void lsys_press_close(LsysPress *p) {
  if (!p) return;
  lsys_pipeline_close(p->pipeline);
  if (p->team.worker) lsys_team_close(&p->team);
  for (uint64_t i = 0; p->block && i < p->most; i++) lsys_memory_free(p->memory, p->block[i].data, p->block[i].room, 1);
  lsys_memory_free(p->memory, p->block, p->most, sizeof *p->block);
  lsys_memory_free(p->memory, p->own.data, p->own.room, 1);
  lsys_memory_free(p->memory, p->own.scratch, p->own.scratch_bytes, 1);
  lsys_memory_free(p->memory, p, 1, sizeof *p);
}
