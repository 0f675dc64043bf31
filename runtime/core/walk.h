// walk.h -- from a word in memory to the scans by which compiled code goes
// through it: one for each view of the grammar, linked.
#ifndef LSYS_CORE_WALK_H
#define LSYS_CORE_WALK_H

#include "core/scan.h"
#include "core/stream.h"

typedef struct LsysWalk {
  LsysWorker *worker;
  ScanTables tables;
  ScanIndex index;
  LsysSegment segment;  // the whole word
  LsysScan *scans;      // one for each view
  LsysNeighbour *left;  // their windows
} LsysWalk;

// False after printing why not. Close it in either case; one that is all zeros holds nothing.
bool lsys_walk_open(LsysWalk *walk, LsysWorker *worker);
void lsys_walk_close(LsysWalk *walk);

// The scan at the beginning of a word, which must stay where it is while the scan is used.
LsysScan *lsys_walk_start(LsysWalk *walk, const LsysWord *word);

#endif
