// raster.c -- lines and polygons to pixels, by exact coverage along one axis:
// a line covers a pixel by how much of the pixel's width lies within half the
// line's width of its axis; a polygon by horizontal spans on quarter rows.
//
// Each pixel holds a base and a top colour that covers a part of it. Drawing in
// the top colour raises that part to the larger of the two, so that the joints
// of a curve and lines drawn over each other do not darken their edges; another
// colour first merges top and base.
#include "sinks/raster.h"

#include "core/memory.h"
#include "core/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  SUBROWS = 4,
  NOTHING_SEEN = 8,  // of 255
};

typedef struct Pixel {
  uint32_t base;  // 0xAARRGGBB, not premultiplied
  uint32_t top;   // 0xCCRRGGBB, CC: how much of the pixel it covers
} Pixel;

// An edge of a polygon that is being filled, from y0 to y1 > y0 downwards.
typedef struct Edge {
  double y0, y1, x, slope;
  int winding;
} Edge;

// Where one crosses a subrow.
typedef struct Crossing {
  double x;
  int winding;
  uint32_t edge;
} Crossing;

typedef struct Raster {
  LsysRaster raster;
  int width, height;
  bool antialias;
  Edge *edge;
  uint32_t *active;  // edges that the row crosses, as far as it is known from left to right
  Crossing *crossing;
  size_t edge_room, active_room, crossing_room;
  LsysMemory *memory;
  uint64_t booked;  // of this and cover
  float *cover;     // of one row of a fill
  Pixel pixel[];
} Raster;

// ---- pixels --------------------------------------------------------------

// Top over base (Porter and Duff 1984), alpha in 0..255.
static uint32_t merge(uint32_t base, uint32_t top) {
  uint32_t a = top >> 24, b = base >> 24, rest = b * (255 - a), all = a * 255 + rest;
  if (!all) return base;
  uint32_t out = (all + 127) / 255 << 24;
  for (int shift = 0; shift < 24; shift += 8) {
    uint32_t t = top >> shift & 255, u = base >> shift & 255;
    out |= (t * a * 255 + u * rest + all / 2) / all << shift;
  }
  return out;
}

// The pixel's top layer in this colour: merges what is there if it has another one.
static inline uint32_t cover_of(Pixel *p, uint32_t rgb) {
  if ((p->top & 0xffffff) != rgb) {
    if (p->top >> 24) p->base = merge(p->base, p->top);
    p->top = rgb;
  }
  return p->top >> 24;
}

static inline uint32_t to_byte(const Raster *r, float cover) {
  if (!r->antialias) return cover >= 0.5f ? 255 : 0;
  return (uint32_t)((cover < 1 ? cover : 1) * 255 + 0.5f);
}

static void row(const LsysRaster *raster, uint32_t y, uint8_t *rgba) {
  const Raster *r = (const Raster *)raster;
  const Pixel *p = r->pixel + (size_t)y * (size_t)r->width;
  for (int x = 0; x < r->width; x++) {
    uint32_t c = p[x].top >> 24 ? merge(p[x].base, p[x].top) : p[x].base;
    rgba[4 * x] = (uint8_t)(c >> 16);
    rgba[4 * x + 1] = (uint8_t)(c >> 8);
    rgba[4 * x + 2] = (uint8_t)c;
    rgba[4 * x + 3] = (uint8_t)(c >> 24);
  }
}

// ---- lines ---------------------------------------------------------------

static int clamp(double x, int low, int high) {
  return x < low ? low : x > high ? high : (int)x;
}

// The first pixel whose centre lies behind x, up to limit.
static inline int centre_behind(double x, int limit) {
  return x > -0.5 ? x < limit ? (int)(x + 0.5) : limit : 0;
}

static inline int within(int x, int low, int high) {
  return x < low ? low : x > high ? high : x;
}

// Where the pixels whose centres a segment can touch begin and end on a row.
typedef struct Span {
  int from, to;
} Span;

// The box around a segment, and the two parallels at a distance of its axis.
typedef struct Strip {
  double left, right;
  double x, y, slope, half;  // the axis goes through (x,y); slope: columns a row; half: columns beside the axis
} Strip;

static Strip strip_of(const LsysPoint *a, const LsysPoint *b, double reach) {
  double dx = b->x - a->x, dy = b->y - a->y;
  Strip s = {(dx < 0 ? b->x : a->x) - reach, (dx < 0 ? a->x : b->x) + reach, a->x, a->y, 0, INFINITY};
  if (fabs(dy) > 1e-9) {
    s.slope = dx / dy;
    s.half = reach * sqrt(1 + s.slope * s.slope);
  }
  return s;
}

static inline Span span_of(const Raster *r, const Strip *s, double y) {
  double middle = s->x + (y - s->y) * s->slope, left = middle - s->half, right = middle + s->half;
  return (Span){centre_behind(left > s->left ? left : s->left, r->width),
                centre_behind(right < s->right ? right : s->right, r->width)};
}

static inline float between(float x, float low, float high) {
  x = x > low ? x : low;
  return x < high ? x : high;
}

// How much of a pixel a line covers whose axis is that far from its middle.
static inline float cover_at(float distance, float radius) {
  float near = distance - 0.5f > -radius ? distance - 0.5f : -radius;
  float far = distance + 0.5f < radius ? distance + 0.5f : radius;
  return far - near;
}

// In rows from .. end-1.
static void segment(Raster *r, const LsysPoint *a, const LsysPoint *b, double width, uint32_t rgb, int from, int end) {
  const double half = width / 2, reach = half + 0.5;
  const float dx = (float)(b->x - a->x), dy = (float)(b->y - a->y), squared = dx * dx + dy * dy;
  const int top = within(centre_behind((dy < 0 ? b->y : a->y) - reach, r->height), from, end);
  const int bottom = within(centre_behind((dy < 0 ? a->y : b->y) + reach, r->height), from, end);
  if (top == bottom) return;
  const float inverse = squared > 0 ? 1 / squared : 0, radius = (float)half;
  const Strip strip = strip_of(a, b, reach);
  for (int y = top; y < bottom; y++) {
    Span span = span_of(r, &strip, y + 0.5);
    Pixel *p = r->pixel + (size_t)y * (size_t)r->width;
    float py = (float)(y + 0.5 - a->y), px = (float)(span.from + 0.5 - a->x);
    for (int x = span.from; x < span.to; x++, px += 1) {
      float along = between((px * dx + py * dy) * inverse, 0, 1);
      float ex = px - along * dx, ey = py - along * dy, distance = sqrtf(ex * ex + ey * ey);
      float cover = cover_at(distance, radius);
      if (cover <= 0) continue;
      uint32_t part = to_byte(r, cover);
      if (part > cover_of(&p[x], rgb)) p[x].top = part << 24 | rgb;
    }
  }
}

// Without anti-aliasing a thinner line would have gaps.
static double width_of(const Raster *r, const LsysInk *ink) {
  return r->antialias ? ink->width : fmax(ink->width, 1);
}

static void line_within(LsysRaster *raster, const LsysPoint *point, size_t count, const LsysInk *ink, int from,
                        int end) {
  Raster *r = (Raster *)raster;
  double width = width_of(r, ink);
  for (size_t i = 1; i < count; i++) segment(r, &point[i - 1], &point[i], width, ink->rgb, from, end);
}

static void line(LsysRaster *raster, const LsysPoint *point, size_t count, const LsysInk *ink) {
  line_within(raster, point, count, ink, 0, ((Raster *)raster)->height);
}

// No pixel could be covered by more than NOTHING_SEEN above what it is.
static bool covered(const LsysRaster *raster, const LsysPoint *middle, double radius, const LsysInk *ink) {
  const Raster *r = (const Raster *)raster;
  const double half = width_of(r, ink) / 2, reach = radius + half + 0.5;
  const int left = clamp(floor(middle->x - reach), 0, r->width), right = clamp(ceil(middle->x + reach), 0, r->width);
  const int top = clamp(floor(middle->y - reach), 0, r->height);
  const int bottom = clamp(ceil(middle->y + reach), 0, r->height);
  for (int y = top; y < bottom; y++) {
    const Pixel *p = r->pixel + (size_t)y * (size_t)r->width;
    const float dy = (float)(y + 0.5 - middle->y);
    float dx = (float)(left + 0.5 - middle->x);
    for (int x = left; x < right; x++, dx += 1) {
      float nearest = fmaxf(sqrtf(dx * dx + dy * dy) - (float)radius, 0), cover = cover_at(nearest, (float)half);
      if (cover <= 0) continue;
      uint32_t most = to_byte(r, cover), is = (p[x].top & 0xffffff) == ink->rgb ? p[x].top >> 24 : 0;
      if (most > is + NOTHING_SEEN) return false;
    }
  }
  return true;
}

// ---- polygons ------------------------------------------------------------

static int by_top(const void *a, const void *b) {
  const Edge *e = a, *f = b;
  return (e->y0 > f->y0) - (e->y0 < f->y0);
}

static size_t make_edges(Raster *r, const LsysPoint *point, size_t count) {
  size_t edges = 0;
  for (size_t i = 0; i < count; i++) {
    const LsysPoint *a = &point[i], *b = &point[i + 1 < count ? i + 1 : 0];
    if (a->y == b->y) continue;
    const LsysPoint *up = a->y < b->y ? a : b, *down = up == a ? b : a;
    r->edge[edges++] = (Edge){up->y, down->y, up->x, (down->x - up->x) / (down->y - up->y), up == a ? 1 : -1};
  }
  qsort(r->edge, edges, sizeof *r->edge, by_top);
  return edges;
}

// Adds a span of one subrow to the cover of its row, pixels at the ends in part.
static void add_span(const Raster *r, double from, double to) {
  const float weight = 1.0f / SUBROWS;
  from = fmax(from, 0);
  to = fmin(to, r->width);
  if (from >= to) return;
  int first = (int)from, last = (int)to;
  if (first == last) {
    r->cover[first] += weight * (float)(to - from);
    return;
  }
  r->cover[first] += weight * (float)(first + 1 - from);
  for (int x = first + 1; x < last; x++) r->cover[x] += weight;
  r->cover[last] += weight * (float)(to - last);
}

static int by_x(const void *a, const void *b) {
  const Crossing *c = a, *d = b;
  if (c->x != d->x) return c->x < d->x ? -1 : 1;
  return (c->edge > d->edge) - (c->edge < d->edge);
}

// From left to right; crossings are mostly in order. True if they all were.
static bool sort(Crossing *crossing, size_t count) {
  size_t moves = 0;
  for (size_t i = 1; i < count; i++) {
    Crossing c = crossing[i];
    size_t at = i;
    for (; at && crossing[at - 1].x > c.x; at--) crossing[at] = crossing[at - 1];
    crossing[at] = c;
    moves += i - at;
    if (moves <= 4 * count) continue;
    qsort(crossing, count, sizeof *crossing, by_x);
    return false;
  }
  return moves == 0;
}

// Edges that cross the subrow go to the front in the order in which they do, so that they stand right for the next one.
static void reorder(const Raster *r, size_t active, size_t crossed, double y) {
  size_t end = active;
  for (size_t i = active; i--;) {
    const Edge *e = &r->edge[r->active[i]];
    if (y < e->y0 || y >= e->y1) r->active[--end] = r->active[i];
  }
  for (size_t i = 0; i < crossed; i++) r->active[i] = r->crossing[i].edge;
}

static size_t sorted_crossings(const Raster *r, size_t active, double y) {
  size_t n = 0;
  for (size_t i = 0; i < active; i++) {
    const Edge *e = &r->edge[r->active[i]];
    if (y < e->y0 || y >= e->y1) continue;
    r->crossing[n++] = (Crossing){e->x + (y - e->y0) * e->slope, e->winding, r->active[i]};
  }
  if (!sort(r->crossing, n)) reorder(r, active, n, y);
  return n;
}

static void fill_subrow(const Raster *r, size_t active, double y) {
  size_t n = sorted_crossings(r, active, y);
  int winding = 0;
  for (size_t i = 0; i + 1 < n; i++) {
    winding += r->crossing[i].winding;
    if (winding) add_span(r, r->crossing[i].x, r->crossing[i + 1].x);
  }
}

// Neighbouring polygons of one colour share their edges' pixels: their parts add up.
static void paint_row(Raster *r, int y, uint32_t rgb) {
  Pixel *p = r->pixel + (size_t)y * (size_t)r->width;
  for (int x = 0; x < r->width; x++) {
    if (r->cover[x] <= 0) continue;
    uint32_t part = to_byte(r, r->cover[x]);
    r->cover[x] = 0;
    if (!part) continue;
    uint32_t both = cover_of(&p[x], rgb) + part;
    p[x].top = (both > 255 ? 255 : both) << 24 | rgb;
  }
  r->cover[r->width] = 0;
}

// Forgets active edges whose lower end is above y.
static size_t drop_passed(const Raster *r, size_t active, double y) {
  size_t kept = 0;
  for (size_t i = 0; i < active; i++)
    if (r->edge[r->active[i]].y1 > y) r->active[kept++] = r->active[i];
  return kept;
}

static bool fill(LsysRaster *raster, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  (void)normal;
  Raster *r = (Raster *)raster;
  if (!lsys_memory_fit(r->memory, &r->edge, &r->edge_room, count, sizeof *r->edge)
      || !lsys_memory_fit(r->memory, &r->active, &r->active_room, count, sizeof *r->active)
      || !lsys_memory_fit(r->memory, &r->crossing, &r->crossing_room, count, sizeof *r->crossing))
    return false;
  size_t edges = make_edges(r, point, count);
  if (!edges) return true;
  double last = r->edge[0].y1;
  for (size_t i = 1; i < edges; i++) last = fmax(last, r->edge[i].y1);
  int top = clamp(floor(r->edge[0].y0), 0, r->height), bottom = clamp(ceil(last), 0, r->height);
  size_t next = 0, active = 0;  // edge[next..) come later
  for (int y = top; y < bottom; y++) {
    active = drop_passed(r, active, y);
    while (next < edges && r->edge[next].y0 < y + 1) r->active[active++] = (uint32_t)next++;
    for (int k = 0; k < SUBROWS; k++) fill_subrow(r, active, y + (k + 0.5) / SUBROWS);
    paint_row(r, y, rgb);
  }
  return true;
}

// --------------------------------------------------------------------------

static void destroy(LsysRaster *raster) {
  Raster *r = (Raster *)raster;
  LsysMemory *memory = r->memory;
  lsys_memory_free(memory, r->edge, r->edge_room, sizeof *r->edge);
  lsys_memory_free(memory, r->active, r->active_room, sizeof *r->active);
  lsys_memory_free(memory, r->crossing, r->crossing_room, sizeof *r->crossing);
  free(r->cover);
  lsys_memory_give(memory, r->booked);
  free(r);
}

bool lsys_raster_book(const LsysPage *page, uint64_t bytes) {
  if (bytes < SIZE_MAX && lsys_memory_take(page->memory, bytes)) return true;
  lsys_error("a picture of %ux%u pixels takes %.3g MiB, which is more than --max-memory leaves", page->width,
             page->height, (double)bytes / (1 << 20));
  return false;
}

LsysRaster *lsys_raster_flat(const LsysPage *page) {
  uint64_t pixels = (uint64_t)page->width * page->height, covers = (uint64_t)page->width + 2;
  uint64_t bytes = sizeof(Raster) + pixels * sizeof(Pixel) + covers * sizeof(float);
  if (!lsys_raster_book(page, bytes)) return NULL;
  Raster *r = malloc(sizeof *r + (size_t)pixels * sizeof *r->pixel);
  float *cover = calloc((size_t)covers, sizeof *cover);
  if (!r || !cover) {
    free(r);
    free(cover);
    lsys_memory_give(page->memory, bytes);
    lsys_error("a picture of %ux%u pixels does not fit into memory", page->width, page->height);
    return NULL;
  }
  *r = (Raster){.raster = {line, line_within, fill, row, destroy, covered},
                .width = (int)page->width,
                .height = (int)page->height,
                .antialias = page->antialias,
                .memory = page->memory,
                .booked = bytes,
                .cover = cover};
  uint32_t base = page->background | (page->transparent ? 0 : 0xff000000u);
  for (uint64_t i = 0; i < pixels; i++) r->pixel[i] = (Pixel){base, 0};
  return &r->raster;
}
