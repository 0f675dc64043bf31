// step.c -- the loop over the steps; see scan.h for what a step sees.
#include "core/step.h"

static bool open_stepper(LsysStepper *stepper, LsysWorker *worker) {
  const LsysGrammar *grammar = worker->run.grammar;
  *stepper = (LsysStepper){.worker = worker};
  for (int i = 0; i < 2; i++) lsys_store_open(&stepper->words[i], grammar, worker->memory);
  stepper->left = lsys_memory_alloc(worker->memory, grammar->left_window, sizeof *stepper->left);
  return stepper->left && scan_tables(&stepper->tables, grammar)
      && lsys_writer_open(&stepper->writer, worker, &stepper->words[1].sink);
}

void lsys_stepper_close(LsysStepper *stepper) {
  if (!stepper->worker) return;
  LsysMemory *memory = stepper->worker->memory;
  lsys_memory_free(memory, stepper->left, stepper->worker->run.grammar->left_window, sizeof *stepper->left);
  for (int i = 0; i < 2; i++) lsys_store_close(&stepper->words[i]);
  if (stepper->writer.stream.run) lsys_writer_close(&stepper->writer);
  scan_free(&stepper->scan, &stepper->worker->run);
  scan_index_free(&stepper->index, &stepper->worker->run);
  scan_tables_free(&stepper->tables);
  *stepper = (LsysStepper){0};
}

// Rewrites every module of `from` into a sink.
static void rewrite(LsysStepper *stepper, const LsysStore *from, LsysSink *to, uint64_t step) {
  LsysRun *run = &stepper->worker->run;
  LsysSegment segment = {
    .sym = from->sym, .end = from->sym + from->nsym * from->width, .arg = from->arg, .key = from->key};
  stepper->writer.sink = to;
  scan_index(&stepper->index, &stepper->tables, run, &segment, 1);
  scan_start(&stepper->scan, &stepper->tables, run, &segment, 1, stepper->left);
  stepper->scan.step = step;
  run->grammar->step(&stepper->scan, &stepper->writer.stream);
  lsys_flush(&stepper->writer.stream);
}

static void run_block(LsysRun *run, uint32_t which) {
  if (run->grammar->block) run->grammar->block(run, which);
}

// Where the grammar decomposes apart: from one store to the other. Returns the one that holds the word then.
static unsigned decompose(LsysStepper *stepper, unsigned now) {
  LsysRun *run = &stepper->worker->run;
  if (!run->grammar->decompose) return now;
  LsysWord word = lsys_store_word(&stepper->words[now]);
  LsysStore *next = &stepper->words[!now];
  lsys_store_clear(next);
  stepper->writer.sink = &next->sink;
  run->grammar->decompose(run, &word, &stepper->writer.stream);
  lsys_flush(&stepper->writer.stream);
  return !now;
}

// Steps between blocks, which may stop them: the last word is known only behind it.
static bool run_with_blocks(LsysStepper *stepper, LsysSink *sink) {
  LsysRun *run = &stepper->worker->run;
  unsigned now = 0;
  for (uint64_t step = 0; step < run->steps && !run->stopped; step++) {
    LsysStore *next = &stepper->words[!now];
    run_block(run, LSYS_BLOCK_START_EACH);
    lsys_store_clear(next);
    rewrite(stepper, &stepper->words[now], &next->sink, step);
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
  if (!open_stepper(stepper, worker) || !stepper->words[0].sink.take(&stepper->words[0].sink, axiom)) return false;
  if (worker->run.grammar->block) return run_with_blocks(stepper, sink);
  unsigned now = 0;
  for (uint64_t step = 0; step < steps; step++, now = !now) {
    LsysStore *next = &stepper->words[!now];
    lsys_store_clear(next);
    rewrite(stepper, &stepper->words[now], step + 1 < steps ? &next->sink : sink, step);
  }
  return true;
}
