// act.c -- what each module does to the turtle, one after another: the
// reference for the fast loop, and the way for everything that it leaves out.
#include "turtle/actions.h"

#include <string.h>

// ---- brackets ------------------------------------------------------------

bool turtle_push(LsysTurtle *t) {
  if (t->by_depth) turtle_change_pen(t);
  if (!turtle_grow(t, &t->stack, &t->stack_room, t->depth + 1, t->state_size)) return false;
  unsigned char *top = t->stack + t->depth++ * t->state_size;
  memcpy(top, &t->state, t->state_size);
  return true;
}

bool turtle_pop(LsysTurtle *t) {
  if (!t->depth) {
    turtle_warn(t, WARN_POP, t->read, "']' without '[' is left out");
    return true;
  }
  turtle_change_pen(t);
  const unsigned char *top = t->stack + --t->depth * t->state_size;
  memcpy(&t->state, top, t->state_size);
  turtle_jump(t);
  return true;
}

static bool act_push(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  return turtle_push(t);
}

static bool act_pop(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  return turtle_pop(t);
}

// ---- all -----------------------------------------------------------------

// NULL: the symbol does nothing to the turtle.
static TurtleAction *const actions[LSYS_TURTLE_COUNT] = {
  [LSYS_TURTLE_DRAW] = act_draw,
  [LSYS_TURTLE_DRAW_NO_VERTEX] = act_draw_no_vertex,
  [LSYS_TURTLE_MOVE] = act_move,
  [LSYS_TURTLE_MOVE_NO_VERTEX] = act_move_no_vertex,
  [LSYS_TURTLE_MOVE_TO] = act_move_to,
  [LSYS_TURTLE_SECOND_DRAW] = act_second_draw,
  [LSYS_TURTLE_SECOND_MOVE] = act_second_move,
  [LSYS_TURTLE_LEFT] = act_left,
  [LSYS_TURTLE_RIGHT] = act_right,
  [LSYS_TURTLE_DOWN] = act_down,
  [LSYS_TURTLE_UP] = act_up,
  [LSYS_TURTLE_ROLL_LEFT] = act_roll_left,
  [LSYS_TURTLE_ROLL_RIGHT] = act_roll_right,
  [LSYS_TURTLE_AROUND] = act_around,
  [LSYS_TURTLE_VERTICAL] = act_vertical,
  [LSYS_TURTLE_HEAD_TO] = act_head_to,
  [LSYS_TURTLE_SWAP_TURNS] = act_swap_turns,
  [LSYS_TURTLE_SECOND_TURN] = act_second_turn,
  [LSYS_TURTLE_ELASTICITY] = act_elasticity,
  [LSYS_TURTLE_TROPISM_SET] = act_tropism_set,
  [LSYS_TURTLE_TROPISM_UP] = act_tropism_up,
  [LSYS_TURTLE_TROPISM_DOWN] = act_tropism_down,
  [LSYS_TURTLE_TWIST_KEEP] = act_twist_keep,
  [LSYS_TURTLE_UNTWIST] = act_untwist,
  [LSYS_TURTLE_POLYGON_BEGIN] = act_polygon_begin,
  [LSYS_TURTLE_POLYGON_VERTEX] = act_polygon_vertex,
  [LSYS_TURTLE_POLYGON_END] = act_polygon_end,
  [LSYS_TURTLE_WIDTH] = act_width,
  [LSYS_TURTLE_WIDTH_UP] = act_width_up,
  [LSYS_TURTLE_COLOUR_UP] = act_colour_up,
  [LSYS_TURTLE_COLOUR_DOWN] = act_colour_down,
  [LSYS_TURTLE_COLOUR_ADD] = act_colour_add,
  [LSYS_TURTLE_COLOUR_SUBTRACT] = act_colour_subtract,
  [LSYS_TURTLE_STEP_SCALE] = act_step_scale,
  [LSYS_TURTLE_SCALE] = act_scale,
  [LSYS_TURTLE_SCALE_UP] = act_scale_up,
  [LSYS_TURTLE_SCALE_DOWN] = act_scale_down,
  [LSYS_TURTLE_SURFACE] = act_surface,
  [LSYS_TURTLE_CIRCLE] = act_circle,
  [LSYS_TURTLE_DISC] = act_disc,
  [LSYS_TURTLE_SPHERE] = act_sphere,
  [LSYS_TURTLE_BOX] = act_box,
  [LSYS_TURTLE_LABEL] = act_label,
  [LSYS_TURTLE_CYLINDER_BEGIN] = act_cylinder_begin,
  [LSYS_TURTLE_CYLINDER_POINT] = act_cylinder_point,
  [LSYS_TURTLE_CYLINDER_END] = act_cylinder_end,
  [LSYS_TURTLE_CYLINDER_TANGENT] = act_cylinder_tangent,
  [LSYS_TURTLE_CONTOUR] = act_contour,
  [LSYS_TURTLE_SIDES] = act_sides,
  [LSYS_TURTLE_PATCH_BEGIN] = act_patch_begin,
  [LSYS_TURTLE_PATCH_POINT] = act_patch_point,
  [LSYS_TURTLE_PATCH_DRAW] = act_patch_draw,
  [LSYS_TURTLE_VERTICAL_AT] = act_vertical,
  [LSYS_TURTLE_COLOUR_NEXT] = act_colour_up,
  [LSYS_TURTLE_PUSH] = act_push,
  [LSYS_TURTLE_POP] = act_pop,
};

// False if an argument that the operation reads is nan or infinite.
static bool arguments_finite(const KindInfo *kind, const double *arg) {
  int most = lsys_turtle[kind->op].most < kind->arity ? lsys_turtle[kind->op].most : kind->arity;
  for (int i = 0; i < most; i++) {
    if (!isfinite(arg[i])) return false;
  }
  return true;
}

static bool sets_colour(uint8_t op) {
  return actions[op] == act_colour_up || actions[op] == act_colour_down || actions[op] == act_colour_add
      || actions[op] == act_colour_subtract;
}

bool turtle_act(LsysTurtle *t, uint32_t kind, const double *arg) {
  const KindInfo *info = &t->kind[kind];
  if (t->by_kind) {
    if (info->colour == KEEP_COLOUR && sets_colour(info->op)) return true;
    if (info->colour != KEEP_COLOUR && info->colour != t->state.colour) {
      turtle_change_pen(t);
      t->state.colour = info->colour;
    }
  }
  if (t->skip_next) return turtle_draw_surface(t, kind, arg);
  if (info->text) return turtle_write_text(t, kind, arg);
  TurtleAction *action = actions[info->op];
  const int given = info->arity;
  if (!action || given < lsys_turtle[info->op].least) return true;
  if (given && !arguments_finite(info, arg)) {
    turtle_warn(t, WARN_NOT_FINITE, t->read, "the module is left out: its argument is nan or infinite");
    return true;
  }
  return action(t, given, arg);
}
