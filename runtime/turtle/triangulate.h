// triangulate.h -- polygons in space to triangles.
#ifndef LSYS_TURTLE_TRIANGULATE_H
#define LSYS_TURTLE_TRIANGULATE_H

#include "turtle/geometry.h"

// The normal of a polygon whose vertices are nearly in a plane, of length twice its area (Newell).
LsysVec3 polygon_normal(const LsysVec3 *vertex, size_t count);

// Cuts a polygon, which may be concave, into count-2 triangles with its orientation: three vertex numbers each, to
// triangle[3 * (count - 2)]. One that crosses itself is cut somehow. work has room for count numbers.
void polygon_triangles(const LsysVec3 *vertex, uint32_t count, uint32_t *triangle, uint32_t *work);

#endif
