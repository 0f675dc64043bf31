// light.h -- how bright a surface is: one lamp from the upper left before the
// page, and light from the sky. Normals have y up and z towards the viewer.
#ifndef LSYS_SINKS_LIGHT_H
#define LSYS_SINKS_LIGHT_H

#include "turtle/vector.h"

static const LsysVec3 LAMP = {-0.42, 0.56, 0.714};  // unit

static const double LAMP_LIGHT = 0.60, SKY_LIGHT = 0.62, SKY_SLOPE = 0.12;

// About 0.5 to 1.3.
static inline double light_on(double towards_lamp, double upwards) {
  return SKY_LIGHT + SKY_SLOPE * upwards + LAMP_LIGHT * (towards_lamp > 0 ? towards_lamp : 0);
}

static inline uint32_t lit(uint32_t rgb, double light) {
  uint32_t out = 0;
  for (int shift = 0; shift < 24; shift += 8) {
    double c = (double)(rgb >> shift & 255) * light;
    out |= (c > 255 ? 255 : (uint32_t)(c + 0.5)) << shift;
  }
  return out;
}

// The colour of a surface that is seen from both sides.
static inline uint32_t lit_surface(uint32_t rgb, LsysVec3 normal) {
  double side = normal.z < 0 ? -1 : 1;
  return lit(rgb, light_on(side * vec_dot(normal, LAMP), side * normal.y));
}

#endif
