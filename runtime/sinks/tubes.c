// tubes.c -- strokes to tubes with mitred joints and flat ends, or to edges;
// polygons, meshes and balls to triangles.
#include "sinks/tubes.h"

#include "core/memory.h"
#include "core/message.h"
#include "turtle/measure.h"
#include "turtle/triangulate.h"
#include "turtle/vector.h"

#include "lsys/functions.h"

#include <stdlib.h>
#include <string.h>

enum {
  BATCH = 4096,    // vertices, triangles and edges that wait
  BALL_RINGS = 8,  // from pole to pole
  BALL_SIDES = 16,
};

static const double SHARPEST = -0.5;  // cosine of the sharpest turn (120 degrees) that is mitred

typedef struct LsysTubeBatch {
  LsysVertex vertex[BATCH];
  uint32_t triangle[3 * BATCH], edge[2 * BATCH];
  uint8_t triangle_colour[BATCH], edge_colour[BATCH];
  size_t vertices, triangles, edges;
  PolygonCutter cutter;
} Batch;

bool lsys_tubes_flush(LsysTubes *t) {
  Batch *b = t->batch;
  bool well = (!b->vertices || t->model->vertices(t->model, b->vertex, b->vertices))
           && (!b->triangles || t->model->triangles(t->model, b->triangle, b->triangle_colour, b->triangles))
           && (!b->edges || t->model->edges(t->model, b->edge, b->edge_colour, b->edges));
  b->vertices = b->triangles = b->edges = 0;
  return well;
}

static bool room(LsysTubes *t, size_t vertices, size_t triangles, size_t edges) {
  Batch *b = t->batch;
  if (t->vertices + vertices > UINT32_MAX) {
    lsys_error("the model has more than 2^32 vertices");
    return false;
  }
  if (b->vertices + vertices <= BATCH && b->triangles + triangles <= BATCH && b->edges + edges <= BATCH) return true;
  return lsys_tubes_flush(t);
}

static uint32_t put_vertex(LsysTubes *t, LsysVec3 p, LsysVec3 normal, uint8_t colour) {
  t->colour = colour;
  LsysVertex *v = &t->batch->vertex[t->batch->vertices++];
  *v = (LsysVertex){(float)(p.x + t->shift.x),
                    (float)(p.y + t->shift.y),
                    (float)(p.z + t->shift.z),
                    (float)normal.x,
                    (float)normal.y,
                    (float)normal.z,
                    colour,
                    {0}};
  return (uint32_t)t->vertices++;
}

static void put_triangle(LsysTubes *t, uint32_t a, uint32_t b, uint32_t c) {
  t->batch->triangle_colour[t->batch->triangles] = t->colour;
  uint32_t *to = &t->batch->triangle[3 * t->batch->triangles++];
  to[0] = a;
  to[1] = b;
  to[2] = c;
}

// ---- edges ---------------------------------------------------------------

// A row of vertices and the edges between them, for which there is room. goes_on: there is one to the last vertex, too.
static void put_ends(LsysTubes *t, const LsysVec3 *p, uint32_t count, bool goes_on, uint8_t colour) {
  Batch *b = t->batch;
  const LsysVec3 shift = t->shift;
  LsysVertex *v = b->vertex + b->vertices;
  for (uint32_t i = 0; i < count; i++)
    v[i] = (LsysVertex){
      (float)(p[i].x + shift.x), (float)(p[i].y + shift.y), (float)(p[i].z + shift.z), 0, 0, 1, colour, {0}};
  uint32_t first = (uint32_t)t->vertices, edges = count - !goes_on, *to = b->edge + 2 * b->edges;
  for (uint32_t end = first + !goes_on; end < first + count; end++) {
    *to++ = end - 1;
    *to++ = end;
  }
  memset(b->edge_colour + b->edges, colour, edges);
  b->vertices += count;
  b->edges += edges;
  t->vertices += count;
  t->colour = colour;
}

// There are never more edges than vertices in a batch.
static bool draw_edges(LsysTubes *t, const LsysVec3 *p, uint32_t count, const LsysPen *pen) {
  for (uint32_t i = 0, n; i < count; i += n) {
    if (!room(t, 1, 0, 1)) return false;
    uint64_t left = BATCH - t->batch->vertices, numbers = UINT32_MAX - t->vertices;
    if (left > numbers) left = numbers;
    n = count - i < left ? count - i : (uint32_t)left;
    put_ends(t, p + i, n, i > 0, pen->colour);
  }
  return true;
}

// ---- tubes ---------------------------------------------------------------

// A unit vector at right angles to the axis, carried along from the last one so that the tube does not twist.
static LsysVec3 side_of(LsysVec3 axis, LsysVec3 last) {
  LsysVec3 side = vec_sum(last, 1, axis, -vec_dot(last, axis));
  if (vec_length(side) < 1e-3) {
    LsysVec3 other = fabs(axis.x) < 0.6 ? (LsysVec3){1, 0, 0} : (LsysVec3){0, 1, 0};
    side = vec_sum(other, 1, axis, -vec_dot(other, axis));
  }
  return vec_unit(side);
}

// The ring where the tube along `axis` meets the plane through p with normal `cut`. Returns its first vertex.
static uint32_t put_ring(LsysTubes *t, LsysVec3 p, LsysVec3 axis, LsysVec3 side, LsysVec3 cut, double radius,
                         uint8_t colour) {
  LsysVec3 other = vec_cross(axis, side);
  double along = vec_dot(axis, cut);
  uint32_t first = (uint32_t)t->vertices;
  for (uint32_t i = 0; i < t->sides; i++) {
    double angle = i * 360.0 / t->sides;
    LsysVec3 out = vec_sum(side, lsys_cos(angle), other, lsys_sin(angle));
    double slide = -radius * vec_dot(out, cut) / along;
    LsysVec3 at = vec_sum(vec_sum(p, 1, out, radius), 1, axis, slide);
    put_vertex(t, at, out, colour);
  }
  return first;
}

// The wall between two rings.
static void put_wall(LsysTubes *t, uint32_t from, uint32_t to) {
  for (uint32_t i = 0; i < t->sides; i++) {
    uint32_t next = i + 1 < t->sides ? i + 1 : 0;
    put_triangle(t, from + i, from + next, to + next);
    put_triangle(t, from + i, to + next, to + i);
  }
}

static void put_cap(LsysTubes *t, uint32_t ring, bool start) {
  for (uint32_t i = 1; i + 1 < t->sides; i++) {
    if (start)
      put_triangle(t, ring, ring + i + 1, ring + i);
    else
      put_triangle(t, ring, ring + i, ring + i + 1);
  }
}

// The next segment from point i that has a length; false at the end.
static bool next_axis(const LsysVec3 *p, uint32_t count, uint32_t *i, LsysVec3 *axis) {
  for (; *i + 1 < count; ++*i) {
    LsysVec3 d = vec_sum(p[*i + 1], 1, p[*i], -1);
    double length = vec_length(d);
    if (!(length > 0)) continue;
    *axis = vec_scale(d, 1 / length);
    return true;
  }
  return false;
}

// Where the tube is cut at the joint of two segments: halfway between them, or straight where the turn is too sharp.
static bool mitre(LsysVec3 axis, LsysVec3 next, LsysVec3 *cut) {
  if (!(vec_dot(axis, next) > SHARPEST)) return false;
  *cut = vec_unit(vec_sum(axis, 1, next, 1));
  return true;
}

// Every segment is a wall between two rings; its ends are cut by the planes of its joints, or have caps.
static bool draw_tube(LsysTubes *t, const LsysVec3 *p, uint32_t count, const LsysPen *pen) {
  const double radius = pen->width * t->width / 2;
  uint32_t i = 0;
  LsysVec3 axis, side = {0, 0, 1}, cut;
  bool more = next_axis(p, count, &i, &axis), open = false;  // open: the start is a joint, cut by `cut`
  while (more) {
    if (!room(t, 2 * t->sides, 4 * t->sides, 0)) return false;
    side = side_of(axis, side);
    uint32_t start = put_ring(t, p[i], axis, side, open ? cut : axis, radius, pen->colour);
    if (!open) put_cap(t, start, true);
    uint32_t at = ++i;
    LsysVec3 next = axis;
    more = next_axis(p, count, &i, &next);
    open = more && mitre(axis, next, &cut);
    uint32_t end = put_ring(t, p[at], axis, side, open ? cut : axis, radius, pen->colour);
    put_wall(t, start, end);
    if (!open) put_cap(t, end, false);
    axis = next;
  }
  return true;
}

static bool strokes(LsysGeometry *geometry, const LsysStrokes *batch) {
  LsysTubes *t = (LsysTubes *)geometry;
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *p = batch->point + s->first;
    bool tube = t->sides > 1 && s->pen.width * t->width > 0;
    if (!(tube ? draw_tube(t, p, s->count, &s->pen) : draw_edges(t, p, s->count, &s->pen))) return false;
  }
  return true;
}

// ---- polygons and meshes -------------------------------------------------

static bool polygon(LsysGeometry *geometry, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  LsysTubes *t = (LsysTubes *)geometry;
  LsysVec3 normal = polygon_normal(vertices, count);
  double length = vec_length(normal);
  if (count < 3 || !(length > 0)) return true;
  normal = vec_scale(normal, 1 / length);
  PolygonCutter *cutter = &t->batch->cutter;
  cutter->memory = t->memory;
  if (!polygon_triangles(cutter, vertices, (uint32_t)count)) return false;
  uint32_t first = (uint32_t)t->vertices;
  for (size_t i = 0; i < count; i++) {
    if (!room(t, 1, 0, 0)) return false;
    put_vertex(t, vertices[i], normal, pen->colour);
  }
  for (size_t i = 0; i + 2 < count; i++) {
    const uint32_t *c = cutter->triangle + 3 * i;
    if (!room(t, 0, 1, 0)) return false;
    put_triangle(t, first + c[0], first + c[1], first + c[2]);
  }
  return true;
}

// A flat mesh gets its vertices anew for every triangle, with the triangle's normal.
static bool flat_mesh(LsysTubes *t, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  for (uint32_t i = 0; i < mesh->triangles; i++) {
    LsysVec3 corner[3];
    for (uint32_t k = 0; k < 3; k++) corner[k] = lsys_mesh_vertex(mesh, place, mesh->corner[3 * i + k]);
    if (!polygon(&t->geometry, corner, 3, pen)) return false;
  }
  return true;
}

static bool mesh(LsysGeometry *geometry, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  LsysTubes *t = (LsysTubes *)geometry;
  if (!mesh->normal) return flat_mesh(t, mesh, place, pen);
  uint32_t first = (uint32_t)t->vertices;
  LsysVec3 axis[3] = {place->right, place->ahead, place->up};
  for (int i = 0; i < 3; i++) {
    double squared = vec_dot(axis[i], axis[i]);
    if (!(squared > 0)) return true;
    axis[i] = vec_scale(axis[i], 1 / squared);
  }
  for (uint32_t i = 0; i < mesh->vertices; i++) {
    LsysVec3 n = mesh->normal[i];
    n = vec_sum(vec_sum(axis[0], n.x, axis[1], n.y), 1, axis[2], n.z);
    double length = vec_length(n);
    if (!room(t, 1, 0, 0)) return false;
    put_vertex(t, lsys_mesh_vertex(mesh, place, i), length > 0 ? vec_scale(n, 1 / length) : (LsysVec3){0, 0, 1},
               pen->colour);
  }
  for (uint32_t i = 0; i < mesh->triangles; i++) {
    const uint32_t *c = mesh->corner + 3 * i;
    if (!room(t, 0, 1, 0)) return false;
    put_triangle(t, first + c[0], first + c[1], first + c[2]);
  }
  return true;
}

// ---- balls ---------------------------------------------------------------

static bool draw_disc(LsysTubes *t, LsysVec3 centre, double radius, const LsysPen *pen) {
  enum { CORNERS = 32 };
  LsysVec3 vertex[CORNERS];
  for (int i = 0; i < CORNERS; i++) {
    double angle = i * 360.0 / CORNERS;
    vertex[i] = (LsysVec3){centre.x + radius * lsys_cos(angle), centre.y + radius * lsys_sin(angle), centre.z};
  }
  return polygon(&t->geometry, vertex, CORNERS, pen);
}

// Rings of vertices between two poles.
static bool ball(LsysGeometry *geometry, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  LsysTubes *t = (LsysTubes *)geometry;
  const double radius = diameter / 2;
  if (disc) return draw_disc(t, *centre, radius, pen);
  if (!room(t, BALL_RINGS * BALL_SIDES, 2 * BALL_RINGS * BALL_SIDES, 0)) return false;
  const uint32_t first = (uint32_t)t->vertices, south = first + 1 + (BALL_RINGS - 1) * BALL_SIDES;
  put_vertex(t, vec_sum(*centre, 1, (LsysVec3){0, radius, 0}, 1), (LsysVec3){0, 1, 0}, pen->colour);
  for (int i = 1; i < BALL_RINGS; i++) {
    double down = i * 180.0 / BALL_RINGS, wide = lsys_sin(down);
    for (int k = 0; k < BALL_SIDES; k++) {
      double around = k * 360.0 / BALL_SIDES;
      LsysVec3 n = {wide * lsys_sin(around), lsys_cos(down), wide * lsys_cos(around)};
      put_vertex(t, vec_sum(*centre, 1, n, radius), n, pen->colour);
    }
  }
  put_vertex(t, vec_sum(*centre, 1, (LsysVec3){0, -radius, 0}, 1), (LsysVec3){0, -1, 0}, pen->colour);
  for (uint32_t k = 0; k < BALL_SIDES; k++) {
    uint32_t next = (k + 1) % BALL_SIDES, top = first + 1, bottom = south - BALL_SIDES;
    put_triangle(t, first, top + k, top + next);
    put_triangle(t, south, bottom + next, bottom + k);
    for (uint32_t ring = top; ring < bottom; ring += BALL_SIDES) {
      put_triangle(t, ring + k, ring + BALL_SIDES + k, ring + BALL_SIDES + next);
      put_triangle(t, ring + k, ring + BALL_SIDES + next, ring + next);
    }
  }
  return true;
}

// --------------------------------------------------------------------------

bool lsys_tubes_create(LsysTubes *t, LsysModel *model) {
  *t = (LsysTubes){
    .geometry = {strokes, polygon, mesh, ball, NULL}, .model = model, .sides = 1, .batch = calloc(1, sizeof *t->batch)};
  if (!t->batch) lsys_error("out of memory");
  return t->batch != NULL;
}

void lsys_tubes_destroy(LsysTubes *t) {
  if (!t->batch) return;
  polygon_cutter_free(&t->batch->cutter);
  free(t->batch);
  t->batch = NULL;
}
