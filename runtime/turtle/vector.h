// vector.h -- vectors of the turtle's space and its frame.
#ifndef LSYS_TURTLE_VECTOR_H
#define LSYS_TURTLE_VECTOR_H

#include "turtle/geometry.h"

#include <math.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Two doubles in one register: a place or a direction in the page.
typedef double Pair __attribute__((vector_size(16)));

// Smaller and larger of each; which one if either is nan is not defined.
static inline Pair pair_min(Pair a, Pair b) {
#ifdef __SSE2__
  return (Pair)_mm_min_pd((__m128d)a, (__m128d)b);
#else
  return (Pair){a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1]};
#endif
}

static inline Pair pair_max(Pair a, Pair b) {
#ifdef __SSE2__
  return (Pair)_mm_max_pd((__m128d)a, (__m128d)b);
#else
  return (Pair){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
#endif
}

// Heading, left, up: orthonormal, H x L = U (ABOP p. 19).
typedef struct Frame {
  LsysVec3 h, l, u;
} Frame;

static inline LsysVec3 vec_sum(LsysVec3 a, double s, LsysVec3 b, double t) {
  return (LsysVec3){a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t};
}

static inline LsysVec3 vec_scale(LsysVec3 a, double s) {
  return (LsysVec3){a.x * s, a.y * s, a.z * s};
}

static inline double vec_dot(LsysVec3 a, LsysVec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline LsysVec3 vec_cross(LsysVec3 a, LsysVec3 b) {
  return (LsysVec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vec_length(LsysVec3 a) {
  return sqrt(vec_dot(a, a));
}

// The largest coordinate, without its sign.
static inline double vec_reach(LsysVec3 a) {
  return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

static inline LsysVec3 vec_unit(LsysVec3 a) {
  return vec_scale(a, 1 / vec_length(a));
}

// Turns a towards b by the angle whose cosine and sine are c and s, in their plane.
static inline void vec_turn(LsysVec3 *a, LsysVec3 *b, double c, double s) {
  LsysVec3 turned = vec_sum(*a, c, *b, s);
  *b = vec_sum(*b, c, *a, -s);
  *a = turned;
}

// Turns v about a unit axis by the angle whose cosine and sine are c and s (Rodrigues).
static inline LsysVec3 vec_about(LsysVec3 v, LsysVec3 axis, double c, double s) {
  LsysVec3 turned = vec_sum(v, c, vec_cross(axis, v), s);
  return vec_sum(turned, 1, axis, vec_dot(axis, v) * (1 - c));
}

// Makes the frame orthonormal again; H keeps its direction.
static inline void frame_straighten(Frame *f) {
  f->h = vec_unit(f->h);
  f->l = vec_unit(vec_sum(f->l, 1, f->h, -vec_dot(f->l, f->h)));
  f->u = vec_cross(f->h, f->l);
}

#endif
