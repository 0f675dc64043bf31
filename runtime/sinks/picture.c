// picture.c -- words to pages: a first pass measures all figures, a last one
// draws them. A figure in space is seen by a camera; with perspective a pass in
// between measures what the eye, placed by the first one, sees.
// Requires that a pass over all start words ends before the next one begins.
#include "sinks/picture.h"

#include "core/memory.h"
#include "core/message.h"
#include "sinks/film.h"
#include "sinks/gauge.h"
#include "sinks/layout.h"
#include "sinks/lettering.h"
#include "sinks/view.h"
#include "turtle/turtle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BATCH = 1024 };  // points handed on at once

const LsysPictureOptions lsys_picture_defaults = {
  .line_width = NAN, .background = 0xffffff, .antialias = true, .azimuth = NAN, .elevation = NAN};

typedef struct Picture {
  LsysSink sink;
  LsysGeometry geometry;  // what the turtle draws to
  LsysPictureOptions options;
  LsysCanvas *canvas;
  LsysTurtle *turtle;
  LsysGauge gauge;
  LsysLayout layout;
  LsysPalette palette;
  LsysRecolour recolour;
  LsysPage page;
  bool solid;     // seen by a camera
  bool open;      // the page
  unsigned pass;  // of sink.passes
  uint32_t current;
  LsysView view;
  LsysEye *eye;      // of each figure
  LsysVec3 *corner;  // of a polygon
  LsysPoint *place;
  size_t corner_room, place_room;
  LsysMemory *memory;
} Picture;

static Picture *picture_of(LsysGeometry *geometry) {
  return (Picture *)((char *)geometry - offsetof(Picture, geometry));
}

static bool drawing(const Picture *p) {
  return p->pass + 1 == p->sink.passes;
}

// ---- drawing -------------------------------------------------------------

// From the turtle's space to the space that the page shows.
static LsysVec3 seen(const Picture *p, LsysVec3 v) {
  if (!p->solid) return v;
  v = view_turn(&p->view, v);
  return p->pass ? eye_project(&p->eye[p->current], v) : v;
}

static LsysPoint on_page(const Picture *p, LsysVec3 v) {
  const LsysFigure *f = &p->layout.figure[p->current];
  LsysVec3 s = seen(p, v);
  return (LsysPoint){f->x + s.x * p->layout.scale, f->y - s.y * p->layout.scale, s.z * p->layout.scale};
}

static LsysInk ink_of(const Picture *p, const LsysPen *pen, double factor) {
  return lsys_layout_ink(&p->page, pen->width * p->layout.unit * factor, p->palette.rgb[pen->colour]);
}

// Places of the turtle's space on the page.
static void put_on_page(const Picture *p, const LsysVec3 *v, size_t count, LsysPoint *to) {
  if (p->solid) {
    for (size_t i = 0; i < count; i++) to[i] = on_page(p, v[i]);
    return;
  }
  const double x = p->layout.figure[p->current].x, y = p->layout.figure[p->current].y, scale = p->layout.scale;
  for (size_t i = 0; i < count; i++) to[i] = (LsysPoint){x + v[i].x * scale, y - v[i].y * scale, v[i].z * scale};
}

static bool draw_stroke(Picture *p, const LsysVec3 *v, size_t count, const LsysPen *pen, bool joined) {
  LsysPoint point[BATCH];
  LsysInk ink = ink_of(p, pen, 1);
  for (size_t from = 0; from + 1 < count;) {
    size_t n = count - from < BATCH ? count - from : BATCH;
    put_on_page(p, v + from, n, point);
    if (!p->canvas->line(p->canvas, point, n, &ink, joined || from)) return false;
    from += n - 1;  // the next part begins where this one ends
  }
  return true;
}

// Nearer segments look thicker: each gets the width of its middle.
static bool draw_perspective(Picture *p, const LsysVec3 *v, size_t count, const LsysPen *pen, bool joined) {
  for (size_t i = 0; i + 1 < count; i++) {
    LsysVec3 middle = view_turn(&p->view, vec_sum(v[i], 0.5, v[i + 1], 0.5));
    LsysInk ink = ink_of(p, pen, eye_factor(&p->eye[p->current], &middle));
    LsysPoint ends[2] = {on_page(p, v[i]), on_page(p, v[i + 1])};
    if (!p->canvas->line(p->canvas, ends, 2, &ink, joined || i)) return false;
  }
  return true;
}

static bool measure_stroke(Picture *p, const LsysVec3 *v, const LsysStroke *stroke) {
  LsysVec3 turned[BATCH];
  for (uint32_t from = 0; from + 1 < stroke->count;) {
    uint32_t n = stroke->count - from < BATCH ? stroke->count - from : BATCH;
    for (uint32_t i = 0; i < n; i++) turned[i] = seen(p, v[from + i]);
    LsysStroke part = {0, n, stroke->pen, false};
    LsysStrokes batch = {turned, &part, 1, n};
    if (!p->gauge.measure.geometry.strokes(&p->gauge.measure.geometry, &batch)) return false;
    from += n - 1;
  }
  return true;
}

static bool strokes(LsysGeometry *geometry, const LsysStrokes *batch) {
  Picture *p = picture_of(geometry);
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *v = batch->point + s->first;
    bool well = !drawing(p)            ? measure_stroke(p, v, s)
              : p->options.perspective ? draw_perspective(p, v, s->count, &s->pen, s->joined)
                                       : draw_stroke(p, v, s->count, &s->pen, s->joined);
    if (!well) return false;
  }
  return true;
}

static bool make_room(Picture *p, size_t count) {
  return lsys_memory_fit(p->memory, &p->corner, &p->corner_room, count, sizeof *p->corner)
      && lsys_memory_fit(p->memory, &p->place, &p->place_room, count, sizeof *p->place);
}

static bool polygon(LsysGeometry *geometry, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  Picture *p = picture_of(geometry);
  if (!make_room(p, count)) return false;
  if (!drawing(p)) {
    for (size_t i = 0; i < count; i++) p->corner[i] = seen(p, vertices[i]);
    return p->gauge.measure.geometry.polygon(&p->gauge.measure.geometry, p->corner, count, pen);
  }
  for (size_t i = 0; i < count; i++) p->place[i] = on_page(p, vertices[i]);
  return p->canvas->fill(p->canvas, p->place, NULL, count, p->palette.rgb[pen->colour]);
}

static bool mesh(LsysGeometry *geometry, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  Picture *p = picture_of(geometry);
  LsysVec3 axis[3] = {place->right, place->ahead, place->up};
  for (int i = 0; i < 3; i++) {  // normals turn by the inverse of the axes, transposed
    double squared = vec_dot(axis[i], axis[i]);
    axis[i] = view_turn(&p->view, squared > 0 ? vec_scale(axis[i], 1 / squared) : axis[i]);
  }
  for (uint32_t i = 0; i < mesh->triangles; i++) {
    LsysVec3 corner[3], normal[3] = {0};
    LsysPoint at[3];
    for (int k = 0; k < 3; k++) {
      uint32_t which = mesh->corner[3 * i + (uint32_t)k];
      corner[k] = lsys_mesh_vertex(mesh, place, which);
      at[k] = on_page(p, corner[k]);
      if (!mesh->normal) continue;
      LsysVec3 n = mesh->normal[which];
      normal[k] = vec_sum(vec_sum(axis[0], n.x, axis[1], n.y), 1, axis[2], n.z);
    }
    if (!drawing(p)) {
      for (int k = 0; k < 3; k++) corner[k] = seen(p, corner[k]);
      p->gauge.measure.geometry.polygon(&p->gauge.measure.geometry, corner, 3, pen);
    } else if (!p->canvas->fill(p->canvas, at, mesh->normal ? normal : NULL, 3, p->palette.rgb[pen->colour])) {
      return false;
    }
  }
  return true;
}

static bool draw_disc(Picture *p, LsysPoint centre, double radius, uint32_t rgb) {
  enum { CORNERS = 48 };
  LsysPoint point[CORNERS];
  for (int i = 0; i < CORNERS; i++) {
    double angle = i * 360.0 / CORNERS;
    point[i] = (LsysPoint){centre.x + radius * lsys_cos(angle), centre.y + radius * lsys_sin(angle), centre.z};
  }
  return p->canvas->fill(p->canvas, point, NULL, CORNERS, rgb);
}

// A ball is a line of no length.
static bool ball(LsysGeometry *geometry, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  Picture *p = picture_of(geometry);
  LsysVec3 turned = p->solid ? view_turn(&p->view, *centre) : *centre;
  if (p->pass) diameter *= eye_factor(&p->eye[p->current], &turned);
  if (!drawing(p)) {
    LsysVec3 middle = seen(p, *centre);
    return p->gauge.measure.geometry.ball(&p->gauge.measure.geometry, &middle, diameter, disc, pen);
  }
  LsysPoint at[2] = {on_page(p, *centre), on_page(p, *centre)};
  LsysInk ink = lsys_layout_ink(&p->page, diameter * p->layout.scale, p->palette.rgb[pen->colour]);
  if (disc && p->solid) return draw_disc(p, at[0], ink.width / 2, ink.rgb);
  return p->canvas->line(p->canvas, at, 2, &ink, false);
}

static bool label(LsysGeometry *geometry, const LsysVec3 *at, const char *text, const LsysPen *pen) {
  Picture *p = picture_of(geometry);
  if (!drawing(p)) {
    LsysVec3 place = seen(p, *at);
    return p->gauge.measure.geometry.label(&p->gauge.measure.geometry, &place, text, pen);
  }
  double longest = fmax(p->page.width, p->page.height);
  LsysPoint place = on_page(p, *at);
  place.z += 2 * longest;  // before everything
  return lsys_lettering(p->canvas, &p->page, text, place, 0.014 * longest, p->palette.rgb[pen->colour]);
}

// ---- passes --------------------------------------------------------------

// Keeps what a film's first picture, which is its last step, found for the others. False if memory ran out.
static bool keep_for_film(const Picture *p, LsysFilm *film) {
  uint32_t figures = p->layout.figures;
  if (!lsys_layout_create(&film->layout, figures)) return false;
  LsysFigure *figure = film->layout.figure;
  film->layout = p->layout;
  film->layout.figure = figure;
  film->eye = calloc((size_t)figures + 1, sizeof *film->eye);
  if (!film->eye) {
    lsys_error("out of memory");
    return false;
  }
  memcpy(figure, p->layout.figure, figures * sizeof *figure);
  memcpy(film->eye, p->eye, figures * sizeof *film->eye);
  film->page = p->page;
  film->laid_out = true;
  return true;
}

// The others take it over, but for how many segments they have themselves.
static void take_from_film(Picture *p, const LsysFilm *film) {
  p->page = film->page;
  p->layout.scale = film->layout.scale;
  p->layout.unit = film->layout.unit;
  for (uint32_t i = 0; i < p->layout.figures; i++) {
    uint64_t segments = p->layout.figure[i].segments;
    p->layout.figure[i] = film->layout.figure[i];
    p->layout.figure[i].segments = segments;
    p->eye[i] = film->eye[i];
  }
}

static bool open_page(Picture *p) {
  LsysFilm *film = p->options.film;
  lsys_layout_fit(&p->layout, &p->options, &p->page);
  if (lsys_turtle_widths_are_lengths(p->turtle)) p->layout.unit = p->layout.scale;
  if (film && film->laid_out) take_from_film(p, film);
  if (film && !film->laid_out && !keep_for_film(p, film)) return false;
  p->open = true;
  return p->canvas->open(p->canvas, &p->page);
}

// A figure in the page needs no camera unless the user asks for one.
static void choose_view(Picture *p) {
  const LsysPictureOptions *o = &p->options;
  p->solid = !lsys_turtle_flat(p->turtle) || !isnan(o->azimuth) || o->perspective;
  bool given = !isnan(o->azimuth), flat = lsys_turtle_flat(p->turtle);
  p->view = lsys_view(given ? o->azimuth : flat ? 0 : 25, given ? o->elevation : flat ? 0 : 15);
}

// A page whose size is given is refused before any work is done for it.
static bool reserve_page(Picture *p) {
  if (!p->options.width || !p->canvas->reserve) return true;
  lsys_layout_page(&p->options, &p->page);
  return p->canvas->reserve(p->canvas, &p->page);
}

static bool start(Picture *p, const LsysRun *run) {
  if (p->turtle) return true;
  uint32_t figures = run->grammar->axiom_count;
  p->eye = calloc((size_t)figures + 1, sizeof *p->eye);
  if (!p->eye) lsys_error("out of memory");
  if (!p->eye || !lsys_layout_create(&p->layout, figures)) return false;
  p->turtle = lsys_turtle_create(run);
  if (!p->turtle) return false;
  p->memory = run->memory;
  choose_view(p);
  lsys_palette_make(&p->palette, &p->options.colours, run->grammar, p->solid);
  p->page.memory = p->memory;
  p->page.threads = run->threads;
  p->page.solid = p->solid;
  return reserve_page(p);
}

// What the turtle draws to in this pass; NULL after printing why there is nothing. The places of figures in space are
// turned on this thread, and measured there.
static LsysGeometry *target(Picture *p, const LsysRun *run) {
  if (!drawing(p)) {
    LsysGeometry *gauge = lsys_gauge_begin(&p->gauge, p->memory, p->solid ? 1 : run->threads);
    return p->solid ? &p->geometry : gauge;
  }
  uint64_t segments = p->layout.figure[p->current].segments;
  return lsys_recolour_begin(&p->recolour, &p->options.colours, segments, run->steps, p->turtle, &p->geometry);
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  Picture *p = (Picture *)sink;
  if (!start(p, run)) return false;
  p->current = axiom;
  p->pass = pass;
  if (drawing(p)) {
    lsys_gauge_close(&p->gauge);
    if (!p->open && !open_page(p)) return false;
  }
  LsysGeometry *to = target(p, run);
  if (to) lsys_turtle_begin(p->turtle, axiom, to);
  return to;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((Picture *)sink)->turtle, part);
}

// The last measuring pass gives the layout; one before it places the eyes.
static bool end(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  if (!lsys_turtle_end(p->turtle)) return false;
  if (drawing(p)) return true;
  if (!lsys_gauge_end(&p->gauge)) return false;
  if (p->pass == 0) p->eye[p->current] = (LsysEye){.distance = INFINITY};
  if (p->pass == 0 && p->options.perspective && lsys_measure_any(&p->gauge.measure)
      && lsys_measure_finite(&p->gauge.measure))
    p->eye[p->current] = lsys_eye(p->gauge.measure.low, p->gauge.measure.high);
  return p->pass + 2 < sink->passes || lsys_layout_add(&p->layout, p->current, &p->gauge.measure);
}

static bool finish(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  if (!p->open && !open_page(p)) return false;
  if (!p->options.film) lsys_layout_tell_empty(&p->layout);
  return p->canvas->close(p->canvas);
}

static void destroy(LsysSink *sink) {
  Picture *p = (Picture *)sink;
  lsys_turtle_destroy(p->turtle);
  lsys_layout_destroy(&p->layout);
  lsys_gauge_close(&p->gauge);
  p->canvas->destroy(p->canvas);
  free(p->eye);
  lsys_memory_free(p->memory, p->corner, p->corner_room, sizeof *p->corner);
  lsys_memory_free(p->memory, p->place, p->place_room, sizeof *p->place);
  free(p);
}

LsysSink *lsys_picture_create(LsysCanvas *canvas, const LsysPictureOptions *options) {
  Picture *p = calloc(1, sizeof *p);
  if (!p) {
    canvas->destroy(canvas);
    lsys_error("out of memory");
    return NULL;
  }
  p->sink = (LsysSink){.passes = options->perspective ? 3 : 2,
                       .begin = begin,
                       .take = take,
                       .end = end,
                       .finish = finish,
                       .destroy = destroy};
  p->geometry = (LsysGeometry){strokes, polygon, mesh, ball, label};
  p->options = *options;
  p->canvas = canvas;
  return &p->sink;
}
