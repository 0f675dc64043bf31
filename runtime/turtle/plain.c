// plain.c -- the fast loop of a turtle in the page whose turns are all in the
// table of directions and whose steps all have the default length: most D0L
// curves and plants.
//
// A move or a turn takes no branch: every module adds its turn to the heading,
// its length along the heading to the place, and stores the place; only moves
// that draw keep it.
#include "turtle/state.h"

#include <string.h>

// The cursors of the loop, in registers.
typedef struct Cursor {
  Pair at;
  uint32_t heading;
  LsysVec3 *out;  // the next free point
} Cursor;

static Cursor load(const LsysTurtle *t) {
  return (Cursor){t->state.at, t->state.heading, t->point + t->points};
}

static void store(LsysTurtle *t, const Cursor *c) {
  t->state.at = c->at;
  t->state.heading = c->heading;
  t->points = (uint32_t)(c->out - t->point);
}

// Brackets and moves without drawing. False to stop.
static bool act(LsysTurtle *t, Cursor *c, const PlainKind *k) {
  store(t, c);
  bool ok = true;
  switch ((PlainAct)k->act) {
  case PLAIN_PUSH:
    ok = turtle_push(t);
    break;
  case PLAIN_POP:
    ok = turtle_pop(t);
    break;
  case PLAIN_JUMP:
    t->state.at += t->directions.at[t->state.heading] * k->move;
    turtle_jump(t);
    break;
  case PLAIN_GO:
  case PLAIN_OTHER:
    break;
  }
  *c = load(t);
  return ok;
}

size_t turtle_read_plain(LsysTurtle *t, const uint8_t *sym, size_t count, bool *ok) {
  const PlainKind *kinds = t->plain_kind;
  const Pair *directions = t->directions.at;
  const uint32_t circle = t->directions.count;
  // A module adds at most two points: the end of its move, and the start of a new stroke.
  size_t room = (BATCH_POINTS - t->points) / 2;
  if (count > room) count = room;
  Cursor c = load(t);
  size_t i = 0;
  for (; i < count; i++) {
    const PlainKind *k = &kinds[sym[i]];
    if (__builtin_expect(k->act != PLAIN_GO, 0)) {
      if (k->act == PLAIN_OTHER) break;
      t->read += i;  // where a warning says it happened
      *ok = act(t, &c, k);
      t->read -= i;
      if (!*ok) break;
      if (k->act == PLAIN_POP && !turtle_is_plain(t)) return i + 1;
      continue;
    }
    uint32_t heading = c.heading + k->turn;
    c.heading = heading >= circle ? heading - circle : heading;
    c.at += directions[c.heading] * k->move;
    memcpy(c.out, &c.at, sizeof c.at);
    c.out += k->draws;
  }
  store(t, &c);
  return i;
}
