// shared_png.c -- a deterministic figure of any number of segments as a picture
// of pixels: a descent through its parts that stops where nobody sees more.
//
// A part that is smaller than a grain, an eighth of a pixel, is drawn as one dot
// of its pen; so no point of a line is drawn farther than half of that from its
// place, and the colour of a pixel is off by that share of the ink at most. The
// grain is coarser for figures so dense that there would be too many. Parts of a
// few pixels are left out where these are covered as far as the pen can.
// Source of the idea: Clark, "Hierarchical geometric models for visible surface
// algorithms", CACM 19 (1976).
#include "core/fit.h"
#include "core/memory.h"
#include "sinks/layout.h"
#include "sinks/shared.h"
#include "turtle/vector.h"

#include <math.h>
#include <string.h>

static const double FINEST = 0.125, COARSEST = 0.5, FEW = 16;  // pixels
static const double MOST_PARTS = 1 << 24;                      // that are descended into

// A circle around what a part draws, in the part's own coordinates.
typedef struct Disc {
  double x, y;
  double radius;  // < 0: it draws nothing
} Disc;

typedef struct Pixels {
  LsysGeometry geometry;
  LsysWalk walk;
  LsysParts *parts;
  LsysCanvas *canvas;
  LsysLayout layout;
  LsysPage page;
  LsysPalette palette;
  const LsysFigure *figure;  // that is being drawn
  Disc *disc;                // [steps * kinds + kind]
  bool one_pen;              // nothing changes it
  double grain;              // pixels
} Pixels;

static Pixels *pixels_of(LsysGeometry *geometry) {
  return (Pixels *)((char *)geometry - offsetof(Pixels, geometry));
}

// ---- drawing -------------------------------------------------------------

static LsysPoint on_page(const Pixels *p, LsysVec3 v) {
  return (LsysPoint){p->figure->x + v.x * p->layout.scale, p->figure->y - v.y * p->layout.scale, 0};
}

static LsysInk ink_of(const Pixels *p, double width, uint8_t colour) {
  return lsys_layout_ink(&p->page, width * p->layout.unit, p->palette.rgb[colour]);
}

static bool dot(Pixels *p, LsysPoint at, const LsysInk *ink) {
  const LsysPoint ends[2] = {at, at};
  return p->canvas->line(p->canvas, ends, 2, ink, false);
}

static bool is_grain(const Pixels *p, const LsysVec3 *v, uint32_t count) {
  const double reach = p->grain / 2 / p->layout.scale;
  for (uint32_t k = 1; k < count; k++)
    if (fabs(v[k].x - v->x) + fabs(v[k].y - v->y) > reach) return false;
  return true;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  Pixels *p = pixels_of(to);
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *v = batch->point + s->first;
    LsysInk ink = ink_of(p, s->pen.width, s->pen.colour);
    if (is_grain(p, v, s->count)) {
      if (!dot(p, on_page(p, *v), &ink)) return false;
      continue;
    }
    for (uint32_t k = 1; k < s->count; k++) {
      LsysPoint ends[2] = {on_page(p, v[k - 1]), on_page(p, v[k])};
      if (!p->canvas->line(p->canvas, ends, 2, &ink, k > 1)) return false;
    }
  }
  return true;
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  Pixels *p = pixels_of(to);
  LsysMemory *memory = p->parts->run->memory;
  LsysPoint *point = lsys_memory_alloc(memory, count, sizeof *point);
  if (!point) return false;
  for (size_t i = 0; i < count; i++) point[i] = on_page(p, vertices[i]);
  bool well = p->canvas->fill(p->canvas, point, NULL, count, p->palette.rgb[pen->colour]);
  lsys_memory_free(memory, point, count, sizeof *point);
  return well;
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  (void)disc;
  Pixels *p = pixels_of(to);
  LsysInk ink = lsys_layout_ink(&p->page, diameter * p->layout.scale, p->palette.rgb[pen->colour]);
  return dot(p, on_page(p, *centre), &ink);
}

// ---- descending ----------------------------------------------------------

static bool child(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  Pixels *p = data;
  const Disc *d = &p->disc[steps * p->parts->kinds + kind];
  if (d->radius < 0) return true;
  LsysPoint middle = on_page(p, vec_sum(vec_sum(pose->at, 1, pose->l, -d->x), 1, pose->h, d->y));
  LsysInk ink = ink_of(p, pose->width, pose->colour);
  double radius = d->radius * p->layout.scale;
  if (2 * radius <= p->grain) return dot(p, middle, &ink);
  if (p->one_pen && 2 * radius <= FEW && p->canvas->covered(p->canvas, &middle, radius, &ink)) return true;
  LsysWord word = lsys_parts_word(p->parts, kind);
  LsysPose inner = *pose;
  return lsys_parts_walk(p->parts, &word, steps - 1, &inner, &p->walk);
}

static bool draw_figure(Pixels *p, uint32_t axiom, const LsysPose *start) {
  p->figure = &p->layout.figure[axiom];
  if (!p->figure->drawn) return true;
  LsysPose pose = *start;
  lsys_parts_begin(p->parts, &p->walk);
  return lsys_parts_walk(p->parts, &p->parts->run->grammar->axioms[axiom].word, p->parts->steps, &pose, &p->walk);
}

// ---- preparing -----------------------------------------------------------

static bool changes_pen(const LsysGrammar *grammar) {
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    LsysTurtleOp op = (LsysTurtleOp)grammar->kinds[i].turtle;
    if (op == LSYS_TURTLE_WIDTH || op == LSYS_TURTLE_WIDTH_UP || op == LSYS_TURTLE_COLOUR_UP
        || op == LSYS_TURTLE_COLOUR_DOWN || op == LSYS_TURTLE_COLOUR_NEXT || op == LSYS_TURTLE_POLYGON_BEGIN)
      return true;
  }
  return false;
}

static bool make_discs(Pixels *p) {
  const LsysParts *parts = p->parts;
  p->disc = lsys_memory_alloc(parts->run->memory, parts->parts, sizeof *p->disc);
  if (!p->disc) return false;
  for (size_t i = 0; i < parts->parts; i++) {
    LsysVec3 low, high;
    p->disc[i].radius = -1;
    if (!lsys_parts_expands(parts, (uint32_t)(i % parts->kinds))) continue;
    if (!lsys_support_box(&parts->directions, parts->part[i].support, &low, &high)) continue;
    p->disc[i] = (Disc){(low.x + high.x) / 2, (low.y + high.y) / 2, hypot(high.x - low.x, high.y - low.y) / 2};
  }
  return true;
}

// How many parts are bigger than the grain, wherever they lie.
static double count_parts(const Pixels *p, uint32_t first, uint32_t end, double *counts, double *next) {
  const LsysParts *parts = p->parts;
  double sum = 0;
  memset(counts, 0, parts->kinds * sizeof *counts);
  for (uint32_t i = first; i < end; i++) lsys_fit_axiom(parts->run->grammar, i, counts);
  for (uint64_t left = parts->steps; left > 0 && sum <= MOST_PARTS; left--) {
    for (uint32_t kind = 0; kind < parts->kinds; kind++)
      if (2 * p->disc[left * parts->kinds + kind].radius * p->layout.scale > p->grain) sum += counts[kind];
    lsys_fit_step(parts->run->grammar, counts, next);
    memcpy(counts, next, parts->kinds * sizeof *counts);
  }
  return sum;
}

static bool choose_grain(Pixels *p, uint32_t first, uint32_t end) {
  LsysMemory *memory = p->parts->run->memory;
  double *counts = lsys_memory_alloc(memory, 2 * (size_t)p->parts->kinds, sizeof *counts);
  if (!counts) return false;
  p->grain = FINEST;
  while (p->grain < COARSEST && count_parts(p, first, end, counts, counts + p->parts->kinds) > MOST_PARTS)
    p->grain *= 2;
  lsys_memory_free(memory, counts, 2 * (size_t)p->parts->kinds, sizeof *counts);
  return true;
}

static bool draw_all(Pixels *p, uint32_t first, uint32_t end, const LsysPictureOptions *options) {
  LsysPose start = {0};
  if (!make_discs(p) || !lsys_layout_create(&p->layout, p->parts->run->grammar->axiom_count)) return false;
  for (uint32_t i = first; i < end; i++)
    if (!lsys_shared_measure(p->parts, i, &p->layout, &start)) return false;
  lsys_layout_fit(&p->layout, options, &p->page);
  if (p->parts->run->value[LSYS_SETTING_WIDTHS] == 1) p->layout.unit = p->layout.scale;
  p->page.memory = p->parts->run->memory;
  p->page.threads = p->parts->run->threads;
  if (!choose_grain(p, first, end) || !p->canvas->open(p->canvas, &p->page)) return false;
  for (uint32_t i = first; i < end; i++)
    if (!draw_figure(p, i, &start)) return false;
  return p->canvas->close(p->canvas);
}

bool lsys_shared_png(LsysParts *parts, uint32_t first, uint32_t end, const LsysPictureOptions *options, LsysOut *out) {
  Pixels p = {.geometry = {strokes, polygon, NULL, ball, NULL}, .parts = parts, .canvas = lsys_png_canvas(out)};
  if (!p.canvas) return false;
  p.walk = (LsysWalk){&p.geometry, child, &p};
  p.one_pen = !changes_pen(parts->run->grammar);
  lsys_palette_make(&p.palette, &options->colours, parts->run->grammar, false);
  bool well = draw_all(&p, first, end, options);
  p.canvas->destroy(p.canvas);
  lsys_layout_destroy(&p.layout);
  lsys_memory_free(parts->run->memory, p.disc, parts->parts, sizeof *p.disc);
  return well;
}
