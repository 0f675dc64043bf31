// moves.c -- what moves the turtle, and the polygons that moves record.
// Sources: ABOP p. 7, 46, 119-122; cpfg's manual.
#include "turtle/actions.h"

static void go(LsysTurtle *t, LsysVec3 direction, double length) {
  t->state.at += (Pair){direction.x, direction.y} * length;
  t->state.z += direction.z * length;
}

static double length_of(const LsysTurtle *t, int given, const double *arg) {
  return (given ? arg[0] : t->step * t->state.scale) * t->state.size;
}

static bool vertex(LsysTurtle *t) {
  if (t->splining) return turtle_spline_node(t);
  LsysVec3 p = turtle_out(t, (LsysVec3){t->state.at[0], t->state.at[1], t->state.z});
  if (t->vertices > t->polygon[t->polygons - 1]) {
    const LsysVec3 *last = &t->vertex[t->vertices - 1];
    if (last->x == p.x && last->y == p.y && last->z == p.z) return true;
  }
  if (!turtle_grow(t, &t->vertex, &t->vertex_room, t->vertices + 1, sizeof *t->vertex)) return false;
  t->vertex[t->vertices++] = p;
  return true;
}

// Where the turtle goes: the way that numbered tropisms lead it.
static LsysVec3 ahead(LsysTurtle *t) {
  turtle_lean(t);
  return turtle_heading(t);
}

// The turtle went to another place.
static void arrive(LsysTurtle *t, bool draw) {
  if (!draw) {
    turtle_jump(t);
    return;
  }
  turtle_draw_to(t);
  if (t->untwists) t->state.kept = t->state.frame;
  if (!t->watches) return;
  t->state.drawn = (LsysVec3){t->state.at[0], t->state.at[1], t->state.z};
  t->state.lines++;
}

// Moves; records an edge of the open polygon if `edge`.
static bool move(LsysTurtle *t, LsysVec3 direction, double length, bool draw, bool edge) {
  edge = edge && (t->polygons || t->splining);
  bool first = t->splining ? t->sweep.nodes == 0 : edge && t->vertices == t->polygon[t->polygons - 1];
  if (edge && first && !vertex(t)) return false;
  go(t, direction, length);
  turtle_bend(t);
  arrive(t, draw);
  return !edge || vertex(t);
}

// F(x,y) of the environment `point`.
static bool draw_to_point(LsysTurtle *t, bool edge, const double *arg) {
  edge = edge && t->polygons;
  if (edge && t->vertices == t->polygon[t->polygons - 1] && !vertex(t)) return false;
  t->state.at = (Pair){arg[0], arg[1]};
  t->state.z = 0;
  arrive(t, true);
  return !edge || vertex(t);
}

// F(l,w): the width is that of this segment only.
static bool draw(LsysTurtle *t, bool edge, int arity, const double *arg) {
  if (arity == 2 && t->to_points) return draw_to_point(t, edge, arg);
  if (arity != 2) return move(t, ahead(t), length_of(t, arity, arg), true, edge);
  double width = t->state.width;
  turtle_change_pen(t);
  t->state.width = turtle_width(t, arg[1]);
  bool ok = move(t, ahead(t), arg[0] * t->state.size, true, edge);
  turtle_change_pen(t);
  t->state.width = width;
  return ok;
}

bool act_draw(LsysTurtle *t, int given, const double *arg) {
  return draw(t, true, given, arg);
}

bool act_draw_no_vertex(LsysTurtle *t, int given, const double *arg) {
  return draw(t, false, given, arg);
}

bool act_move(LsysTurtle *t, int given, const double *arg) {
  return move(t, ahead(t), length_of(t, given, arg), false, true);
}

bool act_move_no_vertex(LsysTurtle *t, int given, const double *arg) {
  return move(t, ahead(t), length_of(t, given, arg), false, false);
}

bool act_move_to(LsysTurtle *t, int given, const double *arg) {
  t->state.at = (Pair){arg[0], arg[1]};
  t->state.z = given > 2 ? arg[2] : 0;
  turtle_jump(t);
  return true;
}

static LsysVec3 second_direction(const LsysTurtle *t) {
  return (LsysVec3){lsys_cos(t->state.second), lsys_sin(t->state.second), 0};
}

bool act_second_draw(LsysTurtle *t, int given, const double *arg) {
  return move(t, second_direction(t), length_of(t, given, arg), true, true);
}

bool act_second_move(LsysTurtle *t, int given, const double *arg) {
  return move(t, second_direction(t), length_of(t, given, arg), false, true);
}

// ---- scales --------------------------------------------------------------

bool act_step_scale(LsysTurtle *t, int given, const double *arg) {
  if (given) t->state.scale *= arg[0];
  return true;
}

// Scales are positive: others, and what would overflow, are left out.
static bool set_size(LsysTurtle *t, double size) {
  if (size > 0 && isfinite(size)) t->state.size = size;
  return true;
}

bool act_scale(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  return set_size(t, arg[0]);
}

bool act_scale_up(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  return set_size(t, t->state.size * arg[0]);
}

bool act_scale_down(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  return set_size(t, t->state.size / arg[0]);
}

// ---- polygons ------------------------------------------------------------

// `{(n)` with n other than 0 begins a generalised cylinder.
bool act_polygon_begin(LsysTurtle *t, int given, const double *arg) {
  if (given && arg[0] != 0) {
    t->splining = true;
    t->sweep.nodes = 0;
    return true;
  }
  if (!turtle_grow(t, &t->polygon, &t->polygon_room, t->polygons + 1, sizeof *t->polygon)) return false;
  t->polygon[t->polygons++] = t->vertices;
  t->polygon_place = t->read;
  return true;
}

bool act_polygon_vertex(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  return !(t->polygons || t->splining) || vertex(t);
}

bool act_polygon_end(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  if (t->splining) {
    t->splining = false;
    return turtle_spline_draw(t);
  }
  if (!t->polygons) {
    turtle_warn(t, WARN_CLOSE, t->read, "'}' without '{' is left out");
    return true;
  }
  size_t first = t->polygon[--t->polygons], count = t->vertices - first;
  t->vertices = first;
  if (count < 3 || !t->to->polygon) return true;
  if (!turtle_flush(t)) return false;
  LsysPen pen = turtle_pen(t);
  return t->to->polygon(t->to, t->vertex + first, count, &pen);
}
