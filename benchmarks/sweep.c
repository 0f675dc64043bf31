// sweep.c -- the same grammars at growing steps, streamed into a sum: the cost
// per module must stay flat and the memory bounded, beyond what would fit into
// memory. Each size runs in a process of its own, whose peak is then its own.
#include "bench.h"
#include "compile.h"
#include "derive.h"
#include "measure.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Row {
  const char *grammar;
  uint64_t first, last, stride, seed;
} Row;

static const Row rows[] = {
  {"koch", 4, 11, 1, 0}, {"row-of-trees", 12, 30, 6, 0}, {"shrub", 8, 16, 2, 1}, {"random-tree", 12, 28, 4, 1}};

static void run_size(const Options *options, const Row *row, const LsysGrammar *grammar, uint64_t steps) {
  uint64_t before = resident();
  size_t nsym, narg;
  double begin = now();
  word_size(grammar, steps, row->seed, &nsym, &narg);
  double seconds = now() - begin, grown = (double)(peak_resident() - before);
  double modules = (double)nsym;
  if (options->json)
    printf("{\"row\":\"%s\",\"steps\":%" PRIu64 ",\"modules\":%.0f,\"seconds\":%.6g,\"resident_bytes\":%.0f}\n",
           row->grammar, steps, modules, seconds, grown);
  else
    printf("%-14s %5" PRIu64 " %14.0f %9.4f %10.3f %10.1f\n", row->grammar, steps, modules, seconds,
           seconds / modules * 1e9, grown / 1e6);
  fflush(stdout);
}

static void run_row(const Options *options, const Row *row) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, row->grammar);
  Compiled *compiled = compile_grammar(path, options->home);
  for (uint64_t steps = row->first; steps <= row->last; steps += row->stride) {
    pid_t child = fork();
    if (child == 0) {
      run_size(options, row, compiled_grammar(compiled), steps);
      _exit(0);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status) exit(1);
  }
  compile_release(compiled);
}

void bench_sweep(const Options *options) {
  if (!options->json)
    printf("%-14s %5s %14s %9s %10s %10s\n", "row", "steps", "modules", "seconds", "ns/module", "MB grown");
  fflush(stdout);  // before processes of rows have it, too
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].grammar)) run_row(options, &rows[i]);
}
