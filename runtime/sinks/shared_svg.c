// shared_svg.c -- a deterministic figure as nested definitions: each part with
// each pen that it is drawn with is one group, which uses the groups of its own
// parts. The file grows with kinds times steps, not with segments.
// Source: SVG 1.1, sections 5.5 (defs), 5.6 (use), 7.6 (transform).
#include "core/memory.h"
#include "core/message.h"
#include "sinks/layout.h"
#include "sinks/shared.h"
#include "turtle/vector.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_VARIANTS = 200000 };

// A part and the pen that it begins with.
typedef struct Variant {
  uint32_t kind;
  uint64_t steps;
  double width;
  uint8_t colour;
} Variant;

typedef struct Svg {
  LsysGeometry geometry;
  LsysParts *parts;
  LsysOut *out;
  LsysLayout layout;
  LsysPalette palette;
  double unit;  // turtle's length of a width of 1
  Variant *variant;
  size_t variants, room;
  size_t *slot;  // hash table of variants: 1 + number, 0 free; twice as big as room
} Svg;

// ---- variants ------------------------------------------------------------

static uint64_t hash(const Variant *v) {
  uint64_t width;
  memcpy(&width, &v->width, sizeof width);
  return lsys_mix64(lsys_mix64(v->steps ^ (uint64_t)v->kind << 32) ^ width ^ (uint64_t)v->colour << 56);
}

static bool same(const Variant *a, const Variant *b) {
  return a->kind == b->kind && a->steps == b->steps && a->width == b->width && a->colour == b->colour;
}

static void enter(Svg *s, size_t number) {
  size_t mask = 2 * s->room - 1, i = hash(&s->variant[number]) & mask;
  while (s->slot[i]) i = (i + 1) & mask;
  s->slot[i] = number + 1;
}

static bool grow(Svg *s) {
  LsysMemory *memory = s->parts->run->memory;
  size_t slots = 2 * s->room;
  if (s->variants >= MOST_VARIANTS) {
    lsys_error("the figure has more than %d parts with different pens", MOST_VARIANTS);
    return false;
  }
  if (!lsys_memory_fit(memory, &s->variant, &s->room, s->room + 1, sizeof *s->variant)) return false;
  lsys_memory_free(memory, s->slot, slots, sizeof *s->slot);
  s->slot = lsys_memory_alloc(memory, 2 * s->room, sizeof *s->slot);
  for (size_t i = 0; s->slot && i < s->variants; i++) enter(s, i);
  return s->slot;
}

// The number of a variant, which is written later if it is new. False after an error.
static bool number_of(Svg *s, const Variant *v, size_t *number) {
  if (s->variants == s->room && !grow(s)) return false;
  size_t mask = 2 * s->room - 1;
  for (size_t i = hash(v) & mask; s->slot[i]; i = (i + 1) & mask) {
    *number = s->slot[i] - 1;
    if (same(&s->variant[*number], v)) return true;
  }
  *number = s->variants;
  s->variant[s->variants++] = *v;
  enter(s, *number);
  return true;
}

// ---- content -------------------------------------------------------------

// Nothing smaller than a part in 10^9 is a number: rotations leave such crumbs.
static double tidy(double x) {
  return fabs(x) < 1e-9 ? 0 : x;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  Svg *s = (Svg *)to;
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *stroke = &batch->stroke[i];
    lsys_out_print(s->out, "<path stroke=\"#%06x\" stroke-width=\"%.4g\" d=\"M", s->palette.rgb[stroke->pen.colour],
                   stroke->pen.width * s->unit);
    for (uint32_t k = 0; k < stroke->count; k++) {
      const LsysVec3 *p = &batch->point[stroke->first + k];
      lsys_out_print(s->out, "%s%.7g %.7g", k ? "L" : "", tidy(p->x), tidy(p->y));
    }
    if (!lsys_out_print(s->out, "\"/>\n")) return false;
  }
  return true;
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  Svg *s = (Svg *)to;
  lsys_out_print(s->out, "<path fill=\"#%06x\" d=\"M", s->palette.rgb[pen->colour]);
  for (size_t i = 0; i < count; i++)
    lsys_out_print(s->out, "%s%.7g %.7g", i ? "L" : "", tidy(vertices[i].x), tidy(vertices[i].y));
  return lsys_out_print(s->out, "z\"/>\n");
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  Svg *s = (Svg *)to;
  (void)disc;
  return lsys_out_print(s->out, "<circle fill=\"#%06x\" cx=\"%.7g\" cy=\"%.7g\" r=\"%.7g\"/>\n",
                        s->palette.rgb[pen->colour], tidy(centre->x), tidy(centre->y), diameter / 2);
}

static bool draws(const LsysParts *parts, const LsysPart *part) {
  LsysVec3 low, high;
  return lsys_support_box(&parts->directions, part->support, &low, &high);
}

static bool child(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  Svg *s = data;
  size_t number;
  if (!draws(s->parts, lsys_part(s->parts, kind, steps))) return true;
  if (!number_of(s, &(Variant){kind, steps, pose->width, pose->colour}, &number)) return false;
  return lsys_out_print(s->out, "<use href=\"#p%zu\" transform=\"matrix(%.9g %.9g %.9g %.9g %.9g %.9g)\"/>\n", number,
                        tidy(-pose->l.x), tidy(-pose->l.y), tidy(pose->h.x), tidy(pose->h.y), tidy(pose->at.x),
                        tidy(pose->at.y));
}

// ---- the file ------------------------------------------------------------

static bool write_figure(Svg *s, uint32_t axiom, const LsysPose *start) {
  const LsysFigure *f = &s->layout.figure[axiom];
  if (!f->drawn) return true;
  const LsysWalk walk = {&s->geometry, child, s};
  LsysPose pose = *start;
  lsys_out_print(s->out, "<g transform=\"matrix(%.9g 0 0 %.9g %.9g %.9g)\">\n", s->layout.scale, -s->layout.scale, f->x,
                 f->y);
  lsys_parts_begin(s->parts, &walk);
  return lsys_parts_walk(s->parts, &s->parts->run->grammar->axioms[axiom].word, s->parts->steps, &pose, &walk)
      && lsys_out_print(s->out, "</g>\n");
}

// New variants turn up while others are written.
static bool write_definitions(Svg *s) {
  const LsysWalk walk = {&s->geometry, child, s};
  lsys_out_print(s->out, "<defs>\n");
  for (size_t i = 0; i < s->variants; i++) {
    const Variant v = s->variant[i];
    LsysWord word = lsys_parts_word(s->parts, v.kind);
    LsysPose pose = lsys_pose_origin(v.width, v.colour);
    lsys_out_print(s->out, "<g id=\"p%zu\">\n", i);
    lsys_parts_begin(s->parts, &walk);
    if (!lsys_parts_walk(s->parts, &word, v.steps - 1, &pose, &walk)) return false;
    if (!lsys_out_print(s->out, "</g>\n")) return false;
  }
  return lsys_out_print(s->out, "</defs>\n");
}

static bool write_all(Svg *s, uint32_t first, uint32_t end, const LsysPictureOptions *options) {
  LsysPose start = {0};
  for (uint32_t i = first; i < end; i++) {
    if (!lsys_shared_measure(s->parts, i, &s->layout, &start)) return false;
  }
  LsysPage page = {0};
  lsys_layout_fit(&s->layout, options, &page);
  s->unit = s->parts->run->value[LSYS_SETTING_WIDTHS] == 1 ? 1 : s->layout.unit / s->layout.scale;
  lsys_out_print(s->out,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%u\" height=\"%u\" viewBox=\"0 0 %u %u\">\n",
                 page.width, page.height, page.width, page.height);
  if (!page.transparent)
    lsys_out_print(s->out, "<rect width=\"%u\" height=\"%u\" fill=\"#%06x\"/>\n", page.width, page.height,
                   page.background);
  lsys_out_print(s->out, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
  for (uint32_t i = first; i < end; i++) {
    if (!write_figure(s, i, &start)) return false;
  }
  return lsys_out_print(s->out, "</g>\n") && write_definitions(s) && lsys_out_print(s->out, "</svg>\n");
}

bool lsys_shared_svg(LsysParts *parts, uint32_t first, uint32_t end, const LsysPictureOptions *options, LsysOut *out) {
  Svg s = {.geometry = {strokes, polygon, NULL, ball, NULL}, .parts = parts, .out = out};
  lsys_palette_make(&s.palette, &options->colours, parts->run->grammar, false);
  bool well = lsys_layout_create(&s.layout, parts->run->grammar->axiom_count) && write_all(&s, first, end, options);
  lsys_layout_destroy(&s.layout);
  lsys_memory_free(parts->run->memory, s.variant, s.room, sizeof *s.variant);
  lsys_memory_free(parts->run->memory, s.slot, 2 * s.room, sizeof *s.slot);
  return well;
}
