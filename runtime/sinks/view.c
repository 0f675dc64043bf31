// view.c -- cameras.
#include "sinks/view.h"

#include "lsys/functions.h"

// The eye's distance, in half diagonals of what it sees: 28 degrees wide.
static const double EYE_DISTANCE = 4;

LsysView lsys_view(double azimuth, double elevation) {
  double ca = lsys_cos(azimuth), sa = lsys_sin(azimuth), ce = lsys_cos(elevation), se = lsys_sin(elevation);
  LsysVec3 right = {ca, 0, -sa}, front = {sa * ce, se, ca * ce};
  return (LsysView){right, vec_cross(front, right), front};
}

LsysEye lsys_eye(LsysVec3 low, LsysVec3 high) {
  double half = vec_length(vec_sum(high, 0.5, low, -0.5));
  return (LsysEye){vec_sum(low, 0.5, high, 0.5), half > 0 ? EYE_DISTANCE * half : INFINITY};
}
