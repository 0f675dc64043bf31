// surface.h -- reading the surfaces that `~NAME` draws, when a grammar is compiled.
#ifndef LSYS_SURFACE_H
#define LSYS_SURFACE_H

#include "lsys/abi.h"

#include <stdbool.h>

// Reads the mesh of an OBJ file (v, vn, f; other lines are skipped) or of one of cpfg's (.s: Bezier patches, moved so
// that the contact point is the origin, H the y axis, U the z axis, and the size 1). Fills all but the name; free it
// with lsys_surface_free. On failure returns false with a phrase such as "line 3: a face needs three vertices" in why.
bool lsys_surface_read(const char *path, LsysSurface *surface, char *why, size_t size);
void lsys_surface_free(LsysSurface *surface);

#endif
