// pens.c -- what changes the width and colour of lines.
// Sources: ABOP p. 26, 57; cpfg's manual; Fractint's commands c, < and >.
#include "turtle/actions.h"

static const double THINNER = 0.70710678118654752440;  // `!`: two equal branches have their parent's cross-section

static uint32_t mark(const LsysTurtle *t) {
  if (t->by_age) return t->born;
  size_t depth = t->by_depth ? t->depth : 0;
  return depth > UINT32_MAX ? UINT32_MAX : (uint32_t)depth;
}

LsysPen turtle_pen(const LsysTurtle *t) {
  return (LsysPen){t->state.width, t->state.colour, mark(t)};
}

double turtle_width(const LsysTurtle *t, double width) {
  return width > 0 ? width * t->state.size : 0;
}

static void set_width(LsysTurtle *t, double width) {
  turtle_change_pen(t);
  t->state.width = width;
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

// One `#` or, with sign -1, `!` without an argument.
static double other_width(const LsysTurtle *t, int sign) {
  if (isfinite(t->width_step)) return fmax(t->state.width + sign * t->width_step * t->state.size, 0);
  return sign < 0 ? t->state.width * THINNER : t->state.width / THINNER;
}

bool act_width(LsysTurtle *t, int given, const double *arg) {
  set_width(t, given ? turtle_width(t, arg[0]) : other_width(t, -1));
  return true;
}

bool act_width_up(LsysTurtle *t, int given, const double *arg) {
  set_width(t, given ? turtle_width(t, arg[0]) : other_width(t, 1));
  return true;
}

bool act_colour_up(LsysTurtle *t, int given, const double *arg) {
  set_colour(t, given ? arg[0] : t->state.colour + t->colour_step);
  return true;
}

bool act_colour_down(LsysTurtle *t, int given, const double *arg) {
  set_colour(t, given ? arg[0] : t->state.colour - t->colour_step);
  return true;
}

bool act_colour_add(LsysTurtle *t, int given, const double *arg) {
  add_colour(t, 1, given, arg);
  return true;
}

bool act_colour_subtract(LsysTurtle *t, int given, const double *arg) {
  add_colour(t, -1, given, arg);
  return true;
}
