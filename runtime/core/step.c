// step.c -- the loop over the steps; see scan.h for what a step sees. A word
// that is long enough is spread over threads, until it is short again.
#include "core/step.h"

enum {
  WORTH = 4,  // stretches: in shorter words waiting for each other takes longer than working
  LEAST = 1,
};

static bool open_stepper(LsysStepper *stepper, LsysWorker *worker, LsysSink *sink) {
  const LsysGrammar *grammar = worker->run.grammar;
  *stepper = (LsysStepper){.worker = worker, .steps = worker->run.steps};
  for (int i = 0; i < 2; i++) lsys_store_open(&stepper->words[i], grammar, worker->memory);
  return (!grammar->step || lsys_walk_open(&stepper->walk, worker)) && lsys_writer_open(&stepper->writer, worker, sink);
}

void lsys_stepper_close(LsysStepper *stepper) {
  if (!stepper->worker) return;
  lsys_spread_close(stepper->spread);
  for (int i = 0; i < 2; i++) lsys_store_close(&stepper->words[i]);
  if (stepper->writer.stream.run) lsys_writer_close(&stepper->writer);
  lsys_walk_close(&stepper->walk);
  *stepper = (LsysStepper){0};
}

// ---- one step ----------------------------------------------------------------

// One step of a context-free grammar, whose modules have keys as long as there are steps to go.
static void expand_once(LsysStepper *stepper, const LsysWord *word, uint64_t step) {
  uint64_t left = stepper->steps - step;
  if (left > 1)
    lsys_writer_advance(&stepper->writer, word, stepper->steps, left, left - 1);
  else
    lsys_writer_finish(&stepper->writer, word, stepper->steps, left);
}

// Rewrites every module of the stored word into what the writer writes to.
static void rewrite(LsysStepper *stepper, uint64_t step) {
  const LsysStore *from = &stepper->words[stepper->now];
  LsysWord word = lsys_store_word(from);
  if (!stepper->worker->run.grammar->step) {
    expand_once(stepper, &word, step);
    return;
  }
  lsys_look(&stepper->worker->run, &word, from->arg);
  LsysScan *scan = lsys_walk_start(&stepper->walk, &word);
  scan->step = step;
  stepper->worker->run.grammar->step(scan, &stepper->writer.stream);
}

// The same into the other store.
static void rewrite_stored(LsysStepper *stepper, uint64_t step) {
  lsys_writer_enter(&stepper->writer, &stepper->words[!stepper->now]);
  rewrite(stepper, step);
  lsys_writer_leave(&stepper->writer);
  stepper->now = !stepper->now;
}

static bool spread(LsysStepper *stepper) {
  LsysWord word = lsys_store_word(&stepper->words[stepper->now]);
  if (!stepper->spread && !lsys_spread_open(&stepper->spread, stepper->worker, stepper->threads, stepper->stretch))
    return false;
  stepper->is_spread = true;
  lsys_spread_begin(stepper->spread, &word);
  return true;
}

static bool gather(LsysStepper *stepper) {
  LsysStore *store = &stepper->words[stepper->now];
  lsys_store_clear(store);
  stepper->is_spread = false;
  return lsys_spread_each(stepper->spread, &store->sink);
}

// Brings the word where it is best rewritten from.
static bool settle(LsysStepper *stepper) {
  if (stepper->threads == 1) return true;
  if (!stepper->is_spread) return stepper->words[stepper->now].nsym < WORTH * stepper->stretch || spread(stepper);
  return lsys_spread_modules(stepper->spread) >= LEAST * stepper->stretch || gather(stepper);
}

static bool advance(LsysStepper *stepper, uint64_t step) {
  if (!settle(stepper)) return false;
  if (!stepper->is_spread) {
    rewrite_stored(stepper, step);
    return true;
  }
  if (!lsys_spread_step(stepper->spread, step)) return false;
  for (int i = 0; i < 2; i++) lsys_store_close(&stepper->words[i]);  // threads have stores of their own
  return true;
}

// The last one, into the sink.
static bool finish(LsysStepper *stepper, uint64_t step, LsysSink *sink) {
  if (!settle(stepper)) return false;
  if (stepper->is_spread) return lsys_spread_finish(stepper->spread, step, sink);
  rewrite(stepper, step);
  lsys_flush(&stepper->writer.stream);
  return true;
}

// ---- all steps ---------------------------------------------------------------

static void run_block(LsysRun *run, uint32_t which) {
  if (run->grammar->block) run->grammar->block(run, which);
}

// Where the grammar decomposes apart, and on one thread: from one store to the other.
static void decompose(LsysStepper *stepper) {
  LsysRun *run = &stepper->worker->run;
  if (!run->grammar->decompose) return;
  LsysWord word = lsys_store_word(&stepper->words[stepper->now]);
  lsys_writer_enter(&stepper->writer, &stepper->words[!stepper->now]);
  run->grammar->decompose(lsys_walk_start(&stepper->walk, &word), &stepper->writer.stream);
  lsys_writer_leave(&stepper->writer);
  stepper->now = !stepper->now;
}

static bool show(LsysStepper *stepper, LsysSink *sink) {
  if (stepper->is_spread) return lsys_spread_show(stepper->spread, sink);
  LsysWord word = lsys_store_word(&stepper->words[stepper->now]);
  return sink->take(sink, &word);
}

// Steps with something behind each: blocks, which may stop them, and decomposition. The last word is known only then.
static bool run_apart(LsysStepper *stepper, LsysSink *sink) {
  LsysRun *run = &stepper->worker->run;
  for (uint64_t step = 0; step < run->steps && !run->stopped; step++) {
    run_block(run, LSYS_BLOCK_START_EACH);
    if (!advance(stepper, step)) return false;
    decompose(stepper);
    run_block(run, LSYS_BLOCK_END_EACH);
  }
  run_block(run, LSYS_BLOCK_END);
  return show(stepper, sink);
}

bool lsys_stepper_run(LsysStepper *stepper, LsysWorker *worker, const LsysWord *axiom, LsysSink *sink, unsigned threads,
                      uint64_t stretch) {
  uint64_t steps = worker->run.steps;
  if (!steps && !worker->run.grammar->block) return sink->take(sink, axiom);
  if (!open_stepper(stepper, worker, sink) || !stepper->words[0].sink.take(&stepper->words[0].sink, axiom))
    return false;
  stepper->threads = lsys_spread_applies(worker->run.grammar) ? threads : 1;
  stepper->stretch = stretch;
  if (worker->run.grammar->block || worker->run.grammar->decompose) return run_apart(stepper, sink);
  for (uint64_t step = 0; step + 1 < steps; step++)
    if (!advance(stepper, step)) return false;
  return finish(stepper, steps - 1, sink);
}
