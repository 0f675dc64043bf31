// strokes.c -- collects what the turtle draws into batches of strokes and hands
// them on in the page's coordinates.
#include "turtle/actions.h"

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

bool turtle_flush(LsysTurtle *t) {
  turtle_change_pen(t);
  if (t->strokes && t->to->strokes) {
    if (t->directions.lattice) {
      for (uint32_t i = 0; i < t->points; i++) t->point[i] = turtle_out(t, t->point[i]);
    }
    LsysStrokes batch = {t->point, t->stroke, t->strokes, t->open};
    if (!t->to->strokes(t->to, &batch)) return false;
  }
  t->strokes = 0;
  t->open = 0;
  t->points = 1;
  t->point[0] = place(t);
  return true;
}
