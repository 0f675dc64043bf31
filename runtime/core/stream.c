// stream.c -- what engines call while they write: full chunks go to the sink.
// Invariant: after lsys_flush there is room for what the grammar writes between two checks.
#include "core/stream.h"

#include "core/message.h"
#include "core/store.h"

#include <stdarg.h>
#include <string.h>

// Words at least this long are handed to the sink where they stand, without a copy.
enum { DIRECT = 1 << 12 };

static uint64_t least(uint64_t a, uint64_t b) {
  return a < b ? a : b;
}

// How many modules of any kinds there is room for.
static uint64_t room_in(const LsysWriter *writer, size_t sym_bytes, size_t arg_room, size_t key_room) {
  uint64_t modules = sym_bytes / writer->width;
  if (writer->arity) modules = least(modules, arg_room / writer->arity);
  return writer->key_room ? least(modules, key_room) : modules;
}

// Lets the next part be written where the sink wants it, if that place is worth it, else into the chunk.
static void rewind_cursors(LsysWriter *writer) {
  LsysSink *sink = writer->sink;
  LsysStream *to = &writer->stream;
  LsysLoan *place = &writer->place;
  uint64_t chunk = writer->sym_bytes / writer->width, modules = 0;
  if (sink && sink->lend && sink->lend(sink, place))
    modules = room_in(writer, place->sym_bytes, place->arg_room, writer->key_room);
  if (modules < chunk) {
    modules = chunk;
    *place = (LsysLoan){writer->sym, writer->arg, writer->sym_bytes, writer->arg_room};
  }
  to->sym = place->sym;
  to->arg = place->arg;
  to->key = writer->key;
  to->sym_limit = place->sym + modules * writer->width;
}

static LsysMemory *memory_of(const LsysWriter *writer) {
  return ((LsysWorker *)writer->stream.run)->memory;
}

// The most arguments that a module has.
static size_t widest(const LsysGrammar *grammar) {
  size_t arity = 0;
  for (uint32_t k = 0; k < grammar->kind_count; k++)
    if (grammar->kinds[k].arity > arity) arity = grammar->kinds[k].arity;
  return arity;
}

bool lsys_writer_open(LsysWriter *writer, LsysWorker *worker, LsysSink *sink) {
  const LsysGrammar *grammar = worker->run.grammar;
  *writer = (LsysWriter){.stream = {.run = &worker->run, .stack_limit = worker->stack_limit}, .sink = sink};
  writer->width = lsys_symbol_width(grammar);
  size_t arity = widest(grammar), modules = arity > 2 ? LSYS_CHUNK / arity * 2 : LSYS_CHUNK;
  if (modules < grammar->room_sym) modules = grammar->room_sym;
  writer->sym_bytes = modules * writer->width;
  writer->arity = arity;
  writer->arg_room = modules * arity;
  writer->key_room = grammar->flags & LSYS_GRAMMAR_RANDOM ? modules : 0;
  writer->sym = lsys_memory_alloc(worker->memory, writer->sym_bytes, 1);
  writer->arg = lsys_memory_alloc(worker->memory, writer->arg_room, sizeof(double));
  writer->key = lsys_memory_alloc(worker->memory, writer->key_room, sizeof(uint64_t));
  rewind_cursors(writer);
  if (writer->sym && writer->arg && writer->key) return true;
  lsys_writer_close(writer);
  return false;
}

void lsys_writer_close(LsysWriter *writer) {
  LsysMemory *memory = memory_of(writer);
  lsys_memory_free(memory, writer->sym, writer->sym_bytes, 1);
  lsys_memory_free(memory, writer->arg, writer->arg_room, sizeof(double));
  lsys_memory_free(memory, writer->key, writer->key_room, sizeof(uint64_t));
  writer->sym = NULL;
  writer->arg = NULL;
  writer->key = NULL;
}

void lsys_writer_use(LsysWriter *writer, uint8_t *sym, double *arg, uint64_t *key) {
  writer->sym = sym;
  writer->arg = arg;
  writer->key = key;
  rewind_cursors(writer);
}

static _Noreturn void stop(LsysRun *run) {
  longjmp(((LsysWorker *)run)->stop, 1);
}

void lsys_writer_pass(LsysWriter *writer, const LsysWord *part) {
  if (!writer->sink->take(writer->sink, part)) stop(writer->stream.run);
  rewind_cursors(writer);
}

// ---- into a store ------------------------------------------------------------

// What was written becomes the store's.
static void settle(LsysWriter *writer) {
  LsysStore *store = writer->store;
  const LsysStream *out = &writer->stream;
  store->nsym = (uint64_t)(out->sym - store->sym) / store->width;
  store->narg = (uint64_t)(out->arg - store->arg);
  store->nkey = (uint64_t)(out->key - store->key);
}

// How many modules the store has room for behind its word.
static uint64_t store_room(const LsysWriter *writer, const LsysStore *store) {
  return room_in(writer, store->sym_bytes - store->nsym * store->width, store->arg_room - store->narg,
                 store->key_room - store->nkey);
}

// Makes room behind the store's word for that much, and a chunk's modules more.
static void make_room(LsysWriter *writer, uint64_t nsym, uint64_t narg) {
  LsysStore *store = writer->store;
  LsysStream *out = &writer->stream;
  uint64_t symbols = store->nsym + nsym + writer->sym_bytes / writer->width;
  if (!lsys_store_reserve(store, symbols * store->width, store->narg + narg + writer->arg_room,
                          store->nkey + writer->key_room))
    stop(out->run);
  out->sym = store->sym + store->nsym * store->width;
  out->arg = store->arg + store->narg;
  out->key = store->key + store->nkey;
  out->sym_limit = out->sym + store_room(writer, store) * store->width;
}

void lsys_writer_enter(LsysWriter *writer, LsysStore *store) {
  lsys_store_clear(store);
  writer->store = store;
  make_room(writer, 0, 0);
}

void lsys_writer_leave(LsysWriter *writer) {
  settle(writer);
  writer->store = NULL;
  rewind_cursors(writer);
}

// ---- what engines call -------------------------------------------------------

void lsys_flush(LsysStream *out) {
  LsysWriter *writer = (LsysWriter *)out;
  if (writer->store) {
    settle(writer);
    make_room(writer, 0, 0);
    return;
  }
  const LsysLoan *place = &writer->place;
  LsysWord part = {.sym = place->sym, .arg = place->arg, .key = writer->key};
  part.nsym = (uint64_t)(out->sym - place->sym) / writer->width;
  part.narg = (uint64_t)(out->arg - place->arg);
  part.nkey = (uint64_t)(out->key - writer->key);
  if (part.nsym) lsys_writer_pass(writer, &part);
}

static void expand(LsysWriter *writer, const LsysWord *in, uint64_t total, uint64_t steps, uint64_t stop) {
  LsysRun *run = writer->stream.run;
  run->steps = total;
  writer->stream.stop = stop;
  run->grammar->expand(&writer->stream, in, steps);
  lsys_flush(&writer->stream);
}

void lsys_writer_finish(LsysWriter *writer, const LsysWord *in, uint64_t total, uint64_t steps) {
  expand(writer, in, total, steps, 0);
}

void lsys_writer_advance(LsysWriter *writer, const LsysWord *in, uint64_t total, uint64_t steps, uint64_t left) {
  expand(writer, in, total + LSYS_FAR, steps + LSYS_FAR, left + LSYS_FAR);
}

void lsys_append(LsysStream *out, const uint8_t *sym, uint64_t nsym, const double *arg, uint64_t narg) {
  LsysWriter *writer = (LsysWriter *)out;
  size_t bytes = (size_t)nsym * writer->width;
  if (writer->store) {
    settle(writer);
    make_room(writer, nsym, narg);
  } else if (nsym >= DIRECT || writer->sym_bytes < bytes) {
    lsys_flush(out);
    lsys_writer_pass(writer, &(LsysWord){.sym = sym, .arg = arg, .nsym = nsym, .narg = narg});
    return;
  } else if ((size_t)(out->sym_limit - out->sym) < bytes) {
    lsys_flush(out);
  }
  memcpy(out->sym, sym, bytes);
  out->sym += bytes;
  if (narg) memcpy(out->arg, arg, narg * sizeof *arg);
  out->arg += narg;
}

void lsys_too_deep(LsysStream *out) {
  lsys_fail(out->run,
            "the derivation is nested too deep for its stack of %.1f MiB: take fewer steps (-n), or allow more memory "
            "(--max-memory)",
            (double)((LsysWorker *)out->run)->stack_bytes / (1 << 20));
}

void lsys_charge(LsysRun *run, int64_t bytes) {
  LsysMemory *memory = ((LsysWorker *)run)->memory;
  if (bytes < 0) {
    lsys_memory_give(memory, -(uint64_t)bytes);
  } else if (!lsys_memory_take(memory, (uint64_t)bytes)) {
    lsys_memory_refuse(memory, (uint64_t)bytes);
    stop(run);
  }
}

void lsys_fail(LsysRun *run, const char *format, ...) {
  va_list args;
  va_start(args, format);
  lsys_verror(format, args);
  va_end(args);
  stop(run);
}
