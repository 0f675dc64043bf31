// hash.c -- the hash of a word (LANGUAGE.md section 9): XXH3-64 over, for each
// block of 65,536 modules, the XXH3-64 of its symbol bytes and that of its
// arguments. It depends on the word alone, not on how it was cut into parts.
//
// Where it is known where parts stand, other threads hash, too: each from the
// first border of blocks that it meets in its stretch. What it hands on of a
// part are the digests of blocks that end in it, and the state of the one that
// goes on, from which anybody can go on.
#include "core/cut.h"
#include "core/message.h"
#include "sinks/count.h"

#include <string.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

enum { BLOCK = 1 << 16, NAN_PIECE = 512 };

// Bits of doubles.
#define INFINITE UINT64_C(0x7ff0000000000000)
#define CANONICAL UINT64_C(0x7ff8000000000000)

// A block, as far as it is known.
typedef struct Block {
  XXH3_state_t symbols, arguments;
  uint64_t modules;
} Block;

typedef struct Digests {
  uint64_t symbols, arguments;
} Digests;

typedef struct HashSink {
  LsysSink sink;
  const LsysGrammar *grammar;
  LsysMemory *memory;
  LsysOut *out;
  unsigned width;
  uint32_t axiom;
  bool several;
  XXH3_state_t *word;
  Block *block;
  void *block_room;
} HashSink;

// What a thread keeps from part to part.
typedef struct Own {
  Block block;
  uint64_t place;  // where the next part stands if it goes on with this block
  bool known;      // from its beginning
} Own;

enum { OWN_ROOM = sizeof(Own) + _Alignof(Own), BLOCK_ROOM = sizeof(Block) + _Alignof(Block) };

// The first address in the room that suits states.
static void *aligned(void *room) {
  uintptr_t at = (uintptr_t)room, alignment = _Alignof(Block);
  return (void *)((at + alignment - 1) / alignment * alignment);
}

static void clear(Block *block) {
  XXH3_64bits_reset(&block->symbols);
  XXH3_64bits_reset(&block->arguments);
  block->modules = 0;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)pass;
  HashSink *hash = (HashSink *)sink;
  hash->axiom = axiom;
  XXH3_64bits_reset(hash->word);
  clear(hash->block);
  return true;
}

// ---- blocks ------------------------------------------------------------------

// The bits of nans are all the same one's. Arrays of this size, aligned, are what the compiler makes vectors of.
static void make_canonical(uint64_t bits[static NAN_PIECE]) {
  uint64_t found = 0;
  for (int i = 0; i < NAN_PIECE; i++) found |= (bits[i] & INT64_MAX) + INT64_MAX - INFINITE;
  if (found >> 63 == 0) return;
  for (int i = 0; i < NAN_PIECE; i++)
    if ((bits[i] & INT64_MAX) > INFINITE) bits[i] = CANONICAL;
}

// Every nan is hashed as the same one.
static void add_arguments(Block *block, const double *arg, uint64_t count) {
  uint64_t bits[NAN_PIECE] = {0};
  while (count) {
    uint64_t n = count < NAN_PIECE ? count : NAN_PIECE;
    memcpy(bits, arg, n * sizeof *arg);
    make_canonical(bits);
    XXH3_64bits_update(&block->arguments, bits, n * sizeof *bits);
    arg += n;
    count -= n;
  }
}

// Takes as many modules as the block still wants.
static void fill(const HashSink *hash, Block *block, LsysCut *cut) {
  LsysWord next = lsys_cut_take(cut, BLOCK - block->modules);
  XXH3_64bits_update(&block->symbols, next.sym, (size_t)next.nsym * hash->width);
  add_arguments(block, next.arg, next.narg);
  block->modules += next.nsym;
}

// What there is of the block is all of it; another one begins.
static Digests close_block(Block *block) {
  Digests digests = {XXH3_64bits_digest(&block->symbols), XXH3_64bits_digest(&block->arguments)};
  clear(block);
  return digests;
}

static void add_digests(HashSink *hash, Digests digests) {
  XXH3_64bits_update(hash->word, &digests, sizeof digests);
}

static bool take(LsysSink *sink, const LsysWord *part) {
  HashSink *hash = (HashSink *)sink;
  LsysCut cut;
  lsys_cut_begin(&cut, hash->grammar, part);
  while (cut.rest.nsym) {
    fill(hash, hash->block, &cut);
    if (hash->block->modules == BLOCK) add_digests(hash, close_block(hash->block));
  }
  return true;
}

static bool end(LsysSink *sink) {
  HashSink *hash = (HashSink *)sink;
  if (hash->block->modules) add_digests(hash, close_block(hash->block));
  return lsys_count_heading(hash->out, hash->several, hash->axiom)
      && lsys_out_print(hash->out, "%016llx\n", (unsigned long long)XXH3_64bits_digest(hash->word));
}

// ---- on other threads --------------------------------------------------------

static Own *own_of(LsysPrepared *prepared) {
  if (!prepared->scratch) {
    prepared->scratch = lsys_memory_alloc(prepared->memory, 1, OWN_ROOM);
    prepared->scratch_bytes = prepared->scratch ? OWN_ROOM : 0;
  }
  return prepared->scratch ? aligned(prepared->scratch) : NULL;
}

// Takes what stands before the last border of blocks in a part, if there is one.
static bool find_border(LsysCut *cut, uint64_t place) {
  uint64_t behind = (place + cut->rest.nsym) % BLOCK;
  if (behind > cut->rest.nsym) return false;
  lsys_cut_take(cut, cut->rest.nsym - behind);
  return true;
}

// The thread does not know how the block began: the sink has to hash this part, and the thread as much as it needs to
// go on.
static bool decline(const HashSink *hash, Own *own, LsysCut *cut, LsysPrepared *prepared) {
  prepared->declined = true;
  clear(&own->block);
  own->known = find_border(cut, prepared->place);
  if (own->known) fill(hash, &own->block, cut);
  return true;
}

static bool append(LsysPrepared *prepared, const void *data, size_t size) {
  char *room = lsys_prepared_room(prepared, size);
  if (!room) return false;
  memcpy(room, data, size);
  prepared->used += size;
  return true;
}

static bool prepare(const LsysSink *sink, const LsysWord *part, LsysPrepared *prepared) {
  const HashSink *hash = (const HashSink *)sink;
  Own *own = own_of(prepared);
  if (!own) return false;
  LsysCut cut;
  lsys_cut_begin(&cut, hash->grammar, part);
  bool goes_on = own->known && own->place == prepared->place, begins = prepared->place % BLOCK == 0;
  own->place = prepared->place + part->nsym;
  if (!goes_on && !begins) return decline(hash, own, &cut, prepared);
  if (begins) clear(&own->block);
  own->known = true;
  if (prepared->used) prepared->used -= sizeof own->block;
  while (cut.rest.nsym) {
    fill(hash, &own->block, &cut);
    if (own->block.modules < BLOCK) break;
    Digests digests = close_block(&own->block);
    if (!append(prepared, &digests, sizeof digests)) return false;
  }
  return append(prepared, &own->block, sizeof own->block);
}

static bool accept(LsysSink *sink, const LsysPrepared *prepared) {
  HashSink *hash = (HashSink *)sink;
  const char *at = prepared->data, *last = prepared->data + prepared->used - sizeof *hash->block;
  for (Digests digests; at < last; at += sizeof digests) {
    memcpy(&digests, at, sizeof digests);
    add_digests(hash, digests);
  }
  memcpy(hash->block, last, sizeof *hash->block);
  return true;
}

// ---- opening and closing -----------------------------------------------------

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  HashSink *hash = (HashSink *)sink;
  XXH3_freeState(hash->word);
  lsys_memory_free(hash->memory, hash->block_room, 1, BLOCK_ROOM);
  lsys_memory_free(hash->memory, hash, 1, sizeof *hash);
}

LsysSink *lsys_sink_hash(const LsysSinkContext *context) {
  HashSink *hash = lsys_memory_alloc(context->memory, 1, sizeof *hash);
  if (!hash) return NULL;
  const LsysGrammar *grammar = context->grammar;
  hash->sink = (LsysSink){.passes = 1,
                          .begin = begin,
                          .take = take,
                          .end = end,
                          .finish = finish,
                          .destroy = destroy,
                          .block = BLOCK,
                          .prepare = prepare,
                          .accept = accept};
  hash->grammar = grammar;
  hash->memory = context->memory;
  hash->out = context->out;
  hash->width = lsys_symbol_width(grammar);
  hash->several = grammar->axiom_count > 1 && !context->options->at[LSYS_OPTION_AXIOM].given;
  hash->word = XXH3_createState();
  hash->block_room = lsys_memory_alloc(context->memory, 1, BLOCK_ROOM);
  if (hash->block_room) hash->block = aligned(hash->block_room);
  if (hash->word && hash->block) return &hash->sink;
  if (!hash->word) lsys_error("out of memory");
  destroy(&hash->sink);
  return NULL;
}
