// picture.c -- turtle space to pages: two passes over the words, one to measure
// and one to draw. Requires that the first pass of all start words comes before
// the second pass of any: their figures share one page and one scale.
#include "sinks/picture.h"

#include "core/message.h"
#include "turtle/measure.h"
#include "turtle/turtle.h"

#include <math.h>
#include <stdlib.h>

enum {
  LONG_SIDE = 1000,  // pixels of a page without --size
  SHORT_SIDE = 120,  // a page is never narrower
  BATCH = 1024,      // points handed to the canvas at once
};

static const double MARGIN = 0.04, GAP = 0.08;  // of the longer side; of the wider figure

const LsysPictureOptions lsys_picture_defaults = {.line_width = NAN, .background = 0xffffff, .antialias = true};

// Where a figure lies: a point p of the turtle is at (x + p.x * scale, y - p.y * scale) on the page.
typedef struct Figure {
  bool drawn;
  LsysVec3 low, high;
  double x, y;
} Figure;

typedef struct Picture {
  LsysSink sink;
  LsysGeometry geometry;
  LsysPictureOptions options;
  LsysCanvas *canvas;
  LsysTurtle *turtle;
  LsysMeasure measure;
  Figure *figure;  // of each start word
  uint32_t figures, current;
  bool open, failed;
  uint64_t segments;
  double length, thinnest, thickest;
  double scale, unit;  // pixels of a step, pixels of a width of 1
  LsysPage page;
  LsysPoint *corner;  // of a polygon
  size_t corner_room;
} Picture;

// ---- fitting -------------------------------------------------------------

static void sum_up(Picture *p) {
  const LsysMeasure *m = &p->measure;
  if (!lsys_measure_any(m)) return;
  p->figure[p->current] = (Figure){.drawn = true, .low = m->low, .high = m->high};
  p->segments += m->segments;
  p->length += m->length;
  p->thinnest = fmin(p->thinnest, m->thinnest);
  p->thickest = fmax(p->thickest, m->thickest);
  if (!lsys_measure_finite(m)) {
    lsys_error("the figure of axiom %u reaches to infinity: it cannot be drawn", p->current + 1);
    p->failed = true;
  }
}

typedef struct Extent {
  double width, height, gap;
} Extent;

// Size of all figures side by side, in the turtle's units.
static Extent extent_of(const Picture *p) {
  Extent e = {0};
  double widest = 0;
  uint32_t drawn = 0;
  for (uint32_t i = 0; i < p->figures; i++) {
    const Figure *f = &p->figure[i];
    if (!f->drawn) continue;
    double width = f->high.x - f->low.x;
    widest = fmax(widest, width);
    e.width += width;
    e.height = fmax(e.height, f->high.y - f->low.y);
    drawn++;
  }
  e.gap = GAP * fmax(widest, e.height);
  if (drawn > 1) e.width += (drawn - 1) * e.gap;
  return e;
}

static uint32_t side(double pixels) {
  return pixels < SHORT_SIDE ? SHORT_SIDE : (uint32_t)ceil(pixels);
}

static void set_scale(Picture *p, const Extent *e) {
  LsysPage *page = &p->page;
  page->width = p->options.width;
  page->height = p->options.height;
  double longest = fmax(page->width, page->height);
  if (longest == 0) longest = LONG_SIDE;
  double margin = MARGIN * longest, room_x = longest - 2 * margin, room_y = room_x;
  if (page->width) {
    margin = MARGIN * fmin(page->width, page->height);
    room_x = page->width - 2 * margin;
    room_y = page->height - 2 * margin;
  }
  p->scale = fmin(room_x / e->width, room_y / e->height);  // a width or height of 0 gives inf: it does not bind
  if (!isfinite(p->scale) || p->scale <= 0) p->scale = 1;
  if (!page->width) {
    page->width = side(e->width * p->scale + 2 * margin);
    page->height = side(e->height * p->scale + 2 * margin);
  }
}

static void place_figures(Picture *p, const Extent *e) {
  double x = (p->page.width - e->width * p->scale) / 2;
  double bottom = (p->page.height + e->height * p->scale) / 2;
  for (uint32_t i = 0; i < p->figures; i++) {
    Figure *f = &p->figure[i];
    if (!f->drawn) continue;
    f->x = x - f->low.x * p->scale;
    f->y = bottom + f->low.y * p->scale;
    x += (f->high.x - f->low.x + e->gap) * p->scale;
  }
}

// How many pixels a width of 1 is, unless the user says so: 1/800 of the page; more where
// twigs would vanish, less where the trunk would swell or a dense curve fill its own gaps.
static void set_line_width(Picture *p) {
  double page = fmax(p->page.width, p->page.height), unit = page / 800;
  p->page.detail = p->segments ? p->length / (double)p->segments * p->scale : page;
  if (isfinite(p->options.line_width)) {
    p->unit = p->options.line_width;
    return;
  }
  if (p->thickest > 0) {
    bool varied = p->thinnest > 0 && p->thinnest < p->thickest;
    if (varied) unit = fmax(unit, 0.5 * page / 1000 / p->thinnest);
    unit = fmin(unit, page / 40 / p->thickest);
    if (!varied) unit = fmin(unit, fmax(0.5, 0.35 * p->page.detail) / p->thickest);
  }
  p->unit = unit;
}

static bool open_page(Picture *p) {
  if (p->failed) return false;
  Extent e = extent_of(p);
  p->page = (LsysPage){
    .background = p->options.background, .transparent = p->options.transparent, .antialias = p->options.antialias};
  set_scale(p, &e);
  place_figures(p, &e);
  set_line_width(p);
  p->open = true;
  return p->canvas->open(p->canvas, &p->page);
}

// ---- drawing -------------------------------------------------------------

static LsysPoint to_page(const Picture *p, const LsysVec3 *v) {
  const Figure *f = &p->figure[p->current];
  return (LsysPoint){f->x + v->x * p->scale, f->y - v->y * p->scale};
}

// A width of 0 is still seen.
static LsysInk ink_of(const Picture *p, const LsysPen *pen) {
  return (LsysInk){fmax(pen->width * p->unit, 0.05), lsys_palette(pen->colour)};
}

static bool draw_stroke(Picture *p, const LsysVec3 *v, size_t count, const LsysPen *pen, bool joined) {
  LsysPoint point[BATCH];
  LsysInk ink = ink_of(p, pen);
  for (size_t from = 0; from + 1 < count;) {
    size_t n = count - from < BATCH ? count - from : BATCH;
    for (size_t i = 0; i < n; i++) point[i] = to_page(p, &v[from + i]);
    if (!p->canvas->line(p->canvas, point, n, &ink, joined || from)) return false;
    from += n - 1;  // the next part begins where this one ends
  }
  return true;
}

static bool strokes(LsysGeometry *geometry, const LsysStrokes *batch) {
  Picture *p = (Picture *)((char *)geometry - offsetof(Picture, geometry));
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    if (!draw_stroke(p, batch->point + s->first, s->count, &s->pen, s->joined)) return false;
  }
  return true;
}

static bool polygon(LsysGeometry *geometry, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  Picture *p = (Picture *)((char *)geometry - offsetof(Picture, geometry));
  if (count > p->corner_room) {
    LsysPoint *grown = count < SIZE_MAX / sizeof *grown ? realloc(p->corner, count * sizeof *grown) : NULL;
    if (!grown) {
      lsys_error("out of memory for a polygon of %zu vertices", count);
      return false;
    }
    p->corner = grown;
    p->corner_room = count;
  }
  for (size_t i = 0; i < count; i++) p->corner[i] = to_page(p, &vertices[i]);
  return p->canvas->fill(p->canvas, p->corner, count, lsys_palette(pen->colour));
}

// ---- the sink ------------------------------------------------------------

static bool start(Picture *p, const LsysRun *run) {
  if (p->turtle) return true;
  p->figures = run->grammar->axiom_count;
  p->figure = calloc(p->figures + 1, sizeof *p->figure);
  if (!p->figure) {
    lsys_error("out of memory");
    return false;
  }
  p->turtle = lsys_turtle_create(run);
  return p->turtle != NULL;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  Picture *p = (Picture *)sink;
  if (!start(p, run)) return false;
  p->current = axiom;
  if (pass == 0) {
    lsys_measure_begin(&p->measure, true);
    lsys_turtle_begin(p->turtle, axiom, &p->measure.geometry);
    return true;
  }
  if (!p->open && !open_page(p)) return false;
  lsys_turtle_begin(p->turtle, axiom, &p->geometry);
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((Picture *)sink)->turtle, part);
}

static bool end(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  if (!lsys_turtle_end(p->turtle)) return false;
  if (!p->open) sum_up(p);
  return !p->failed;
}

static bool finish(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  if (!p->open && !open_page(p)) return false;
  return p->canvas->close(p->canvas);
}

static void destroy(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  lsys_turtle_destroy(p->turtle);
  p->canvas->destroy(p->canvas);
  free(p->figure);
  free(p->corner);
  free(p);
}

LsysSink *lsys_picture_create(LsysCanvas *canvas, const LsysPictureOptions *options) {
  Picture *p = aligned_alloc(_Alignof(Picture), sizeof *p);
  if (!p) {
    canvas->destroy(canvas);
    lsys_error("out of memory");
    return NULL;
  }
  *p = (Picture){.sink = {2, begin, take, end, finish, destroy},
                 .geometry = {strokes, polygon},
                 .options = *options,
                 .canvas = canvas,
                 .thinnest = INFINITY};
  return &p->sink;
}
