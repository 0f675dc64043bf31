// triangulate.h -- polygons in space to triangles.
#ifndef LSYS_TURTLE_TRIANGULATE_H
#define LSYS_TURTLE_TRIANGULATE_H

#include "turtle/geometry.h"

// The normal of a polygon whose vertices are nearly in a plane, of length twice its area (Newell).
LsysVec3 polygon_normal(const LsysVec3 *vertex, size_t count);

// Cuts polygons into triangles, one after another; all zeros but for the account is an empty one.
typedef struct PolygonCutter {
  struct LsysMemory *memory;  // that it books on; NULL: none
  uint32_t *triangle;         // what the last polygon was cut into: three vertex numbers each

  // Of triangulate.c:
  struct CutVertex *vertex;
  uint32_t *queue;
  struct CutKey *key;
  struct CutNode *node;
  size_t triangle_room, vertex_room, queue_room, key_room, node_room;
  uint32_t keys, leaves;
} PolygonCutter;

// Cuts a polygon, which may be concave, into count-2 triangles with its orientation; of one that crosses itself they
// are some count-2 triangles, always the same. Takes some n log n for n vertices, but for polygons that can only be cut
// into needles as long as themselves. False after printing that memory ran out.
bool polygon_triangles(PolygonCutter *cutter, const LsysVec3 *vertex, uint32_t count);

void polygon_cutter_free(PolygonCutter *cutter);

#endif
