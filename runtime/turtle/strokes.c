// strokes.c -- collects what the turtle draws into batches of strokes and hands
// them on in the page's coordinates.
#include "turtle/actions.h"

#include <string.h>

LsysVec3 turtle_out(const LsysTurtle *t, LsysVec3 p) {
  if (t->directions.lattice == LATTICE_NONE) return p;
  Pair out = directions_out(&t->directions, t->run->value[LSYS_SETTING_STEP], (Pair){p.x, p.y});
  return (LsysVec3){out[0], out[1], 0};
}

static LsysVec3 place(const LsysTurtle *t) {
  return (LsysVec3){t->state.at[0], t->state.at[1], t->state.z};
}

// Ends the open stroke and begins the next where the turtle stands.
static void end_stroke(LsysTurtle *t, bool joined) {
  uint32_t count = t->points - t->open;
  if (count >= 2) {
    LsysPen pen = turtle_pen(t);
    t->stroke[t->strokes++] = (LsysStroke){t->open, count, pen, t->joined};
    t->open = t->points++;
    t->joined = joined;
  } else {
    t->joined = joined && t->joined;
  }
  t->point[t->open] = place(t);
}

void turtle_jump(LsysTurtle *t) {
  end_stroke(t, false);
}

void turtle_change_pen(LsysTurtle *t) {
  if (t->points - t->open >= 2) end_stroke(t, true);
}

void turtle_draw_to(LsysTurtle *t) {
  t->point[t->points++] = place(t);
}

// A batch in coordinates of the page; on a lattice z is 0.
static inline void leave_lattice(const Directions *d, double step, LsysVec3 *point, const LsysVec3 *end) {
  for (; point < end; point++) {
    Pair p;
    memcpy(&p, point, sizeof p);
    p = directions_out(d, step, p);
    memcpy(point, &p, sizeof p);
  }
}

// A loop for each shape, in registers.
static void to_page(const LsysTurtle *t) {
  Directions d = t->directions;
  const double step = t->run->value[LSYS_SETTING_STEP];
  const LsysVec3 *end = t->point + t->points;
  if (t->directions.lattice == LATTICE_SQUARE) {
    d.lattice = LATTICE_SQUARE;
    leave_lattice(&d, step, t->point, end);
  } else if (t->directions.lattice == LATTICE_HEX) {
    d.lattice = LATTICE_HEX;
    leave_lattice(&d, step, t->point, end);
  }
}

bool turtle_flush(LsysTurtle *t) {
  turtle_change_pen(t);
  if (t->strokes && t->to->strokes) {
    to_page(t);
    LsysStrokes batch = {t->point, t->stroke, t->strokes, t->open};
    if (!t->to->strokes(t->to, &batch)) return false;
  }
  t->strokes = 0;
  t->open = 0;
  t->points = 1;
  t->point[0] = place(t);
  return true;
}
