// stream.h -- the writer behind an LsysStream: a bounded chunk that engines fill
// and that flows into a sink whenever it is full.
#ifndef LSYS_CORE_STREAM_H
#define LSYS_CORE_STREAM_H

#include "core/memory.h"
#include "sinks/sink.h"

#include <setjmp.h>

// Modules in a chunk: its symbols, and two arguments for each, fit into an L2 cache.
enum { LSYS_CHUNK = 1 << 14 };

// A run as the thread sees it that works on it.
typedef struct LsysWorker {
  LsysRun run;  // first: engines and sinks hold a pointer to it
  LsysMemory *memory;
  jmp_buf stop;           // where the thread goes when the run has to stop; a message was printed
  uintptr_t stack_limit;  // of its stack, for streams
  size_t stack_bytes;
} LsysWorker;

typedef struct LsysWriter {
  LsysStream stream;  // first: engines hold a pointer to it; its run is a worker's
  LsysSink *sink;
  struct LsysStore *store;  // written in place of chunks; NULL: there is a sink
  LsysLoan place;           // what the stream writes into: the chunk, or what the sink lends. Keys stay in the chunk
  uint8_t *sym;             // the chunk
  double *arg;
  uint64_t *key;
  size_t sym_bytes, arg_room, key_room;
  unsigned width;  // bytes of a symbol
  size_t arity;    // the most arguments of a module
} LsysWriter;

// Makes an empty chunk that flows into sink. False after printing why not.
bool lsys_writer_open(LsysWriter *writer, LsysWorker *worker, LsysSink *sink);
void lsys_writer_close(LsysWriter *writer);

// Makes these arrays, of the same sizes as its own, the writer's chunk, and empty.
void lsys_writer_use(LsysWriter *writer, uint8_t *sym, double *arg, uint64_t *key);

// Hands a part that stands elsewhere to the sink; nothing else is written now. The run ends where the sink refuses it.
void lsys_writer_pass(LsysWriter *writer, const LsysWord *part);

// Both derive modules with `steps` steps left, of `total` ones of the whole derivation, flush, and may change the
// run's steps: to the end, or until `left` steps are left; then the modules have their keys.
void lsys_writer_finish(LsysWriter *writer, const LsysWord *in, uint64_t total, uint64_t steps);
void lsys_writer_advance(LsysWriter *writer, const LsysWord *in, uint64_t total, uint64_t steps, uint64_t left);

// Until lsys_writer_leave, the writer writes a new word right into a store. The run ends where there is no memory.
void lsys_writer_enter(LsysWriter *writer, struct LsysStore *store);
void lsys_writer_leave(LsysWriter *writer);

static inline unsigned lsys_symbol_width(const LsysGrammar *grammar) {
  return grammar->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
}

#endif
