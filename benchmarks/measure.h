// measure.h -- timing of alternatives that take turns, so that a noisy machine
// disturbs all of them alike.
#ifndef LSYSC_BENCHMARKS_MEASURE_H
#define LSYSC_BENCHMARKS_MEASURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MOST_SIDES = 8, MOST_RUNS = 31 };

// One of the things compared. run is timed; before is not (fresh pages, warm pages).
typedef struct Side {
  const char *name;
  void (*before)(void *data);
  void (*run)(void *data);
  void *data;
  double seconds[MOST_RUNS];
  double busy[MOST_RUNS];  // seconds of processors, over all threads
} Side;

// Runs every side once per round, in turn. runs <= MOST_RUNS.
void measure(Side *sides, size_t count, unsigned runs);

double median(const double *values, unsigned count);

// The median over the rounds of (a's time / b's time): how many times slower a is than b.
double ratio(const Side *a, const Side *b, unsigned runs);

double now(void);         // seconds, monotonic
uint64_t resident(void);  // bytes now in memory
uint64_t peak_resident(void);

// Memory of whole huge pages where the system gives them, untouched: the first write to a page counts as cost.
void *fresh_pages(size_t bytes);
void release_pages(void *at, size_t bytes);
void forget_pages(void *at, size_t bytes);  // the next write is a first touch again

#endif
