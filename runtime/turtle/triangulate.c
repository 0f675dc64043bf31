// triangulate.c -- ear clipping in the plane of the polygon.
// Source: Meisters, "Polygons have ears", 1975.
#include "turtle/triangulate.h"

#include "turtle/vector.h"

typedef struct Corner {
  double x, y;
} Corner;

LsysVec3 polygon_normal(const LsysVec3 *vertex, size_t count) {
  LsysVec3 n = {0};
  for (size_t i = 0; i < count; i++) {
    LsysVec3 a = vec_sum(vertex[i], 1, vertex[0], -1), b = vec_sum(vertex[i + 1 < count ? i + 1 : 0], 1, vertex[0], -1);
    n = vec_sum(n, 1, vec_cross(a, b), 1);
  }
  return n;
}

// The polygon seen along the axis that its normal is nearest to, so that it turns counter-clockwise.
static Corner flatten(const LsysVec3 *v, const LsysVec3 *n) {
  double x = fabs(n->x), y = fabs(n->y), z = fabs(n->z);
  if (z >= x && z >= y) return n->z >= 0 ? (Corner){v->x, v->y} : (Corner){v->y, v->x};
  if (y >= x) return n->y >= 0 ? (Corner){v->z, v->x} : (Corner){v->x, v->z};
  return n->x >= 0 ? (Corner){v->y, v->z} : (Corner){v->z, v->y};
}

static double area(Corner a, Corner b, Corner c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool inside(Corner p, Corner a, Corner b, Corner c) {
  return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

static bool same(Corner a, Corner b) {
  return a.x == b.x && a.y == b.y;
}

typedef struct Polygon {
  const LsysVec3 *vertex;
  LsysVec3 normal;
  const uint32_t *left;  // the vertices that are not cut off yet
  uint32_t count;
} Polygon;

static Corner corner(const Polygon *p, uint32_t i) {
  return flatten(&p->vertex[p->left[i % p->count]], &p->normal);
}

// Can the triangle of vertex i and its neighbours be cut off? It is convex and holds no other vertex.
static bool is_ear(const Polygon *p, uint32_t i) {
  Corner a = corner(p, i + p->count - 1), b = corner(p, i), c = corner(p, i + 1);
  if (area(a, b, c) <= 0) return same(a, b) || same(b, c);
  for (uint32_t k = i + 2; k < i + p->count - 1; k++) {
    Corner other = corner(p, k);
    if (!same(other, a) && !same(other, b) && !same(other, c) && inside(other, a, b, c)) return false;
  }
  return true;
}

void polygon_triangles(const LsysVec3 *vertex, uint32_t count, uint32_t *triangle, uint32_t *work) {
  Polygon p = {vertex, polygon_normal(vertex, count), work, count};
  for (uint32_t i = 0; i < count; i++) work[i] = i;
  uint32_t at = 0, tried = 0;
  while (p.count >= 3) {
    // A polygon without ears crosses itself: then any corner goes.
    if (!is_ear(&p, at) && ++tried < p.count) {
      at = (at + 1) % p.count;
      continue;
    }
    *triangle++ = work[(at + p.count - 1) % p.count];
    *triangle++ = work[at];
    *triangle++ = work[(at + 1) % p.count];
    for (uint32_t k = at + 1; k < p.count; k++) work[k - 1] = work[k];
    p.count--;
    tried = 0;
    if (at >= p.count) at = 0;
  }
}
