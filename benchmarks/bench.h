// bench.h -- the groups of rows, one file each; every group prints its own table.
#ifndef LSYSC_BENCHMARKS_BENCH_H
#define LSYSC_BENCHMARKS_BENCH_H

#include <stdbool.h>

typedef struct Options {
  const char *home;       // the folder that holds lsysc-llvm.so
  const char *lsysc;      // the compiler, for start-up times
  const char *with_llvm;  // a compiler that holds LLVM (LSYSC_STATIC_LLVM), to be timed beside; NULL: none
  const char *grammars;   // the folder of the rows' grammars
  const char *only;       // NULL: every row
  unsigned runs;
  bool json;
  bool markdown;  // words, sweep: rows of the tables in docs/PERFORMANCE.md
} Options;

void bench_words(const Options *options);    // words.c: words beside C and memcpy
void bench_turtle(const Options *options);   // turtle.c: words to segments, nothing drawn
void bench_outputs(const Options *options);  // outputs.c: text, hash, pictures
void bench_sweep(const Options *options);    // sweep.c: cost per module as words grow
void bench_threads(const Options *options);  // threads.c: one thread and two
void bench_start(const Options *options);    // start.c: from a grammar to its first module
void bench_passes(const Options *options);   // passes.c: where the time of a compilation goes
void bench_today(const Options *options);    // today.c: what people use, if it is installed

bool bench_wants(const Options *options, const char *row);

#endif
