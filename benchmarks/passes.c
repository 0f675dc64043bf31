// passes.c -- where the time of a compilation goes: what `lsysc --times` says of the grammar of twenty productions, as
// a program and in memory.
#include "bench.h"
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_PASSES = 12, MOST_NAME = 16 };

typedef struct Way {
  const char *name;
  const char *before, *behind;  // the grammar, on lsysc's command line
} Way;

static const Way ways[] = {
  {"-O0", "", "-O0 -o"},
  {"-O2", "", "-O2 -o"},
  {"run", "run", "-n 1 --format text -o"},
};
enum { WAYS = sizeof ways / sizeof *ways };

typedef struct Pass {
  char name[MOST_NAME];
  double ms[MOST_RUNS];
} Pass;

// A line of --times: the pass's name, which may hold spaces, and milliseconds.
static bool read_pass(const char *line, char *name, double *ms) {
  if (sscanf(line, "%15[^0-9]%lf ms", name, ms) != 2) return false;
  for (size_t end = strlen(name); end > 0 && name[end - 1] == ' '; end--) name[end - 1] = 0;
  return true;
}

// Runs lsysc once, which is run number r of all passes. Returns how many there are.
static size_t time_passes(const Options *options, const Way *way, const char *program, unsigned r, Pass *passes) {
  char command[3 * 4096], line[80];
  snprintf(command, sizeof command, "'%s' %s '%s/twenty.lsys' --times %s '%s' 2>&1", options->lsysc, way->before,
           options->grammars, way->behind, program);
  FILE *in = popen(command, "r");
  size_t count = 0;
  while (in && count < MOST_PASSES && fgets(line, sizeof line, in))
    count += read_pass(line, passes[count].name, &passes[count].ms[r]);
  if (in && pclose(in) == 0) return count;
  fprintf(stderr, "bench: failed: %s\n", command);
  exit(1);
}

static void print_passes(const Options *options, const Way *way, const Pass *passes, size_t count) {
  const char *layout = "%-8s %-14s %10.2f\n";
  if (options->json)
    layout = "{\"row\":\"%s\",\"pass\":\"%s\",\"milliseconds\":%.4g}\n";
  else if (options->markdown)
    layout = "| %s | %s | %.2f |\n";
  for (size_t i = 0; i < count; i++) printf(layout, way->name, passes[i].name, median(passes[i].ms, options->runs));
  fflush(stdout);
}

void bench_passes(const Options *options) {
  char program[64];
  snprintf(program, sizeof program, "/tmp/lsysc-bench-%d", (int)getpid());
  if (!options->json && !options->markdown) printf("%-8s %-14s %10s\n", "20 rules", "pass", "ms");
  for (int i = 0; i < WAYS; i++) {
    if (!bench_wants(options, ways[i].name)) continue;
    Pass passes[MOST_PASSES];
    size_t count = 0;
    for (unsigned r = 0; r < options->runs; r++) count = time_passes(options, &ways[i], program, r, passes);
    print_passes(options, &ways[i], passes, count);
  }
  unlink(program);
}
