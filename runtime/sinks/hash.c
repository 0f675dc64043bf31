// hash.c -- the hash of a word (LANGUAGE.md section 9): XXH3-64 over, for each
// block of 65,536 modules, the XXH3-64 of its symbol bytes and that of its
// arguments. It depends on the word alone, not on how it was cut into parts.
#include "core/message.h"
#include "core/stream.h"
#include "sinks/count.h"

#include <string.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

enum { BLOCK = 1 << 16, NAN_PIECE = 512 };

// Bits of doubles.
#define INFINITE UINT64_C(0x7ff0000000000000)
#define CANONICAL UINT64_C(0x7ff8000000000000)

typedef struct HashSink {
  LsysSink sink;
  const LsysGrammar *grammar;
  LsysMemory *memory;
  LsysOut *out;
  unsigned width;
  uint32_t axiom;
  bool several, parametric;
  uint64_t in_block;  // modules of the current block so far
  XXH3_state_t *word, *symbols, *arguments;
} HashSink;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)pass;
  HashSink *hash = (HashSink *)sink;
  hash->axiom = axiom;
  hash->in_block = 0;
  XXH3_64bits_reset(hash->word);
  XXH3_64bits_reset(hash->symbols);
  XXH3_64bits_reset(hash->arguments);
  return true;
}

static void close_block(HashSink *hash) {
  uint64_t digests[2] = {XXH3_64bits_digest(hash->symbols), XXH3_64bits_digest(hash->arguments)};
  XXH3_64bits_update(hash->word, digests, sizeof digests);
  XXH3_64bits_reset(hash->symbols);
  XXH3_64bits_reset(hash->arguments);
  hash->in_block = 0;
}

// The bits of nans are all the same one's. Arrays of this size, aligned, are what the compiler makes vectors of.
static void make_canonical(uint64_t bits[static NAN_PIECE]) {
  uint64_t found = 0;
  for (int i = 0; i < NAN_PIECE; i++) found |= (bits[i] & INT64_MAX) + INT64_MAX - INFINITE;
  if (found >> 63 == 0) return;
  for (int i = 0; i < NAN_PIECE; i++)
    if ((bits[i] & INT64_MAX) > INFINITE) bits[i] = CANONICAL;
}

// Every nan is hashed as the same one.
static void add_arguments(HashSink *hash, const double *arg, uint64_t count) {
  uint64_t bits[NAN_PIECE] = {0};
  while (count) {
    uint64_t n = count < NAN_PIECE ? count : NAN_PIECE;
    memcpy(bits, arg, n * sizeof *arg);
    make_canonical(bits);
    XXH3_64bits_update(hash->arguments, bits, n * sizeof *bits);
    arg += n;
    count -= n;
  }
}

static uint64_t arguments_of(const HashSink *hash, const uint8_t *sym, uint64_t modules) {
  const LsysKind *kinds = hash->grammar->kinds;
  uint64_t sum = 0;
  if (hash->width == 1)
    for (uint64_t i = 0; i < modules; i++) sum += kinds[sym[i]].arity;
  else
    for (uint64_t i = 0; i < modules; i++) sum += kinds[sym[2 * i] | sym[2 * i + 1] << 8].arity;
  return sum;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  HashSink *hash = (HashSink *)sink;
  const uint8_t *sym = part->sym;
  const double *arg = part->arg;
  uint64_t modules = part->nsym, arguments = part->narg;
  while (modules) {
    uint64_t n = BLOCK - hash->in_block;
    uint64_t n_arg = arguments;
    if (n > modules)
      n = modules;
    else if (hash->parametric && n < modules)
      n_arg = arguments_of(hash, sym, n);
    XXH3_64bits_update(hash->symbols, sym, (size_t)n * hash->width);
    add_arguments(hash, arg, n_arg);
    sym += n * hash->width;
    arg += n_arg;
    modules -= n;
    arguments -= n_arg;
    hash->in_block += n;
    if (hash->in_block == BLOCK) close_block(hash);
  }
  return true;
}

static bool end(LsysSink *sink) {
  HashSink *hash = (HashSink *)sink;
  if (hash->in_block) close_block(hash);
  return lsys_count_heading(hash->out, hash->several, hash->axiom)
      && lsys_out_print(hash->out, "%016llx\n", (unsigned long long)XXH3_64bits_digest(hash->word));
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  HashSink *hash = (HashSink *)sink;
  XXH3_freeState(hash->word);
  XXH3_freeState(hash->symbols);
  XXH3_freeState(hash->arguments);
  lsys_memory_free(hash->memory, hash, 1, sizeof *hash);
}

LsysSink *lsys_sink_hash(const LsysSinkContext *context) {
  HashSink *hash = lsys_memory_alloc(context->memory, 1, sizeof *hash);
  if (!hash) return NULL;
  const LsysGrammar *grammar = context->grammar;
  hash->sink = (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  hash->grammar = grammar;
  hash->memory = context->memory;
  hash->out = context->out;
  hash->width = lsys_symbol_width(grammar);
  hash->several = grammar->axiom_count > 1 && !context->options->at[LSYS_OPTION_AXIOM].given;
  for (uint32_t i = 0; i < grammar->kind_count; i++) hash->parametric |= grammar->kinds[i].arity > 0;
  hash->word = XXH3_createState();
  hash->symbols = XXH3_createState();
  hash->arguments = XXH3_createState();
  if (hash->word && hash->symbols && hash->arguments) return &hash->sink;
  lsys_error("out of memory");
  destroy(&hash->sink);
  return NULL;
}
