// cursor.h -- where the turtle stands and what it has drawn of the batch, for the
// fast loops of plain.c and replay.c.
#ifndef LSYS_TURTLE_CURSOR_H
#define LSYS_TURTLE_CURSOR_H

#include "turtle/state.h"

#include <string.h>

// What the loops change, in registers.
typedef struct Cursor {
  Pair at;
  uint32_t heading;
  LsysVec3 *out;       // the next free point
  LsysVec3 *open;      // where the open stroke begins
  LsysStroke *stroke;  // the next free stroke
  unsigned char *top;  // of the stack
  bool joined;
} Cursor;

static inline Cursor cursor_load(const LsysTurtle *t) {
  return (Cursor){.at = t->state.at,
                  .heading = t->state.heading,
                  .out = t->point + t->points,
                  .open = t->point + t->open,
                  .stroke = t->stroke + t->strokes,
                  .top = t->stack + t->depth * t->state_size,
                  .joined = t->joined};
}

static inline void cursor_store(LsysTurtle *t, const Cursor *c) {
  t->state.at = c->at;
  t->state.heading = c->heading;
  t->points = (uint32_t)(c->out - t->point);
  t->open = (uint32_t)(c->open - t->point);
  t->strokes = (uint32_t)(c->stroke - t->stroke);
  t->depth = (size_t)(c->top - t->stack) / t->state_size;
  t->joined = c->joined;
}

static inline void put_place(LsysVec3 *to, Pair at) {
  memcpy(to, &at, sizeof at);
}

// The turtle stands somewhere else: the open stroke, if it has a segment, is written, and another begins.
static inline void cursor_jump(const LsysTurtle *t, Cursor *c, const LsysPen *pen) {
  uint32_t count = (uint32_t)(c->out - c->open);
  bool drawn = count >= 2;
  *c->stroke = (LsysStroke){(uint32_t)(c->open - t->point), count, *pen, c->joined};
  c->stroke += drawn;
  c->open = drawn ? c->out : c->open;
  put_place(c->open, c->at);
  c->out = c->open + 1;
  c->joined = false;
}

#endif
