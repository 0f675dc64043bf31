// measure.h -- geometry measured instead of drawn: sizes for `--stats`, for
// fitting pictures to their page, and for tests.
#ifndef LSYS_TURTLE_MEASURE_H
#define LSYS_TURTLE_MEASURE_H

#include "turtle/geometry.h"

typedef struct LsysMeasure {
  LsysGeometry geometry;  // what the turtle draws to
  bool wants_length;      // false: `length` stays 0 (it takes a square root a segment)
  uint64_t segments, polygons, meshes, balls;
  uint64_t of_colour[256];    // segments of each colour
  double length;              // of all segments
  LsysVec3 low, high;         // bounding box, without the widths of lines; low > high if nothing was drawn
  bool odd;                   // a coordinate was nan or infinite, or above 1e300: the box is not to be trusted
  double thinnest, thickest;  // widths of segments; infinite and 0 if there are none
} LsysMeasure;

void lsys_measure_begin(LsysMeasure *m, bool wants_length);

// Adds what was measured behind.
void lsys_measure_join(LsysMeasure *m, const LsysMeasure *part);

// The vertices of a placed mesh, one after another.
static inline LsysVec3 lsys_mesh_vertex(const LsysMesh *mesh, const LsysPlace *p, uint32_t i) {
  LsysVec3 v = mesh->vertex[i];
  return (LsysVec3){p->origin.x + v.x * p->right.x + v.y * p->ahead.x + v.z * p->up.x,
                    p->origin.y + v.x * p->right.y + v.y * p->ahead.y + v.z * p->up.y,
                    p->origin.z + v.x * p->right.z + v.y * p->ahead.z + v.z * p->up.z};
}

// True if something was drawn. Coordinates may still be infinite or nan: see lsys_measure_finite.
bool lsys_measure_any(const LsysMeasure *m);
bool lsys_measure_finite(const LsysMeasure *m);

#endif
