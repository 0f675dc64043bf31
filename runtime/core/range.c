// range.c -- descent to a stretch of a word.
//
// size[s][k], the length of what a module of kind k becomes in s steps, follows
// from the growth matrix. Modules stand on a stack with the steps that are left
// for them, the next one on top:
//
//   before the range    passed over
//   inside of it        expanded to the end
//   across its border   derived by one step; its successor's modules go onto the stack
//
// At most two modules of a level lie across a border: the work is the depth times the longest successor.
#include "core/range.h"

#include "core/cut.h"
#include "core/message.h"
#include "core/store.h"

#include <string.h>

#define ENDLESS (~(LsysLength)0)

// ---- the option --------------------------------------------------------------

// Reads a natural number; NULL if there is none or it is too large.
static const char *parse_length(const char *text, LsysLength *length) {
  const char *at = text;
  for (*length = 0; *at >= '0' && *at <= '9'; at++) {
    if (*length > ENDLESS / 10 - 1) return NULL;
    *length = *length * 10 + (unsigned)(*at - '0');
  }
  return at > text ? at : NULL;
}

bool lsys_range_parse(const LsysOptionValue *value, LsysRange *range) {
  const char *at = parse_length(value->text, &range->first);
  if (at && *at == ':' && (at = parse_length(at + 1, &range->length)) && !*at) return true;
  lsys_error("--range %s: it is A:LEN, the place of the first module counted from 0, and how many (below 10^37)",
             value->text);
  return false;
}

// ---- the window --------------------------------------------------------------

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  LsysWindow *window = (LsysWindow *)sink;
  return window->inner->begin(window->inner, run, axiom, pass);
}

static uint64_t at_most(LsysLength length, uint64_t most) {
  return length < most ? (uint64_t)length : most;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  LsysWindow *window = (LsysWindow *)sink;
  LsysCut cut;
  lsys_cut_begin(&cut, window->grammar, part);
  uint64_t before = at_most(window->skip, part->nsym);
  if (before) lsys_cut_take(&cut, before);
  window->skip -= before;
  uint64_t inside = at_most(window->left, cut.rest.nsym);
  if (inside) {
    LsysWord through = lsys_cut_take(&cut, inside);
    if (!window->inner->take(window->inner, &through)) return false;
    window->left -= inside;
  }
  window->done = window->left == 0;
  return !window->done;
}

static bool end(LsysSink *sink) {
  LsysWindow *window = (LsysWindow *)sink;
  if (window->left) lsys_note("the word ends inside of or before the range");
  return window->inner->end(window->inner);
}

void lsys_window_open(LsysWindow *window, const LsysGrammar *grammar, LsysRange range, LsysSink *inner) {
  *window = (LsysWindow){.sink = {.passes = inner->passes, .begin = begin, .take = take, .end = end},
                         .inner = inner,
                         .grammar = grammar,
                         .skip = range.first,
                         .left = range.length,
                         .done = range.length == 0};
}

// ---- the descent -------------------------------------------------------------

// Modules in reverse order: the end of each array belongs to the next one.
typedef struct Stack {
  uint16_t *kind;
  uint64_t *steps;
  double *arg;
  uint64_t *key;
  size_t count, arg_count, key_count;
  size_t kind_room, steps_room, arg_room, key_room;
} Stack;

struct LsysDescent {
  LsysWorker *worker;
  LsysWorker one_step;     // of the same thread; its derivation ends one step below the module's level
  LsysWriter writer;       // into the window
  LsysWriter step_writer;  // into the successor
  LsysStore successor;
  Stack stack;
  LsysLength *size;  // size[s * kind_count + k]
  size_t size_count;
};

static LsysLength add(LsysLength a, LsysLength b) {
  return a > ENDLESS - b ? ENDLESS : a + b;
}

static LsysLength multiply(LsysLength a, uint32_t factor) {
  if (a <= ENDLESS >> 32) return a * factor;  // the usual case, without a division of 128 bits
  return factor && a > ENDLESS / factor ? ENDLESS : a * factor;
}

static bool find_sizes(LsysDescent *descent) {
  const LsysGrammar *grammar = descent->worker->run.grammar;
  const LsysGrowth *growth = &grammar->growth;
  size_t kinds = grammar->kind_count;
  uint64_t steps = descent->worker->run.steps;
  if (steps == UINT64_MAX || __builtin_mul_overflow((size_t)steps + 1, kinds, &descent->size_count))
    descent->size_count = SIZE_MAX;
  descent->size = lsys_memory_alloc(descent->worker->memory, descent->size_count, sizeof *descent->size);
  if (!descent->size) return false;
  LsysLength *now = descent->size;
  for (size_t k = 0; k < kinds; k++) now[k] = 1;
  for (uint64_t s = 1; s <= steps; s++, now += kinds)
    for (size_t k = 0; k < kinds; k++)
      for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++)
        now[kinds + k] = add(now[kinds + k], multiply(now[growth->kind[e]], growth->count[e]));
  return true;
}

static bool grow(LsysMemory *memory, void **at, size_t *room, size_t count, size_t size) {
  if (count < *room) return true;
  void *grown = lsys_memory_grow(memory, *at, room, size);
  if (grown) *at = grown;
  return grown;
}

static bool push(LsysDescent *descent, unsigned kind, const double *arg, const uint64_t *key, uint64_t steps) {
  const LsysKind *info = &descent->worker->run.grammar->kinds[kind];
  LsysMemory *memory = descent->worker->memory;
  Stack *stack = &descent->stack;
  bool has_key = info->flags & LSYS_KIND_KEY;
  if (!grow(memory, (void **)&stack->kind, &stack->kind_room, stack->count, sizeof *stack->kind)
      || !grow(memory, (void **)&stack->steps, &stack->steps_room, stack->count, sizeof *stack->steps))
    return false;
  while (stack->arg_count + info->arity > stack->arg_room)
    if (!grow(memory, (void **)&stack->arg, &stack->arg_room, stack->arg_room, sizeof *stack->arg)) return false;
  if (has_key && !grow(memory, (void **)&stack->key, &stack->key_room, stack->key_count, sizeof *stack->key))
    return false;
  stack->kind[stack->count] = (uint16_t)kind;
  stack->steps[stack->count++] = steps;
  for (unsigned i = 0; i < info->arity; i++) stack->arg[stack->arg_count++] = arg[i];
  if (has_key) stack->key[stack->key_count++] = *key;
  return true;
}

// The modules of a word, the first one on top.
static bool push_word(LsysDescent *descent, const LsysWord *word, uint64_t steps) {
  const LsysGrammar *grammar = descent->worker->run.grammar;
  unsigned width = lsys_symbol_width(grammar);
  const double *arg = word->arg + word->narg;
  const uint64_t *key = word->key + word->nkey;
  for (uint64_t i = word->nsym; i-- > 0;) {
    const uint8_t *sym = word->sym + i * width;
    unsigned kind = width == 1 ? sym[0] : (unsigned)(sym[0] | sym[1] << 8);
    arg -= grammar->kinds[kind].arity;
    key -= (grammar->kinds[kind].flags & LSYS_KIND_KEY) != 0;
    if (!push(descent, kind, arg, key, steps)) return false;
  }
  return true;
}

// One module off the stack, as a word; its arguments and key stay readable until the next push.
typedef struct Popped {
  uint8_t sym[2];
  unsigned kind;
  uint64_t steps;
  LsysWord word;
} Popped;

static void pop(LsysDescent *descent, Popped *popped) {
  Stack *stack = &descent->stack;
  stack->count--;
  unsigned kind = popped->kind = stack->kind[stack->count];
  const LsysKind *info = &descent->worker->run.grammar->kinds[kind];
  uint64_t keys = (info->flags & LSYS_KIND_KEY) != 0;
  stack->arg_count -= info->arity;
  stack->key_count -= keys;
  popped->steps = stack->steps[stack->count];
  popped->sym[0] = (uint8_t)kind;
  popped->sym[1] = (uint8_t)(kind >> 8);
  popped->word = (LsysWord){.sym = popped->sym,
                            .arg = info->arity ? stack->arg + stack->arg_count : NULL,
                            .key = keys ? stack->key + stack->key_count : NULL,
                            .nsym = 1,
                            .narg = info->arity,
                            .nkey = keys};
}

// Derives the module by one step and puts its successor onto the stack.
static bool open_up(LsysDescent *descent, const Popped *popped) {
  lsys_store_clear(&descent->successor);
  lsys_writer_advance(&descent->step_writer, &popped->word, descent->worker->run.steps, popped->steps,
                      popped->steps - 1);
  LsysWord successor = lsys_store_word(&descent->successor);
  return push_word(descent, &successor, popped->steps - 1);
}

static bool descend(LsysDescent *descent, LsysWindow *window) {
  size_t kinds = descent->worker->run.grammar->kind_count;
  while (descent->stack.count && !window->done) {
    Popped popped;
    pop(descent, &popped);
    LsysLength size = descent->size[popped.steps * kinds + popped.kind];
    if (size <= window->skip)
      window->skip -= size;
    else if (window->skip == 0 && size <= window->left)
      lsys_writer_finish(&descent->writer, &popped.word, descent->worker->run.steps, popped.steps);
    else if (!open_up(descent, &popped))
      return false;
  }
  return true;
}

bool lsys_descent_run(LsysDescent **place, LsysWorker *worker, const LsysWord *word, LsysWindow *window) {
  LsysDescent *descent = *place = lsys_memory_alloc(worker->memory, 1, sizeof *descent);
  if (!descent) return false;
  descent->worker = worker;
  descent->one_step.run = worker->run;
  descent->one_step.memory = worker->memory;
  descent->one_step.stack_limit = worker->stack_limit;
  descent->one_step.stack_bytes = worker->stack_bytes;
  lsys_store_open(&descent->successor, worker->run.grammar, worker->memory);
  if (setjmp(descent->one_step.stop)) return false;
  return find_sizes(descent) && lsys_writer_open(&descent->writer, worker, &window->sink)
      && lsys_writer_open(&descent->step_writer, &descent->one_step, &descent->successor.sink)
      && push_word(descent, word, worker->run.steps) && descend(descent, window);
}

void lsys_descent_close(LsysDescent *descent) {
  if (!descent) return;
  LsysMemory *memory = descent->worker->memory;
  Stack *stack = &descent->stack;
  if (descent->writer.stream.run) lsys_writer_close(&descent->writer);
  if (descent->step_writer.stream.run) lsys_writer_close(&descent->step_writer);
  lsys_store_close(&descent->successor);
  lsys_memory_free(memory, stack->kind, stack->kind_room, sizeof *stack->kind);
  lsys_memory_free(memory, stack->steps, stack->steps_room, sizeof *stack->steps);
  lsys_memory_free(memory, stack->arg, stack->arg_room, sizeof *stack->arg);
  lsys_memory_free(memory, stack->key, stack->key_room, sizeof *stack->key);
  lsys_memory_free(memory, descent->size, descent->size_count, sizeof *descent->size);
  lsys_memory_free(memory, descent, 1, sizeof *descent);
}
