// gauge.h -- measures what the turtle draws, on all threads: a turtle walks on one, which is not to wait for boxes and
// lengths.
#ifndef LSYS_SINKS_GAUGE_H
#define LSYS_SINKS_GAUGE_H

#include "sinks/press.h"
#include "turtle/measure.h"

// All zeros: nothing is measured yet.
typedef struct LsysGauge {
  LsysGeometry geometry;
  LsysMeasure measure;  // the result, behind lsys_gauge_end
  LsysPress *press;     // of batches of strokes; NULL: on one thread
  unsigned batches;     // in its block
} LsysGauge;

// Begins to measure anew, with lengths; returns what the turtle draws to, or NULL after printing why not. threads:
// that may work, this one included. The result does not depend on them.
LsysGeometry *lsys_gauge_begin(LsysGauge *gauge, LsysMemory *memory, unsigned threads);

// Waits until all is measured. False to stop.
bool lsys_gauge_end(LsysGauge *gauge);

// Ends the other threads' work for it; the measure stays.
void lsys_gauge_close(LsysGauge *gauge);

#endif
