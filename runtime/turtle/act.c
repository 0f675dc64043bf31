// act.c -- what each module does to the turtle, one after another: the
// reference for the fast loop, and the way for everything that it leaves out.
// Sources: ABOP p. 18-27, 46, 57, 119-122; cpfg's manual.
#include "turtle/state.h"

#include <stdlib.h>
#include <string.h>

static const double THINNER = 0.70710678118654752440;  // `!`: two equal branches have their parent's cross-section

// ---- brackets ------------------------------------------------------------

bool turtle_push(LsysTurtle *t) {
  turtle_change_pen(t);
  if (!turtle_grow(&t->stack, &t->stack_room, t->depth + 1, t->state_size)) return false;
  unsigned char *top = t->stack + t->depth++ * t->state_size;
  if (t->state_size == STATE_SMALL) {
    memcpy(top, &t->state, STATE_SMALL);
  } else {
    memcpy(top, &t->state, sizeof t->state);
  }
  return true;
}

bool turtle_pop(LsysTurtle *t) {
  if (!t->depth) {
    turtle_warn(t, WARN_POP, t->read, "']' without '[' is left out");
    return true;
  }
  turtle_change_pen(t);
  const unsigned char *top = t->stack + --t->depth * t->state_size;
  if (t->state_size == STATE_SMALL) {
    memcpy(&t->state, top, STATE_SMALL);
  } else {
    memcpy(&t->state, top, sizeof t->state);
  }
  turtle_jump(t);
  return true;
}

// ---- turns ---------------------------------------------------------------

typedef enum Axis { AXIS_U, AXIS_L, AXIS_H } Axis;

static void turn_frame(LsysTurtle *t, Axis axis, double c, double s) {
  Frame *f = &t->state.frame;
  switch (axis) {
  case AXIS_U:
    vec_turn(&f->h, &f->l, c, s);
    break;
  case AXIS_L:
    vec_turn(&f->u, &f->h, c, s);
    break;
  case AXIS_H:
    vec_turn(&f->l, &f->u, c, s);
    break;
  }
  if (++t->state.turned >= STRAIGHTEN_TURNS) {
    frame_straighten(f);
    t->state.turned = 0;
  }
}

// Turns to the left in the page by a number of degrees.
static void turn_page(LsysTurtle *t, double degrees) {
  State *s = &t->state;
  const Directions *d = &t->directions;
  uint32_t index;
  if (directions_find(d, degrees, &index)) {
    s->heading = (s->heading + index) % d->count;
    if (s->extra == 0) return;
  } else {
    s->extra = fmod(s->extra + degrees, 360);
  }
  double c = lsys_cos(s->extra), sine = lsys_sin(s->extra);
  Pair at = d->at[s->heading];
  s->direction = (Pair){c * at[0] - sine * at[1], sine * at[0] + c * at[1]};
}

// About an axis by the module's argument, or by the default angle; sign -1: to the other side.
static void turn(LsysTurtle *t, Axis axis, int sign, int given, const double *arg) {
  State *s = &t->state;
  if (t->flat) {
    if (!given && t->directions.exact) {
      uint32_t n = t->directions.count, by = sign > 0 ? t->directions.angle : n - t->directions.angle;
      s->heading = (s->heading + by) % n;
      if (s->extra == 0) return;
      turn_page(t, 0);
    } else {
      turn_page(t, sign * (given ? arg[0] : t->angle));
    }
  } else if (given) {
    turn_frame(t, axis, lsys_cos(arg[0]), sign * lsys_sin(arg[0]));
  } else {
    turn_frame(t, axis, t->turn_cos, sign * t->turn_sin);
  }
}

// `$`: rolls about H until L is horizontal (ABOP p. 57); undefined, so left as it is, where H is vertical.
static void roll_to_vertical(LsysTurtle *t) {
  Frame *f = &t->state.frame;
  LsysVec3 left = vec_cross((LsysVec3){0, 1, 0}, f->h);
  if (t->flat || vec_length(left) < 1e-12) return;
  f->l = vec_unit(left);
  f->u = vec_cross(f->h, f->l);
}

// @R: the frame whose heading is h and whose up vector is as near as can be to u.
static void head_to(LsysTurtle *t, int given, const double *arg) {
  LsysVec3 h = {arg[0], arg[1], given > 2 ? arg[2] : 0}, u = t->state.frame.u;
  if (given >= 6) u = (LsysVec3){arg[3], arg[4], arg[5]};
  if (vec_length(h) == 0 || !isfinite(vec_length(h))) return;
  h = vec_unit(h);
  LsysVec3 l = vec_cross(u, h);
  if (vec_length(l) < 1e-12 * (1 + vec_length(u))) l = vec_sum(t->state.frame.l, 1, h, -vec_dot(t->state.frame.l, h));
  if (vec_length(l) < 1e-12) l = vec_cross(t->state.frame.h, h);
  l = vec_unit(l);
  t->state.frame = (Frame){h, l, vec_cross(h, l)};
}

// Bends the frame towards the tropism by e |H x T| radians (ABOP p. 58), never beyond it.
static void bend(LsysTurtle *t) {
  Frame *f = &t->state.frame;
  LsysVec3 axis = vec_cross(f->h, t->tropism);
  double sine = vec_length(axis), angle = t->state.elasticity * sine;
  if (t->flat || !(fabs(angle) > 1e-15)) return;
  double most = angle > 0 ? atan2(sine, vec_dot(f->h, t->tropism)) : atan2(sine, -vec_dot(f->h, t->tropism));
  angle = copysign(fmin(fabs(angle), most), angle);
  axis = vec_scale(axis, 1 / sine);
  double c = cos(angle), s = sin(angle);
  *f = (Frame){vec_about(f->h, axis, c, s), vec_about(f->l, axis, c, s), vec_about(f->u, axis, c, s)};
  frame_straighten(f);
}

static void set_elasticity(LsysTurtle *t, int given, const double *arg, double base, double sign) {
  if (given && arg[0] != 1) {
    turtle_warn(t, WARN_TROPISM, t->read, "there is one tropism only, number 1: the module is left out");
    return;
  }
  t->state.elasticity = base + sign * (given > 1 ? arg[1] : 0);
}

// ---- moves ---------------------------------------------------------------

static void go(LsysTurtle *t, LsysVec3 direction, double length) {
  t->state.at += (Pair){direction.x, direction.y} * length;
  t->state.z += direction.z * length;
}

static LsysVec3 heading(const LsysTurtle *t) {
  const State *s = &t->state;
  if (!t->flat) return s->frame.h;
  Pair d = s->extra == 0 ? t->directions.at[s->heading] : s->direction;
  return (LsysVec3){d[0], d[1], 0};
}

static double length_of(const LsysTurtle *t, int given, const double *arg) {
  return (given ? arg[0] : t->step * t->state.scale) * t->state.size;
}

static bool vertex(LsysTurtle *t) {
  LsysVec3 p = turtle_out(t, (LsysVec3){t->state.at[0], t->state.at[1], t->state.z});
  if (t->vertices > t->polygon[t->polygons - 1]) {
    const LsysVec3 *last = &t->vertex[t->vertices - 1];
    if (last->x == p.x && last->y == p.y && last->z == p.z) return true;
  }
  if (!turtle_grow(&t->vertex, &t->vertex_room, t->vertices + 1, sizeof *t->vertex)) return false;
  t->vertex[t->vertices++] = p;
  return true;
}

// Moves; records an edge of the open polygon if `edge`.
static bool move(LsysTurtle *t, LsysVec3 direction, double length, bool draw, bool edge) {
  edge = edge && t->polygons;
  if (edge && t->vertices == t->polygon[t->polygons - 1] && !vertex(t)) return false;
  go(t, direction, length);
  bend(t);
  if (draw) {
    turtle_draw_to(t);
  } else {
    turtle_jump(t);
  }
  return !edge || vertex(t);
}

static double width_of(const LsysTurtle *t, double width) {
  return width > 0 ? width * t->state.size : 0;
}

// F(l,w): the width is that of this segment only.
static bool draw(LsysTurtle *t, bool edge, int arity, const double *arg) {
  if (arity != 2) return move(t, heading(t), length_of(t, arity, arg), true, edge);
  double width = t->state.width;
  turtle_change_pen(t);
  t->state.width = width_of(t, arg[1]);
  bool ok = move(t, heading(t), arg[0] * t->state.size, true, edge);
  turtle_change_pen(t);
  t->state.width = width;
  return ok;
}

static void move_to(LsysTurtle *t, int given, const double *arg) {
  t->state.at = (Pair){arg[0], arg[1]};
  t->state.z = given > 2 ? arg[2] : 0;
  turtle_jump(t);
}

static LsysVec3 second_direction(const LsysTurtle *t) {
  return (LsysVec3){lsys_cos(t->state.second), lsys_sin(t->state.second), 0};
}

// ---- polygons ------------------------------------------------------------

static bool polygon_begin(LsysTurtle *t) {
  if (!turtle_grow(&t->polygon, &t->polygon_room, t->polygons + 1, sizeof *t->polygon)) return false;
  t->polygon[t->polygons++] = t->vertices;
  t->polygon_place = t->read;
  return true;
}

static bool polygon_end(LsysTurtle *t) {
  if (!t->polygons) {
    turtle_warn(t, WARN_CLOSE, t->read, "'}' without '{' is left out");
    return true;
  }
  size_t first = t->polygon[--t->polygons], count = t->vertices - first;
  t->vertices = first;
  if (count < 3 || !t->to->polygon) return true;
  if (!turtle_flush(t)) return false;
  LsysPen pen = {t->state.width, t->state.colour, t->depth > UINT32_MAX ? UINT32_MAX : (uint32_t)t->depth};
  return t->to->polygon(t->to, t->vertex + first, count, &pen);
}

// ---- pens ----------------------------------------------------------------

static void set_width(LsysTurtle *t, double width) {
  turtle_change_pen(t);
  t->state.width = width;
}

// Scales are positive: others, and what would overflow, are left out.
static void set_size(LsysTurtle *t, double size) {
  if (size > 0 && isfinite(size)) t->state.size = size;
}

// Colour indices go round: 256 is 0.
static void set_colour(LsysTurtle *t, double index) {
  turtle_change_pen(t);
  double colour = fmod(trunc(index), 256);
  t->state.colour = (uint8_t)(colour < 0 ? colour + 256 : colour);
}

// Fractint's relative colours: modulo the number of colours, and instead of 0 the one beyond.
static void add_colour(LsysTurtle *t, int sign, int arity, const double *arg) {
  double colours = arity > 1 ? fmin(fmax(trunc(arg[1]), 2), 256) : 256;
  double index = fmod(t->state.colour + sign * (arity ? trunc(arg[0]) : 0), colours);
  if (index < 0) index += colours;
  if (index == 0) index = sign > 0 ? 1 : colours - 1;
  set_colour(t, index);
}

// --------------------------------------------------------------------------

// False if an argument that the operation reads is nan or infinite.
static bool arguments_finite(const KindInfo *kind, const double *arg) {
  int most = lsys_turtle[kind->op].most < kind->arity ? lsys_turtle[kind->op].most : kind->arity;
  for (int i = 0; i < most; i++) {
    if (!isfinite(arg[i])) return false;
  }
  return true;
}

bool turtle_act(LsysTurtle *t, const KindInfo *kind, const double *arg) {
  const int given = kind->arity;
  if (t->skip_next) {  // the module behind `~` is a surface, whatever its symbol
    t->skip_next = false;
    return true;
  }
  if (given < lsys_turtle[kind->op].least) return true;  // another symbol of the same name: it draws nothing
  if (given && !arguments_finite(kind, arg)) {
    turtle_warn(t, WARN_NOT_FINITE, t->read, "the module is left out: its argument is nan or infinite");
    return true;
  }
  const int left = t->clockwise != t->state.swapped ? -1 : 1;
  switch ((LsysTurtleOp)kind->op) {
  case LSYS_TURTLE_NONE:
  case LSYS_TURTLE_COUNT:
    return true;
  case LSYS_TURTLE_DRAW:
    return draw(t, true, given, arg);
  case LSYS_TURTLE_DRAW_NO_VERTEX:
    return draw(t, false, given, arg);
  case LSYS_TURTLE_MOVE:
    return move(t, heading(t), length_of(t, given, arg), false, true);
  case LSYS_TURTLE_MOVE_NO_VERTEX:
    return move(t, heading(t), length_of(t, given, arg), false, false);
  case LSYS_TURTLE_SECOND_DRAW:
    return move(t, second_direction(t), length_of(t, given, arg), true, true);
  case LSYS_TURTLE_SECOND_MOVE:
    return move(t, second_direction(t), length_of(t, given, arg), false, true);
  case LSYS_TURTLE_LEFT:
    turn(t, AXIS_U, left, given, arg);
    return true;
  case LSYS_TURTLE_RIGHT:
    turn(t, AXIS_U, -left, given, arg);
    return true;
  case LSYS_TURTLE_DOWN:
    turn(t, AXIS_L, 1, given, arg);
    return true;
  case LSYS_TURTLE_UP:
    turn(t, AXIS_L, -1, given, arg);
    return true;
  case LSYS_TURTLE_ROLL_LEFT:
    turn(t, AXIS_H, 1, given, arg);
    return true;
  case LSYS_TURTLE_ROLL_RIGHT:
    turn(t, AXIS_H, -1, given, arg);
    return true;
  case LSYS_TURTLE_AROUND:
    turn(t, AXIS_U, 1, 1, given ? arg : &(double){180});
    return true;
  case LSYS_TURTLE_VERTICAL:
  case LSYS_TURTLE_VERTICAL_AT:
    roll_to_vertical(t);
    return true;
  case LSYS_TURTLE_PUSH:
    return turtle_push(t);
  case LSYS_TURTLE_POP:
    return turtle_pop(t);
  case LSYS_TURTLE_POLYGON_BEGIN:
    return polygon_begin(t);
  case LSYS_TURTLE_POLYGON_VERTEX:
    return !t->polygons || vertex(t);
  case LSYS_TURTLE_POLYGON_END:
    return polygon_end(t);
  case LSYS_TURTLE_WIDTH:
    set_width(t, given ? width_of(t, arg[0]) : t->state.width * THINNER);
    return true;
  case LSYS_TURTLE_WIDTH_UP:
    set_width(t, given ? width_of(t, arg[0]) : t->state.width / THINNER);
    return true;
  case LSYS_TURTLE_COLOUR_NEXT:
  case LSYS_TURTLE_COLOUR_UP:
    set_colour(t, given ? arg[0] : t->state.colour + 1.0);
    return true;
  case LSYS_TURTLE_COLOUR_DOWN:
    set_colour(t, given ? arg[0] : t->state.colour - 1.0);
    return true;
  case LSYS_TURTLE_COLOUR_ADD:
    add_colour(t, 1, given, arg);
    return true;
  case LSYS_TURTLE_COLOUR_SUBTRACT:
    add_colour(t, -1, given, arg);
    return true;
  case LSYS_TURTLE_STEP_SCALE:
    t->state.scale *= given ? arg[0] : 1;
    return true;
  case LSYS_TURTLE_SWAP_TURNS:
    t->state.swapped = !t->state.swapped;
    return true;
  case LSYS_TURTLE_SECOND_TURN:
    t->state.second = fmod(t->state.second + left * (given ? arg[0] : 0), 360);
    return true;
  case LSYS_TURTLE_CUT:
    return true;
  case LSYS_TURTLE_MOVE_TO:
    move_to(t, given, arg);
    return true;
  case LSYS_TURTLE_HEAD_TO:
    head_to(t, given, arg);
    return true;
  case LSYS_TURTLE_SCALE:
    set_size(t, arg[0]);
    return true;
  case LSYS_TURTLE_SCALE_UP:
    set_size(t, t->state.size * arg[0]);
    return true;
  case LSYS_TURTLE_SCALE_DOWN:
    set_size(t, t->state.size / arg[0]);
    return true;
  case LSYS_TURTLE_TROPISM_SET:
    set_elasticity(t, given, arg, 0, 1);
    return true;
  case LSYS_TURTLE_TROPISM_UP:
    set_elasticity(t, given, arg, t->state.elasticity, 1);
    return true;
  case LSYS_TURTLE_TROPISM_DOWN:
    set_elasticity(t, given, arg, t->state.elasticity, -1);
    return true;
  case LSYS_TURTLE_SURFACE:
    t->skip_next = true;
    return true;
  }
  return true;
}
