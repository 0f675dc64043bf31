// blocks.c -- D0L parts of a derivation at the speed of memcpy: a fixed kind is
// after s steps always the same word, so its words for the last few steps are
// made once and then copied.
//
// Level s of a kind is made by expand itself on a word of one module, which
// copies the blocks of level s - 1: no kind's level is made before all kinds
// have the level below it, or never will. Sizes are chosen so that a block in
// use stays in an L2 cache.
#include "core/blocks.h"

#include <stdlib.h>
#include <string.h>

enum {
  LARGEST_BLOCK = 1 << 16,  // bytes; a kind whose word is longer gets no further level
  ALL_BLOCKS = 1 << 20,     // bytes of all blocks together
};

struct LsysBlocks {
  LsysBlock **block;  // as LsysRun.block
  uint64_t *levels;
  size_t *capacities;  // of block[k]
  bool *closed;        // the kind gets no further level
  uint32_t kind_count;
  unsigned width;  // bytes of a symbol
  size_t bytes;    // of all blocks and their entries
};

// A sink that keeps what flows in, up to LARGEST_BLOCK bytes.
typedef struct Capture {
  LsysSink sink;
  uint8_t sym[LARGEST_BLOCK];
  double arg[LARGEST_BLOCK / sizeof(double)];
  uint64_t nsym, narg;
  unsigned width;
  bool overflow;
} Capture;

static bool take(LsysSink *sink, const LsysWord *part) {
  Capture *capture = (Capture *)sink;
  uint64_t used = capture->nsym * capture->width + capture->narg * sizeof(double);
  uint64_t size = part->nsym * capture->width + part->narg * sizeof(double);
  if (capture->overflow || size > LARGEST_BLOCK - used) {
    capture->overflow = true;
    return true;
  }
  memcpy(capture->sym + capture->nsym * capture->width, part->sym, part->nsym * capture->width);
  if (part->narg) memcpy(capture->arg + capture->narg, part->arg, part->narg * sizeof(double));
  capture->nsym += part->nsym;
  capture->narg += part->narg;
  return true;
}

// Copies the captured word to memory of its own. An empty word has none.
static bool keep(const Capture *capture, LsysMemory *memory, LsysBlock *block) {
  uint8_t *sym = lsys_memory_alloc(memory, capture->nsym, capture->width);
  double *arg = lsys_memory_alloc(memory, capture->narg, sizeof *arg);
  *block = (LsysBlock){sym, arg, capture->nsym, capture->narg};
  if (sym) memcpy(sym, capture->sym, capture->nsym * capture->width);
  if (arg) memcpy(arg, capture->arg, capture->narg * sizeof *arg);
  return sym && arg;
}

// Appends what was captured as the kind's next level. False if there is no memory.
static bool add_level(LsysBlocks *blocks, uint32_t kind, const Capture *capture, LsysMemory *memory) {
  if (blocks->levels[kind] == blocks->capacities[kind]) {
    void *grown = lsys_memory_grow(memory, blocks->block[kind], &blocks->capacities[kind], sizeof *blocks->block[kind]);
    if (!grown) return false;
    blocks->block[kind] = grown;
  }
  blocks->bytes += sizeof(LsysBlock) + capture->nsym * capture->width + capture->narg * sizeof(double);
  return keep(capture, memory, &blocks->block[kind][blocks->levels[kind]++]);
}

static bool is_fixed(const LsysKind *kind) {
  return (kind->flags & LSYS_KIND_FIXED) && !(kind->flags & LSYS_KIND_TERMINAL);
}

// Derives one module of the kind into the capture.
static void derive(LsysWriter *writer, Capture *capture, uint32_t kind, uint64_t steps) {
  uint8_t sym[2] = {(uint8_t)kind, (uint8_t)(kind >> 8)};
  LsysWord word = {.sym = sym, .nsym = 1};
  capture->nsym = capture->narg = 0;
  capture->overflow = false;
  writer->stream.run->grammar->expand(&writer->stream, &word, steps);
  lsys_flush(&writer->stream);
}

// All levels, until no kind gets a further one.
static bool build(LsysBlocks *blocks, LsysWorker *worker, LsysWriter *writer, Capture *capture) {
  bool open = true;
  for (uint64_t level = 0; open && level <= worker->run.steps; level++) {
    open = false;
    for (uint32_t kind = 0; kind < blocks->kind_count; kind++) {
      if (blocks->closed[kind]) continue;
      derive(writer, capture, kind, level);
      blocks->closed[kind] = capture->overflow || blocks->bytes > ALL_BLOCKS;
      if (blocks->closed[kind]) continue;
      if (!add_level(blocks, kind, capture, worker->memory)) return false;
      open = true;
    }
  }
  return true;
}

static bool allocate(LsysBlocks *blocks, LsysMemory *memory, const LsysGrammar *grammar) {
  uint32_t kinds = blocks->kind_count = grammar->kind_count;
  blocks->width = lsys_symbol_width(grammar);
  blocks->block = lsys_memory_alloc(memory, kinds, sizeof(LsysBlock *));
  blocks->levels = lsys_memory_alloc(memory, kinds, sizeof *blocks->levels);
  blocks->capacities = lsys_memory_alloc(memory, kinds, sizeof *blocks->capacities);
  blocks->closed = lsys_memory_alloc(memory, kinds, sizeof *blocks->closed);
  return blocks->block && blocks->levels && blocks->capacities && blocks->closed;
}

static bool fill(LsysBlocks *blocks, LsysWorker *worker) {
  const LsysGrammar *grammar = worker->run.grammar;
  bool some = false;
  for (uint32_t kind = 0; kind < blocks->kind_count; kind++) {
    blocks->closed[kind] = !is_fixed(&grammar->kinds[kind]);
    some |= !blocks->closed[kind];
  }
  worker->run.block = (const LsysBlock *const *)blocks->block;
  worker->run.block_levels = blocks->levels;
  if (!some || !grammar->expand) return true;
  Capture *capture = lsys_memory_alloc(worker->memory, 1, sizeof *capture);
  if (!capture) return false;
  capture->sink = (LsysSink){.passes = 1, .take = take};
  capture->width = lsys_symbol_width(grammar);
  LsysWriter writer;
  bool well = lsys_writer_open(&writer, worker, &capture->sink);
  if (well) {
    well = build(blocks, worker, &writer, capture);
    lsys_writer_close(&writer);
  }
  lsys_memory_free(worker->memory, capture, 1, sizeof *capture);
  return well;
}

LsysBlocks *lsys_blocks_build(LsysWorker *worker) {
  LsysBlocks *blocks = lsys_memory_alloc(worker->memory, 1, sizeof *blocks);
  if (!blocks) return NULL;
  if (allocate(blocks, worker->memory, worker->run.grammar) && fill(blocks, worker)) return blocks;
  lsys_blocks_free(blocks, worker->memory);
  worker->run.block = NULL;
  worker->run.block_levels = NULL;
  return NULL;
}

void lsys_blocks_free(LsysBlocks *blocks, LsysMemory *memory) {
  if (!blocks) return;
  for (uint32_t kind = 0; blocks->block && blocks->levels && kind < blocks->kind_count; kind++) {
    for (uint64_t level = 0; level < blocks->levels[kind]; level++) {
      LsysBlock *block = &blocks->block[kind][level];
      lsys_memory_free(memory, (uint8_t *)block->sym, block->nsym, blocks->width);
      lsys_memory_free(memory, (double *)block->arg, block->narg, sizeof(double));
    }
    lsys_memory_free(memory, blocks->block[kind], blocks->capacities[kind], sizeof(LsysBlock));
  }
  lsys_memory_free(memory, blocks->block, blocks->kind_count, sizeof(LsysBlock *));
  lsys_memory_free(memory, blocks->levels, blocks->kind_count, sizeof *blocks->levels);
  lsys_memory_free(memory, blocks->capacities, blocks->kind_count, sizeof *blocks->capacities);
  lsys_memory_free(memory, blocks->closed, blocks->kind_count, sizeof *blocks->closed);
  lsys_memory_free(memory, blocks, 1, sizeof *blocks);
}
