// main.c -- the benchmark's command line: which groups of rows, how often.
#include "bench.h"
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
  const char *name;
  void (*run)(const Options *options);
  const char *doc;
} groups[] = {
  {"words", bench_words, "words in memory beside C written for the grammar, and memcpy of the same bytes"},
  {"turtle", bench_turtle, "words to segments that nobody draws, in the plane and in space"},
  {"outputs", bench_outputs, "text, hash, SVG and PNG of big words"},
  {"sweep", bench_sweep, "cost per module and memory as a streamed word grows"},
  {"threads", bench_threads, "one thread and two, beside plain arithmetic and memcpy on as many"},
  {"start", bench_start, "start-up, compile times, time to the first module"},
  {"passes", bench_passes, "where the time of a compilation goes"},
  {"today", bench_today, "the npm package lindenmayer, run by node where both are installed"},
};
enum { GROUPS = sizeof groups / sizeof *groups };

bool bench_wants(const Options *options, const char *row) {
  return !options->only || strcmp(options->only, row) == 0;
}

static int usage(FILE *to, int status) {
  fputs("usage: bench [--json | --markdown] [--runs N] [--only ROW] [--static LSYSC] [GROUP...]\n", to);
  for (int i = 0; i < GROUPS; i++) fprintf(to, "  %-8s %s\n", groups[i].name, groups[i].doc);
  fputs("times C, x memcpy: how many times as long the other side takes (above 1: lsysc is faster)\n"
        "--static: `start` times this compiler, too, which was built with -DLSYSC_STATIC_LLVM=ON\n"
        "first: the first write to each page is part of the time; warm: it is not; sum: streamed, not stored\n",
        to);
  return status;
}

static int find_group(const char *name) {
  for (int i = 0; i < GROUPS; i++)
    if (strcmp(groups[i].name, name) == 0) return i;
  return -1;
}

int main(int argc, char **argv) {
  Options options = {.home = LSYSC_BENCH_HOME, .lsysc = LSYSC_BENCH_LSYSC, .grammars = LSYSC_BENCH_GRAMMARS, .runs = 7};
  bool wanted[GROUPS] = {false}, any = false;
  for (int i = 1; i < argc; i++) {
    bool more = i + 1 < argc;
    int group = find_group(argv[i]);
    if (group >= 0)
      wanted[group] = any = true;
    else if (strcmp(argv[i], "--json") == 0)
      options.json = true;
    else if (strcmp(argv[i], "--markdown") == 0)
      options.markdown = true;
    else if (strcmp(argv[i], "--runs") == 0 && more)
      options.runs = (unsigned)atoi(argv[++i]);
    else if (strcmp(argv[i], "--static") == 0 && more)
      options.with_llvm = argv[++i];
    else if (strcmp(argv[i], "--only") == 0 && more)
      options.only = argv[++i];
    else
      return strcmp(argv[i], "--help") == 0 ? usage(stdout, 0) : usage(stderr, 1);
  }
  if (options.runs < 1 || options.runs > MOST_RUNS) return usage(stderr, 1);
  for (int i = 0; i < GROUPS; i++)
    if (!any || wanted[i]) groups[i].run(&options);
  return 0;
}
