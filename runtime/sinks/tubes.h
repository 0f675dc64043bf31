// tubes.h -- what the turtle draws as vertices, triangles and edges.
#ifndef LSYS_SINKS_TUBES_H
#define LSYS_SINKS_TUBES_H

#include "sinks/model.h"

typedef struct LsysTubes {
  LsysGeometry geometry;  // what the turtle draws to
  LsysModel *model;
  double width;               // length of a width of 1
  uint32_t sides;             // of a tube; 1: segments are edges
  LsysVec3 shift;             // added to every place
  struct LsysMemory *memory;  // that it books on; NULL: none
  uint64_t vertices;
  uint8_t colour;  // of the last vertex
  struct LsysTubeBatch *batch;
} LsysTubes;

// False after printing that memory ran out.
bool lsys_tubes_create(LsysTubes *tubes, LsysModel *model);
// Hands on what is left. False to stop.
bool lsys_tubes_flush(LsysTubes *tubes);
void lsys_tubes_destroy(LsysTubes *tubes);

#endif
