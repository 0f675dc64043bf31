// geometry.h -- what the turtle draws: the interface between the turtle and
// the picture and mesh formats.
//
// Coordinates are the turtle's (H starts at +y, x to the right, z towards the
// reader), widths in the turtle's units of `!`, colours are palette indices 0..255.
// Primitives come in the order in which the turtle drew them.
#ifndef LSYS_TURTLE_GEOMETRY_H
#define LSYS_TURTLE_GEOMETRY_H

#include "lsys/abi.h"

#include <stdbool.h>

typedef struct LsysVec3 {
  double x, y, z;
} LsysVec3;

typedef struct LsysPen {
  double width;  // finite, >= 0; 0 is the thinnest line that a format can show
  uint8_t colour;
  uint32_t mark;  // open brackets or the step of birth, where the turtle was asked for them; else 0
} LsysPen;

// Connected segments drawn with one pen: points first .. first+count-1 of the
// batch, count >= 2. joined: it begins where the stroke before it ended, without
// a jump in between (the pen changed, or a batch was full).
typedef struct LsysStroke {
  uint32_t first, count;
  LsysPen pen;
  bool joined;
} LsysStroke;

// Segments come in batches, so that a call costs nothing per segment. Strokes
// cover the batch's points one behind the other, without gaps.
typedef struct LsysStrokes {
  const LsysVec3 *point;
  const LsysStroke *stroke;
  size_t count, points;  // of strokes, of points
} LsysStrokes;

// A surface of triangles. corner holds three vertex numbers a triangle, counter-clockwise as
// seen from where the normals point.
typedef struct LsysMesh {
  const LsysVec3 *vertex;
  const LsysVec3 *normal;  // unit, one a vertex; NULL: the triangles are flat
  const uint32_t *corner;
  uint32_t vertices, triangles;
  uint32_t surface;  // 1 + its place among the grammar's surfaces: drawn again and again; 0: drawn once
} LsysMesh;

// Where a mesh is put: its point (x,y,z) is at origin + x right + y ahead + z up.
typedef struct LsysPlace {
  LsysVec3 origin, right, ahead, up;  // the last three orthogonal
} LsysPlace;

typedef struct LsysGeometry LsysGeometry;

// Every function may be NULL: the format does not show that primitive.
// Each returns false to stop after printing an error.
struct LsysGeometry {
  bool (*strokes)(LsysGeometry *to, const LsysStrokes *batch);
  bool (*polygon)(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen);
  bool (*mesh)(LsysGeometry *to, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen);
  // A sphere, or a disc that faces the viewer; the diameter is a length, not a width.
  bool (*ball)(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen);
  bool (*label)(LsysGeometry *to, const LsysVec3 *at, const char *text, const LsysPen *pen);
};

#endif
