// today.c -- what a person has who derives by a library of JavaScript: the npm
// package lindenmayer, run by node. Neither is needed for anything else; it is
// found where NODE_PATH says (npm install lindenmayer). Both sides give the same
// number of modules; the seconds are the best of some runs within one process.
#include "bench.h"
#include "compile.h"
#include "derive.h"
#include "measure.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Row {
  const char *name;
  uint64_t steps;
} Row;

static const Row rows[] = {{"koch", 6}, {"plant", 12}};

typedef struct Result {
  double modules, seconds;
} Result;

// False where node or the package is not there.
static bool run_theirs(const Options *options, const Row *row, Result *result) {
  char command[8192];
  snprintf(command, sizeof command, "node '%s/../lindenmayer.js' %s %" PRIu64 " %u 2>/dev/null", options->grammars,
           row->name, row->steps, options->runs);
  FILE *in = popen(command, "r");
  if (!in) return false;
  bool read = fscanf(in, "%lf %lf", &result->modules, &result->seconds) == 2;
  return pclose(in) == 0 && read;
}

static Result run_ours(const Options *options, const Row *row) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, row->name);
  Compiled *compiled = compile_grammar(path, options->home);
  size_t nsym, narg;
  word_size(compiled_grammar(compiled), row->steps, 0, &nsym, &narg);
  LsysWhole out = {.sym = fresh_pages(nsym), .sym_bytes = nsym, .given = true};
  Result best = {.modules = (double)nsym, .seconds = 1e9};
  for (unsigned r = 0; r < options->runs; r++) {
    forget_pages(out.sym, nsym);
    double begin = now();
    word_store(compiled_grammar(compiled), row->steps, 0, &out);
    double seconds = now() - begin;
    if (seconds < best.seconds) best.seconds = seconds;
  }
  release_pages(out.sym, nsym);
  compile_release(compiled);
  return best;
}

static void print_row(const Options *options, const Row *row, const Result *ours, const Result *theirs) {
  const char *layout = "%-14s %12.0f %12.1f %12.1f %9.0f\n";
  if (options->json)
    layout = "{\"row\":\"%s\",\"modules\":%.0f,\"million_modules_per_second\":%.4g,"
             "\"theirs\":%.4g,\"times_theirs\":%.4g}\n";
  else if (options->markdown)
    layout = "| %s | %.0f | %.0f | %.1f | %.0f |\n";
  printf(layout, row->name, ours->modules, ours->modules / ours->seconds / 1e6, theirs->modules / theirs->seconds / 1e6,
         theirs->seconds / ours->seconds);
  fflush(stdout);
}

static bool run_row(const Options *options, const Row *row) {
  Result theirs;
  if (!run_theirs(options, row, &theirs)) {
    fputs("not installed: node with `npm install lindenmayer`, whose node_modules NODE_PATH names\n",
          options->json ? stderr : stdout);
    return false;
  }
  Result ours = run_ours(options, row);
  if (ours.modules != theirs.modules) {
    fprintf(stderr, "bench: %s: lsysc and lindenmayer give words of %.0f and %.0f modules\n", row->name, ours.modules,
            theirs.modules);
    exit(1);
  }
  print_row(options, row, &ours, &theirs);
  return true;
}

void bench_today(const Options *options) {
  if (options->markdown)
    printf("| row | modules | M modules/s | lindenmayer | times |\n| --- | --- | --- | --- | --- |\n");
  else if (!options->json)
    printf("%-14s %12s %12s %12s %9s\n", "row", "modules", "M mod/s", "lindenmayer", "times");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].name) && !run_row(options, &rows[i])) return;
}
