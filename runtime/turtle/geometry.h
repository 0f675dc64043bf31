// geometry.h -- what the turtle draws, one primitive at a time: the interface
// between the turtle and the picture and mesh formats.
//
// Coordinates are the turtle's (H starts at +y, x to the right, z towards the
// reader), widths in the turtle's units of `!`, colours are palette indices.
#ifndef LSYS_TURTLE_GEOMETRY_H
#define LSYS_TURTLE_GEOMETRY_H

#include "lsys/abi.h"

#include <stdbool.h>

typedef struct LsysVec3 {
  double x, y, z;
} LsysVec3;

typedef struct LsysPen {
  double width;
  int32_t colour;
} LsysPen;

typedef struct LsysGeometry LsysGeometry;

// Every function may be NULL: the format does not show that primitive.
// Each returns false to stop after printing an error.
struct LsysGeometry {
  bool (*segment)(LsysGeometry *to, const LsysVec3 *from, const LsysVec3 *to_point, const LsysPen *pen);
  bool (*polygon)(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen);
};

#endif
