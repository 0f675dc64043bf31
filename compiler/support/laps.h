// laps.h -- how long each pass took, for --times.
#ifndef LSYSC_SUPPORT_LAPS_H
#define LSYSC_SUPPORT_LAPS_H

#include <stddef.h>
#include <stdio.h>

enum { MOST_LAPS = 12 };

typedef struct Laps {
  double last;  // when the last lap ended, in seconds of the monotonic clock
  size_t count;
  struct {
    const char *name;
    double seconds;
  } lap[MOST_LAPS];
} Laps;

void laps_begin(Laps *laps);

// What was done since the last lap is called name; NULL: nobody asks.
void laps_end(Laps *laps, const char *name);

// A line for each lap, `name` and milliseconds, and one for their sum.
void laps_print(const Laps *laps, FILE *out);

#endif
