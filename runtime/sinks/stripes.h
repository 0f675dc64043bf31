// stripes.h -- lines drawn on a raster by all threads, each in a stripe of its rows. A pixel sees its lines in the
// order in which they were added, whatever the number of threads, so that the picture does not depend on it.
#ifndef LSYS_SINKS_STRIPES_H
#define LSYS_SINKS_STRIPES_H

#include "sinks/raster.h"

typedef struct LsysStripes LsysStripes;

// The raster has line_within, the page at least two threads. NULL after printing why not.
LsysStripes *lsys_stripes_open(const LsysPage *page, LsysRaster *raster);

// Segments between count points, drawn now or later. False after printing why not.
bool lsys_stripes_add(LsysStripes *stripes, const LsysPoint *point, size_t count, const LsysInk *ink);

// Draws what was added so far. False after printing why not.
bool lsys_stripes_draw(LsysStripes *stripes);

// What was not drawn is lost. NULL is fine.
void lsys_stripes_close(LsysStripes *stripes);

#endif
