// stats.h -- how --stats prints.
#ifndef LSYS_SINKS_STATS_H
#define LSYS_SINKS_STATS_H

#include "core/out.h"
#include "turtle/geometry.h"

// A row of a name and three coordinates. False if the output failed.
bool lsys_stats_point(LsysOut *out, const char *name, LsysVec3 point);

#endif
