// laps.c -- see laps.h.
#include "support/laps.h"

#include <time.h>

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

void laps_begin(Laps *laps) {
  *laps = (Laps){.last = now()};
}

void laps_end(Laps *laps, const char *name) {
  if (!laps || laps->count == MOST_LAPS) return;
  double time = now();
  laps->lap[laps->count].name = name;
  laps->lap[laps->count++].seconds = time - laps->last;
  laps->last = time;
}

static void print(FILE *out, const char *name, double seconds) {
  fprintf(out, "%-12s %9.2f ms\n", name, 1e3 * seconds);
}

void laps_print(const Laps *laps, FILE *out) {
  double sum = 0;
  for (size_t i = 0; i < laps->count; i++) {
    print(out, laps->lap[i].name, laps->lap[i].seconds);
    sum += laps->lap[i].seconds;
  }
  print(out, "total", sum);
}
