// solid.c -- pixels with depth: cylinders and polygons, lit, the nearest one
// seen. Each pixel is a square of samples; a sample keeps colour and depth.
#include "core/memory.h"
#include "core/message.h"
#include "sinks/light.h"
#include "sinks/raster.h"
#include "turtle/triangulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FACTOR = 3, MOST_SAMPLES = 1 << 26 };  // samples along a pixel's side; in all (512 MiB), unless one a pixel

typedef struct Sample {
  float depth;  // larger is nearer
  uint32_t rgb;
} Sample;

typedef struct Solid {
  LsysRaster raster;
  LsysPage page;
  int factor, width, height;  // in samples
  LsysVec3 *corner;           // of a polygon
  size_t corner_room;
  PolygonCutter cutter;
  uint64_t booked;
  Sample sample[];
} Solid;

static int clamp(double x, int high) {
  return x < 0 ? 0 : x > high ? high : (int)x;
}

// The first sample whose centre is not before x.
static int sample_from(double x, int high) {
  return clamp(ceil(x - 0.5), high);
}

// ---- cylinders -----------------------------------------------------------

// A cylinder with round ends, in samples. Across it the normal goes from -side over front to side.
typedef struct Rod {
  float x, y, z, dx, dy, dz, inverse;  // its axis, and 1 / squared length of the axis on the page
  float radius;
  float side_x, side_y;  // unit, on the page
  double side_lamp, side_up, front_lamp, front_up;
  bool thin;  // too thin for shading across
  uint32_t rgb, middle;
} Rod;

static Rod rod_of(const LsysPoint *a, const LsysPoint *b, double radius, uint32_t rgb) {
  LsysVec3 axis = {b->x - a->x, -(b->y - a->y), b->z - a->z}, side = {1, 0, 0};
  double flat = axis.x * axis.x + axis.y * axis.y, length = vec_length(axis);
  if (flat > 1e-12) side = vec_scale((LsysVec3){axis.y, -axis.x, 0}, 1 / sqrt(flat));
  LsysVec3 front = {0, 0, 1};
  if (length > 0) front = vec_cross(side, vec_scale(axis, 1 / length));
  if (front.z < 0) front = vec_scale(front, -1);
  Rod rod = {.x = (float)a->x,
             .y = (float)a->y,
             .z = (float)a->z,
             .dx = (float)axis.x,
             .dy = (float)-axis.y,
             .dz = (float)axis.z,
             .inverse = flat > 1e-12 ? (float)(1 / flat) : 0,
             .radius = (float)radius,
             .side_x = (float)side.x,
             .side_y = (float)-side.y,
             .side_lamp = vec_dot(side, LAMP),
             .side_up = side.y,
             .front_lamp = vec_dot(front, LAMP),
             .front_up = front.y,
             .thin = radius < 1,
             .rgb = rgb};
  rod.middle = lit(rgb, light_on(rod.front_lamp, rod.front_up));
  return rod;
}

// The samples of a row that the rod can cover.
static void rod_row(Solid *s, const Rod *r, int y, int from, int to) {
  Sample *row = s->sample + (size_t)y * (size_t)s->width;
  float py = (float)y + 0.5f - r->y, radius2 = r->radius * r->radius;
  for (int x = from; x < to; x++) {
    float px = (float)x + 0.5f - r->x;
    float along = fminf(fmaxf((px * r->dx + py * r->dy) * r->inverse, 0), 1);
    float ex = px - along * r->dx, ey = py - along * r->dy, e2 = ex * ex + ey * ey;
    if (e2 > radius2) continue;
    float out = sqrtf(radius2 - e2), depth = r->z + along * r->dz + out;
    if (depth <= row[x].depth) continue;
    uint32_t rgb = r->middle;
    if (!r->thin) {
      double across = (double)((ex * r->side_x + ey * r->side_y) / r->radius), front = (double)(out / r->radius);
      rgb =
        lit(r->rgb, light_on(across * r->side_lamp + front * r->front_lamp, across * r->side_up + front * r->front_up));
    }
    row[x] = (Sample){depth, rgb};
  }
}

static void draw_rod(Solid *s, const Rod *r) {
  double x0 = (double)fminf(r->x, r->x + r->dx) - (double)r->radius,
         x1 = (double)fmaxf(r->x, r->x + r->dx) + (double)r->radius;
  double y0 = (double)fminf(r->y, r->y + r->dy) - (double)r->radius,
         y1 = (double)fmaxf(r->y, r->y + r->dy) + (double)r->radius;
  int top = sample_from(y0, s->height), bottom = clamp(floor(y1 + 0.5), s->height);
  double slope = fabsf(r->dy) > 1e-6f ? (double)(r->dx / r->dy) : 0;
  double half = (double)r->radius * sqrt(1 + slope * slope);
  for (int y = top; y < bottom; y++) {
    double from = x0, to = x1;
    if (fabsf(r->dy) > 1e-6f) {
      double middle = (double)r->x + (y + 0.5 - (double)r->y) * slope;
      from = fmax(from, middle - half);
      to = fmin(to, middle + half);
    }
    rod_row(s, r, y, sample_from(from, s->width), clamp(floor(to + 0.5), s->width));
  }
}

static LsysPoint in_samples(const Solid *s, const LsysPoint *p) {
  return (LsysPoint){p->x * s->factor, p->y * s->factor, p->z * s->factor};
}

static void line(LsysRaster *raster, const LsysPoint *point, size_t count, const LsysInk *ink) {
  Solid *s = (Solid *)raster;
  double radius = fmax(ink->width / 2 * s->factor, 0.5);
  for (size_t i = 1; i < count; i++) {
    LsysPoint a = in_samples(s, &point[i - 1]), b = in_samples(s, &point[i]);
    Rod rod = rod_of(&a, &b, radius, ink->rgb);
    draw_rod(s, &rod);
  }
}

// ---- polygons ------------------------------------------------------------

static double edge(const LsysVec3 *a, const LsysVec3 *b, double x, double y) {
  return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

// A triangle of a polygon; colour is its light, or normal those of its corners.
typedef struct Triangle {
  const LsysVec3 *a, *b, *c;
  const LsysVec3 *na, *nb, *nc;  // NULL: colour counts
  uint32_t rgb, colour;
} Triangle;

static uint32_t colour_at(const Triangle *t, double wa, double wb, double wc) {
  if (!t->na) return t->colour;
  LsysVec3 n = vec_sum(vec_sum(*t->na, wa, *t->nb, wb), 1, *t->nc, wc);
  double length = vec_length(n);
  return length > 0 ? lit_surface(t->rgb, vec_scale(n, 1 / length)) : t->colour;
}

static void draw_triangle(Solid *s, const Triangle *t) {
  const LsysVec3 *a = t->a, *b = t->b, *c = t->c;
  double area = edge(a, b, c->x, c->y);
  if (area == 0) return;
  int top = sample_from(fmin(a->y, fmin(b->y, c->y)), s->height);
  int bottom = clamp(floor(fmax(a->y, fmax(b->y, c->y)) + 0.5), s->height);
  int left = sample_from(fmin(a->x, fmin(b->x, c->x)), s->width);
  int right = clamp(floor(fmax(a->x, fmax(b->x, c->x)) + 0.5), s->width);
  for (int y = top; y < bottom; y++) {
    Sample *row = s->sample + (size_t)y * (size_t)s->width;
    for (int x = left; x < right; x++) {
      double px = x + 0.5, py = y + 0.5;
      double wa = edge(b, c, px, py) / area, wb = edge(c, a, px, py) / area, wc = edge(a, b, px, py) / area;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      float depth = (float)(wa * a->z + wb * b->z + wc * c->z);
      if (depth > row[x].depth) row[x] = (Sample){depth, colour_at(t, wa, wb, wc)};
    }
  }
}

static bool fill(LsysRaster *raster, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  Solid *s = (Solid *)raster;
  if (count < 3) return true;
  if (!lsys_memory_fit(s->page.memory, &s->corner, &s->corner_room, count, sizeof *s->corner)) return false;
  for (size_t i = 0; i < count; i++) {
    LsysPoint p = in_samples(s, &point[i]);
    s->corner[i] = (LsysVec3){p.x, p.y, p.z};
  }
  LsysVec3 n = polygon_normal(s->corner, count);
  double length = vec_length(n);
  if (!(length > 0)) return true;
  uint32_t colour = lit_surface(rgb, vec_scale((LsysVec3){n.x, -n.y, n.z}, 1 / length));
  if (!polygon_triangles(&s->cutter, s->corner, (uint32_t)count)) return false;
  for (size_t i = 0; i + 2 < count; i++) {
    const uint32_t *t = s->cutter.triangle + 3 * i;
    Triangle part = {&s->corner[t[0]], &s->corner[t[1]], &s->corner[t[2]], NULL, NULL, NULL, rgb, colour};
    if (normal) {
      part.na = &normal[t[0]];
      part.nb = &normal[t[1]];
      part.nc = &normal[t[2]];
    }
    draw_triangle(s, &part);
  }
  return true;
}

// ---- rows ----------------------------------------------------------------

// The mean of a pixel's samples; where the page is transparent, of those that are covered.
static void row(const LsysRaster *raster, uint32_t y, uint8_t *rgba) {
  const Solid *s = (const Solid *)raster;
  const uint32_t all = (uint32_t)(s->factor * s->factor);
  for (uint32_t x = 0; x < s->page.width; x++) {
    uint32_t sum[3] = {0}, covered = 0;
    for (uint32_t i = 0; i < all; i++) {
      size_t sx = x * (uint32_t)s->factor + i % (uint32_t)s->factor,
             sy = y * (uint32_t)s->factor + i / (uint32_t)s->factor;
      const Sample *sample = &s->sample[sy * (size_t)s->width + sx];
      bool hit = sample->depth > -INFINITY;
      if (!hit && s->page.transparent) continue;
      covered++;
      for (int c = 0; c < 3; c++) sum[c] += sample->rgb >> (16 - 8 * c) & 255;
    }
    for (int c = 0; c < 3; c++) rgba[4 * x + (uint32_t)c] = (uint8_t)(covered ? (sum[c] + covered / 2) / covered : 0);
    rgba[4 * x + 3] = (uint8_t)((covered * 255 + all / 2) / all);
  }
}

static void destroy(LsysRaster *raster) {
  Solid *s = (Solid *)raster;
  LsysMemory *memory = s->page.memory;
  lsys_memory_free(memory, s->corner, s->corner_room, sizeof *s->corner);
  polygon_cutter_free(&s->cutter);
  lsys_memory_give(memory, s->booked);
  free(s);
}

LsysRaster *lsys_raster_solid(const LsysPage *page) {
  uint64_t pixels = (uint64_t)page->width * page->height;
  int factor = page->antialias ? MOST_FACTOR : 1;
  while (factor > 1 && pixels * (uint64_t)(factor * factor) > MOST_SAMPLES) factor--;
  uint64_t samples = pixels * (uint64_t)(factor * factor), bytes = sizeof(Solid) + samples * sizeof(Sample);
  if (!lsys_raster_book(page, bytes)) return NULL;
  Solid *s = malloc((size_t)bytes);
  if (!s) {
    lsys_memory_give(page->memory, bytes);
    lsys_error("a picture of %ux%u pixels does not fit into memory", page->width, page->height);
    return NULL;
  }
  *s = (Solid){.raster = {.line = line, .fill = fill, .row = row, .destroy = destroy},
               .page = *page,
               .cutter = {.memory = page->memory},
               .booked = bytes,
               .factor = factor,
               .width = (int)page->width * factor,
               .height = (int)page->height * factor};
  for (uint64_t i = 0; i < samples; i++) s->sample[i] = (Sample){-INFINITY, page->background};
  return &s->raster;
}
