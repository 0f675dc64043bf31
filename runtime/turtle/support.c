// support.c -- see support.h.
#include "turtle/support.h"

#include "turtle/vector.h"

#include "lsys/functions.h"

#include <math.h>

enum { MOST_DIRECTIONS = 4096, SOME_DIRECTIONS = 720 };

static uint32_t divisor(uint32_t a, uint32_t b) {
  return b ? divisor(b, a % b) : a;
}

// As many as turns lead to, and the page's own four.
static uint32_t needed_in_page(double angle) {
  for (uint32_t n = 1; n <= MOST_DIRECTIONS; n++) {
    double turns = angle * n / 360;
    if (fabs(turns - rint(turns)) > 1e-12 * (1 + turns)) continue;
    uint32_t common = n / divisor(n, 4) * 4;
    return common <= MOST_DIRECTIONS ? common : SOME_DIRECTIONS;
  }
  return SOME_DIRECTIONS;
}

uint32_t lsys_directions_needed(double angle, bool flat) {
  if (flat) return needed_in_page(fabs(angle));
  return fmod(angle, 90) == 0 ? LSYS_AXES : 0;
}

void lsys_directions_fill(const LsysDirections *directions) {
  static const LsysVec3 axes[LSYS_AXES] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (uint32_t i = 0; i < directions->count; i++) {
    double degrees = i * 360.0 / directions->count;
    directions->unit[i] = directions->flat ? (LsysVec3){lsys_cos(degrees), lsys_sin(degrees), 0} : axes[i];
  }
}

void lsys_support_clear(const LsysDirections *directions, double *support) {
  for (uint32_t i = 0; i < directions->count; i++) support[i] = -INFINITY;
}

static double larger(double a, double b) {
  return a > b ? a : b;
}

void lsys_support_add(const LsysDirections *directions, double *support, LsysVec3 centre, double radius) {
  for (uint32_t i = 0; i < directions->count; i++)
    support[i] = larger(support[i], vec_dot(centre, directions->unit[i]) + radius);
}

// In between directions the corner of the two half-planes beside them is taken.
static void add_in_page(const LsysDirections *directions, double *support, const double *part, const LsysPose *pose) {
  const uint32_t n = directions->count;
  double turned = atan2(-pose->h.x, pose->h.y) * (n / (2 * 3.14159265358979323846)), whole = floor(turned + 1e-6);
  bool exact = fabs(turned - rint(turned)) < 1e-6;
  double slack = 1 / lsys_cos(180.0 / n);
  for (uint32_t i = 0; i < n; i++) {
    uint32_t from = (uint32_t)fmod(i + 2.0 * n - fmod(whole, n), n);
    double far = part[from];
    if (!exact) {
      double other = part[(from + n - 1) % n];
      far = larger(larger(far, other), larger(far, other) * slack);
    }
    support[i] = larger(support[i], vec_dot(pose->at, directions->unit[i]) + far);
  }
}

// The axis that a direction is, or LSYS_AXES.
static uint32_t axis_of(const LsysDirections *directions, LsysVec3 v) {
  uint32_t i = 0;
  while (i < LSYS_AXES && vec_dot(directions->unit[i], v) < 1 - 1e-9) i++;
  return i;
}

static void add_in_space(const LsysDirections *directions, double *support, const double *part, const LsysPose *pose) {
  for (uint32_t i = 0; i < LSYS_AXES; i++) {
    LsysVec3 unit = directions->unit[i];
    LsysVec3 back = {-vec_dot(unit, pose->l), vec_dot(unit, pose->h), vec_dot(unit, pose->u)};
    uint32_t axis = axis_of(directions, back);
    double far = axis < LSYS_AXES ? part[axis] : part[0] > -INFINITY ? INFINITY : -INFINITY;
    support[i] = larger(support[i], vec_dot(pose->at, unit) + far);
  }
}

void lsys_support_add_part(const LsysDirections *directions, double *support, const double *part,
                           const LsysPose *pose) {
  if (directions->flat)
    add_in_page(directions, support, part, pose);
  else if (directions->count)
    add_in_space(directions, support, part, pose);
}

bool lsys_support_box(const LsysDirections *directions, const double *support, LsysVec3 *low, LsysVec3 *high) {
  const uint32_t n = directions->count, quarter = directions->flat ? n / 4 : 1;
  if (!n || !(support[0] > -INFINITY)) return false;
  *high = (LsysVec3){support[0], support[quarter], directions->flat ? 0 : support[4]};
  *low = (LsysVec3){0 - support[2 * quarter], 0 - support[3 * quarter], directions->flat ? 0 : 0 - support[5]};
  return true;
}
