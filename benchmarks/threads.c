// threads.c -- the same run on one thread and on two, beside plain arithmetic
// and memcpy on as many: what the machine itself gives for a second thread. Runs are whole
// programs: hashes and counts, which leave little to be done in order, and
// words as text and as bytes and pictures, written to nowhere.
#include "bench.h"
#include "compile.h"
#include "measure.h"
#include "program.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Row {
  const char *name, *grammar, *arguments;
} Row;

static const Row rows[] = {
  {"hash of shrub", "shrub", "-n 15 --seed 1 --hash"},
  {"count of shrub", "shrub", "-n 15 --seed 1 --count"},
  {"hash of koch", "koch", "-n 10 --hash"},
  {"hash of random tree", "random-tree", "-n 25 --seed 1 --hash"},
  {"count of guards", "guards", "-n 45 --count"},
  {"text of random tree", "random-tree", "-n 21 --seed 1 -o /dev/null --format text"},
  {"bytes of random tree", "random-tree", "-n 25 --seed 1 -o /dev/null --format binary"},
  {"hash of guards", "guards", "-n 45 --hash"},
  {"text of row of trees", "row-of-trees", "-n 22 -o /dev/null --format text"},
  {"hash of heterocysts", "heterocysts", "-n 900 --hash"},
  {"hash of hogeweg", "hogeweg", "-n 66 --hash"},
  {"hash of signal", "signal", "-n 17 --hash"},
  {"svg of plant", "plant", "-n 14 -o /dev/null --format svg"},
  {"json of plant", "plant", "-n 13 -o /dev/null --format json"},
  {"obj of plant", "plant", "-n 13 -o /dev/null --format obj"},
  {"png of plant", "plant", "-n 13 --size 4096x4096 -o /dev/null --format png"},
  {"pdf of plant", "plant", "-n 13 -o /dev/null --format pdf"},
};

static void *arithmetic(void *data) {
  volatile double *result = data;
  double x = 1;
  for (long i = 0; i < 100000000; i++) x = x * 0.999999 + 1;
  *result = x;
  return NULL;
}

static void *copying(void *data) {
  const size_t bytes = (size_t)1 << 26;
  char *from = malloc(bytes), *to = malloc(bytes);
  if (!from || !to) abort();
  memset(from, 1, bytes);
  for (int i = 0; i < 8; i++) memcpy(to, from + i, bytes - 8);
  *(volatile double *)data = to[bytes / 2];
  free(from);
  free(to);
  return NULL;
}

typedef struct Work {
  void *(*work)(void *result);
  unsigned threads;
} Work;

// A fixed amount of work for each of so many threads.
static void run_work(void *data) {
  const Work *work = data;
  pthread_t others[8];
  double results[8];
  for (unsigned i = 1; i < work->threads; i++) pthread_create(&others[i], NULL, work->work, &results[i]);
  work->work(&results[0]);
  for (unsigned i = 1; i < work->threads; i++) pthread_join(others[i], NULL);
}

// work: how many times as much two threads did.
static void print_row(const Options *options, const char *name, const Side *sides, double work) {
  double one = median(sides[0].seconds, options->runs), two = median(sides[1].seconds, options->runs);
  double speedup = ratio(&sides[0], &sides[1], options->runs) * work;
  double cost = median(sides[1].busy, options->runs) / median(sides[0].busy, options->runs) / work;
  printf(options->json ? "{\"row\":\"%s\",\"one\":%.6g,\"two\":%.6g,\"speedup\":%.3g,\"cost\":%.3g}\n"
                       : "%-22s %9.4f %9.4f %8.2f %8.2f\n",
         name, one, two, speedup, cost);
  fflush(stdout);
}

static void time_work(const Options *options, const char *name, void *(*work)(void *)) {
  Work one = {work, 1}, two = {work, 2};
  Side sides[2] = {{.name = "one", .run = run_work, .data = &one}, {.name = "two", .run = run_work, .data = &two}};
  measure(sides, 2, options->runs);
  print_row(options, name, sides, 2);
}

static void time_row(const Options *options, const Row *row) {
  char path[4096], arguments[2][256];
  snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, row->grammar);
  Compiled *compiled = compile_grammar(path, options->home);
  Program programs[2];
  Side sides[2];
  for (int i = 0; i < 2; i++) {
    snprintf(arguments[i], sizeof arguments[i], "%s --threads %d", row->arguments, i + 1);
    programs[i] = program_of(compiled_grammar(compiled));
    program_add_all(&programs[i], arguments[i]);
    sides[i] = (Side){.name = row->name, .run = program_run, .data = &programs[i]};
  }
  int screen = screen_hide();
  measure(sides, 2, options->runs);
  screen_show(screen);
  print_row(options, row->name, sides, 1);
  compile_release(compiled);
}

void bench_threads(const Options *options) {
  if (!options->json) printf("%-22s %9s %9s %8s %8s\n", "row", "1 thread", "2 threads", "speedup", "cost");
  if (bench_wants(options, "arithmetic")) time_work(options, "arithmetic", arithmetic);
  if (bench_wants(options, "memcpy")) time_work(options, "memcpy", copying);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].name)) time_row(options, &rows[i]);
}
