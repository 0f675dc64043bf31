// view.h -- a camera: from the turtle's space to a plane, x to the right, y up,
// z towards the viewer, in the turtle's units.
#ifndef LSYS_SINKS_VIEW_H
#define LSYS_SINKS_VIEW_H

#include "turtle/vector.h"

typedef struct LsysView {
  LsysVec3 right, up, front;  // orthonormal; front points from the figure to the viewer
} LsysView;

// The viewer stands in front of the figure, walks around it to the right by azimuth degrees and rises by elevation.
LsysView lsys_view(double azimuth, double elevation);

static inline LsysVec3 view_turn(const LsysView *v, LsysVec3 p) {
  return (LsysVec3){vec_dot(v->right, p), vec_dot(v->up, p), vec_dot(v->front, p)};
}

// Perspective: an eye at `distance` before the centre of what is seen, which keeps its size there.
typedef struct LsysEye {
  LsysVec3 centre;
  double distance;  // infinite: orthographic
} LsysEye;

// The eye that sees a box (in turned coordinates) under a moderate angle.
LsysEye lsys_eye(LsysVec3 low, LsysVec3 high);

// How much bigger things at the point look than at the centre.
static inline double eye_factor(const LsysEye *eye, const LsysVec3 *p) {
  return isinf(eye->distance) ? 1 : eye->distance / (eye->distance - (p->z - eye->centre.z));
}

static inline LsysVec3 eye_project(const LsysEye *eye, LsysVec3 p) {
  double factor = eye_factor(eye, &p);
  return (LsysVec3){eye->centre.x + (p.x - eye->centre.x) * factor, eye->centre.y + (p.y - eye->centre.y) * factor,
                    p.z};
}

#endif
