// shapes.c -- things that the turtle draws where it stands: surfaces, discs,
// spheres, boxes, labels.
// Sources: ABOP p. 119 (~); cpfg's manual.
#include "turtle/actions.h"

#include "core/message.h"
#include "core/print.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DISC_CORNERS = 32 };

// Where the turtle stands, on the page or in space.
static LsysVec3 here(const LsysTurtle *t) {
  return turtle_out(t, (LsysVec3){t->state.at[0], t->state.at[1], t->state.z});
}

static bool draw_polygon(LsysTurtle *t, const LsysVec3 *vertex, size_t count) {
  LsysPen pen = turtle_pen(t);
  return !t->to->polygon || t->to->polygon(t->to, vertex, count, &pen);
}

// A length in an argument, or the line's width.
static double size_of(const LsysTurtle *t, int given, const double *arg) {
  return given ? arg[0] * t->state.size : t->state.width;
}

// ---- balls and discs -----------------------------------------------------

static bool ball(LsysTurtle *t, LsysVec3 centre, double diameter, bool disc) {
  LsysPen pen = turtle_pen(t);
  return !(diameter > 0) || !t->to->ball || (turtle_flush(t) && t->to->ball(t->to, &centre, diameter, disc, &pen));
}

// In the plane of H and L; a circle on the page needs no corners.
static bool disc(LsysTurtle *t, double diameter) {
  if (!(diameter > 0)) return true;
  if (t->in_page) return ball(t, here(t), diameter, true);
  Frame f = turtle_frame(t);
  LsysVec3 centre = here(t), vertex[DISC_CORNERS];
  for (int i = 0; i < DISC_CORNERS; i++) {
    double angle = i * 360.0 / DISC_CORNERS, c = lsys_cos(angle) * diameter / 2, s = lsys_sin(angle) * diameter / 2;
    vertex[i] = vec_sum(centre, 1, vec_sum(f.h, c, f.l, s), 1);
  }
  return turtle_flush(t) && draw_polygon(t, vertex, DISC_CORNERS);
}

bool act_circle(LsysTurtle *t, int given, const double *arg) {
  return ball(t, here(t), size_of(t, given, arg), true);
}

bool act_disc(LsysTurtle *t, int given, const double *arg) {
  return disc(t, size_of(t, given, arg));
}

bool act_sphere(LsysTurtle *t, int given, const double *arg) {
  return ball(t, here(t), size_of(t, given, arg), false);
}

// ---- boxes ---------------------------------------------------------------

// From here ahead by `ahead`, `left` wide, `up` high, its axis along H.
static bool box(LsysTurtle *t, double ahead, double left, double up) {
  static const uint8_t face[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  Frame f = turtle_frame(t);
  LsysVec3 corner[8], base = here(t);
  for (int i = 0; i < 8; i++) {
    LsysVec3 p = vec_sum(base, 1, f.h, i & 4 ? ahead : 0);
    p = vec_sum(p, 1, f.l, (i & 2 ? 0.5 : -0.5) * left);
    corner[i] = vec_sum(p, 1, f.u, (i & 1 ? 0.5 : -0.5) * up);
  }
  if (!turtle_flush(t)) return false;
  for (int i = 0; i < 6; i++) {
    LsysVec3 vertex[4];
    for (int k = 0; k < 4; k++) vertex[k] = corner[face[i][k]];
    if (!draw_polygon(t, vertex, 4)) return false;
  }
  return true;
}

bool act_box(LsysTurtle *t, int given, const double *arg) {
  double ahead = size_of(t, given, arg), left = given > 1 ? arg[1] * t->state.size : ahead;
  return box(t, ahead, left, given > 2 ? arg[2] * t->state.size : left);
}

// ---- labels --------------------------------------------------------------

static bool write_label(LsysTurtle *t, const char *text) {
  LsysPen pen = turtle_pen(t);
  LsysVec3 at = here(t);
  return turtle_flush(t) && t->to->label(t->to, &at, text, &pen);
}

bool act_label(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  char text[32];
  snprintf(text, sizeof text, "%.6g", arg[0]);
  return !t->to->label || write_label(t, text);
}

bool turtle_write_text(LsysTurtle *t, uint32_t kind, const double *arg) {
  if (!t->to->label) return true;
  // The driver's run, as every sink has it.
  char *text = lsys_print_text((LsysRun *)t->run, t->kind[kind].text, arg, t->kind[kind].width);
  if (!text) lsys_error("out of memory for a label");
  bool well = text && write_label(t, text);
  free(text);
  return well;
}

// ---- surfaces ------------------------------------------------------------

bool act_surface(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  t->skip_next = true;
  return true;
}

static bool draw_mesh(LsysTurtle *t, uint32_t which, const double *scale) {
  const LsysSurface *s = &t->run->grammar->surfaces[which];
  const LsysMesh mesh = {
    (const LsysVec3 *)s->vertex, (const LsysVec3 *)s->normal, s->corner, s->vertices, s->triangles, which + 1};
  Frame f = turtle_frame(t);
  LsysPlace place = {here(t), vec_scale(f.l, -scale[0]), vec_scale(f.h, scale[1]), vec_scale(f.u, scale[2])};
  LsysPen pen = turtle_pen(t);
  return !t->to->mesh || (turtle_flush(t) && t->to->mesh(t->to, &mesh, &place, &pen));
}

// ~X(s) scales by s, ~X(x,y,z) by three factors. A module that is no surface draws nothing.
bool turtle_draw_surface(LsysTurtle *t, uint32_t kind, const double *arg) {
  t->skip_next = false;
  uint32_t which = t->kind[kind].surface, given = t->kind[kind].arity;
  if (which == NO_SURFACE) return true;
  double scale[3];
  for (uint32_t i = 0; i < 3; i++) {
    scale[i] = (given >= 3 ? arg[i] : given ? arg[0] : 1) * t->state.size;
    if (!isfinite(scale[i])) {
      turtle_warn(t, WARN_NOT_FINITE, t->read, "the surface is left out: its scale is nan or infinite");
      return true;
    }
  }
  const LsysSurface *s = &t->run->grammar->surfaces[which];
  switch ((LsysSurfaceForm)s->form) {
  case LSYS_SURFACE_DISC:
    return disc(t, s->size[0] * scale[0]);
  case LSYS_SURFACE_SPHERE:
    return ball(t, here(t), s->size[0] * scale[0], false);
  case LSYS_SURFACE_BOX:
    return box(t, s->size[1] * scale[1], s->size[0] * scale[0], s->size[2] * scale[2]);
  case LSYS_SURFACE_MESH:
    return draw_mesh(t, which, scale);
  }
  return true;
}
