// measure.c -- see measure.h. Times are of the monotonic clock; pages come
// from mmap with the same advice for every side.
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double busy(void) {
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
       + 1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

void measure(Side *sides, size_t count, unsigned runs) {
  for (unsigned r = 0; r < runs; r++)
    for (size_t i = 0; i < count; i++) {
      Side *side = &sides[(i + r) % count];
      if (side->before) side->before(side->data);
      double begin = now(), idle = busy();
      side->run(side->data);
      side->seconds[r] = now() - begin;
      side->busy[r] = busy() - idle;
    }
}

static int by_size(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double median(const double *values, unsigned count) {
  double sorted[MOST_RUNS];
  memcpy(sorted, values, count * sizeof *values);
  qsort(sorted, count, sizeof *sorted, by_size);
  return count % 2 ? sorted[count / 2] : (sorted[count / 2 - 1] + sorted[count / 2]) / 2;
}

double ratio(const Side *a, const Side *b, unsigned runs) {
  double quotients[MOST_RUNS];
  for (unsigned r = 0; r < runs; r++) quotients[r] = a->seconds[r] / b->seconds[r];
  return median(quotients, runs);
}

uint64_t resident(void) {
  unsigned long pages = 0, held = 0;
  FILE *in = fopen("/proc/self/statm", "r");
  if (!in) return 0;
  if (fscanf(in, "%lu %lu", &pages, &held) != 2) held = 0;
  fclose(in);
  return (uint64_t)held * (uint64_t)sysconf(_SC_PAGESIZE);
}

uint64_t peak_resident(void) {
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return (uint64_t)usage.ru_maxrss * 1024;
}

void *fresh_pages(size_t bytes) {
  void *at = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (at == MAP_FAILED) {
    fprintf(stderr, "bench: cannot map %zu bytes\n", bytes);
    exit(1);
  }
  madvise(at, bytes, MADV_HUGEPAGE);
  return at;
}

void release_pages(void *at, size_t bytes) {
  munmap(at, bytes);
}

void forget_pages(void *at, size_t bytes) {
  madvise(at, bytes, MADV_DONTNEED);
}
