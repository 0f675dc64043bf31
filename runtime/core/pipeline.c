// pipeline.c -- see pipeline.h. Stretches that are under way are tasks in a
// ring, in the order of the word:
//
//   head (consumed here) | running | running | ready | ready | <- new ones
//
// A thread writes pieces (chunks, references to blocks, or what the sink
// prepared of either) into its task, and waits when there is no chunk left for
// it: that bounds the memory. Some are kept for the head, which all wait for. This thread hands the head's pieces to
// the sink; while there are none it writes a stretch as the others do, and right into the sink once that stretch is the
// head.
#include "core/pipeline.h"

enum {
  TASKS_A_MEMBER = 8,
  MOST_PIECES = 128,     // of a task that wait to be consumed
  CHUNKS_A_MEMBER = 8,   // in flight: pieces that are no references
  CHUNKS_OF_HEAD = 3,    // kept for it
  MOST_DRAFT = 1 << 12,  // bytes of a draft, and little more, that is not counted as a chunk
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
  uint64_t number, place;
  bool placed;  // it is known where it stands
  State state;
  const LsysMember *member;  // that writes it
  Piece piece[MOST_PIECES];  // a ring
  unsigned first, count;
} Task;

// What a member needs to write with.
typedef struct Hand {
  LsysSink sink;  // takes what is written into the task
  LsysPipeline *pipeline;
  LsysMember *member;
  LsysWriter writer;
  Task *task;
  Draft *draft;   // what is prepared and not entered yet
  void *scratch;  // what the sink keeps for preparing
  size_t scratch_bytes;
} Hand;

struct LsysPipeline {
  LsysTeam *team;
  LsysMemory *memory;
  LsysSink *sink;
  LsysPipelineWrite *write;
  void *data;
  uint64_t alone;
  Hand *hands;   // one for each member
  bool begun;    // by the other members, too
  Piece held;    // what the sink reads now
  bool refused;  // by the sink, which said why
  Task *ring;    // task i stands in ring[i % ring_size]
  uint64_t ring_size;
  pthread_mutex_t lock;  // guards what follows, and the tasks
  pthread_cond_t added;  // a task, or quit is set
  pthread_cond_t eased;  // a writer may go on, or quit is set
  pthread_cond_t ahead;  // the head has a piece, or is over
  bool quit;
  uint64_t retired;     // number of the head
  uint64_t next_ready;  // number of the first task that nobody took
  uint64_t filled;      // number of tasks that were added
  unsigned chunks;      // in flight, drafts included
  Chunk *free_chunks;
  Draft *free_drafts;
};

// ---- chunks and drafts -------------------------------------------------------

static void free_chunk(const LsysPipeline *p, Chunk *chunk) {
  const LsysWriter *shape = &p->hands[0].writer;
  lsys_memory_free(p->memory, chunk->sym, shape->sym_bytes, 1);
  lsys_memory_free(p->memory, chunk->arg, shape->arg_room, sizeof(double));
  lsys_memory_free(p->memory, chunk->key, shape->key_room, sizeof(uint64_t));
  lsys_memory_free(p->memory, chunk, 1, sizeof *chunk);
}

static Chunk *new_chunk(const LsysPipeline *p) {
  const LsysWriter *shape = &p->hands[0].writer;
  Chunk *chunk = lsys_memory_alloc(p->memory, 1, sizeof *chunk);
  if (!chunk) return NULL;
  chunk->sym = lsys_memory_alloc(p->memory, shape->sym_bytes, 1);
  chunk->arg = lsys_memory_alloc(p->memory, shape->arg_room, sizeof(double));
  chunk->key = lsys_memory_alloc(p->memory, shape->key_room, sizeof(uint64_t));
  if (chunk->sym && chunk->arg && chunk->key) return chunk;
  free_chunk(p, chunk);
  return NULL;
}

// Takes the writer's full chunk away and gives it an empty one. Called with the lock held.
static Chunk *exchange_chunk(LsysPipeline *p, LsysWriter *writer) {
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

static Draft *new_draft(LsysPipeline *p) {
  Draft *draft = p->free_drafts;
  if (draft)
    p->free_drafts = draft->next;
  else if ((draft = lsys_memory_alloc(p->memory, 1, sizeof *draft)))
    draft->prepared.memory = p->memory;
  return draft;
}

// As what a draft counts: what is made of blocks is small.
static unsigned draft_chunks(const LsysPipeline *p) {
  return p->sink->block ? 0 : 1;
}

static void release(LsysPipeline *p, Draft *draft) {
  draft->next = p->free_drafts;
  p->free_drafts = draft;
  p->chunks -= draft_chunks(p);
}

static void free_draft(const LsysPipeline *p, Draft *draft) {
  lsys_memory_free(p->memory, draft->prepared.data, draft->prepared.room, 1);
  lsys_memory_free(p->memory, draft, 1, sizeof *draft);
}

// ---- reading -----------------------------------------------------------------

// What the sink says is for the user, whatever is written around it.
static bool give(LsysPipeline *p, const LsysWord *part, const LsysPrepared *prepared) {
  LsysMessage *before = lsys_message_catch(NULL);
  bool well = prepared ? p->sink->accept(p->sink, prepared) : p->sink->take(p->sink, part);
  lsys_message_catch(before);
  p->refused |= !well;
  return well;
}

// The first task that is under way; NULL if there is none.
static Task *head(const LsysPipeline *p) {
  return p->retired < p->filled ? &p->ring[p->retired % p->ring_size] : NULL;
}

static unsigned most_chunks(const LsysPipeline *p) {
  return p->team->count * CHUNKS_A_MEMBER;
}

// Whether the task has to wait with its next piece. Called with the lock held.
static bool is_ahead(const LsysPipeline *p, const Task *task) {
  unsigned most = most_chunks(p);
  return task->count == MOST_PIECES || p->chunks >= (task == head(p) ? most : most - CHUNKS_OF_HEAD);
}

// The memory of what the sink has read goes back to those who write.
static void give_back(LsysPipeline *p) {
  pthread_mutex_lock(&p->lock);
  if (p->held.chunk) {
    p->held.chunk->next = p->free_chunks;
    p->free_chunks = p->held.chunk;
    p->chunks--;
  }
  if (p->held.draft) release(p, p->held.draft);
  p->held = (Piece){0};
  if (p->chunks <= most_chunks(p) / 2 || !head(p)->count)
    pthread_cond_broadcast(&p->eased);  // not for every single one
  pthread_mutex_unlock(&p->lock);
}

// Takes a piece of the head to be consumed, or the head out of the ring. False where neither can be done now.
// Called with the lock held.
static bool take_up(LsysPipeline *p, const Task *own) {
  Task *task = head(p);
  if (!task) return false;
  if (task->count) {
    p->held = task->piece[task->first];
    task->first = (task->first + 1) % MOST_PIECES;
    task->count--;
    return true;
  }
  if (task->state != DONE || task == own) return false;
  p->retired++;
  pthread_cond_broadcast(&p->eased);  // the next one may be waiting for chunks that are kept for the head
  return true;
}

// Hands to the sink what there is for it, before stretch `own` of this thread goes on (NULL: there is none); waits as
// long as that is too far ahead. False when the run has to stop.
static bool consume(LsysPipeline *p, const Task *own) {
  while (!p->refused) {
    pthread_mutex_lock(&p->lock);
    Task *task = head(p);
    bool some = take_up(p, own), failed = !some && task && task->state == FAILED;
    bool waits = !some && !failed && own && task != own && is_ahead(p, own);
    if (waits) pthread_cond_wait(&p->ahead, &p->lock);
    pthread_mutex_unlock(&p->lock);
    if (failed) return false;
    if (!some && !waits) return true;
    if (!p->held.chunk && !p->held.draft && !p->held.word.nsym) continue;
    if (give(p, &p->held.word, p->held.draft ? &p->held.draft->prepared : NULL)) give_back(p);
  }
  return false;
}

// ---- writing -----------------------------------------------------------------

// Called with the lock held.
static void enter(LsysPipeline *p, Task *task, Piece piece) {
  task->piece[(task->first + task->count++) % MOST_PIECES] = piece;
  if (task == head(p)) pthread_cond_signal(&p->ahead);
}

// Waits while the task is far enough ahead; false when all is over. Who consumes has made sure of that before, as far
// as needed: nobody would wake it. Called with the lock held.
static bool wait_for_room(LsysPipeline *p, const Hand *hand) {
  while (!p->quit && hand->member->number && is_ahead(p, hand->task)) pthread_cond_wait(&p->eased, &p->lock);
  return !p->quit;
}

// Enters a part as it is.
static bool enter_part(Hand *hand, const LsysWord *part) {
  LsysPipeline *p = hand->pipeline;
  Task *task = hand->task;
  bool is_chunk = part->sym == hand->writer.sym;
  pthread_mutex_lock(&p->lock);
  bool well = wait_for_room(p, hand);
  Chunk *chunk = well && is_chunk ? exchange_chunk(p, &hand->writer) : NULL;
  if (is_chunk && !chunk) well = false;
  p->chunks += is_chunk && well;
  if (well) enter(p, task, (Piece){.word = *part, .chunk = chunk});
  pthread_mutex_unlock(&p->lock);
  return well;
}

// Enters what is prepared.
static void enter_draft(Hand *hand) {
  LsysPipeline *p = hand->pipeline;
  pthread_mutex_lock(&p->lock);
  if (hand->draft->prepared.used)
    enter(p, hand->task, (Piece){.draft = hand->draft});
  else
    release(p, hand->draft);
  pthread_mutex_unlock(&p->lock);
  hand->draft = NULL;
}

static bool take_draft(Hand *hand) {
  LsysPipeline *p = hand->pipeline;
  if (hand->draft) return true;
  pthread_mutex_lock(&p->lock);
  if (wait_for_room(p, hand)) hand->draft = new_draft(p);
  p->chunks += hand->draft ? draft_chunks(p) : 0;
  pthread_mutex_unlock(&p->lock);
  if (hand->draft) hand->draft->prepared.used = 0;
  return hand->draft;
}

// Lets the sink prepare the part. The scratch goes along with the thread, not with the draft.
static bool prepare(Hand *hand, const LsysWord *part) {
  const LsysSink *sink = hand->pipeline->sink;
  LsysPrepared *prepared = &hand->draft->prepared;
  prepared->declined = false;
  prepared->place = hand->task->place;
  prepared->scratch = hand->scratch;
  prepared->scratch_bytes = hand->scratch_bytes;
  bool well = sink->prepare(sink, part, prepared);
  hand->scratch = prepared->scratch;
  hand->scratch_bytes = prepared->scratch_bytes;
  return well;
}

// Enters what a sink that shares its work makes of a part, if it does.
static bool enter_prepared(Hand *hand, const LsysWord *part) {
  if (!take_draft(hand) || !prepare(hand, part)) return false;
  if (hand->draft->prepared.declined) {
    enter_draft(hand);
    return enter_part(hand, part);
  }
  if (!hand->pipeline->sink->block || hand->draft->prepared.used >= MOST_DRAFT) enter_draft(hand);
  return true;
}

static bool can_prepare(const LsysPipeline *p, const Task *task) {
  return p->sink->prepare && (!p->sink->block || task->placed);
}

// Right into the sink, behind all that came before.
static bool pass(Hand *hand, const LsysWord *part) {
  LsysPipeline *p = hand->pipeline;
  if (hand->draft) {
    enter_draft(hand);
    if (!consume(p, hand->task)) return false;
  }
  return give(p, part, NULL);
}

// A part that a member has written.
static bool take(LsysSink *sink, const LsysWord *part) {
  Hand *hand = (Hand *)((char *)sink - offsetof(Hand, sink));
  LsysPipeline *p = hand->pipeline;
  bool consumes = hand->member->number == 0;
  if (consumes && !consume(p, hand->task)) return false;
  bool well = consumes && hand->task == head(p) ? pass(hand, part)
            : can_prepare(p, hand->task)        ? enter_prepared(hand, part)
                                                : enter_part(hand, part);
  hand->task->place += part->nsym;
  return well;
}

static void write(LsysMember *member, void *data, uint64_t i) {
  LsysPipeline *p = data;
  Hand *hand = &p->hands[member->number];
  hand->writer.stream.stack_limit = member->worker.stack_limit;
  lsys_writer_use(&hand->writer, hand->writer.sym, hand->writer.arg, hand->writer.key);
  p->write(member, p->data, i, &hand->writer.stream);
  if (hand->draft) enter_draft(hand);
}

// A task that nobody took, now the member's; NULL if there is none now. Called with the lock held.
static Task *take_task(LsysPipeline *p, const LsysMember *member) {
  if (p->quit || p->next_ready == p->filled) return NULL;
  Task *task = &p->ring[p->next_ready++ % p->ring_size];
  task->state = RUNNING;
  task->member = member;
  return task;
}

// False if it failed.
static bool run(LsysPipeline *p, LsysMember *member, Task *task) {
  p->hands[member->number].task = task;
  bool well = lsys_member_try(member, write, p, task->number);
  pthread_mutex_lock(&p->lock);
  task->state = well ? DONE : FAILED;
  if (task == head(p)) pthread_cond_signal(&p->ahead);
  pthread_mutex_unlock(&p->lock);
  return well;
}

// What the other members do.
static void help(LsysMember *member, void *data) {
  LsysPipeline *p = data;
  Task *task;
  do {
    pthread_mutex_lock(&p->lock);
    while (!(task = take_task(p, member)) && !p->quit) pthread_cond_wait(&p->added, &p->lock);
    pthread_mutex_unlock(&p->lock);
  } while (task && run(p, member, task));
}

// ---- this thread -------------------------------------------------------------

// Tells why the head failed, unless the sink did.
static void report(const LsysPipeline *p) {
  if (!p->refused) lsys_error("%s", head(p)->member->message.text);
}

// Reads and writes until no more than `most` stretches are under way.
static bool work(LsysPipeline *p, uint64_t most) {
  LsysMember *self = &p->team->members[0];
  for (;;) {
    if (!consume(p, NULL)) {
      report(p);
      return false;
    }
    if (p->filled - p->retired <= most) return true;
    pthread_mutex_lock(&p->lock);
    Task *task = take_task(p, self), *first = head(p);
    if (!task && first->state == RUNNING && !first->count) pthread_cond_wait(&p->ahead, &p->lock);
    pthread_mutex_unlock(&p->lock);
    if (task) run(p, self, task);
  }
}

uint64_t lsys_pipeline_most(const LsysTeam *team) {
  return TASKS_A_MEMBER * (uint64_t)team->count;
}

bool lsys_pipeline_open(LsysPipeline **place, LsysTeam *team, LsysSink *sink, uint64_t alone, LsysPipelineWrite *write_,
                        void *data) {
  LsysMemory *memory = team->worker->memory;
  LsysPipeline *p = *place = lsys_memory_alloc(memory, 1, sizeof *p);
  if (!p) return false;
  p->team = team;
  p->memory = memory;
  p->sink = sink;
  p->alone = alone;
  p->write = write_;
  p->data = data;
  p->ring_size = lsys_pipeline_most(team);
  pthread_mutex_init(&p->lock, NULL);
  pthread_cond_init(&p->added, NULL);
  pthread_cond_init(&p->eased, NULL);
  pthread_cond_init(&p->ahead, NULL);
  p->ring = lsys_memory_alloc(memory, p->ring_size, sizeof *p->ring);
  p->hands = lsys_memory_alloc(memory, team->count, sizeof *p->hands);
  if (!p->ring || !p->hands) return false;
  for (unsigned i = 0; i < team->count; i++) {
    Hand *hand = &p->hands[i];
    hand->sink = (LsysSink){.passes = 1, .take = take};
    hand->pipeline = p;
    hand->member = &team->members[i];
  }
  p->hands[0].member->worker.run = team->worker->run;
  return lsys_writer_open(&p->hands[0].writer, &p->hands[0].member->worker, &p->hands[0].sink);
}

// The other members start, too.
static bool begin(LsysPipeline *p) {
  for (unsigned i = 1; i < p->team->count; i++) {
    Hand *hand = &p->hands[i];
    if (!lsys_writer_open(&hand->writer, &hand->member->worker, &hand->sink)) return false;
  }
  p->begun = true;
  return lsys_team_begin(p->team, help, p);
}

bool lsys_pipeline_add(LsysPipeline *p, const uint64_t *place) {
  if (!p->begun && p->filled >= p->alone && !begin(p)) return false;
  Task *task = &p->ring[p->filled % p->ring_size];
  pthread_mutex_lock(&p->lock);
  task->number = p->filled++;
  task->placed = place != NULL;
  task->place = place ? *place : 0;
  task->state = READY;
  pthread_cond_signal(&p->added);
  pthread_mutex_unlock(&p->lock);
  return work(p, p->begun ? p->ring_size - 1 : 0);
}

bool lsys_pipeline_finish(LsysPipeline *p) {
  return work(p, 0);
}

static void free_piece(const LsysPipeline *p, const Piece *piece) {
  if (piece->chunk) free_chunk(p, piece->chunk);
  if (piece->draft) free_draft(p, piece->draft);
}

static void close_task(const LsysPipeline *p, const Task *task) {
  for (unsigned i = 0; i < task->count; i++) free_piece(p, &task->piece[(task->first + i) % MOST_PIECES]);
}

static void close_hand(const LsysPipeline *p, Hand *hand) {
  lsys_memory_free(p->memory, hand->scratch, 1, hand->scratch_bytes);
  if (hand->draft) free_draft(p, hand->draft);
  if (hand->writer.stream.run) lsys_writer_close(&hand->writer);
}

void lsys_pipeline_close(LsysPipeline *p) {
  if (!p) return;
  pthread_mutex_lock(&p->lock);
  p->quit = true;
  pthread_cond_broadcast(&p->added);
  pthread_cond_broadcast(&p->eased);
  pthread_mutex_unlock(&p->lock);
  if (p->begun) lsys_team_wait(p->team);
  for (uint64_t i = 0; p->ring && i < p->ring_size; i++) close_task(p, &p->ring[i]);
  free_piece(p, &p->held);
  for (Chunk *chunk = p->free_chunks, *next; chunk; chunk = next) {
    next = chunk->next;
    free_chunk(p, chunk);
  }
  for (Draft *draft = p->free_drafts, *next; draft; draft = next) {
    next = draft->next;
    free_draft(p, draft);
  }
  for (unsigned i = 0; p->hands && i < p->team->count; i++) close_hand(p, &p->hands[i]);
  lsys_memory_free(p->memory, p->hands, p->team->count, sizeof *p->hands);
  lsys_memory_free(p->memory, p->ring, p->ring_size, sizeof *p->ring);
  pthread_cond_destroy(&p->added);
  pthread_cond_destroy(&p->eased);
  pthread_cond_destroy(&p->ahead);
  pthread_mutex_destroy(&p->lock);
  lsys_memory_free(p->memory, p, 1, sizeof *p);
}
