// births_step.c -- the step engine where births are asked for: compiled code
// goes through a word module by module, so that it is known what each became.
// One thread does so: whoever asks draws the word, which takes longer.
//
//   words[0]  before the step     | A     | B | % | ...     born      | 3     | 1 | 2 |
//   words[1]  behind its rewriting| C | D | B | ...         rewritten | 2     | 1 | 0 |
//   words[2]  decomposed          | C | D | B | ...         length    | 2     | 1 | 0 |
//
// Invariant: born[i] is the birth of module i of words[0], rewritten[i] and
// length[i] the number of modules that it became.
#include "core/births.h"
#include "core/cut.h"
#include "core/store.h"
#include "core/walk.h"

#include <string.h>

// A number for each module of a word.
typedef struct Row {
  uint64_t *at;
  size_t room;
} Row;

typedef void Way(LsysScan *scan, LsysStream *out);

struct LsysBirthsStep {
  LsysWorker *worker;
  LsysSink *sink;
  LsysWalk walk;
  LsysWriter writer;
  LsysStore words[3];
  Row born, next_born, rewritten, length;
};

static bool fit(LsysBirthsStep *s, Row *row, uint64_t count) {
  return lsys_memory_fit(s->worker->memory, &row->at, &row->room, count, sizeof *row->at);
}

static void free_row(LsysBirthsStep *s, Row *row) {
  lsys_memory_free(s->worker->memory, row->at, row->room, sizeof *row->at);
}

// ---- module by module --------------------------------------------------------

static uint64_t written(const LsysWriter *writer) {
  return (uint64_t)(writer->stream.sym - writer->store->sym) / writer->width;
}

// Modules that a predecessor or a cut takes along with another one become nothing.
static void go_apart(LsysBirthsStep *s, Way *way, LsysScan *scan, uint64_t *length) {
  const uint8_t *first = scan->sym, *end = scan->end;
  size_t width = lsys_symbol_width(s->worker->run.grammar);
  while (scan->sym < end) {
    size_t i = (size_t)(scan->sym - first) / width;
    uint64_t before = written(&s->writer);
    scan->end = scan->sym + width;
    way(scan, &s->writer.stream);
    length[i] = written(&s->writer) - before;
  }
}

// Compiled code goes through one word and writes another one.
static bool go(LsysBirthsStep *s, Way *way, unsigned from, unsigned to, uint64_t step, Row *length) {
  LsysWord word = lsys_store_word(&s->words[from]);
  if (!fit(s, length, word.nsym)) return false;
  memset(length->at, 0, word.nsym * sizeof *length->at);
  lsys_writer_enter(&s->writer, &s->words[to]);
  LsysScan *scan = lsys_walk_start(&s->walk, &word);
  scan->step = step;
  if (s->worker->run.grammar->flags & LSYS_GRAMMAR_LETTERS) {  // has no other way than step
    scan->lengths = length->at;
    way(scan, &s->writer.stream);
  } else {
    go_apart(s, way, scan, length->at);
  }
  lsys_writer_leave(&s->writer);
  return true;
}

// ---- one step ----------------------------------------------------------------

// Of the modules that a module became by rewriting, those that these became by decomposition.
static void compose(const Row *rewritten, uint64_t count, Row *length, const Row *decomposed) {
  const uint64_t *next = decomposed->at;
  for (uint64_t i = 0; i < count; i++) {
    length->at[i] = 0;
    for (uint64_t k = 0; k < rewritten->at[i]; k++) length->at[i] += *next++;
  }
}

static bool bear(LsysBirthsStep *s, const LsysStore *after, uint64_t step) {
  const LsysGrammar *grammar = s->worker->run.grammar;
  LsysWord before = lsys_store_word(&s->words[0]), word = lsys_store_word(after);
  if (!fit(s, &s->next_born, word.nsym)) return false;
  LsysCut old, new;
  lsys_cut_begin(&old, grammar, &before);
  lsys_cut_begin(&new, grammar, &word);
  uint64_t *born = s->next_born.at;
  for (uint64_t i = 0; i < before.nsym; i++) {
    uint64_t length = s->length.at[i];
    LsysWord module = lsys_cut_take(&old, 1), became = lsys_cut_take(&new, length);
    uint64_t birth = length == 1 && lsys_births_same(grammar, &module, &became) ? s->born.at[i] : step + 1;
    for (uint64_t k = 0; k < length; k++) *born++ = birth;
  }
  return true;
}

static void swap_stores(LsysStore *a, LsysStore *b) {
  LsysStore store = *a;
  *a = *b;
  *b = store;
}

static void swap_rows(Row *a, Row *b) {
  Row row = *a;
  *a = *b;
  *b = row;
}

static bool decompose(LsysBirthsStep *s, uint64_t step) {
  if (!go(s, s->worker->run.grammar->decompose, 1, 2, step, &s->next_born)) return false;
  compose(&s->rewritten, s->words[0].nsym, &s->length, &s->next_born);
  return true;
}

static bool advance(LsysBirthsStep *s, uint64_t step) {
  LsysRun *run = &s->worker->run;
  LsysWord word = lsys_store_word(&s->words[0]);
  lsys_look(run, &word, s->words[0].arg);
  bool apart = run->grammar->decompose;
  LsysStore *after = &s->words[1 + apart];
  if (!fit(s, &s->length, word.nsym)) return false;
  if (!go(s, run->grammar->step, 0, 1, step, apart ? &s->rewritten : &s->length)) return false;
  if ((apart && !decompose(s, step)) || !bear(s, after, step)) return false;
  swap_stores(&s->words[0], after);
  swap_rows(&s->born, &s->next_born);
  return true;
}

// ---- all steps ---------------------------------------------------------------

static void run_block(LsysRun *run, uint32_t which) {
  if (run->grammar->block) run->grammar->block(run, which);
}

static bool show(LsysBirthsStep *s) {
  LsysCut cut;
  LsysWord word = lsys_store_word(&s->words[0]);
  lsys_cut_begin(&cut, s->worker->run.grammar, &word);
  for (uint64_t i = 0, end; i < word.nsym; i = end) {
    for (end = i + 1; end < word.nsym && s->born.at[end] == s->born.at[i];) end++;
    LsysWord part = lsys_cut_take(&cut, end - i);
    s->worker->run.born = s->born.at[i];
    if (!s->sink->take(s->sink, &part)) return false;
  }
  return true;
}

static bool open(LsysBirthsStep *s, const LsysWord *axiom) {
  for (int i = 0; i < 3; i++) lsys_store_open(&s->words[i], s->worker->run.grammar, s->worker->memory);
  if (!lsys_walk_open(&s->walk, s->worker) || !lsys_writer_open(&s->writer, s->worker, s->sink)) return false;
  if (!s->words[0].sink.take(&s->words[0].sink, axiom) || !fit(s, &s->born, axiom->nsym)) return false;
  memset(s->born.at, 0, axiom->nsym * sizeof *s->born.at);
  return true;
}

bool lsys_births_step(LsysBirthsStep **place, LsysWorker *worker, const LsysWord *axiom, LsysSink *sink) {
  LsysRun *run = &worker->run;
  LsysBirthsStep *s = *place = lsys_memory_alloc(worker->memory, 1, sizeof *s);
  if (!s) return false;
  s->worker = worker;
  s->sink = sink;
  if (!open(s, axiom)) return false;
  for (uint64_t step = 0; step < run->steps && !run->stopped; step++) {
    run_block(run, LSYS_BLOCK_START_EACH);
    if (!advance(s, step)) return false;
    run_block(run, LSYS_BLOCK_END_EACH);
  }
  run_block(run, LSYS_BLOCK_END);
  return show(s);
}

void lsys_births_step_close(LsysBirthsStep *s) {
  if (!s) return;
  for (int i = 0; i < 3; i++)
    if (s->words[i].memory) lsys_store_close(&s->words[i]);
  if (s->writer.stream.run) lsys_writer_close(&s->writer);
  lsys_walk_close(&s->walk);
  free_row(s, &s->born);
  free_row(s, &s->next_born);
  free_row(s, &s->rewritten);
  free_row(s, &s->length);
  lsys_memory_free(s->worker->memory, s, 1, sizeof *s);
}
