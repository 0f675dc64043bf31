// glb.h -- the frame of a GLB file.
#ifndef LSYS_SINKS_GLB_H
#define LSYS_SINKS_GLB_H

#include "core/out.h"

// Writes the file's head and that of its JSON chunk, whose size must be a multiple of 4; binary 0: no second chunk.
// False after printing that the file would be too big.
bool lsys_glb_head(LsysOut *out, uint64_t json, uint64_t binary);

// Writes the head of the binary chunk.
bool lsys_glb_binary(LsysOut *out, uint64_t binary);

// From a palette's colour to glTF's linear light, 0..1.
void lsys_glb_linear(uint32_t rgb, double *linear);

#endif
