// turtle.c -- packed words in, geometry out: sets the turtle up from a grammar's
// kinds and the run's settings, and reads words part by part.
// Invariant: between two parts everything that the turtle knows is in LsysTurtle.
#include "turtle/turtle.h"

#include "core/memory.h"
#include "core/message.h"
#include "turtle/actions.h"
#include "turtle/trail.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

// ---- messages and memory -------------------------------------------------

void turtle_warn(LsysTurtle *t, TurtleWarning which, uint64_t place, const char *text) {
  if (t->warned & 1u << which) return;
  t->warned |= 1u << which;
  lsys_warning("axiom %" PRIu32 ", module %" PRIu64 ": %s (said once)", t->axiom + 1, place + 1, text);
}

static bool out_of_memory(void) {
  lsys_error("out of memory for the turtle");
  return false;
}

bool turtle_grow(LsysTurtle *t, void *array, size_t *room, size_t count, size_t size) {
  return lsys_memory_fit(t->run->memory, array, room, count, size);
}

// ---- set-up --------------------------------------------------------------

// What a grammar's symbols can make a turtle do.
typedef struct Abilities {
  bool leaves_page;  // rotates about other axes than U, or goes to places with a z
  bool free_frame;   // takes any heading
  bool any_length;   // moves whose length is not the default one
  bool any_angle;    // turns by an argument
  bool more_state;   // changes of State beyond its small part
  bool untwists;     // goes back to a roll that was kept
  bool sweeps;       // generalised cylinders
} Abilities;

static Abilities abilities(const LsysGrammar *g) {
  Abilities can = {0};
  for (uint32_t i = 0; i < g->surface_count; i++) {
    can.leaves_page |= g->surfaces[i].form == LSYS_SURFACE_BOX || g->surfaces[i].form == LSYS_SURFACE_MESH;
  }
  for (uint32_t i = 0; i < g->kind_count; i++) {
    bool given = g->kinds[i].arity > 0;
    switch ((LsysTurtleOp)g->kinds[i].turtle) {
    case LSYS_TURTLE_DRAW:
    case LSYS_TURTLE_DRAW_NO_VERTEX:
    case LSYS_TURTLE_MOVE:
    case LSYS_TURTLE_MOVE_NO_VERTEX:
      can.any_length |= given;
      break;
    case LSYS_TURTLE_LEFT:
    case LSYS_TURTLE_RIGHT:
    case LSYS_TURTLE_AROUND:
      can.any_angle |= given;
      break;
    case LSYS_TURTLE_DOWN:
    case LSYS_TURTLE_UP:
    case LSYS_TURTLE_ROLL_LEFT:
    case LSYS_TURTLE_ROLL_RIGHT:
    case LSYS_TURTLE_BOX:
    case LSYS_TURTLE_VERTICAL:
    case LSYS_TURTLE_VERTICAL_AT:
      can.leaves_page = true;
      break;
    case LSYS_TURTLE_CYLINDER_BEGIN:
    case LSYS_TURTLE_PATCH_DRAW:
      can.leaves_page = true;
      can.sweeps |= g->kinds[i].turtle == LSYS_TURTLE_CYLINDER_BEGIN;
      break;
    case LSYS_TURTLE_POLYGON_BEGIN:
      can.leaves_page |= given;
      can.sweeps |= given;
      break;
    case LSYS_TURTLE_STEP_SCALE:
    case LSYS_TURTLE_SECOND_DRAW:
    case LSYS_TURTLE_SECOND_MOVE:
      can.any_length = can.more_state = true;
      break;
    case LSYS_TURTLE_SWAP_TURNS:
    case LSYS_TURTLE_SECOND_TURN:
      can.more_state = true;
      break;
    case LSYS_TURTLE_SCALE:
    case LSYS_TURTLE_SCALE_UP:
    case LSYS_TURTLE_SCALE_DOWN:
      can.any_length = can.more_state = true;
      break;
    case LSYS_TURTLE_MOVE_TO:
      can.any_length = true;
      can.leaves_page |= g->kinds[i].arity > 2;
      break;
    case LSYS_TURTLE_HEAD_TO:
      can.free_frame = true;
      can.leaves_page |= g->kinds[i].arity > 2;
      break;
    case LSYS_TURTLE_ELASTICITY:
    case LSYS_TURTLE_TROPISM_SET:
    case LSYS_TURTLE_TROPISM_UP:
    case LSYS_TURTLE_TROPISM_DOWN:
      can.free_frame = true;
      break;
    case LSYS_TURTLE_TWIST_KEEP:
    case LSYS_TURTLE_UNTWIST:
      can.free_frame = can.untwists = true;
      break;
    default:
      break;
    }
  }
  return can;
}

double turtle_setting(const LsysRun *run, LsysSetting which) {
  double value = run->value[which];
  if (isfinite(value)) return value;
  lsys_warning("%s: is %g; %g is taken instead", lsys_settings[which].keyword, value, lsys_settings[which].value);
  return run->value[which] = lsys_settings[which].value;
}

static uint32_t surface_of(const LsysGrammar *g, const char *symbol) {
  for (uint32_t i = 0; i < g->surface_count && i < NO_SURFACE; i++) {
    if (strcmp(g->surfaces[i].name, symbol) == 0) return i;
  }
  return NO_SURFACE;
}

// What the fast loop does for a kind with arguments. F(l,w) has a width of its own.
static void set_plain_arg(const LsysTurtle *t, PlainKind *p, const LsysKind *kind) {
  const double left = t->clockwise ? -1 : 1;
  switch ((LsysTurtleOp)kind->turtle) {
  case LSYS_TURTLE_NONE:
    p->act = PLAIN_SKIP;
    break;
  case LSYS_TURTLE_DRAW:
  case LSYS_TURTLE_DRAW_NO_VERTEX:
    p->act = kind->arity == 2 ? PLAIN_OTHER : PLAIN_DRAW_ARG;
    break;
  case LSYS_TURTLE_MOVE:
  case LSYS_TURTLE_MOVE_NO_VERTEX:
    p->act = PLAIN_JUMP_ARG;
    break;
  case LSYS_TURTLE_LEFT:
  case LSYS_TURTLE_RIGHT:
    p->act = PLAIN_TURN_ARG;
    p->move = kind->turtle == LSYS_TURTLE_LEFT ? left : -left;
    break;
  default:
    break;
  }
}

static void set_kind(LsysTurtle *t, uint32_t i, const LsysKind *kind) {
  const LsysGrammar *g = t->run->grammar;
  t->kind[i] = (KindInfo){.op = kind->turtle,
                          .arity = (uint8_t)(kind->arity > 255 ? 255 : kind->arity),
                          .width = kind->arity,
                          .colour = KEEP_COLOUR,
                          .surface = surface_of(g, kind->symbol),
                          .text = g->texts ? g->texts[i] : NULL};
  PlainKind *p = &t->plain_kind[i];
  *p = (PlainKind){.act = PLAIN_OTHER, .skip = kind->arity};
  const uint32_t n = t->directions.count, angle = t->directions.angle, back = (n - angle) % n;
  if (kind->arity) {
    set_plain_arg(t, p, kind);
    return;
  }
  switch ((LsysTurtleOp)kind->turtle) {
  case LSYS_TURTLE_NONE:
    p->act = PLAIN_GO;
    break;
  case LSYS_TURTLE_DRAW:
  case LSYS_TURTLE_DRAW_NO_VERTEX:
    *p = (PlainKind){t->step, 0, sizeof(LsysVec3), PLAIN_GO, 0};
    break;
  case LSYS_TURTLE_MOVE:
  case LSYS_TURTLE_MOVE_NO_VERTEX:
    *p = (PlainKind){t->step, 0, 0, PLAIN_JUMP, 0};
    break;
  case LSYS_TURTLE_LEFT:
    *p = (PlainKind){0, t->clockwise ? back : angle, 0, PLAIN_GO, 0};
    break;
  case LSYS_TURTLE_RIGHT:
    *p = (PlainKind){0, t->clockwise ? angle : back, 0, PLAIN_GO, 0};
    break;
  case LSYS_TURTLE_AROUND:
    *p = (PlainKind){0, n / 2, 0, PLAIN_GO, 0};
    break;
  case LSYS_TURTLE_PUSH:
    p->act = PLAIN_PUSH;
    break;
  case LSYS_TURTLE_POP:
    p->act = PLAIN_POP;
    break;
  default:
    break;
  }
}

static Frame first_frame(const Directions *d) {
  LsysVec3 h = {d->first_cos, d->first_sin, 0}, u = {0, 0, 1};
  return (Frame){h, vec_cross(u, h), u};
}

static bool set_up(LsysTurtle *t) {
  const LsysGrammar *g = t->run->grammar;
  Abilities can = abilities(g);
  double heading = turtle_setting(t->run, LSYS_SETTING_HEADING);
  t->tropism =
    (LsysVec3){turtle_setting(t->run, LSYS_SETTING_TROPISM_X), turtle_setting(t->run, LSYS_SETTING_TROPISM_Y),
               turtle_setting(t->run, LSYS_SETTING_TROPISM_Z)};
  double elasticity = turtle_setting(t->run, LSYS_SETTING_ELASTICITY);
  double elasticities[LSYS_TROPISMS];
  bool leans_in_page = turtle_set_tropisms(t, t->run, elasticities);
  bool bends = can.free_frame || elasticity != 0 || t->tropisms;
  t->untwists = can.untwists || t->tropisms;
  t->in_page = !can.leaves_page && !(bends && t->tropism.z != 0) && leans_in_page;
  t->flat = t->in_page && !bends;
  t->angle = turtle_setting(t->run, LSYS_SETTING_ANGLE);
  t->turn_cos = lsys_cos(t->angle);
  t->turn_sin = lsys_sin(t->angle);
  t->clockwise = turtle_setting(t->run, LSYS_SETTING_TURNS) != 0;
  t->to_points = g->environment == LSYS_ENVIRONMENT_POINT;
  bool lattice = t->flat && !can.any_length && !can.any_angle;
  if (!directions_create(&t->directions, t->angle, heading, can.any_angle, lattice)) return out_of_memory();
  t->width_step = t->run->value[LSYS_SETTING_WIDTH_STEP];
  t->colour_step = turtle_setting(t->run, LSYS_SETTING_COLOUR_STEP);
  t->elasticity_step = turtle_setting(t->run, LSYS_SETTING_ELASTICITY_STEP);
  double step = turtle_setting(t->run, LSYS_SETTING_STEP), width = turtle_setting(t->run, LSYS_SETTING_WIDTH);
  t->step = t->directions.lattice ? 1 : step;
  t->plain = t->flat && t->directions.exact && !(g->flags & LSYS_GRAMMAR_WIDE);
  t->sweeps = can.sweeps;
  t->state_size = can.sweeps                                                          ? sizeof(State)
                : t->untwists                                                         ? STATE_UNTWIST
                : t->flat && t->directions.exact && !can.any_angle && !can.more_state ? STATE_SMALL
                                                                                      : STATE_MEDIUM;
  double colour = fmod(trunc(turtle_setting(t->run, LSYS_SETTING_COLOUR)), 256);
  t->start = (State){.width = width > 0 ? width : 0,
                     .colour = (uint8_t)(colour < 0 ? colour + 256 : colour),
                     .second = heading,
                     .scale = 1,
                     .size = 1,
                     .tangent = {1.2, 1.2},
                     .sides = (uint8_t)fmin(fmax(turtle_setting(t->run, LSYS_SETTING_CONTOUR_SIDES), 3), MOST_SIDES),
                     .elasticity = elasticity,
                     .frame = first_frame(&t->directions),
                     .kept = first_frame(&t->directions)};
  memcpy(t->start.elasticities, elasticities, sizeof elasticities);
  t->kind = calloc(g->kind_count + 1, sizeof *t->kind);
  t->plain_kind = calloc(g->kind_count + 1, sizeof *t->plain_kind);
  // One point more: the fast loop stores the place behind the last point, too.
  t->point = calloc(BATCH_POINTS + 1, sizeof *t->point);
  t->stroke = calloc(BATCH_POINTS / 2 + 1, sizeof *t->stroke);
  if (!t->kind || !t->plain_kind || !t->point || !t->stroke) return out_of_memory();
  for (uint32_t i = 0; i < g->kind_count; i++) set_kind(t, i, &g->kinds[i]);
  return true;
}

LsysTurtle *lsys_turtle_create(const LsysRun *run) {
  LsysTurtle *t = aligned_alloc(_Alignof(LsysTurtle), sizeof *t);
  if (!t) {
    out_of_memory();
    return NULL;
  }
  memset(t, 0, sizeof *t);
  t->run = run;
  if (!set_up(t)) {
    lsys_turtle_destroy(t);
    return NULL;
  }
  return t;
}

void lsys_turtle_destroy(LsysTurtle *t) {
  if (!t) return;
  turtle_forget_trails(t);
  directions_destroy(&t->directions);
  free(t->kind);
  free(t->plain_kind);
  free(t->point);
  free(t->stroke);
  LsysMemory *memory = t->run->memory;
  Sweep *s = &t->sweep;
  lsys_memory_free(memory, t->stack, t->stack_room, t->state_size);
  lsys_memory_free(memory, t->vertex, t->vertex_room, sizeof *t->vertex);
  lsys_memory_free(memory, t->polygon, t->polygon_room, sizeof *t->polygon);
  lsys_memory_free(memory, s->node, s->node_room, sizeof *s->node);
  lsys_memory_free(memory, s->patch, s->patch_room, sizeof *s->patch);
  lsys_memory_free(memory, s->vertex, s->vertex_room, sizeof *s->vertex);
  lsys_memory_free(memory, s->normal, s->normal_room, sizeof *s->normal);
  lsys_memory_free(memory, s->corner, s->corner_room, sizeof *s->corner);
  free(t);
}

bool lsys_turtle_widths_are_lengths(const LsysTurtle *t) {
  return t->sweeps || t->run->value[LSYS_SETTING_WIDTHS] == 1;
}

bool lsys_turtle_flat(const LsysTurtle *t) {
  return t->in_page;
}

void lsys_turtle_by_depth(LsysTurtle *t) {
  t->by_depth = true;
}

void lsys_turtle_by_age(LsysTurtle *t) {
  t->by_age = true;
}

// The part that begins was born at another time than what was drawn.
static void change_birth(LsysTurtle *t) {
  uint32_t born = t->run->born > UINT32_MAX ? UINT32_MAX : (uint32_t)t->run->born;
  if (born == t->born) return;
  turtle_change_pen(t);
  t->born = born;
}

static bool draws(uint8_t op) {
  return op == LSYS_TURTLE_DRAW || op == LSYS_TURTLE_DRAW_NO_VERTEX || op == LSYS_TURTLE_SECOND_DRAW;
}

void lsys_turtle_by_kind(LsysTurtle *t) {
  uint32_t kinds = t->run->grammar->kind_count, drawing = 0;
  for (uint32_t i = 0; i < kinds; i++) drawing += draws(t->kind[i].op);
  uint8_t next = 0;
  for (uint32_t i = 0; i < kinds; i++) {
    bool counts = drawing > 1 ? draws(t->kind[i].op) : t->kind[i].op == LSYS_TURTLE_NONE;
    t->kind[i].colour = counts && next < KEEP_COLOUR ? next++ : KEEP_COLOUR;
  }
  t->by_kind = true;
  t->plain = false;
}

// ---- reading -------------------------------------------------------------

void lsys_turtle_begin(LsysTurtle *t, uint32_t axiom, LsysGeometry *to) {
  t->to = to;
  t->state = t->start;
  t->axiom = axiom;
  t->read = 0;
  t->depth = 0;
  t->vertices = t->polygons = 0;
  t->strokes = t->open = 0;
  t->points = 1;
  t->point[0] = (LsysVec3){0};
  t->joined = false;
  t->born = 0;
  t->skip_next = t->splining = false;
  t->sweep.nodes = t->sweep.patches = 0;
}

static uint32_t symbol(const LsysTurtle *t, const uint8_t *sym, uint64_t i) {
  if (!(t->run->grammar->flags & LSYS_GRAMMAR_WIDE)) return sym[i];
  uint16_t wide;
  memcpy(&wide, sym + 2 * i, sizeof wide);
  return wide;
}

bool lsys_turtle_take(LsysTurtle *t, const LsysWord *part) {
  const double *arg = part->arg;
  const uint64_t start = t->read;
  bool ok = true;
  if (t->by_age) change_birth(t);
  if (turtle_follow(t, part, &ok)) {
    t->read += part->nsym;
    return ok;
  }
  for (uint64_t i = 0; i < part->nsym;) {
    t->read = start + i;
    if (t->points >= BATCH_FULL && !turtle_flush(t)) return false;
    if (turtle_is_plain(t)) {
      size_t plain = turtle_read_plain(t, part->sym + i, &arg, part->nsym - i, &ok);
      if (!ok) return false;
      i += plain;
      if (plain) continue;
    }
    uint32_t kind = symbol(t, part->sym, i);
    if (!turtle_act(t, kind, arg)) return false;
    arg += t->kind[kind].width;
    i++;
  }
  t->read = start + part->nsym;
  return true;
}

bool lsys_turtle_end(LsysTurtle *t) {
  if (t->polygons) turtle_warn(t, WARN_OPEN_POLYGON, t->polygon_place, "'{' without '}': the polygon is not drawn");
  return turtle_flush(t);
}

LsysPose lsys_turtle_pose(const LsysTurtle *t) {
  Frame f = turtle_frame(t);
  return (LsysPose){lsys_turtle_position(t), f.h, f.l, f.u, t->state.width, t->state.colour};
}

void lsys_turtle_free(LsysTurtle *t) {
  t->flat = t->plain = false;
  t->directions.lattice = LATTICE_NONE;
  t->step = t->run->value[LSYS_SETTING_STEP];
  t->state_size = sizeof(State);
}

void lsys_turtle_watch(LsysTurtle *t) {
  t->plain = false;
  t->warned = UINT32_MAX;
  t->watches = true;
  t->state_size = sizeof(State);
}

uint32_t lsys_turtle_drawn(const LsysTurtle *t, LsysVec3 *end) {
  *end = turtle_out(t, t->state.drawn);
  return t->state.lines;
}

bool lsys_turtle_set_pose(LsysTurtle *t, const LsysPose *p) {
  if (!turtle_flush(t)) return false;
  t->state.at = (Pair){p->at.x, p->at.y};
  t->state.z = p->at.z;
  t->state.frame = (Frame){p->h, p->l, p->u};
  t->state.width = p->width;
  t->state.colour = p->colour;
  turtle_jump(t);
  return true;
}

LsysVec3 lsys_turtle_position(const LsysTurtle *t) {
  return turtle_out(t, (LsysVec3){t->state.at[0], t->state.at[1], t->state.z});
}
