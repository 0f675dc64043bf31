// derive.c -- sinks of the benchmark: one counts, one sums.
#include "derive.h"

#include "core/derive.h"
#include "sinks/homomorphism.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct WordSink {
  LsysSink sink;
  Streamed seen;
} WordSink;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)sink, (void)run, (void)axiom, (void)pass;
  return true;
}

static bool end(LsysSink *sink) {
  (void)sink;
  return true;
}

static bool take_size(LsysSink *sink, const LsysWord *part) {
  Streamed *seen = &((WordSink *)sink)->seen;
  seen->nsym += part->nsym;
  seen->narg += part->narg;
  return true;
}

// In rows of sums of 16 bits, each of at most 256 bytes: widened to 64 bits at once, adding would take longer than
// deriving.
uint64_t sum_bytes(const uint8_t *at, size_t count) {
  enum { LANES = 64, MOST = 256 };
  uint64_t sum = 0;
  while (count >= LANES) {
    uint16_t lanes[LANES] = {0};
    size_t rows = count / LANES < MOST ? count / LANES : MOST;
    for (size_t r = 0; r < rows; r++, at += LANES)
      for (int i = 0; i < LANES; i++) lanes[i] = (uint16_t)(lanes[i] + at[i]);
    for (int i = 0; i < LANES; i++) sum += lanes[i];
    count -= rows * LANES;
  }
  for (size_t i = 0; i < count; i++) sum += at[i];
  return sum;
}

static bool take_sum(LsysSink *sink, const LsysWord *part) {
  Streamed *seen = &((WordSink *)sink)->seen;
  seen->sum += sum_bytes(part->sym, part->nsym) + sum_bytes((const uint8_t *)part->arg, 8 * part->narg);
  return take_size(sink, part);
}

void word_flow(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, bool shown, LsysSink *sink) {
  LsysMemory memory = {.limit = lsys_memory_default()};
  LsysOptions options = {0};
  options.at[LSYS_OPTION_STEPS] = (LsysOptionValue){.given = true, .whole = steps};
  options.at[LSYS_OPTION_THREADS] = (LsysOptionValue){.given = true, .whole = 1};
  options.at[LSYS_OPTION_SEED] = (LsysOptionValue){.given = true, .whole = seed};
  LsysSinkContext context = {.grammar = grammar, .options = &options, .memory = &memory};
  LsysDerivation derivation;
  if (!lsys_derivation_open(&derivation, grammar, &options, &memory)) exit(1);
  LsysSink *to = shown ? lsys_sink_homomorphism(&context, sink) : sink;
  if (!to || !lsys_derivation_run(&derivation, 0, to, 0)) exit(1);
  if (shown) to->destroy(to);
  lsys_derivation_close(&derivation);
}

static Streamed derive(const LsysGrammar *grammar, uint64_t steps, uint64_t seed,
                       bool (*take)(LsysSink *, const LsysWord *)) {
  WordSink sink = {.sink = {.passes = 1, .begin = begin, .take = take, .end = end}};
  word_flow(grammar, steps, seed, false, &sink.sink);
  return sink.seen;
}

void word_size(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, size_t *nsym, size_t *narg) {
  Streamed seen = derive(grammar, steps, seed, take_size);
  *nsym = seen.nsym;
  *narg = seen.narg;
}

void word_store(const LsysGrammar *grammar, uint64_t steps, uint64_t seed, LsysWhole *whole) {
  char n[24], s[24];
  snprintf(n, sizeof n, "%" PRIu64, steps);
  snprintf(s, sizeof s, "%" PRIu64, seed);
  if (!lsys_derive_word(grammar, (const char *const[]){"-n", n, "--seed", s, "--threads", "1", NULL}, whole)) exit(1);
}

Streamed word_stream(const LsysGrammar *grammar, uint64_t steps, uint64_t seed) {
  return derive(grammar, steps, seed, take_sum);
}
