// measure.c -- sums up segments and polygons.
#include "turtle/measure.h"

#include "turtle/vector.h"

#include <string.h>

// A box that grows by two points at a time, x y, z x, y z, so that no half of a register is idle.
typedef struct Box {
  Pair low[3], high[3];
  Pair sum[3];  // nan or infinite once a coordinate was: comparisons may lose those
} Box;

static inline void add_two(Box *box, const LsysVec3 *point) {
  for (int i = 0; i < 3; i++) {
    Pair p;
    memcpy(&p, (const char *)point + (size_t)i * sizeof p, sizeof p);
    box->low[i] = pair_min(box->low[i], p);
    box->high[i] = pair_max(box->high[i], p);
    box->sum[i] += p;
  }
}

static double least(double a, double b) {
  return a < b ? a : b;
}

static double most(double a, double b) {
  return a > b ? a : b;
}

static void add_points(LsysMeasure *m, const LsysVec3 *point, size_t count) {
  if (!count) return;
  const LsysVec3 last[2] = {point[count - 1], point[count - 1]};
  Box box = {.sum = {{0}}};
  for (int i = 0; i < 3; i++) {
    memcpy(&box.low[i], (const char *)last + (size_t)i * sizeof(Pair), sizeof(Pair));
    box.high[i] = box.low[i];
  }
  for (size_t i = 0; i + 1 < count; i += 2) add_two(&box, &point[i]);
  add_two(&box, last);
  m->low = (LsysVec3){least(m->low.x, least(box.low[0][0], box.low[1][1])),
                      least(m->low.y, least(box.low[0][1], box.low[2][0])),
                      least(m->low.z, least(box.low[1][0], box.low[2][1]))};
  m->high = (LsysVec3){most(m->high.x, most(box.high[0][0], box.high[1][1])),
                       most(m->high.y, most(box.high[0][1], box.high[2][0])),
                       most(m->high.z, most(box.high[1][0], box.high[2][1]))};
  Pair sum = box.sum[0] + box.sum[1] + box.sum[2];
  if (!isfinite(sum[0] + sum[1])) m->odd = true;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysMeasure *m = (LsysMeasure *)to;
  add_points(m, batch->point, batch->points);
  double length = 0;  // of the batch, so that batches can be measured apart
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *point = batch->point + s->first;
    m->segments += s->count - 1;
    m->of_colour[s->pen.colour] += s->count - 1;
    if (s->pen.width < m->thinnest) m->thinnest = s->pen.width;
    if (s->pen.width > m->thickest) m->thickest = s->pen.width;
    if (!m->wants_length) continue;
    for (uint32_t k = 1; k < s->count; k++) length += vec_length(vec_sum(point[k], 1, point[k - 1], -1));
  }
  m->length += length;
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

void lsys_measure_join(LsysMeasure *m, const LsysMeasure *part) {
  m->segments += part->segments;
  m->polygons += part->polygons;
  m->meshes += part->meshes;
  m->balls += part->balls;
  for (int i = 0; i < 256; i++) m->of_colour[i] += part->of_colour[i];
  m->length += part->length;
  m->low = (LsysVec3){least(m->low.x, part->low.x), least(m->low.y, part->low.y), least(m->low.z, part->low.z)};
  m->high = (LsysVec3){most(m->high.x, part->high.x), most(m->high.y, part->high.y), most(m->high.z, part->high.z)};
  m->odd |= part->odd;
  m->thinnest = least(m->thinnest, part->thinnest);
  m->thickest = most(m->thickest, part->thickest);
}

bool lsys_measure_any(const LsysMeasure *m) {
  return m->odd || m->low.x <= m->high.x;
}

bool lsys_measure_finite(const LsysMeasure *m) {
  return !m->odd;
}
