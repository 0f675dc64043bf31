// plain.c -- the fast loop of a turtle in the page whose turns are all in the
// table of directions and whose steps all have the default length: most D0L
// curves and plants.
//
// A move or a turn takes no branch: every module adds its turn to the heading,
// its length along the heading to the place, and stores the place; only moves
// that draw keep it. Brackets take one branch each, and none on what they find.
#include "turtle/actions.h"
#include "turtle/cursor.h"

// The small part of a State, as brackets keep it.
typedef struct Saved {
  Pair at;
  double width;
  uint32_t heading;
  uint8_t colour, rest[3];
} Saved;
_Static_assert(sizeof(Saved) == STATE_SMALL && offsetof(Saved, width) == offsetof(State, width)
                 && offsetof(Saved, heading) == offsetof(State, heading)
                 && offsetof(Saved, colour) == offsetof(State, colour),
               "Saved is the small part of State");

// `[` and `]` of a turtle with a small state. False: the general functions must see to it.
static inline bool push(const LsysTurtle *t, Cursor *c) {
  if (c->top + STATE_SMALL > t->stack + t->stack_room * STATE_SMALL) return false;
  Saved s;
  memcpy(&s, &t->state, sizeof s);
  s.at = c->at;
  s.heading = c->heading;
  memcpy(c->top, &s, sizeof s);
  c->top += STATE_SMALL;
  return true;
}

static inline bool pop(LsysTurtle *t, Cursor *c, LsysPen *pen) {
  if (c->top == t->stack) return false;
  Saved s;
  c->top -= STATE_SMALL;
  memcpy(&s, c->top, sizeof s);
  c->at = s.at;
  c->heading = s.heading;
  cursor_jump(t, c, pen);
  memcpy(&t->state, &s, sizeof s);
  *pen = (LsysPen){s.width, s.colour, pen->mark};
  return true;
}

// Brackets and moves without drawing, the general way. False to stop.
static bool act(LsysTurtle *t, Cursor *c, PlainAct what) {
  cursor_store(t, c);
  bool well = what == PLAIN_PUSH ? turtle_push(t) : turtle_pop(t);
  *c = cursor_load(t);
  return well;
}

static bool is_finite(double x) {
  return x - x == 0;
}

// What takes an argument. False: act.c must see to it.
static inline bool act_by_arg(const LsysTurtle *t, Cursor *c, const PlainKind *k, double x, const LsysPen *pen) {
  uint32_t turn;
  switch ((PlainAct)k->act) {
  case PLAIN_DRAW_ARG:
    if (!is_finite(x)) return false;
    c->at += t->directions.at[c->heading] * x;
    put_place(c->out++, c->at);
    return true;
  case PLAIN_JUMP_ARG:
    if (!is_finite(x)) return false;
    c->at += t->directions.at[c->heading] * x;
    cursor_jump(t, c, pen);
    return true;
  case PLAIN_TURN_ARG:
    if (!is_finite(x) || !directions_find(&t->directions, k->move * x, &turn)) return false;
    c->heading += turn;
    if (c->heading >= t->directions.count) c->heading -= t->directions.count;
    return true;
  case PLAIN_SKIP:
    return true;
  default:
    return false;
  }
}

// The modules from i on as long as they are turns, draws, or nothing. A loop of its own, as what it needs fits into the
// registers. Returns where they end.
static inline size_t go_along(const LsysTurtle *t, Cursor *c, const uint8_t *sym, size_t i, size_t count) {
  const PlainKind *kinds = t->plain_kind;
  const Pair *directions = t->directions.at;
  const uint32_t circle = t->directions.count;
  Pair at = c->at;
  uint32_t heading = c->heading;
  char *out = (char *)c->out;
  for (; i < count; i++) {
    const PlainKind *k = &kinds[sym[i]];
    if (k->act != PLAIN_GO) break;
    uint32_t turned = heading + k->turn;
    heading = turned >= circle ? turned - circle : turned;
    at += directions[heading] * k->move;
    memcpy(out, &at, sizeof at);
    out += k->advance;
  }
  c->at = at;
  c->heading = heading;
  c->out = (LsysVec3 *)out;
  return i;
}

size_t turtle_read_plain(LsysTurtle *t, const uint8_t *sym, const double **arg, size_t count, bool *ok) {
  const PlainKind *kinds = t->plain_kind;
  const Pair *directions = t->directions.at;
  const bool small = t->state_size == STATE_SMALL && !t->by_depth;
  // A module adds at most two points: the end of its move, and the start of a new stroke. So the batch is found full
  // behind the first module that fills it, wherever the word's parts end: what is drawn does not depend on them.
  size_t room = (BATCH_FULL + 1 - t->points) / 2;
  if (count > room) count = room;
  Cursor c = cursor_load(t);
  LsysPen pen = turtle_pen(t);
  size_t i = 0;
  for (; (i = go_along(t, &c, sym, i, count)) < count; i++) {
    const PlainKind *k = &kinds[sym[i]];
    if (k->act == PLAIN_JUMP) {
      c.at += directions[c.heading] * k->move;
      cursor_jump(t, &c, &pen);
    } else if (k->skip) {
      if (!act_by_arg(t, &c, k, **arg, &pen)) break;
      *arg += k->skip;
    } else if (k->act == PLAIN_OTHER) {
      break;
    } else if (!small || !(k->act == PLAIN_PUSH ? push(t, &c) : pop(t, &c, &pen))) {
      t->read += i;  // where a warning says it happened
      *ok = act(t, &c, (PlainAct)k->act);
      t->read -= i;
      pen = turtle_pen(t);
      if (!*ok) break;
      if (!turtle_is_plain(t)) return i + 1;
    }
  }
  cursor_store(t, &c);
  return i;
}
