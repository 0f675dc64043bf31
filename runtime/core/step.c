// step.c -- the loop over the steps; see scan.h for what a step sees.
#include "core/step.h"

static bool open_stepper(LsysStepper *stepper, LsysWorker *worker, LsysSink *sink) {
  const LsysGrammar *grammar = worker->run.grammar;
  *stepper = (LsysStepper){.worker = worker};
  for (int i = 0; i < 2; i++) lsys_store_open(&stepper->words[i], grammar, worker->memory);
  return lsys_walk_open(&stepper->walk, worker) && lsys_writer_open(&stepper->writer, worker, sink);
}

void lsys_stepper_close(LsysStepper *stepper) {
  if (!stepper->worker) return;
  for (int i = 0; i < 2; i++) lsys_store_close(&stepper->words[i]);
  if (stepper->writer.stream.run) lsys_writer_close(&stepper->writer);
  lsys_walk_close(&stepper->walk);
  *stepper = (LsysStepper){0};
}

// Rewrites every module of `from` into what the writer writes to.
static void rewrite(LsysStepper *stepper, const LsysStore *from, uint64_t step) {
  LsysWord word = lsys_store_word(from);
  lsys_look(&stepper->worker->run, &word, from->arg);
  LsysScan *scan = lsys_walk_start(&stepper->walk, &word);
  scan->step = step;
  stepper->worker->run.grammar->step(scan, &stepper->writer.stream);
}

// The same into the other store.
static void rewrite_stored(LsysStepper *stepper, unsigned now, uint64_t step) {
  lsys_writer_enter(&stepper->writer, &stepper->words[!now]);
  rewrite(stepper, &stepper->words[now], step);
  lsys_writer_leave(&stepper->writer);
}

static void run_block(LsysRun *run, uint32_t which) {
  if (run->grammar->block) run->grammar->block(run, which);
}

// Where the grammar decomposes apart: from one store to the other. Returns the one that holds the word then.
static unsigned decompose(LsysStepper *stepper, unsigned now) {
  LsysRun *run = &stepper->worker->run;
  if (!run->grammar->decompose) return now;
  LsysWord word = lsys_store_word(&stepper->words[now]);
  lsys_writer_enter(&stepper->writer, &stepper->words[!now]);
  run->grammar->decompose(lsys_walk_start(&stepper->walk, &word), &stepper->writer.stream);
  lsys_writer_leave(&stepper->writer);
  return !now;
}

// Steps with something behind each: blocks, which may stop them, and decomposition. The last word is known only then.
static bool run_apart(LsysStepper *stepper, LsysSink *sink) {
  LsysRun *run = &stepper->worker->run;
  unsigned now = 0;
  for (uint64_t step = 0; step < run->steps && !run->stopped; step++) {
    run_block(run, LSYS_BLOCK_START_EACH);
    rewrite_stored(stepper, now, step);
    now = decompose(stepper, !now);
    run_block(run, LSYS_BLOCK_END_EACH);
  }
  run_block(run, LSYS_BLOCK_END);
  LsysWord word = lsys_store_word(&stepper->words[now]);
  return sink->take(sink, &word);
}

bool lsys_stepper_run(LsysStepper *stepper, LsysWorker *worker, const LsysWord *axiom, LsysSink *sink) {
  uint64_t steps = worker->run.steps;
  if (!steps && !worker->run.grammar->block) return sink->take(sink, axiom);
  if (!open_stepper(stepper, worker, sink) || !stepper->words[0].sink.take(&stepper->words[0].sink, axiom))
    return false;
  if (worker->run.grammar->block || worker->run.grammar->decompose) return run_apart(stepper, sink);
  unsigned now = 0;
  for (uint64_t step = 0; step + 1 < steps; step++, now = !now) rewrite_stored(stepper, now, step);
  rewrite(stepper, &stepper->words[now], steps - 1);
  lsys_flush(&stepper->writer.stream);
  return true;
}
