// raster.h -- grids of pixels on which lines and polygons are drawn.
#ifndef LSYS_SINKS_RASTER_H
#define LSYS_SINKS_RASTER_H

#include "sinks/picture.h"

typedef struct LsysRaster LsysRaster;

struct LsysRaster {
  // Segments between count points with round ends and joints.
  void (*line)(LsysRaster *raster, const LsysPoint *point, size_t count, const LsysInk *ink);
  // The same as far as it lies in rows from .. end-1, which several threads may do in rows of their own; NULL: one
  // thread has to draw everything.
  void (*line_within)(LsysRaster *raster, const LsysPoint *point, size_t count, const LsysInk *ink, int from, int end);
  // A polygon, lit by the normals of its points or its own. False if memory ran out (printed).
  bool (*fill)(LsysRaster *raster, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb);
  // One finished row: width pixels of R, G, B, A.
  void (*row)(const LsysRaster *raster, uint32_t y, uint8_t *rgba);
  void (*destroy)(LsysRaster *raster);
  // As a canvas has it (picture.h); NULL: there is no telling.
  bool (*covered)(const LsysRaster *raster, const LsysPoint *middle, double radius, const LsysInk *ink);
};

// Books the bytes of a raster. False after printing that it is too big.
bool lsys_raster_book(const LsysPage *page, uint64_t bytes);

// In the order in which things are drawn, edges anti-aliased. 8 bytes a pixel. NULL after printing that it is too big.
LsysRaster *lsys_raster_flat(const LsysPage *page);

// By depth and with light: lines are cylinders. 72 bytes a pixel where anti-aliased, 8 where not; less for big pages.
LsysRaster *lsys_raster_solid(const LsysPage *page);

#endif
