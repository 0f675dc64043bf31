// triangulate.c -- ear clipping in the plane of the polygon.
//
// Whether a corner is an ear changes only when a neighbour is cut off, so that
// every vertex is tried once and again after each change: a queue holds those
// that have to be. Ears go first whose neighbours were left alone, because
// fans of needles would come of always cutting at the same place.
// A corner is no ear if a vertex lies in its triangle, and then one that is not
// convex does (the one farthest from the cut). Those stand in a tree of boxes
// over their order along Morton's curve, so that a try costs no walk around.
// Sources: Meisters, "Polygons have ears", 1975; Eberly, "Triangulation by ear
// clipping", 1998; Morton, "A computer oriented geodetic data base", 1966.
#include "turtle/triangulate.h"

#include "core/memory.h"
#include "turtle/vector.h"

#include <stdlib.h>

enum {
  FEW = 32,         // vertices up to which the walk is as fast
  LEAF = 8,         // vertices of a leaf of the tree
  MOST_DEPTH = 64,  // of the tree, and one for each level
};

typedef struct CutVertex {
  double x, y;
  uint32_t before, after;
  uint32_t leaf;  // of the tree
  bool blocks;    // it is not convex, and not cut off
  bool waits;     // in the queue
  bool touched;   // a neighbour was cut off while it waited
} Vertex;

// A vertex in the tree's order.
typedef struct CutKey {
  uint64_t place;
  uint32_t vertex;
} Key;

// The box of the vertices that block; node 1 is the root, the children of i are 2i and 2i+1, the leaves come last.
typedef struct CutNode {
  double left, right, bottom, top;
  uint32_t blocking;
} Node;

typedef struct Triangle {
  const Vertex *a, *b, *c;
} Triangle;

LsysVec3 polygon_normal(const LsysVec3 *vertex, size_t count) {
  LsysVec3 n = {0};
  for (size_t i = 0; i < count; i++) {
    LsysVec3 a = vec_sum(vertex[i], 1, vertex[0], -1), b = vec_sum(vertex[i + 1 < count ? i + 1 : 0], 1, vertex[0], -1);
    n = vec_sum(n, 1, vec_cross(a, b), 1);
  }
  return n;
}

// ---- the plane ---------------------------------------------------------------

// The polygon seen along the axis that its normal is nearest to, so that it turns counter-clockwise.
static void flatten(const LsysVec3 *v, const LsysVec3 *n, Vertex *to) {
  double x = fabs(n->x), y = fabs(n->y), z = fabs(n->z), a, b;
  bool front;
  if (z >= x && z >= y) {
    a = v->x, b = v->y, front = n->z >= 0;
  } else if (y >= x) {
    a = v->z, b = v->x, front = n->y >= 0;
  } else {
    a = v->y, b = v->z, front = n->x >= 0;
  }
  to->x = front ? a : b;
  to->y = front ? b : a;
}

// Twice the area of the triangle of a line and a place; above 0 to the left of the line.
static double area(const Vertex *a, const Vertex *b, double x, double y) {
  return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

static bool same(const Vertex *a, const Vertex *b) {
  return a->x == b->x && a->y == b->y;
}

static Triangle corner(const Vertex *vertex, uint32_t i) {
  return (Triangle){&vertex[vertex[i].before], &vertex[i], &vertex[vertex[i].after]};
}

static double turn(const Triangle *t) {
  return area(t->a, t->b, t->c->x, t->c->y);
}

// Is the vertex in the triangle or on its border, but no corner of it?
static bool holds(const Triangle *t, const Vertex *p) {
  return area(t->a, t->b, p->x, p->y) >= 0 && area(t->b, t->c, p->x, p->y) >= 0 && area(t->c, t->a, p->x, p->y) >= 0
      && !same(p, t->a) && !same(p, t->b) && !same(p, t->c);
}

// ---- the tree ----------------------------------------------------------------

// The bits of a number, every other one.
static uint64_t spread(uint64_t x) {
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}

// Where x lies between the two, in 2^32 parts.
static uint64_t part(double x, double low, double high) {
  double ratio = (x - low) / (high - low);
  return ratio >= 0 && ratio <= 1 ? (uint64_t)(ratio * UINT32_MAX) : 0;
}

static int by_place(const void *a, const void *b) {
  const Key *k = a, *l = b;
  if (k->place != l->place) return k->place < l->place ? -1 : 1;
  return (k->vertex > l->vertex) - (k->vertex < l->vertex);
}

static const Node nothing = {INFINITY, -INFINITY, INFINITY, -INFINITY, 0};

static Node joined(const Node *a, const Node *b) {
  return (Node){fmin(a->left, b->left), fmax(a->right, b->right), fmin(a->bottom, b->bottom), fmax(a->top, b->top),
                a->blocking + b->blocking};
}

static Node box_of(const Vertex *v) {
  return (Node){v->x, v->x, v->y, v->y, 1};
}

static void sort_keys(const PolygonCutter *c) {
  Node all = nothing;
  for (uint32_t i = 0; i < c->keys; i++) {
    Node one = box_of(&c->vertex[c->key[i].vertex]);
    all = joined(&all, &one);
  }
  for (uint32_t i = 0; i < c->keys; i++) {
    const Vertex *v = &c->vertex[c->key[i].vertex];
    c->key[i].place = spread(part(v->x, all.left, all.right)) | spread(part(v->y, all.bottom, all.top)) << 1;
  }
  qsort(c->key, c->keys, sizeof *c->key, by_place);
}

// Builds the tree over the vertices that block; none for a few.
static bool plant(PolygonCutter *c, uint32_t count) {
  c->keys = c->leaves = 0;
  if (count <= FEW) return true;
  if (!lsys_memory_fit(c->memory, &c->key, &c->key_room, count, sizeof *c->key)) return false;
  for (uint32_t i = 0; i < count; i++)
    if (c->vertex[i].blocks) c->key[c->keys++].vertex = i;
  c->leaves = 1;
  while ((uint64_t)c->leaves * LEAF < c->keys) c->leaves *= 2;
  if (!lsys_memory_fit(c->memory, &c->node, &c->node_room, 2 * (size_t)c->leaves, sizeof *c->node)) return false;
  sort_keys(c);
  for (uint32_t i = 0; i < 2 * c->leaves; i++) c->node[i] = nothing;
  for (uint32_t i = 0; i < c->keys; i++) {
    Vertex *v = &c->vertex[c->key[i].vertex];
    Node one = box_of(v), *leaf = &c->node[v->leaf = c->leaves + i / LEAF];
    *leaf = joined(leaf, &one);
  }
  for (uint32_t i = c->leaves - 1; i; i--) c->node[i] = joined(&c->node[2 * i], &c->node[2 * i + 1]);
  return true;
}

static void unblock(const PolygonCutter *c, Vertex *v) {
  if (!v->blocks) return;
  v->blocks = false;
  for (uint32_t i = c->leaves ? v->leaf : 0; i; i /= 2) c->node[i].blocking--;
}

// Is all of the box to the right of the line? Its corner farthest to the left is, rounded as its vertices would be.
static bool outside(const Node *n, const Vertex *a, const Vertex *b) {
  return area(a, b, b->y > a->y ? n->left : n->right, b->x > a->x ? n->top : n->bottom) < 0;
}

// Are the boxes of the node and of the triangle apart?
static bool boxes_apart(const Node *n, const Triangle *t) {
  const Vertex *a = t->a, *b = t->b, *c = t->c;
  return (a->x < n->left && b->x < n->left && c->x < n->left) || (a->x > n->right && b->x > n->right && c->x > n->right)
      || (a->y < n->bottom && b->y < n->bottom && c->y < n->bottom)
      || (a->y > n->top && b->y > n->top && c->y > n->top);
}

static bool apart(const Node *n, const Triangle *t) {
  return boxes_apart(n, t) || outside(n, t->a, t->b) || outside(n, t->b, t->c) || outside(n, t->c, t->a);
}

static bool leaf_blocks(const PolygonCutter *c, uint32_t leaf, const Triangle *t) {
  uint32_t from = leaf * LEAF, end = c->keys - from < LEAF ? c->keys : from + LEAF;
  for (uint32_t i = from; i < end; i++) {
    const Vertex *v = &c->vertex[c->key[i].vertex];
    if (v->blocks && holds(t, v)) return true;
  }
  return false;
}

// Does a vertex lie in the triangle?
static bool blocked(const PolygonCutter *c, const Triangle *t) {
  if (!c->leaves) {
    const Vertex *v = &c->vertex[t->c->after];
    for (; v != t->a; v = &c->vertex[v->after])
      if (v->blocks && holds(t, v)) return true;
    return false;
  }
  uint32_t stack[MOST_DEPTH], depth = 0;
  stack[depth++] = 1;
  while (depth) {
    uint32_t i = stack[--depth];
    const Node *n = &c->node[i];
    if (!n->blocking || apart(n, t)) continue;
    if (i < c->leaves) {
      stack[depth++] = 2 * i + 1;
      stack[depth++] = 2 * i;
    } else if (leaf_blocks(c, i - c->leaves, t)) {
      return true;
    }
  }
  return false;
}

// ---- ears --------------------------------------------------------------------

// The polygon that is left, and the ring of vertices to be tried.
typedef struct Rest {
  PolygonCutter *cutter;
  uint32_t *triangle;             // the next one
  uint32_t count, some;           // vertices; one of them
  uint32_t first, waiting, room;  // of the queue
} Rest;

static void wait(Rest *r, uint32_t i) {
  uint32_t last = (uint32_t)(((uint64_t)r->first + r->waiting++) % r->room);
  r->cutter->queue[last] = i;
  r->cutter->vertex[i].waits = true;
  r->cutter->vertex[i].touched = false;
}

static uint32_t next_waiting(Rest *r) {
  uint32_t i = r->cutter->queue[r->first];
  r->first = r->first + 1 < r->room ? r->first + 1 : 0;
  r->waiting--;
  r->cutter->vertex[i].waits = false;
  return i;
}

// Can the triangle of vertex i and its neighbours be cut off? A spike without area can.
static bool is_ear(const PolygonCutter *c, uint32_t i) {
  Triangle t = corner(c->vertex, i);
  double turned = turn(&t);
  if (turned == 0) return (t.a->x - t.b->x) * (t.c->x - t.b->x) + (t.a->y - t.b->y) * (t.c->y - t.b->y) >= 0;
  return turned > 0 && !blocked(c, &t);
}

// A neighbour of i was cut off.
static void touch(Rest *r, uint32_t i) {
  Vertex *v = &r->cutter->vertex[i];
  Triangle t = corner(r->cutter->vertex, i);
  if (turn(&t) > 0) unblock(r->cutter, v);
  v->touched = true;
  if (!v->waits) wait(r, i);
}

static void cut_off(Rest *r, uint32_t i) {
  Vertex *vertex = r->cutter->vertex, *v = &vertex[i];
  *r->triangle++ = v->before;
  *r->triangle++ = i;
  *r->triangle++ = v->after;
  vertex[v->before].after = v->after;
  vertex[v->after].before = v->before;
  unblock(r->cutter, v);
  r->count--;
  r->some = v->after;
  touch(r, v->before);
  touch(r, v->after);
}

static void cut(PolygonCutter *c, uint32_t count) {
  Rest r = {.cutter = c, .triangle = c->triangle, .count = count, .room = count};
  for (uint32_t i = 0; i < count; i++) wait(&r, i);
  while (r.count >= 3) {
    if (!r.waiting) {  // a polygon without ears crosses itself: then any corner goes
      cut_off(&r, r.some);
      continue;
    }
    uint32_t i = next_waiting(&r);
    if (c->vertex[i].touched)
      wait(&r, i);
    else if (is_ear(c, i))
      cut_off(&r, i);
  }
}

bool polygon_triangles(PolygonCutter *c, const LsysVec3 *vertex, uint32_t count) {
  if (count < 3) return true;
  if (!lsys_memory_fit(c->memory, &c->triangle, &c->triangle_room, count, 3 * sizeof *c->triangle)
      || !lsys_memory_fit(c->memory, &c->vertex, &c->vertex_room, count, sizeof *c->vertex)
      || !lsys_memory_fit(c->memory, &c->queue, &c->queue_room, count, sizeof *c->queue))
    return false;
  LsysVec3 normal = polygon_normal(vertex, count);
  for (uint32_t i = 0; i < count; i++) {
    Vertex *v = &c->vertex[i];
    *v = (Vertex){.before = i ? i - 1 : count - 1, .after = i + 1 < count ? i + 1 : 0};
    flatten(&vertex[i], &normal, v);
  }
  for (uint32_t i = 0; i < count; i++) {
    Triangle t = corner(c->vertex, i);
    c->vertex[i].blocks = !(turn(&t) > 0);
  }
  if (!plant(c, count)) return false;
  cut(c, count);
  return true;
}

void polygon_cutter_free(PolygonCutter *c) {
  lsys_memory_free(c->memory, c->triangle, c->triangle_room, 3 * sizeof *c->triangle);
  lsys_memory_free(c->memory, c->vertex, c->vertex_room, sizeof *c->vertex);
  lsys_memory_free(c->memory, c->queue, c->queue_room, sizeof *c->queue);
  lsys_memory_free(c->memory, c->key, c->key_room, sizeof *c->key);
  lsys_memory_free(c->memory, c->node, c->node_room, sizeof *c->node);
  *c = (PolygonCutter){.memory = c->memory};
}
