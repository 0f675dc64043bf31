// layout.c -- fits figures to a page and chooses how thick lines are.
#include "sinks/layout.h"

#include "core/message.h"

#include <math.h>
#include <stdlib.h>

enum {
  LONG_SIDE = 1000,  // pixels of a page without --size
  SHORT_SIDE = 120,  // a page is never narrower
};

static const double MARGIN = 0.04, GAP = 0.08;  // of the page's longer side; of the biggest figure

bool lsys_layout_create(LsysLayout *layout, uint32_t figures) {
  *layout = (LsysLayout){.figure = calloc((size_t)figures + 1, sizeof *layout->figure), .figures = figures};
  layout->thinnest = INFINITY;
  if (layout->figure) return true;
  lsys_error("out of memory");
  return false;
}

void lsys_layout_destroy(LsysLayout *layout) {
  free(layout->figure);
  layout->figure = NULL;
}

bool lsys_layout_add(LsysLayout *layout, uint32_t which, const LsysMeasure *m) {
  if (!lsys_measure_any(m)) return true;
  layout->figure[which] = (LsysFigure){.drawn = true, .segments = m->segments, .low = m->low, .high = m->high};
  layout->segments += m->segments;
  layout->length += m->length;
  layout->thinnest = fmin(layout->thinnest, m->thinnest);
  layout->thickest = fmax(layout->thickest, m->thickest);
  if (lsys_measure_finite(m)) return true;
  lsys_error("the figure of axiom %u reaches to infinity: it cannot be drawn", which + 1);
  return false;
}

void lsys_layout_tell_empty(const LsysLayout *layout) {
  for (uint32_t i = 0; i < layout->figures; i++)
    if (layout->figure[i].drawn) return;
  lsys_note("nothing was drawn: the word has no F, no polygon and nothing else that the turtle draws "
            "(--help turtle lists what does)");
}

// Size of all figures side by side, in the turtle's units.
typedef struct Extent {
  double width, height, gap;
} Extent;

static Extent extent_of(const LsysLayout *layout) {
  Extent e = {0};
  double widest = 0;
  uint32_t drawn = 0;
  for (uint32_t i = 0; i < layout->figures; i++) {
    const LsysFigure *f = &layout->figure[i];
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

static void set_scale(LsysLayout *layout, const Extent *e, LsysPage *page) {
  double longest = page->width ? fmax(page->width, page->height) : LONG_SIDE;
  double margin = MARGIN * longest, room_x = longest - 2 * margin, room_y = room_x;
  if (page->width) {
    margin = MARGIN * fmin(page->width, page->height);
    room_x = page->width - 2 * margin;
    room_y = page->height - 2 * margin;
  }
  layout->scale = fmin(room_x / e->width, room_y / e->height);  // a width or height of 0 gives inf: it does not bind
  if (!isfinite(layout->scale) || layout->scale <= 0) layout->scale = 1;
  if (!page->width) {
    page->width = side(e->width * layout->scale + 2 * margin);
    page->height = side(e->height * layout->scale + 2 * margin);
  }
}

static void place_figures(LsysLayout *layout, const Extent *e, const LsysPage *page) {
  double x = (page->width - e->width * layout->scale) / 2;
  double bottom = (page->height + e->height * layout->scale) / 2;
  for (uint32_t i = 0; i < layout->figures; i++) {
    LsysFigure *f = &layout->figure[i];
    if (!f->drawn) continue;
    f->x = x - f->low.x * layout->scale;
    f->y = bottom + f->low.y * layout->scale;
    x += (f->high.x - f->low.x + e->gap) * layout->scale;
  }
}

// How many pixels a width of 1 is, unless the user says so: 1/800 of the page, but a pixel on
// small ones; more where twigs would vanish or a curve in space can be a tube, less where the
// trunk would swell or a dense curve fill its own gaps.
static void set_line_width(LsysLayout *layout, const LsysPictureOptions *options, LsysPage *page) {
  double longest = fmax(page->width, page->height), unit = fmax(longest / 800, 1);
  page->detail = layout->segments ? layout->length / (double)layout->segments * layout->scale : longest;
  if (isfinite(options->line_width)) {
    layout->unit = options->line_width;
    return;
  }
  if (layout->thickest > 0) {
    bool varied = layout->thinnest > 0 && layout->thinnest < layout->thickest;
    if (varied) unit = fmax(unit, 0.5 * fmax(longest / 1000, 1) / layout->thinnest);
    if (!varied && page->solid) unit = fmax(unit, fmin(0.22 * page->detail, longest / 60) / layout->thickest);
    unit = fmin(unit, longest / 40 / layout->thickest);
    if (!varied) unit = fmin(unit, fmax(0.5, 0.35 * page->detail) / layout->thickest);
  }
  layout->unit = unit;
}

void lsys_layout_page(const LsysPictureOptions *options, LsysPage *page) {
  page->width = options->width;
  page->height = options->height;
  page->background = options->background;
  page->transparent = options->transparent;
  page->antialias = options->antialias;
}

LsysInk lsys_layout_ink(const LsysPage *page, double pixels, uint32_t rgb) {
  return (LsysInk){fmin(fmax(pixels, 0.05), 4.0 * (page->width + page->height)), rgb};
}

void lsys_layout_fit(LsysLayout *layout, const LsysPictureOptions *options, LsysPage *page) {
  lsys_layout_page(options, page);
  Extent e = extent_of(layout);
  set_scale(layout, &e, page);
  place_figures(layout, &e, page);
  set_line_width(layout, options, page);
}
