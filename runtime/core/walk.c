// walk.c -- scans over a word in memory; see lsys/scan.h for what they show.
#include "core/walk.h"

bool lsys_walk_open(LsysWalk *walk, LsysWorker *worker) {
  const LsysGrammar *grammar = worker->run.grammar;
  *walk = (LsysWalk){.worker = worker};
  walk->scans = lsys_memory_alloc(worker->memory, grammar->view_count, sizeof *walk->scans);
  size_t neighbours = (size_t)grammar->view_count * grammar->left_window;
  if (walk->scans) walk->left = lsys_memory_alloc(worker->memory, neighbours, sizeof *walk->left);
  return walk->left && scan_tables(&walk->tables, grammar, worker->memory);
}

void lsys_walk_close(LsysWalk *walk) {
  if (!walk->worker) return;
  const LsysGrammar *grammar = walk->worker->run.grammar;
  LsysMemory *memory = walk->worker->memory;
  LsysRun *run = &walk->worker->run;
  for (uint32_t i = 0; walk->scans && i < grammar->view_count; i++) scan_free(&walk->scans[i], run);
  lsys_memory_free(memory, walk->scans, grammar->view_count, sizeof *walk->scans);
  lsys_memory_free(memory, walk->left, (size_t)grammar->view_count * grammar->left_window, sizeof *walk->left);
  scan_index_free(&walk->index, run);
  scan_tables_free(&walk->tables);
  *walk = (LsysWalk){0};
}

LsysScan *lsys_walk_start(LsysWalk *walk, const LsysWord *word) {
  LsysRun *run = &walk->worker->run;
  const LsysGrammar *grammar = run->grammar;
  const uint8_t *end = word->sym + word->nsym * lsys_symbol_width(grammar);
  walk->segment = (LsysSegment){.sym = word->sym, .end = end, .arg = word->arg, .key = word->key};
  scan_index(&walk->index, &walk->tables, run, &walk->segment);
  for (uint32_t i = grammar->view_count; i-- > 0;) {
    LsysScan *scan = &walk->scans[i];
    scan_start(scan, &walk->tables, &grammar->views[i], run, &walk->segment, 1,
               walk->left + (size_t)i * grammar->left_window);
    scan->other = i + 1 < grammar->view_count ? &walk->scans[i + 1] : NULL;
  }
  return walk->scans;
}
