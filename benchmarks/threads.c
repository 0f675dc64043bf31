// threads.c -- the same derivation on one thread and on two, beside plain
// arithmetic on as many: what the machine itself gives for a second thread.
#include "bench.h"
#include "compile.h"
#include "derive.h"
#include "measure.h"

#include <pthread.h>
#include <stdio.h>

typedef struct Row {
  const char *grammar;
  uint64_t steps, seed;
} Row;

static const Row rows[] = {{"row-of-trees", 26, 0}, {"guards", 44, 0},  {"shrub", 14, 1}, {"random-tree", 24, 1},
                           {"heterocysts", 900, 0}, {"hogeweg", 60, 0}, {"signal", 14, 0}};

typedef struct Job {
  const Row *row;  // NULL: arithmetic
  const LsysGrammar *grammar;
  unsigned threads;
} Job;

static void *arithmetic(void *data) {
  volatile double *result = data;
  double x = 1;
  for (long i = 0; i < 100000000; i++) x = x * 0.999999 + 1;
  *result = x;
  return NULL;
}

// A fixed amount of work for each thread.
static void run_arithmetic(unsigned threads) {
  pthread_t others[8];
  double results[8];
  for (unsigned i = 1; i < threads; i++) pthread_create(&others[i], NULL, arithmetic, &results[i]);
  arithmetic(&results[0]);
  for (unsigned i = 1; i < threads; i++) pthread_join(others[i], NULL);
}

static void run_job(void *data) {
  const Job *job = data;
  if (job->row)
    word_pass(job->grammar, job->row->steps, job->row->seed, job->threads);
  else
    run_arithmetic(job->threads);
}

static void print_row(const Options *options, const char *name, const Side *sides, double scaling) {
  double one = median(sides[0].seconds, options->runs), two = median(sides[1].seconds, options->runs);
  printf(options->json ? "{\"row\":\"%s\",\"one\":%.6g,\"two\":%.6g,\"speedup\":%.3g}\n" : "%-14s %9.4f %9.4f %8.2f\n",
         name, one, two, scaling);
  fflush(stdout);
}

static void run_row(const Options *options, const Row *row, const LsysGrammar *grammar, const char *name) {
  Job jobs[2] = {{row, grammar, 1}, {row, grammar, 2}};
  Side sides[2] = {{.name = "one", .run = run_job, .data = &jobs[0]},
                   {.name = "two", .run = run_job, .data = &jobs[1]}};
  measure(sides, 2, options->runs);
  // Arithmetic does twice the work on two threads, a derivation the same.
  print_row(options, name, sides, ratio(&sides[0], &sides[1], options->runs) * (row ? 1 : 2));
}

void bench_threads(const Options *options) {
  if (!options->json) printf("%-14s %9s %9s %8s\n", "row", "1 thread", "2 threads", "speedup");
  if (bench_wants(options, "arithmetic")) run_row(options, NULL, NULL, "arithmetic");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    if (!bench_wants(options, rows[i].grammar)) continue;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, rows[i].grammar);
    Compiled *compiled = compile_grammar(path, options->home);
    run_row(options, &rows[i], compiled_grammar(compiled), rows[i].grammar);
    compile_release(compiled);
  }
}
