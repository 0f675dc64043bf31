// recolour.c -- a geometry in front of another one that changes colours only.
#include "sinks/colours.h"

#include "core/message.h"
#include "core/options.h"

#include <string.h>

bool lsys_colours_read(const LsysOptions *given, LsysColours *colours) {
  static const char *const names[] = {[LSYS_BY_PEN] = "pen",
                                      [LSYS_BY_PROGRESS] = "progress",
                                      [LSYS_BY_ORDER] = "order",
                                      [LSYS_BY_KIND] = "kind",
                                      [LSYS_BY_AGE] = "age"};
  const LsysOptionValue *by = &given->at[LSYS_OPTION_COLOUR_BY], *list = &given->at[LSYS_OPTION_PALETTE];
  *colours = (LsysColours){.by = LSYS_BY_PEN, .list = list->given ? list->text : NULL};
  if (list->given && !lsys_colours_list(list->text)) {
    lsys_error("--palette %s: it is colours separated by commas, #rrggbb or names such as brown", list->text);
    return false;
  }
  if (!by->given) return true;
  for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
    if (strcmp(by->text, names[i])) continue;
    colours->by = (LsysColourBy)i;
    return true;
  }
  lsys_error("--colour-by %s: it is pen, progress, order, kind or age", by->text);
  return false;
}

static uint8_t colour_of(const LsysRecolour *r, const LsysPen *pen) {
  switch (r->by) {
  case LSYS_BY_PROGRESS:
    return r->total > 1 ? (uint8_t)((double)r->drawn / (double)r->total * 256) : 0;
  case LSYS_BY_ORDER:
    return (uint8_t)pen->mark;
  case LSYS_BY_AGE:
    return r->total ? (uint8_t)((double)pen->mark / (double)r->total * 255) : 0;
  case LSYS_BY_PEN:
  case LSYS_BY_KIND:
    break;
  }
  return pen->colour;
}

// How many segments from now on have the same colour.
static uint64_t same_for(const LsysRecolour *r, uint8_t colour) {
  if (r->by != LSYS_BY_PROGRESS || colour == 255) return UINT64_MAX;
  double next = (double)r->total * (colour + 1) / 256 - (double)r->drawn;
  return next > 1 ? (uint64_t)next : 1;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysRecolour *r = (LsysRecolour *)to;
  for (size_t i = 0; i < batch->count; i++) {
    LsysStroke part = batch->stroke[i];
    const LsysVec3 *point = batch->point + part.first;
    uint32_t left = part.count - 1;
    part.first = 0;
    while (left) {
      part.pen.colour = colour_of(r, &batch->stroke[i].pen);
      uint64_t same = same_for(r, part.pen.colour);
      uint32_t segments = same < left ? (uint32_t)same : left;
      part.count = segments + 1;
      LsysStrokes one = {point, &part, 1, part.count};
      if (!r->next->strokes(r->next, &one)) return false;
      part.joined = true;
      point += segments;
      left -= segments;
      r->drawn += segments;
    }
  }
  return true;
}

static LsysPen pen_of(const LsysRecolour *r, const LsysPen *pen) {
  LsysPen new = *pen;
  new.colour = colour_of(r, pen);
  return new;
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  LsysRecolour *r = (LsysRecolour *)to;
  LsysPen new = pen_of(r, pen);
  return r->next->polygon(r->next, vertices, count, &new);
}

static bool mesh(LsysGeometry *to, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  LsysRecolour *r = (LsysRecolour *)to;
  LsysPen new = pen_of(r, pen);
  return r->next->mesh(r->next, mesh, place, &new);
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  LsysRecolour *r = (LsysRecolour *)to;
  LsysPen new = pen_of(r, pen);
  return r->next->ball(r->next, centre, diameter, disc, &new);
}

static bool label(LsysGeometry *to, const LsysVec3 *at, const char *text, const LsysPen *pen) {
  LsysRecolour *r = (LsysRecolour *)to;
  LsysPen new = pen_of(r, pen);
  return r->next->label(r->next, at, text, &new);
}

LsysGeometry *lsys_recolour_begin(LsysRecolour *r, const LsysColours *colours, uint64_t segments, uint64_t steps,
                                  LsysTurtle *turtle, LsysGeometry *next) {
  if (colours->by == LSYS_BY_KIND) lsys_turtle_by_kind(turtle);
  if (colours->by == LSYS_BY_ORDER) lsys_turtle_by_depth(turtle);
  if (colours->by == LSYS_BY_AGE) lsys_turtle_by_age(turtle);
  if (colours->by == LSYS_BY_PEN || colours->by == LSYS_BY_KIND) return next;
  *r = (LsysRecolour){.geometry = {.strokes = strokes,
                                   .polygon = next->polygon ? polygon : NULL,
                                   .mesh = next->mesh ? mesh : NULL,
                                   .ball = next->ball ? ball : NULL,
                                   .label = next->label ? label : NULL},
                      .next = next,
                      .by = colours->by,
                      .total = colours->by == LSYS_BY_AGE ? steps : segments};
  return &r->geometry;
}
