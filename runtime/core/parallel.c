// parallel.c -- expand on several threads.
//
// The derivation is cut at a step k: its first k steps, derived here, give the
// frontier; stretches of the frontier are tasks, and the last steps of each are
// derived by whoever is free. Tasks stand in a ring in the order of the word:
//
//   head (consumed here) | running | running | ready | ready | <- new ones
//
// Workers write pieces (chunks, references to blocks, or what the sink prepared
// of either) into their task; this thread hands the head's pieces to the sink. A worker whose task is not the
// head waits once it is a few pieces ahead: that bounds the memory. When the
// ring is full and its head has no worker yet, this thread derives it itself.
// Keys are functions of their place (LANGUAGE.md 5.8), so who derives what
// changes no bit.
#include "core/parallel.h"

#include "core/cut.h"
#include "core/message.h"
#include "core/store.h"
#include "core/thread.h"

#include <string.h>

enum {
  MOST_PIECES = 64,  // of a task that wait to be consumed
  MOST_CHUNKS = 4,   // of these, not references
  ALONE = 64,        // tasks that this thread derives before it starts others: small words need no threads
};

typedef enum State { READY, RUNNING, DONE, FAILED } State;

// A chunk's memory, as a writer's arrays.
typedef struct Chunk {
  struct Chunk *next;  // in the list of free ones
  uint8_t *sym;
  double *arg;
  uint64_t *key;
} Chunk;

// Memory that a sink prepares a part in.
typedef struct Draft {
  struct Draft *next;  // in the list of free ones
  LsysPrepared prepared;
} Draft;

typedef struct Piece {
  LsysWord word;
  Chunk *chunk;  // that the word is in; NULL: a reference to a block
  Draft *draft;  // instead of the word
} Piece;

typedef struct Task {
  LsysStore frontier;
  State state;
  Piece piece[MOST_PIECES];  // a ring
  unsigned first, count, chunks;
} Task;

typedef struct Helper {
  LsysWorker worker;
  LsysSink sink;  // takes what the helper derives into its task
  LsysParallel *parallel;
  LsysThread thread;
  LsysWriter writer;
  Task *task;
  void *scratch;  // what the sink keeps for preparing
  size_t scratch_bytes;
  bool started;
} Helper;

struct LsysParallel {
  LsysWorker *worker;   // of this thread, with all steps
  LsysWorker frontier;  // of this thread, while it makes the frontier
  LsysSink *sink;
  LsysSink splitter;  // takes the frontier
  uint64_t last_steps;
  uint64_t modules_a_task;
  LsysWriter writer;           // this thread's, into sink
  LsysWriter frontier_writer;  // this thread's, into splitter
  unsigned helper_count;
  Helper *helpers;
  bool running;          // the helpers are started
  uint64_t retired;      // tasks that the sink has
  Piece held;            // what the sink reads now
  pthread_mutex_t lock;  // guards what follows, and the tasks from READY on
  pthread_cond_t changed;
  bool quit;
  uint64_t next_ready;  // number of the first task that nobody took; task i stands in ring[i % ring_size]
  uint64_t filled;      // number of the task that is filled with frontier now
  Task *ring;
  unsigned ring_size;
  Chunk *free_chunks;
  Draft *free_drafts;
};

// ---- chunks ------------------------------------------------------------------

static void free_chunk(const LsysParallel *p, Chunk *chunk) {
  LsysMemory *memory = p->worker->memory;
  const LsysWriter *shape = &p->writer;
  lsys_memory_free(memory, chunk->sym, shape->sym_bytes, 1);
  lsys_memory_free(memory, chunk->arg, shape->arg_room, sizeof(double));
  lsys_memory_free(memory, chunk->key, shape->key_room, sizeof(uint64_t));
  lsys_memory_free(memory, chunk, 1, sizeof *chunk);
}

static Chunk *new_chunk(const LsysParallel *p) {
  LsysMemory *memory = p->worker->memory;
  const LsysWriter *shape = &p->writer;
  Chunk *chunk = lsys_memory_alloc(memory, 1, sizeof *chunk);
  if (!chunk) return NULL;
  chunk->sym = lsys_memory_alloc(memory, shape->sym_bytes, 1);
  chunk->arg = lsys_memory_alloc(memory, shape->arg_room, sizeof(double));
  chunk->key = lsys_memory_alloc(memory, shape->key_room, sizeof(uint64_t));
  if (chunk->sym && chunk->arg && chunk->key) return chunk;
  free_chunk(p, chunk);
  return NULL;
}

// Takes the writer's full chunk away and gives it an empty one. Called with the lock held.
static Chunk *exchange_chunk(LsysParallel *p, LsysWriter *writer) {
  Chunk *chunk = p->free_chunks;
  if (chunk)
    p->free_chunks = chunk->next;
  else
    chunk = new_chunk(p);
  if (!chunk) return NULL;
  Chunk full = *chunk;
  *chunk = (Chunk){.sym = writer->sym, .arg = writer->arg, .key = writer->key};
  lsys_writer_use(writer, full.sym, full.arg, full.key);
  return chunk;
}

// ---- helpers -----------------------------------------------------------------

static bool is_ahead(const Task *task) {
  return task->count == MOST_PIECES || task->chunks == MOST_CHUNKS;
}

// Called with the lock held.
static void enter(LsysParallel *p, Task *task, Piece piece) {
  task->piece[(task->first + task->count++) % MOST_PIECES] = piece;
  pthread_cond_broadcast(&p->changed);
}

// Waits while the task is far enough ahead; false when all is over. Called with the lock held.
static bool wait_for_room(LsysParallel *p, const Task *task) {
  while (!p->quit && is_ahead(task)) pthread_cond_wait(&p->changed, &p->lock);
  return !p->quit;
}

// Enters a part that a helper derived into its task.
static bool take_piece(LsysSink *sink, const LsysWord *part) {
  Helper *helper = (Helper *)((char *)sink - offsetof(Helper, sink));
  LsysParallel *p = helper->parallel;
  Task *task = helper->task;
  bool is_chunk = part->sym == helper->writer.sym;
  pthread_mutex_lock(&p->lock);
  bool well = wait_for_room(p, task);
  Chunk *chunk = well && is_chunk ? exchange_chunk(p, &helper->writer) : NULL;
  if (is_chunk && !chunk) well = false;
  task->chunks += is_chunk && well;
  if (well) enter(p, task, (Piece){.word = *part, .chunk = chunk});
  pthread_mutex_unlock(&p->lock);
  return well;
}

static Draft *new_draft(LsysParallel *p) {
  Draft *draft = p->free_drafts;
  if (draft)
    p->free_drafts = draft->next;
  else if ((draft = lsys_memory_alloc(p->worker->memory, 1, sizeof *draft)))
    draft->prepared.memory = p->worker->memory;
  return draft;
}

// Lets the sink prepare the part. The scratch goes along with the thread, not with the draft.
static bool prepare(Helper *helper, const LsysWord *part, LsysPrepared *prepared) {
  const LsysSink *sink = helper->parallel->sink;
  prepared->used = 0;
  prepared->scratch = helper->scratch;
  prepared->scratch_bytes = helper->scratch_bytes;
  bool well = sink->prepare(sink, part, prepared);
  helper->scratch = prepared->scratch;
  helper->scratch_bytes = prepared->scratch_bytes;
  return well;
}

// The same for a sink that shares its work.
static bool take_prepared(LsysSink *sink, const LsysWord *part) {
  Helper *helper = (Helper *)((char *)sink - offsetof(Helper, sink));
  LsysParallel *p = helper->parallel;
  Task *task = helper->task;
  pthread_mutex_lock(&p->lock);
  Draft *draft = wait_for_room(p, task) ? new_draft(p) : NULL;
  task->chunks += draft != NULL;
  pthread_mutex_unlock(&p->lock);
  if (!draft) return false;
  bool well = prepare(helper, part, &draft->prepared);
  pthread_mutex_lock(&p->lock);
  enter(p, task, (Piece){.draft = draft});
  pthread_mutex_unlock(&p->lock);
  return well;
}

static void expand(LsysWriter *writer, const LsysStore *frontier, uint64_t steps) {
  LsysWord word = lsys_store_word(frontier);
  writer->stream.run->grammar->expand(&writer->stream, &word, steps);
  lsys_flush(&writer->stream);
}

// The next task that nobody took, or NULL when there will be none.
static Task *wait_for_task(LsysParallel *p) {
  pthread_mutex_lock(&p->lock);
  while (!p->quit && p->next_ready == p->filled) pthread_cond_wait(&p->changed, &p->lock);
  Task *task = p->quit ? NULL : &p->ring[p->next_ready++ % p->ring_size];
  if (task) task->state = RUNNING;
  pthread_mutex_unlock(&p->lock);
  return task;
}

static void set_state(LsysParallel *p, Task *task, State state) {
  pthread_mutex_lock(&p->lock);
  task->state = state;
  pthread_cond_broadcast(&p->changed);
  pthread_mutex_unlock(&p->lock);
}

static void *help(void *data) {
  Helper *helper = data;
  LsysParallel *p = helper->parallel;
  if (setjmp(helper->worker.stop)) {
    set_state(p, helper->task, FAILED);
    return NULL;
  }
  while ((helper->task = wait_for_task(p))) {
    expand(&helper->writer, &helper->task->frontier, p->last_steps);
    set_state(p, helper->task, DONE);
  }
  return NULL;
}

static bool start_helpers(LsysParallel *p) {
  p->running = true;
  for (unsigned i = 0; i < p->helper_count; i++) {
    Helper *helper = &p->helpers[i];
    helper->worker.run = p->worker->run;
    helper->worker.memory = p->worker->memory;
    helper->parallel = p;
    helper->sink = (LsysSink){.passes = 1, .take = p->sink->prepare ? take_prepared : take_piece};
    if (!lsys_writer_open(&helper->writer, &helper->worker, &helper->sink)) return false;
    helper->started = lsys_thread_start(&helper->thread, &helper->worker, help, helper);
    if (!helper->started) return false;
  }
  return true;
}

// ---- this thread -------------------------------------------------------------

static Task *head(const LsysParallel *p) {
  return &p->ring[p->retired % p->ring_size];
}

// The head's next piece; false when there is none any more. Waits for its worker.
static bool next_piece(LsysParallel *p, Piece *piece) {
  Task *task = head(p);
  pthread_mutex_lock(&p->lock);
  while (!task->count && task->state == RUNNING) pthread_cond_wait(&p->changed, &p->lock);
  bool some = task->count;
  if (some) {
    *piece = task->piece[task->first];
    task->first = (task->first + 1) % MOST_PIECES;
    task->count--;
  }
  pthread_mutex_unlock(&p->lock);
  return some;
}

// The memory of what the sink has read goes back to the helpers.
static void give_back(LsysParallel *p) {
  pthread_mutex_lock(&p->lock);
  if (p->held.chunk) {
    p->held.chunk->next = p->free_chunks;
    p->free_chunks = p->held.chunk;
    head(p)->chunks--;
  }
  if (p->held.draft) {
    p->held.draft->next = p->free_drafts;
    p->free_drafts = p->held.draft;
    head(p)->chunks--;
  }
  p->held = (Piece){0};
  pthread_cond_broadcast(&p->changed);
  pthread_mutex_unlock(&p->lock);
}

static bool consume(LsysParallel *p, const Piece *piece) {
  LsysSink *sink = p->sink;
  p->held = *piece;
  if (!(piece->draft ? sink->accept(sink, &piece->draft->prepared) : sink->take(sink, &piece->word))) return false;
  give_back(p);
  return true;
}

// Hands the head's word to the sink and takes the task out of the ring.
static bool retire(LsysParallel *p) {
  Task *task = head(p);
  pthread_mutex_lock(&p->lock);
  bool mine = task->state == READY;
  if (mine) p->next_ready++;
  pthread_mutex_unlock(&p->lock);
  if (mine) expand(&p->writer, &task->frontier, p->last_steps);
  Piece piece;
  while (!mine && next_piece(p, &piece))
    if (!consume(p, &piece)) return false;
  if (task->state == FAILED) return false;
  p->retired++;
  return true;
}

// The task that is filled now is complete: makes it ready, and the next one empty.
static bool submit(LsysParallel *p) {
  if (!p->running && p->filled >= ALONE && !start_helpers(p)) return false;
  pthread_mutex_lock(&p->lock);
  p->ring[p->filled++ % p->ring_size].state = READY;
  pthread_cond_broadcast(&p->changed);
  pthread_mutex_unlock(&p->lock);
  if (p->filled - p->retired == p->ring_size && !retire(p)) return false;
  lsys_store_clear(&p->ring[p->filled % p->ring_size].frontier);
  return true;
}

// Cuts a part of the frontier into tasks.
static bool take_frontier(LsysSink *sink, const LsysWord *part) {
  LsysParallel *p = (LsysParallel *)((char *)sink - offsetof(LsysParallel, splitter));
  LsysCut cut;
  lsys_cut_begin(&cut, p->worker->run.grammar, part);
  while (cut.rest.nsym) {
    LsysStore *store = &p->ring[p->filled % p->ring_size].frontier;
    LsysWord stretch = lsys_cut_take(&cut, p->modules_a_task - store->nsym);
    if (!store->sink.take(&store->sink, &stretch)) return false;
    if (store->nsym == p->modules_a_task && !submit(p)) return false;
  }
  return true;
}

static bool finish(LsysParallel *p) {
  if (p->ring[p->filled % p->ring_size].frontier.nsym && !submit(p)) return false;
  while (p->retired < p->filled)
    if (!retire(p)) return false;
  return true;
}

static bool set_up(LsysParallel *p, LsysWorker *worker, LsysSink *sink, unsigned threads) {
  LsysMemory *memory = worker->memory;
  p->sink = sink;
  p->splitter = (LsysSink){.passes = 1, .take = take_frontier};
  p->helper_count = threads - 1;
  p->ring_size = threads + 2;
  p->helpers = lsys_memory_alloc(memory, p->helper_count, sizeof *p->helpers);
  p->ring = lsys_memory_alloc(memory, p->ring_size, sizeof *p->ring);
  if (!p->helpers || !p->ring) return false;
  for (unsigned i = 0; i < p->ring_size; i++) lsys_store_open(&p->ring[i].frontier, worker->run.grammar, memory);
  p->frontier = (LsysWorker){.run = worker->run, .memory = memory};
  p->frontier.stack_limit = worker->stack_limit;
  p->frontier.stack_bytes = worker->stack_bytes;
  return lsys_writer_open(&p->writer, worker, sink)
      && lsys_writer_open(&p->frontier_writer, &p->frontier, &p->splitter);
}

bool lsys_parallel_run(LsysParallel **place, LsysWorker *worker, const LsysWord *word, LsysSink *sink,
                       unsigned threads) {
  LsysParallel *p = *place = lsys_memory_alloc(worker->memory, 1, sizeof *p);
  if (!p) return false;
  p->worker = worker;
  pthread_mutex_init(&p->lock, NULL);
  pthread_cond_init(&p->changed, NULL);
  p->last_steps = lsys_cut_choose(worker, word, sink->prepare != NULL, &p->modules_a_task);
  if (!p->last_steps || !set_up(p, worker, sink, threads)) return false;
  if (setjmp(p->frontier.stop)) return false;
  uint64_t steps = worker->run.steps;
  lsys_writer_advance(&p->frontier_writer, word, steps, steps, p->last_steps);
  return finish(p);
}

static void free_draft(LsysParallel *p, Draft *draft) {
  lsys_memory_free(p->worker->memory, draft->prepared.data, draft->prepared.room, 1);
  lsys_memory_free(p->worker->memory, draft, 1, sizeof *draft);
}

static void free_piece(LsysParallel *p, const Piece *piece) {
  if (piece->chunk) free_chunk(p, piece->chunk);
  if (piece->draft) free_draft(p, piece->draft);
}

static void close_helper(Helper *helper) {
  if (helper->started) lsys_thread_join(&helper->thread);
  if (!helper->writer.stream.run) return;
  lsys_memory_free(helper->worker.memory, helper->scratch, 1, helper->scratch_bytes);
  lsys_writer_close(&helper->writer);
}

static void close_task(LsysParallel *p, Task *task) {
  for (unsigned i = 0; i < task->count; i++) free_piece(p, &task->piece[(task->first + i) % MOST_PIECES]);
  if (task->frontier.memory) lsys_store_close(&task->frontier);
}

void lsys_parallel_close(LsysParallel *p) {
  if (!p) return;
  LsysMemory *memory = p->worker->memory;
  pthread_mutex_lock(&p->lock);
  p->quit = true;
  pthread_cond_broadcast(&p->changed);
  pthread_mutex_unlock(&p->lock);
  for (unsigned i = 0; p->helpers && i < p->helper_count; i++) close_helper(&p->helpers[i]);
  for (unsigned i = 0; p->ring && i < p->ring_size; i++) close_task(p, &p->ring[i]);
  free_piece(p, &p->held);
  for (Chunk *chunk = p->free_chunks, *next; chunk; chunk = next) {
    next = chunk->next;
    free_chunk(p, chunk);
  }
  for (Draft *draft = p->free_drafts, *next; draft; draft = next) {
    next = draft->next;
    free_draft(p, draft);
  }
  lsys_memory_free(memory, p->helpers, p->helper_count, sizeof *p->helpers);
  lsys_memory_free(memory, p->ring, p->ring_size, sizeof *p->ring);
  if (p->writer.stream.run) lsys_writer_close(&p->writer);
  if (p->frontier_writer.stream.run) lsys_writer_close(&p->frontier_writer);
  pthread_cond_destroy(&p->changed);
  pthread_mutex_destroy(&p->lock);
  lsys_memory_free(memory, p, 1, sizeof *p);
}
