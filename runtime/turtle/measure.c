// measure.c -- sums up segments and polygons.
#include "turtle/measure.h"

#include "turtle/vector.h"

// The box grows by comparisons that a nan fails, so nan must be caught apart: it makes `odd` nan.
typedef struct Box {
  Pair low, high;
  double low_z, high_z;
  Pair odd;  // 0, or nan once a coordinate was nan or infinite
} Box;

static Box box_of(const LsysMeasure *m) {
  return (Box){{m->low.x, m->low.y}, {m->high.x, m->high.y}, m->low.z, m->high.z, {0, 0}};
}

static inline Pair pair_min(Pair a, Pair b) {
  return (Pair){a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1]};
}

static inline Pair pair_max(Pair a, Pair b) {
  return (Pair){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

static void add_points(LsysMeasure *m, const LsysVec3 *point, size_t count) {
  Box box = box_of(m);
  for (size_t i = 0; i < count; i++) {
    Pair p = {point[i].x, point[i].y};
    double z = point[i].z;
    box.low = pair_min(p, box.low);
    box.high = pair_max(p, box.high);
    box.low_z = z < box.low_z ? z : box.low_z;
    box.high_z = z > box.high_z ? z : box.high_z;
    box.odd += (p + z) * 0;
  }
  m->low = (LsysVec3){box.low[0], box.low[1], box.low_z};
  m->high = (LsysVec3){box.high[0], box.high[1], box.high_z};
  if (isnan(box.odd[0] + box.odd[1])) m->low.x = m->high.x = NAN;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysMeasure *m = (LsysMeasure *)to;
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *point = batch->point + s->first;
    m->segments += s->count - 1;
    m->of_colour[s->pen.colour] += s->count - 1;
    if (s->pen.width < m->thinnest) m->thinnest = s->pen.width;
    if (s->pen.width > m->thickest) m->thickest = s->pen.width;
    add_points(m, point, s->count);
    if (!m->wants_length) continue;
    for (uint32_t k = 1; k < s->count; k++) m->length += vec_length(vec_sum(point[k], 1, point[k - 1], -1));
  }
  return true;
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  LsysMeasure *m = (LsysMeasure *)to;
  (void)pen;
  m->polygons++;
  add_points(m, vertices, count);
  return true;
}

static bool mesh(LsysGeometry *to, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  LsysMeasure *m = (LsysMeasure *)to;
  (void)pen;
  m->meshes++;
  for (uint32_t i = 0; i < mesh->vertices; i++) {
    LsysVec3 p = lsys_mesh_vertex(mesh, place, i);
    add_points(m, &p, 1);
  }
  return true;
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  LsysMeasure *m = (LsysMeasure *)to;
  (void)pen;
  m->balls++;
  double r = diameter / 2, deep = disc ? 0 : r;
  LsysVec3 corner[2] = {{centre->x - r, centre->y - r, centre->z - deep},
                        {centre->x + r, centre->y + r, centre->z + deep}};
  add_points(m, corner, 2);
  return true;
}

static bool label(LsysGeometry *to, const LsysVec3 *at, const char *text, const LsysPen *pen) {
  (void)text;
  (void)pen;
  add_points((LsysMeasure *)to, at, 1);
  return true;
}

void lsys_measure_begin(LsysMeasure *m, bool wants_length) {
  *m = (LsysMeasure){.geometry = {strokes, polygon, mesh, ball, label},
                     .wants_length = wants_length,
                     .low = {INFINITY, INFINITY, INFINITY},
                     .high = {-INFINITY, -INFINITY, -INFINITY},
                     .thinnest = INFINITY};
}

bool lsys_measure_any(const LsysMeasure *m) {
  return m->low.x <= m->high.x || isnan(m->low.x);
}

bool lsys_measure_finite(const LsysMeasure *m) {
  return isfinite(m->low.x) && isfinite(m->low.y) && isfinite(m->low.z) && isfinite(m->high.x) && isfinite(m->high.y)
      && isfinite(m->high.z);
}
