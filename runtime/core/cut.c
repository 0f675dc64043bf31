// cut.c -- samples a derivation to find a cut: modules here and there of the word
// before the last m steps are derived to the end, for growing m, until they
// become long enough to be worth handing to another thread.
#include "core/cut.h"

#include "core/store.h"

enum {
  SAMPLE = 64,           // modules,
  STRIDE = 17,           //   each the first of so many: a prime, as words repeat themselves
  WORTH = 1 << 9,        // weight that a module has to become; little of a stretch, so that stretches weigh the same
  MOST_STEPS = 1 << 16,  // beyond, words are chains, and sampling takes longer than deriving
  STRETCH = 3 << 14,     // weight of a stretch: less than what a task may be ahead (pipeline.c)
  STRETCH_OF_BLOCKS = 1 << 18,  //   where what is no whole block of the word at its ends is not shared
  REFERENCE_DIVISOR = 16,       // a module of a block costs its reader this much less than one that was written
  MOSTLY = 16,
  MOST_WEIGHT = 1 << 21,  // of a sample
};

// ---- words -------------------------------------------------------------------

void lsys_cut_begin(LsysCut *cut, const LsysGrammar *grammar, const LsysWord *word) {
  cut->grammar = grammar;
  cut->rest = *word;
}

LsysWord lsys_cut_take(LsysCut *cut, uint64_t modules) {
  LsysWord *rest = &cut->rest, taken = *rest;
  if (modules >= rest->nsym) {
    *rest = (LsysWord){0};
    return taken;
  }
  unsigned width = lsys_symbol_width(cut->grammar);
  taken.nsym = modules;
  taken.narg = taken.nkey = 0;
  bool bare = !rest->narg && !rest->nkey;
  for (uint64_t i = 0; i < modules && !bare; i++) {
    const uint8_t *sym = rest->sym + i * width;
    const LsysKind *kind = &cut->grammar->kinds[width == 1 ? sym[0] : sym[0] | sym[1] << 8];
    taken.narg += kind->arity;
    taken.nkey += (kind->flags & LSYS_KIND_KEY) != 0;
  }
  rest->sym += modules * width;
  rest->arg += taken.narg;
  rest->key += taken.nkey;
  rest->nsym -= taken.nsym;
  rest->narg -= taken.narg;
  rest->nkey -= taken.nkey;
  return taken;
}

// ---- samples -----------------------------------------------------------------

typedef struct Sampler {
  LsysWorker worker;  // of this thread
  LsysSink sink;
  LsysWriter writer;
  LsysStore sample;
  uint64_t passed;             // modules to be left out before the next one
  double weight;               // of what the sample became
  double written, referenced;  // modules of it
  LsysCutWork work;
} Sampler;

static Sampler *sampler_of(LsysSink *sink) {
  return (Sampler *)((char *)sink - offsetof(Sampler, sink));
}

// Both stop the derivation when they have enough.
static bool take_sample(LsysSink *sink, const LsysWord *part) {
  Sampler *sampler = sampler_of(sink);
  LsysCut cut;
  lsys_cut_begin(&cut, sampler->worker.run.grammar, part);
  while (cut.rest.nsym && sampler->sample.nsym < SAMPLE) {
    LsysWord next = lsys_cut_take(&cut, sampler->passed ? sampler->passed : 1);
    if (sampler->passed)
      sampler->passed -= next.nsym;
    else if (sampler->sample.sink.take(&sampler->sample.sink, &next))
      sampler->passed = STRIDE - 1;
    else
      return false;
  }
  return sampler->sample.nsym < SAMPLE;
}

static bool take_weight(LsysSink *sink, const LsysWord *part) {
  Sampler *sampler = sampler_of(sink);
  if (part->sym == sampler->writer.sym)
    sampler->written += (double)part->nsym;
  else
    sampler->referenced += (double)part->nsym;
  sampler->weight = sampler->written + sampler->referenced / (sampler->work == LSYS_CUT_PARTS ? 1 : REFERENCE_DIVISOR);
  return sampler->weight < MOST_WEIGHT;
}

static void use(Sampler *sampler, bool (*take)(LsysSink *, const LsysWord *)) {
  sampler->sink.take = take;
  lsys_writer_use(&sampler->writer, sampler->writer.sym, sampler->writer.arg, sampler->writer.key);
}

// Derives until `last` steps are left, or the sample is big enough.
static void take_frontier(Sampler *sampler, const LsysWord *word, uint64_t steps, uint64_t last) {
  use(sampler, take_sample);
  if (!setjmp(sampler->worker.stop)) lsys_writer_advance(&sampler->writer, word, steps, steps, last);
}

// Derives the last steps of the sample, or until it is heavy enough.
static void take_rest(Sampler *sampler, const LsysWord *sample, uint64_t steps, uint64_t last) {
  use(sampler, take_weight);
  if (!setjmp(sampler->worker.stop)) lsys_writer_finish(&sampler->writer, sample, steps, last);
}

// The mean weight of what a module before the last `last` steps becomes.
static double weigh(Sampler *sampler, const LsysWord *word, uint64_t steps, uint64_t last) {
  lsys_store_clear(&sampler->sample);
  sampler->passed = 0;
  take_frontier(sampler, word, steps, last);
  sampler->weight = sampler->written = sampler->referenced = 0;
  LsysWord sample = lsys_store_word(&sampler->sample);
  take_rest(sampler, &sample, steps, last);
  return sample.nsym ? sampler->weight / (double)sample.nsym : 0;
}

// The fewest of the last steps, above `few` and up to `many`, in which a module becomes heavy enough; in `many` it
// does.
static uint64_t bisect(Sampler *sampler, const LsysWord *word, uint64_t steps, uint64_t few, uint64_t many) {
  while (many - few > 1) {
    uint64_t middle = few + (many - few) / 2;
    *(weigh(sampler, word, steps, middle) < WORTH ? &few : &many) = middle;
  }
  return many;
}

// Looks at few steps first, because samples of many take long.
static uint64_t search(Sampler *sampler, const LsysWord *word, uint64_t steps, uint64_t *modules) {
  const double stretch = sampler->work == LSYS_CUT_BLOCKS ? STRETCH_OF_BLOCKS : STRETCH;
  for (uint64_t last = 1, before = 0; last < steps; before = last, last += last < 16 ? 1 : last) {
    if (weigh(sampler, word, steps, last) < WORTH) continue;
    if (sampler->work == LSYS_CUT_ALONE && sampler->referenced > MOSTLY * sampler->written) break;
    last = bisect(sampler, word, steps, before, last);
    double weight = weigh(sampler, word, steps, last);
    *modules = weight < stretch ? (uint64_t)(stretch / weight) : 1;
    return last;
  }
  return steps;
}

uint64_t lsys_cut_choose(const LsysWorker *worker, const LsysWord *word, LsysCutWork work, uint64_t *modules) {
  uint64_t steps = worker->run.steps;
  *modules = UINT64_MAX;
  if (steps > MOST_STEPS || !word->nsym) return steps;
  LsysMemory *memory = worker->memory;
  Sampler *sampler = lsys_memory_alloc(memory, 1, sizeof *sampler);
  if (!sampler) return 0;
  sampler->worker.run = worker->run;
  sampler->worker.memory = memory;
  sampler->work = work;
  sampler->worker.stack_limit = worker->stack_limit;
  sampler->worker.stack_bytes = worker->stack_bytes;
  lsys_store_open(&sampler->sample, worker->run.grammar, memory);
  uint64_t last = 0;
  if (lsys_writer_open(&sampler->writer, &sampler->worker, &sampler->sink)) {
    last = search(sampler, word, steps, modules);
    lsys_writer_close(&sampler->writer);
  }
  lsys_store_close(&sampler->sample);
  lsys_memory_free(memory, sampler, 1, sizeof *sampler);
  return last;
}
