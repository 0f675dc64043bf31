// homomorphism.c -- derived words in, words to be looked at out, part by part.
// A homomorphism with contexts sees the whole word, which is stored for it.
#include "sinks/homomorphism.h"

#include "core/store.h"
#include "core/stream.h"
#include "core/walk.h"

typedef struct HomomorphismSink {
  LsysSink sink;
  LsysSink *inner;
  LsysMemory *memory;
  LsysRun *run;       // a worker's
  LsysWriter writer;  // into inner
  bool whole, open;
  LsysStore store;  // the word, if it is needed as a whole,
  LsysWalk walk;    //   compiled code's way through it,
  uint64_t *birth;  //   and the birth of each module, where it is asked for
  size_t birth_room;
} HomomorphismSink;

static void close(HomomorphismSink *filter) {
  if (filter->open) lsys_writer_close(&filter->writer);
  lsys_walk_close(&filter->walk);
  filter->open = false;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  close(filter);
  // The derivation's driver hands its worker's run to sinks, which charge and fail by it.
  filter->run = (LsysRun *)run;
  if (filter->whole) lsys_store_clear(&filter->store);
  // The writer may ask the inner sink for memory.
  filter->open = filter->inner->begin(filter->inner, run, axiom, pass)
              && lsys_writer_open(&filter->writer, (LsysWorker *)filter->run, filter->inner);
  return filter->open;
}

// A part of a word that is needed as a whole.
static bool keep(HomomorphismSink *filter, const LsysWord *part) {
  const LsysRun *run = filter->run;
  uint64_t before = filter->store.nsym, count = before + part->nsym;
  if (!filter->store.sink.take(&filter->store.sink, part)) return false;
  if (!run->births) return true;
  if (!lsys_memory_fit(filter->memory, &filter->birth, &filter->birth_room, count, sizeof *filter->birth)) return false;
  for (uint64_t i = before; i < count; i++) filter->birth[i] = run->born;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  if (filter->whole) return keep(filter, part);
  filter->run->grammar->homomorphism(filter->run, part, &filter->writer.stream);
  if (filter->run->births) lsys_flush(&filter->writer.stream);
  return true;
}

// Module by module: what each is shown as has its birth.
static void interpret_births(HomomorphismSink *filter, LsysScan *scan) {
  LsysRun *run = filter->run;
  LsysStream *out = &filter->writer.stream;
  const uint8_t *end = scan->end;
  for (const uint64_t *birth = filter->birth; scan->sym < end; birth++) {
    if (*birth != run->born) lsys_flush(out);
    run->born = *birth;
    scan->end = scan->sym + lsys_symbol_width(run->grammar);
    run->grammar->interpret(scan, out);
  }
}

static bool show_whole(HomomorphismSink *filter) {
  LsysRun *run = filter->run;
  const LsysGrammar *grammar = run->grammar;
  LsysWord word = lsys_store_word(&filter->store);
  if (!grammar->interpret) {
    run->birth = filter->birth;
    grammar->homomorphism(run, &word, &filter->writer.stream);
    run->birth = NULL;
    return true;
  }
  if (!lsys_walk_open(&filter->walk, (LsysWorker *)run)) return false;
  LsysScan *scan = lsys_walk_start(&filter->walk, &word);
  if (run->births)
    interpret_births(filter, scan);
  else
    grammar->interpret(scan, &filter->writer.stream);
  return true;
}

static bool end(LsysSink *sink) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  if (filter->whole && !show_whole(filter)) return false;
  lsys_flush(&filter->writer.stream);
  return filter->inner->end(filter->inner);
}

static bool finish(LsysSink *sink) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  return filter->inner->finish(filter->inner);
}

static void destroy(LsysSink *sink) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  close(filter);
  lsys_store_close(&filter->store);
  lsys_memory_free(filter->memory, filter->birth, filter->birth_room, sizeof *filter->birth);
  filter->inner->destroy(filter->inner);
  lsys_memory_free(filter->memory, filter, 1, sizeof *filter);
}

LsysSink *lsys_sink_homomorphism(const LsysSinkContext *context, LsysSink *inner) {
  HomomorphismSink *filter = lsys_memory_alloc(context->memory, 1, sizeof *filter);
  if (!filter) {
    inner->destroy(inner);
    return NULL;
  }
  filter->sink =
    (LsysSink){.passes = inner->passes, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  filter->inner = inner;
  filter->memory = context->memory;
  filter->whole = context->grammar->flags & LSYS_GRAMMAR_WHOLE;
  lsys_store_open(&filter->store, context->grammar, context->memory);
  return &filter->sink;
}
