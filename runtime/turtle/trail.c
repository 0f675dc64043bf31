// trail.c -- the blocks of a derivation (core/blocks.h) flow in again and again,
// each the same word where it stands. Of a block that comes a second time the
// turtle notes its trail: the directions of the segments, counted from the
// heading that it is entered with, and where strokes begin. Turns, brackets and
// what draws nothing are gone from it.
//
//   runs  | 3, keep 1 | 2, back to 1 | 1, back to 1 | 7, on | ...
//   steps | . . . | . . | . | . . . . . . . | ...         the number of a direction each
//
// Following a trail adds the same lengths to the same places in the same order
// as reading its block does, so that not a bit of what is drawn differs.
// Invariant: a trail never leaves the branch that it begins in.
#include "turtle/trail.h"

#include "core/memory.h"
#include "turtle/actions.h"
#include "turtle/cursor.h"

#include <stdlib.h>

enum {
  LEAST_BLOCK = 1 << 10,  // modules; a shorter one is not worth it
  ALL_TRAILS = 2 << 20,   // bytes of all trails together
  DIRECTIONS = 256,       // that a trail may have
  KEPT = 256,             // places that it may keep at a time; the first is nobody's
};

typedef enum Then {
  THEN_ON,    // the stroke goes on
  THEN_BACK,  // to a place that was kept: a stroke begins
  THEN_MOVE,  // without drawing: a stroke begins
} Then;

// Segments one behind the other, and what comes then.
typedef struct Run {
  uint32_t count;
  uint8_t keep;  // where the place behind them is kept
  uint8_t then;  // Then
  uint8_t with;  // the place, or the number of the move's direction
} Run;

typedef struct Trail {
  Run *run;
  uint8_t *step;
  size_t runs, steps;
  uint32_t turn[DIRECTIONS];  // its directions: to the left of the heading at its beginning
  uint32_t directions;
  uint32_t turned;  // the heading behind it, likewise
} Trail;

// A block, known by where it stands.
typedef struct Block {
  const uint8_t *sym;
  uint64_t nsym;
  bool seen, unfit;
  Trail *trail;  // NULL: none yet
} Block;

typedef struct Trails {
  const LsysBlock *const *of;  // the run's blocks
  Block *block;                // those that are long enough, in the order of their places
  size_t blocks;
  size_t bytes;
} Trails;

// ---- noting ------------------------------------------------------------------

typedef struct Opened {
  uint32_t turned;
  uint8_t kept;
} Opened;

// What is known while a block is read.
typedef struct Noter {
  const LsysTurtle *t;
  Trail *trail;  // without room for runs and steps: they are counted
  Run last;      // not written yet
  bool some;     // there is one
  uint32_t count;
  uint32_t turned;
  uint8_t direction;  // the number of `turned`
  bool known;         //   if that was looked up
  uint8_t here;       // where the turtle's place is kept; 0: nowhere
  uint32_t depth;
  Opened opened[KEPT];
} Noter;

static void write_last(const Noter *n) {
  if (!n->some) return;
  if (n->trail->run) n->trail->run[n->trail->runs] = n->last;
  n->trail->runs++;
}

// The segments since the last run become one.
static void end_run(Noter *n, uint8_t keep, Then then, uint8_t with) {
  write_last(n);
  n->last = (Run){n->count, keep, then, with};
  n->some = true;
  n->count = 0;
}

// The turtle goes back to a place: whatever came behind the last segment is forgotten.
static void go_back(Noter *n, uint8_t kept) {
  n->here = kept;
  if (n->count || !n->some) {
    end_run(n, 0, THEN_BACK, kept);
  } else {
    n->last.then = THEN_BACK;
    n->last.with = kept;
  }
}

static bool find_direction(Noter *n) {
  Trail *trail = n->trail;
  uint32_t i = 0;
  if (n->known) return true;
  while (i < trail->directions && trail->turn[i] != n->turned) i++;
  if (i == DIRECTIONS) return false;
  if (i == trail->directions) trail->turn[trail->directions++] = n->turned;
  n->direction = (uint8_t)i;
  return n->known = true;
}

static bool note_go(Noter *n, const PlainKind *k) {
  const uint32_t circle = n->t->directions.count;
  n->turned = (n->turned + k->turn) % circle;
  n->known &= k->turn == 0;
  if (!k->advance) return true;
  if (!find_direction(n)) return false;
  if (n->trail->step) n->trail->step[n->trail->steps] = n->direction;
  n->trail->steps++;
  n->count++;
  n->here = 0;
  return true;
}

static bool note_move(Noter *n) {
  if (!find_direction(n)) return false;
  end_run(n, 0, THEN_MOVE, n->direction);
  n->here = 0;
  return true;
}

static bool note_push(Noter *n) {
  if (n->depth + 1 == KEPT) return false;
  if (!n->here) {
    n->here = (uint8_t)(n->depth ? n->opened[n->depth - 1].kept + 1 : 1);
    end_run(n, n->here, THEN_ON, 0);
  }
  n->opened[n->depth++] = (Opened){n->turned, n->here};
  return true;
}

static bool note_pop(Noter *n) {
  if (!n->depth) return false;
  const Opened *o = &n->opened[--n->depth];
  n->known &= n->turned == o->turned;
  n->turned = o->turned;
  go_back(n, o->kept);
  return true;
}

// Notes a block into the trail. False if it holds what a trail cannot.
static bool note(const LsysTurtle *t, Trail *trail, const LsysWord *block) {
  Noter n = {.t = t, .trail = trail};
  trail->runs = trail->steps = trail->directions = 0;
  for (uint64_t i = 0; i < block->nsym; i++) {
    const PlainKind *k = &t->plain_kind[block->sym[i]];
    bool well = !k->skip
             && (k->act == PLAIN_GO     ? note_go(&n, k)
                 : k->act == PLAIN_JUMP ? note_move(&n)
                 : k->act == PLAIN_PUSH ? note_push(&n)
                                        : k->act == PLAIN_POP && note_pop(&n));
    if (!well) return false;
  }
  end_run(&n, 0, THEN_ON, 0);
  write_last(&n);
  trail->turned = n.turned;
  return n.depth == 0;
}

static size_t trail_bytes(const Trail *trail) {
  return sizeof *trail + trail->runs * sizeof *trail->run + trail->steps;
}

static void free_trail(LsysMemory *memory, Trail *trail) {
  lsys_memory_free(memory, trail->run, trail->runs, sizeof *trail->run);
  lsys_memory_free(memory, trail->step, trail->steps, 1);
  lsys_memory_free(memory, trail, 1, sizeof *trail);
}

// Does it leave room for others, and most of the memory for what has to be held?
static bool is_small(const Trails *trails, const Trail *trail, const LsysMemory *memory) {
  return trail_bytes(trail) <= ALL_TRAILS - trails->bytes && trail_bytes(trail) <= lsys_memory_left(memory) / 8;
}

// The trail of a block, noted; NULL if it gets none.
static Trail *make_trail(const LsysTurtle *t, Trails *trails, const LsysWord *block) {
  LsysMemory *memory = t->run->memory;
  Trail *trail = lsys_memory_try(memory, 1, sizeof *trail);
  if (!trail) return NULL;
  bool fits = note(t, trail, block) && is_small(trails, trail, memory);
  if (fits) {
    trail->run = lsys_memory_try(memory, trail->runs, sizeof *trail->run);
    trail->step = lsys_memory_try(memory, trail->steps, 1);
  }
  if (trail->run && trail->step) {
    note(t, trail, block);
    trails->bytes += trail_bytes(trail);
    return trail;
  }
  free_trail(memory, trail);
  return NULL;
}

// ---- following ---------------------------------------------------------------

// Draws segments.
static inline const uint8_t *go_along(Cursor *c, const Pair *way, const uint8_t *step, size_t count) {
  Pair at = c->at;
  LsysVec3 *out = c->out;
  for (const uint8_t *end = step + count; step < end; step++) {
    at += way[*step];
    put_place(out++, at);
  }
  c->at = at;
  c->out = out;
  return step;
}

static bool hand_on(LsysTurtle *t, Cursor *c) {
  cursor_store(t, c);
  if (!turtle_flush(t)) return false;
  *c = cursor_load(t);
  return true;
}

// What a step in each of the trail's directions adds.
static void set_ways(const LsysTurtle *t, const Trail *trail, Pair *way) {
  const Directions *d = &t->directions;
  for (uint32_t i = 0; i < trail->directions; i++)
    way[i] = d->at[(t->state.heading + trail->turn[i]) % d->count] * t->step;
}

static bool follow(LsysTurtle *t, const Trail *trail) {
  Pair way[DIRECTIONS], kept[KEPT];
  set_ways(t, trail, way);
  Cursor c = cursor_load(t);
  const LsysPen pen = turtle_pen(t);
  const LsysVec3 *full = t->point + BATCH_FULL;
  const uint8_t *step = trail->step;
  for (const Run *run = trail->run, *end = run + trail->runs; run < end; run++) {
    size_t left = run->count;
    // The batch is handed on before a module finds it full, as when modules are read.
    for (size_t room; left >= (room = (size_t)(full - c.out)); left -= room) {
      step = go_along(&c, way, step, room);
      if (!hand_on(t, &c)) return false;
    }
    step = go_along(&c, way, step, left);
    kept[run->keep] = c.at;
    if (run->then == THEN_ON) continue;
    if (run->then == THEN_BACK)
      c.at = kept[run->with];
    else
      c.at += way[run->with];
    cursor_jump(t, &c, &pen);
  }
  c.heading = (c.heading + trail->turned) % t->directions.count;
  cursor_store(t, &c);
  return true;
}

// ---- blocks ------------------------------------------------------------------

static bool is_long(const LsysBlock *block) {
  return block->nsym >= LEAST_BLOCK && !block->narg;
}

static int by_place(const void *a, const void *b) {
  const Block *x = a, *y = b;
  return (x->sym > y->sym) - (x->sym < y->sym);
}

// Lists the run's blocks that are long enough.
static void list_blocks(LsysTurtle *t) {
  const LsysRun *run = t->run;
  const uint32_t kinds = run->block ? run->grammar->kind_count : 0;
  size_t count = 0;
  for (uint32_t k = 0; k < kinds; k++)
    for (uint64_t level = 0; level < run->block_levels[k]; level++) count += is_long(&run->block[k][level]);
  Trails *trails = t->trails = lsys_memory_try(run->memory, 1, sizeof *trails);
  if (!trails) return;
  trails->of = run->block;
  trails->block = lsys_memory_try(run->memory, count, sizeof *trails->block);
  if (!trails->block) return;
  for (uint32_t k = 0; k < kinds; k++) {
    for (uint64_t level = 0; level < run->block_levels[k]; level++) {
      const LsysBlock *b = &run->block[k][level];
      if (is_long(b)) trails->block[trails->blocks++] = (Block){.sym = b->sym, .nsym = b->nsym};
    }
  }
  qsort(trails->block, count, sizeof *trails->block, by_place);
}

// The block that a part is; NULL if it is none.
static Block *find_block(LsysTurtle *t, const LsysWord *part) {
  if (t->trails && t->trails->of != t->run->block) turtle_forget_trails(t);
  if (!t->trails) list_blocks(t);
  const Trails *trails = t->trails;
  const Block wanted = {.sym = part->sym};
  if (!trails || !trails->blocks) return NULL;
  Block *block = bsearch(&wanted, trails->block, trails->blocks, sizeof wanted, by_place);
  return block && block->nsym == part->nsym ? block : NULL;
}

bool turtle_follow(LsysTurtle *t, const LsysWord *part, bool *ok) {
  if (part->nsym < LEAST_BLOCK || part->narg || t->by_depth || t->state_size != STATE_SMALL || !turtle_is_plain(t))
    return false;
  Block *block = find_block(t, part);
  if (!block || block->unfit) return false;
  if (!block->trail && block->seen) {
    block->trail = make_trail(t, t->trails, part);
    block->unfit = !block->trail;
  }
  block->seen = true;
  if (!block->trail) return false;
  *ok = (t->points < BATCH_FULL || turtle_flush(t)) && follow(t, block->trail);
  return true;
}

void turtle_forget_trails(LsysTurtle *t) {
  Trails *trails = t->trails;
  LsysMemory *memory = t->run->memory;
  if (!trails) return;
  for (size_t i = 0; i < trails->blocks; i++)
    if (trails->block[i].trail) free_trail(memory, trails->block[i].trail);
  lsys_memory_free(memory, trails->block, trails->blocks, sizeof *trails->block);
  lsys_memory_free(memory, trails, 1, sizeof *trails);
  t->trails = NULL;
}
