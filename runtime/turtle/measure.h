// measure.h -- geometry measured instead of drawn: sizes for `--stats`, for
// fitting pictures to their page, and for tests.
#ifndef LSYS_TURTLE_MEASURE_H
#define LSYS_TURTLE_MEASURE_H

#include "turtle/geometry.h"

typedef struct LsysMeasure {
  LsysGeometry geometry;  // what the turtle draws to
  bool wants_length;      // false: `length` stays 0 (it takes a square root a segment)
  uint64_t segments, polygons;
  uint64_t of_colour[256];  // segments of each colour
  double length;            // of all segments
  LsysVec3 low, high;  // bounding box of segments and polygons, without their widths; low > high if nothing was drawn
  double thinnest, thickest;  // widths of segments; infinite and 0 if there are none
} LsysMeasure;

void lsys_measure_begin(LsysMeasure *m, bool wants_length);

// True if something was drawn. Coordinates may still be infinite or nan: see lsys_measure_finite.
bool lsys_measure_any(const LsysMeasure *m);
bool lsys_measure_finite(const LsysMeasure *m);

#endif
