// patch.c -- bicubic patches in the Bezier and the uniform B-spline basis.
#include "turtle/patch.h"

#include "turtle/vector.h"

// The four weights of control points at t in 0..1, and their derivatives.
static void weights(PatchBasis basis, double t, double *w, double *slope) {
  double u = 1 - t;
  if (basis == PATCH_BEZIER) {
    w[0] = u * u * u;
    w[1] = 3 * t * u * u;
    w[2] = 3 * t * t * u;
    w[3] = t * t * t;
    slope[0] = -3 * u * u;
    slope[1] = 3 * u * u - 6 * t * u;
    slope[2] = 6 * t * u - 3 * t * t;
    slope[3] = 3 * t * t;
    return;
  }
  w[0] = u * u * u / 6;
  w[1] = (3 * t * t * t - 6 * t * t + 4) / 6;
  w[2] = (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6;
  w[3] = t * t * t / 6;
  slope[0] = -u * u / 2;
  slope[1] = (3 * t * t - 4 * t) / 2;
  slope[2] = (-3 * t * t + 2 * t + 1) / 2;
  slope[3] = t * t / 2;
}

static void point(const LsysVec3 *control, PatchBasis basis, double s, double t, LsysVec3 up, LsysVec3 *place,
                  LsysVec3 *normal) {
  double ws[4], ds[4], wt[4], dt[4];
  weights(basis, s, ws, ds);
  weights(basis, t, wt, dt);
  LsysVec3 p = {0}, along_s = {0}, along_t = {0};
  for (int n = 0; n < PATCH_CONTROLS; n++) {
    p = vec_sum(p, 1, control[n], ws[n / 4] * wt[n % 4]);
    along_s = vec_sum(along_s, 1, control[n], ds[n / 4] * wt[n % 4]);
    along_t = vec_sum(along_t, 1, control[n], ws[n / 4] * dt[n % 4]);
  }
  LsysVec3 across = vec_cross(along_s, along_t);
  double length = vec_length(across);
  *place = p;
  *normal = length > 0 ? vec_scale(across, 1 / length) : up;
}

void patch_grid(const LsysVec3 *control, PatchBasis basis, uint32_t s, uint32_t t, LsysVec3 up, uint32_t first,
                LsysVec3 *vertex, LsysVec3 *normal, uint32_t *corner) {
  for (uint32_t i = 0; i <= s; i++) {
    for (uint32_t k = 0; k <= t; k++) point(control, basis, (double)i / s, (double)k / t, up, vertex++, normal++);
  }
  for (uint32_t i = 0; i < s; i++) {
    for (uint32_t k = 0; k < t; k++) {
      uint32_t a = first + i * (t + 1) + k, b = a + 1, c = a + t + 1, d = c + 1;
      const uint32_t two[6] = {a, c, d, a, d, b};
      for (int n = 0; n < 6; n++) *corner++ = two[n];
    }
  }
}
