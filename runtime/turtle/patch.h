// patch.h -- bicubic patches: 4 by 4 control points to a grid of triangles.
#ifndef LSYS_TURTLE_PATCH_H
#define LSYS_TURTLE_PATCH_H

#include "turtle/geometry.h"

enum { PATCH_CONTROLS = 16, PATCH_MOST_PIECES = 64 };

typedef enum PatchBasis { PATCH_BEZIER, PATCH_BSPLINE } PatchBasis;

// Cuts the patch into s by t pieces. vertex and normal have room for (s+1)(t+1), corner for 6 s t; first is added to
// every vertex number. Normals are unit; where the patch has none, `up`.
void patch_grid(const LsysVec3 *control, PatchBasis basis, uint32_t s, uint32_t t, LsysVec3 up, uint32_t first,
                LsysVec3 *vertex, LsysVec3 *normal, uint32_t *corner);

#endif
