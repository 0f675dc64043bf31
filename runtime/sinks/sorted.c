// sorted.c -- a canvas for figures in space over one without depth: keeps
// everything that is drawn, lit, and draws it from back to front in the end
// (the painter's algorithm; Newell, Newell, Sancha 1972 without their splitting).
#include "core/memory.h"
#include "core/message.h"
#include "sinks/light.h"
#include "sinks/picture.h"
#include "turtle/triangulate.h"

#include <stdlib.h>
#include <string.h>

// A segment (2 points, a width) or a polygon (width 0).
typedef struct Item {
  float depth, width;
  uint32_t rgb;
  uint32_t count;
  size_t first;
} Item;

typedef struct Sorted {
  LsysCanvas canvas;
  LsysCanvas *inner;
  LsysMemory *memory;
  bool solid;
  Item *item;
  size_t items, item_room;
  LsysPoint *point;
  size_t points, point_room;
} Sorted;

static bool keep(Sorted *s, const LsysPoint *point, size_t count, double width, uint32_t rgb) {
  if (!lsys_memory_fit(s->memory, &s->item, &s->item_room, s->items + 1, sizeof *s->item)
      || !lsys_memory_fit(s->memory, &s->point, &s->point_room, s->points + count, sizeof *s->point))
    return false;
  double depth = 0;
  for (size_t i = 0; i < count; i++) depth += point[i].z / (double)count;
  memcpy(s->point + s->points, point, count * sizeof *point);
  s->item[s->items++] = (Item){(float)depth, (float)width, rgb, (uint32_t)count, s->points};
  s->points += count;
  return true;
}

static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  Sorted *s = (Sorted *)canvas;
  s->solid = page->solid;
  s->memory = page->memory;
  return s->inner->open(s->inner, page);
}

// A cylinder has the light of the side that it turns to the viewer.
static uint32_t lit_segment(const LsysPoint *a, const LsysPoint *b, uint32_t rgb) {
  LsysVec3 axis = {b->x - a->x, a->y - b->y, b->z - a->z}, front = {0, 0, 1};
  double along = vec_dot(axis, front), length = vec_length(axis);
  if (length > 0) front = vec_sum(front, 1, axis, -along / (length * length));
  double rest = vec_length(front);
  return lit_surface(rgb, rest > 1e-6 ? vec_scale(front, 1 / rest) : (LsysVec3){0, 0, 1});
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  Sorted *s = (Sorted *)canvas;
  if (!s->solid) return s->inner->line(s->inner, point, count, ink, joined);
  for (size_t i = 1; i < count; i++) {
    if (!keep(s, &point[i - 1], 2, ink->width, lit_segment(&point[i - 1], &point[i], ink->rgb))) return false;
  }
  return true;
}

// A polygon has one light: that of its mean normal, or of its plane (Newell's, with y up).
static LsysVec3 mean_normal(const LsysPoint *point, const LsysVec3 *normal, size_t count) {
  LsysVec3 sum = {0};
  for (size_t i = 0; i < count; i++) {
    const LsysPoint *a = &point[i], *b = &point[i + 1 < count ? i + 1 : 0];
    LsysVec3 edge = {-(a->y - b->y) * (a->z + b->z), (a->z - b->z) * (a->x + b->x), -(a->x - b->x) * (a->y + b->y)};
    sum = vec_sum(sum, 1, normal ? normal[i] : edge, 1);
  }
  return sum;
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  Sorted *s = (Sorted *)canvas;
  if (!s->solid) return s->inner->fill(s->inner, point, normal, count, rgb);
  LsysVec3 mean = mean_normal(point, normal, count);
  double length = vec_length(mean);
  if (length > 0) rgb = lit_surface(rgb, vec_scale(mean, 1 / length));
  return keep(s, point, count, 0, rgb);
}

// Equal depths stay in the order in which they were drawn, whatever the sort does.
static int from_back(const void *a, const void *b) {
  const Item *i = a, *k = b;
  if (i->depth != k->depth) return i->depth < k->depth ? -1 : 1;
  return (i->first > k->first) - (i->first < k->first);
}

static bool close_page(LsysCanvas *canvas) {
  Sorted *s = (Sorted *)canvas;
  if (s->items) qsort(s->item, s->items, sizeof *s->item, from_back);
  for (size_t i = 0; i < s->items; i++) {
    const Item *item = &s->item[i];
    LsysInk ink = {(double)item->width, item->rgb};
    const LsysPoint *point = s->point + item->first;
    bool well = item->width > 0 ? s->inner->line(s->inner, point, item->count, &ink, false)
                                : s->inner->fill(s->inner, point, NULL, item->count, item->rgb);
    if (!well) return false;
  }
  return s->inner->close(s->inner);
}

static void destroy(LsysCanvas *canvas) {
  Sorted *s = (Sorted *)canvas;
  s->inner->destroy(s->inner);
  lsys_memory_free(s->memory, s->item, s->item_room, sizeof *s->item);
  lsys_memory_free(s->memory, s->point, s->point_room, sizeof *s->point);
  free(s);
}

LsysCanvas *lsys_canvas_sorted(LsysCanvas *inner) {
  Sorted *s = calloc(1, sizeof *s);
  if (!s) {
    inner->destroy(inner);
    lsys_error("out of memory");
    return NULL;
  }
  s->canvas = (LsysCanvas){NULL, open_page, line, fill, close_page, destroy, NULL};
  s->inner = inner;
  return &s->canvas;
}
