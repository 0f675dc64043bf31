// progress.c -- counts modules and looks at the clock now and then.
#include "sinks/progress.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

enum { PARTS = 16 };  // between two looks at the clock

typedef struct ProgressSink {
  LsysSink sink;
  LsysMemory *memory;
  uint32_t axiom;
  double modules;   // of this word so far
  double expected;  // nan: nobody knows
  unsigned parts;
  struct timespec started, shown;
} ProgressSink;

static double seconds(const struct timespec *from, const struct timespec *to) {
  return (double)(to->tv_sec - from->tv_sec) + (double)(to->tv_nsec - from->tv_nsec) * 1e-9;
}

// The length of the word by the growth matrix, to a double's precision.
static double expected_modules(const LsysRun *run, uint32_t axiom, LsysMemory *memory) {
  enum { MOST_STEPS = 100000 };
  const LsysGrammar *grammar = run->grammar;
  const LsysGrowth *growth = &grammar->growth;
  uint32_t kinds = grammar->kind_count;
  if (!growth->row || run->steps > MOST_STEPS) return NAN;
  double *size = lsys_memory_alloc(memory, (size_t)kinds * 2, sizeof *size), sum = 0;
  if (!size) return NAN;
  for (uint32_t k = 0; k < kinds; k++) size[k] = 1;
  for (uint64_t step = 0; step < run->steps; step++) {
    double *next = size + (step % 2 ? 0 : kinds), *now = size + (step % 2 ? kinds : 0);
    for (uint32_t k = 0; k < kinds; k++) {
      next[k] = 0;
      for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++) next[k] += growth->count[e] * now[growth->kind[e]];
    }
  }
  const LsysWord *word = &grammar->axioms[axiom].word;
  const double *last = size + (run->steps % 2 ? kinds : 0);
  unsigned width = grammar->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
  for (uint64_t i = 0; i < word->nsym; i++) {
    const uint8_t *sym = word->sym + i * width;
    sum += last[width == 1 ? sym[0] : sym[0] | sym[1] << 8];
  }
  lsys_memory_free(memory, size, (size_t)kinds * 2, sizeof *size);
  return sum;
}

static void show(ProgressSink *progress, const struct timespec *now) {
  double elapsed = seconds(&progress->started, now);
  progress->shown = *now;
  fprintf(stderr, "\r%.3g modules", progress->modules);
  if (isfinite(progress->expected) && progress->expected > 0) {
    double done = progress->modules / progress->expected;
    fprintf(stderr, " of %.3g (%.1f %%), %.0f s left", progress->expected, 100 * done, elapsed / done - elapsed);
  }
  fprintf(stderr, ", %.3g/s\033[K", progress->modules / elapsed);
  fflush(stderr);
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  ProgressSink *progress = (ProgressSink *)sink;
  progress->modules = 0;
  progress->expected = expected_modules(run, axiom, progress->memory);
  clock_gettime(CLOCK_MONOTONIC, &progress->started);
  progress->shown = progress->started;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  ProgressSink *progress = (ProgressSink *)sink;
  progress->modules += (double)part->nsym;
  if (++progress->parts % PARTS) return true;
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (seconds(&progress->shown, &now) > 0.2) show(progress, &now);
  return true;
}

static bool end(LsysSink *sink) {
  (void)sink;
  fputs("\r\033[K", stderr);
  return true;
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  ProgressSink *progress = (ProgressSink *)sink;
  lsys_memory_free(progress->memory, progress, 1, sizeof *progress);
}

LsysSink *lsys_sink_progress(const LsysSinkContext *context) {
  ProgressSink *progress = lsys_memory_alloc(context->memory, 1, sizeof *progress);
  if (!progress) return NULL;
  progress->sink =
    (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  progress->memory = context->memory;
  return &progress->sink;
}
