// support.h -- how far parts of a figure reach, from which their boxes come.
//
// The support of a figure in a direction is the largest product of one of its points and that unit vector. That of a
// part which was turned is the part's own in the direction turned back, so that supports compose where turns lead from
// directions to directions: in the page by whole parts of a circle, in space by right angles.
#ifndef LSYS_TURTLE_SUPPORT_H
#define LSYS_TURTLE_SUPPORT_H

#include "turtle/turtle.h"

enum { LSYS_AXES = 6 };  // the directions of space: +x +y -x -y +z -z

typedef struct LsysDirections {
  bool flat;       // counter-clockwise from +x; otherwise the axes of space
  uint32_t count;  // 0: the turns of the figure lead to too many directions
  LsysVec3 *unit;  // [count]
} LsysDirections;

// How many there are for figures whose turns are by multiples of angle degrees.
uint32_t lsys_directions_needed(double angle, bool flat);

// Sets count vectors.
void lsys_directions_fill(const LsysDirections *directions);

// A figure that draws nothing.
void lsys_support_clear(const LsysDirections *directions, double *support);

// A ball of this radius, or a point (0), is added.
void lsys_support_add(const LsysDirections *directions, double *support, LsysVec3 centre, double radius);

// A part is added that stands at pose. In the page it may be turned by any angle: in between directions it is taken to
// reach a little farther than it does. In space such a part has no support: it reaches infinitely far.
void lsys_support_add_part(const LsysDirections *directions, double *support, const double *part, const LsysPose *pose);

// The box of what was added, whose coordinates may be infinite. False if that is nothing, or there are no directions.
bool lsys_support_box(const LsysDirections *directions, const double *support, LsysVec3 *low, LsysVec3 *high);

#endif
