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
  LsysWalk walk;    //   and compiled code's way through it
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
  filter->open = lsys_writer_open(&filter->writer, (LsysWorker *)filter->run, filter->inner);
  if (filter->whole) lsys_store_clear(&filter->store);
  return filter->open && filter->inner->begin(filter->inner, run, axiom, pass);
}

static bool take(LsysSink *sink, const LsysWord *part) {
  HomomorphismSink *filter = (HomomorphismSink *)sink;
  if (filter->whole) return filter->store.sink.take(&filter->store.sink, part);
  filter->run->grammar->homomorphism(filter->run, part, &filter->writer.stream);
  if (filter->run->births) lsys_flush(&filter->writer.stream);
  return true;
}

static bool show_whole(HomomorphismSink *filter) {
  const LsysGrammar *grammar = filter->run->grammar;
  LsysWord word = lsys_store_word(&filter->store);
  if (!grammar->interpret) {
    grammar->homomorphism(filter->run, &word, &filter->writer.stream);
    return true;
  }
  if (!lsys_walk_open(&filter->walk, (LsysWorker *)filter->run)) return false;
  grammar->interpret(lsys_walk_start(&filter->walk, &word), &filter->writer.stream);
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
