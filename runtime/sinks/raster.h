// raster.h -- a grid of pixels on which lines and polygons are drawn with
// anti-aliased edges.
//
// Each pixel holds a base and a top colour that covers a part of it. Drawing in
// the top colour raises that part to the larger of the two, so that the joints
// of a curve and lines drawn over each other do not darken their edges; another
// colour first merges top and base.
#ifndef LSYS_SINKS_RASTER_H
#define LSYS_SINKS_RASTER_H

#include "sinks/picture.h"

typedef struct Raster Raster;

// NULL after printing that the page is too big. 8 bytes a pixel.
Raster *raster_create(const LsysPage *page);
void raster_destroy(Raster *raster);

// Segments between count points, `width` thick, with round ends and joints.
void raster_line(Raster *raster, const LsysPoint *point, size_t count, double width, uint32_t rgb);

// A polygon, by non-zero winding. False if memory ran out.
bool raster_fill(Raster *raster, const LsysPoint *point, size_t count, uint32_t rgb);

// One row: width pixels of R, G, B, A.
void raster_row(const Raster *raster, uint32_t y, uint8_t *rgba);

#endif
