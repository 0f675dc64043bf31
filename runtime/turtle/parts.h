// parts.h -- a deterministic figure as shared parts: what a kind draws in its
// last s steps is always the same, moved, turned, and with another pen.
//
// A part is a kind with a number of steps. Its word is what the kind becomes in
// one of them: modules that stay, which the turtle draws, and modules that are
// parts with one step less. So a figure of any number of segments is known by
// kinds times steps parts.
#ifndef LSYS_TURTLE_PARTS_H
#define LSYS_TURTLE_PARTS_H

#include "turtle/support.h"

// What drawing a part does to the turtle, whose pose before it is the origin, H up the page.
typedef struct LsysPart {
  LsysPose exit;    // where it stands behind it; its pen is that behind a pen of width 1 and colour 0
  bool sets_width;  // the width behind it does not depend on the one before it
  bool sets_colour;
  double segments, length;  // in all; beyond 2^53 rounded
  double polygons;
  double *support;  // in each direction (support.h)
} LsysPart;

typedef struct LsysParts {
  const LsysRun *run;
  LsysTurtle *turtle;  // free, for walking
  uint64_t steps;      // parts have up to these
  uint32_t kinds;
  LsysPart *part;  // [steps * kinds + kind]
  size_t parts;
  LsysDirections directions;  // flat: everything stays in the page
  double *whole;              // support of a figure
  double *support;            // of all parts
} LsysParts;

// Makes the parts of every kind with up to run->steps steps. Requires the run's blocks. NULL if that worked; else
// a phrase why this figure has no shared parts, such as "a production has a parameter", or "" after an error.
const char *lsys_parts_create(LsysParts *parts, const LsysRun *run);
void lsys_parts_destroy(LsysParts *parts);

// The part of a kind with steps left.
static inline const LsysPart *lsys_part(const LsysParts *parts, uint32_t kind, uint64_t steps) {
  return &parts->part[steps * parts->kinds + kind];
}

// True for kinds that become something else; the others are drawn as they are.
bool lsys_parts_expands(const LsysParts *parts, uint32_t kind);

// What such a kind becomes in one step.
LsysWord lsys_parts_word(const LsysParts *parts, uint32_t kind);

// Who sees a walk: modules that stay are drawn to `to`; child is called for parts. False: stop.
typedef struct LsysWalk {
  LsysGeometry *to;
  bool (*child)(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose);
  void *data;
} LsysWalk;

// Begins a walk with no bracket open.
void lsys_parts_begin(const LsysParts *parts, const LsysWalk *walk);

// Walks a word whose modules have steps left, from a pose; *pose is then the one behind it. A child may walk its own
// word meanwhile. False if something wanted to stop.
bool lsys_parts_walk(const LsysParts *parts, const LsysWord *word, uint64_t steps, LsysPose *pose,
                     const LsysWalk *walk);

// The whole figure of a start word: its pose at the start, and as a part (its support belongs to parts and is that of
// the figure asked for last).
bool lsys_parts_figure(LsysParts *parts, uint32_t axiom, LsysPose *start, LsysPart *whole);

// Where a turtle starts a part: at the origin, H up the page.
LsysPose lsys_pose_origin(double width, uint8_t colour);

// The pose that is `inner` as seen from `outer`, with inner's pen.
LsysPose lsys_pose_within(const LsysPose *outer, const LsysPose *inner);

// The pose behind a part that begins at `from`.
LsysPose lsys_part_behind(const LsysPart *part, const LsysPose *from);

#endif
