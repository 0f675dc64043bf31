// spline.h -- the functions and curves of cpfg's files (.func, .fset, .con, .cset): B-splines that a grammar reads by
// samples.
#ifndef LSYSC_FRONTEND_SPLINE_H
#define LSYSC_FRONTEND_SPLINE_H

#include "support/arena.h"
#include "support/vec.h"

#include <stdbool.h>

typedef struct SplinePoint {
  double at[3];
} SplinePoint;

typedef struct Spline {
  const char *name;         // as the file gives it; "" if it does not
  VEC(SplinePoint) points;  // control points, one that counts several times as often
  bool closed;              // goes back to its first point
  bool clamped;             // begins and ends in its first and last point
  unsigned samples;         // pieces of the table that stands for it
} Spline;
typedef VEC(Spline) Splines;

enum { SPLINE_MOST_SAMPLES = 10000 };

// Reads all functions (curves: curves) of a file. On failure returns false with a phrase such as "line 3: this is no
// point" in why.
bool splines_read(Arena *arena, const char *path, bool curves, Splines *splines, char *why, size_t size);

// A function's first and last x, and its y at samples + 1 places from one to the other.
void spline_function(const Spline *spline, double range[2], double *values);

// A curve's coordinates at samples + 1 places that are equally far from each other along it; returns its length.
double spline_curve(Arena *arena, const Spline *spline, double *const values[3]);

#endif
