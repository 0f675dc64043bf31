// turns.c -- what turns the turtle: in the page by the table of directions, in
// space by rotations of its frame.
// Sources: ABOP p. 19 (rotations), 57 ($); cpfg's manual.
#include "turtle/actions.h"

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
bool act_vertical(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  Frame *f = &t->state.frame;
  LsysVec3 left = vec_cross((LsysVec3){0, 1, 0}, f->h);
  if (vec_length(left) < 1e-12) return true;
  f->l = vec_unit(left);
  f->u = vec_cross(f->h, f->l);
  return true;
}

// 1, or -1 where + turns right.
static int left_side(const LsysTurtle *t) {
  return t->clockwise != t->state.swapped ? -1 : 1;
}

bool act_left(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_U, left_side(t), given, arg);
  return true;
}

bool act_right(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_U, -left_side(t), given, arg);
  return true;
}

bool act_down(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_L, 1, given, arg);
  return true;
}

bool act_up(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_L, -1, given, arg);
  return true;
}

bool act_roll_left(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_H, 1, given, arg);
  return true;
}

bool act_roll_right(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_H, -1, given, arg);
  return true;
}

bool act_around(LsysTurtle *t, int given, const double *arg) {
  turn(t, AXIS_U, 1, 1, given ? arg : &(double){180});
  return true;
}

bool act_swap_turns(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  t->state.swapped = !t->state.swapped;
  return true;
}

bool act_second_turn(LsysTurtle *t, int given, const double *arg) {
  if (given) t->state.second = fmod(t->state.second + left_side(t) * arg[0], 360);
  return true;
}

// ---- headings ------------------------------------------------------------

LsysVec3 turtle_heading(const LsysTurtle *t) {
  const State *s = &t->state;
  if (!t->flat) return s->frame.h;
  Pair d = s->extra == 0 ? t->directions.at[s->heading] : s->direction;
  return (LsysVec3){d[0], d[1], 0};
}

Frame turtle_frame(const LsysTurtle *t) {
  if (!t->flat) return t->state.frame;
  LsysVec3 ahead = turtle_heading(t), up = {0, 0, 1};
  Pair h = directions_out(&t->directions, 1, (Pair){ahead.x, ahead.y});
  LsysVec3 unit = vec_unit((LsysVec3){h[0], h[1], 0});
  return (Frame){unit, vec_cross(up, unit), up};
}

// @R: the frame whose heading is h and whose up vector is as near as can be to u.
bool act_head_to(LsysTurtle *t, int given, const double *arg) {
  LsysVec3 h = {arg[0], arg[1], given > 2 ? arg[2] : 0}, u = t->state.frame.u;
  if (given >= 6) u = (LsysVec3){arg[3], arg[4], arg[5]};
  if (vec_length(h) == 0 || !isfinite(vec_length(h))) return true;
  h = vec_unit(h);
  LsysVec3 l = vec_cross(u, h);
  if (vec_length(l) < 1e-12 * (1 + vec_length(u))) l = vec_sum(t->state.frame.l, 1, h, -vec_dot(t->state.frame.l, h));
  if (vec_length(l) < 1e-12) l = vec_cross(t->state.frame.h, h);
  l = vec_unit(l);
  t->state.frame = (Frame){h, l, vec_cross(h, l)};
  return true;
}
