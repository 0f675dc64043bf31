// sweep.c -- the same grammars at growing steps, streamed into a sum of all
// their bytes: the cost per module must stay flat and the memory bounded, far
// beyond what would fit into memory. Each size runs in a process of its own,
// whose peak is then its own.
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

// Words of 10^4 modules and more, each about ten times as long as the one before, up to 10^11 and 10^10.
static const Row rows[] = {
  {"koch", 4, 12, 1, 0}, {"row-of-trees", 10, 31, 3, 0}, {"shrub", 6, 18, 2, 1}, {"random-tree", 10, 31, 3, 1}};

static void run_size(const Options *options, const Row *row, const LsysGrammar *grammar, uint64_t steps) {
  uint64_t before = resident();
  double begin = now();
  Streamed word = word_stream(grammar, steps, row->seed);
  double seconds = now() - begin, grown = (double)(peak_resident() - before);
  double modules = (double)word.nsym, bytes = modules + 8 * (double)word.narg;
  const char *layout = "%-14s %5" PRIu64 " %13.0f %13.0f %10.4f %10.3f %9.1f\n";
  if (options->json)
    layout = "{\"row\":\"%s\",\"steps\":%" PRIu64 ",\"modules\":%.0f,\"bytes\":%.0f,\"seconds\":%.6g,"
             "\"ns_per_module\":%.4g,\"resident_megabytes\":%.3g}\n";
  else if (options->markdown)
    layout = "| %s | %" PRIu64 " | %.0f | %.0f | %.4f | %.3f | %.1f |\n";
  printf(layout, row->grammar, steps, modules, bytes, seconds, seconds / modules * 1e9, grown / 1e6);
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
  if (options->markdown)
    printf("| row | steps | modules | bytes | seconds | ns a module | MB grown |\n"
           "| --- | --- | --- | --- | --- | --- | --- |\n");
  else if (!options->json)
    printf("%-14s %5s %13s %13s %10s %10s %9s\n", "row", "steps", "modules", "bytes", "seconds", "ns/module",
           "MB grown");
  fflush(stdout);  // before processes of rows have it, too
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].grammar)) run_row(options, &rows[i]);
}
