// actions.h -- what single modules do to the turtle: one function a symbol of
// turtle.def, listed in act.c.
#ifndef LSYS_TURTLE_ACTIONS_H
#define LSYS_TURTLE_ACTIONS_H

#include "turtle/state.h"

// given: number of arguments that the module has, at least the table's least and all finite as far as they are read.
// False to stop.
typedef bool TurtleAction(LsysTurtle *t, int given, const double *arg);

// turns.c
TurtleAction act_left, act_right, act_down, act_up, act_roll_left, act_roll_right, act_around, act_vertical;
TurtleAction act_head_to, act_swap_turns, act_second_turn;
TurtleAction act_elasticity, act_tropism_set, act_tropism_up, act_tropism_down, act_twist_keep, act_untwist;
void turtle_bend(LsysTurtle *t);               // towards the tropism of the settings, after a move
void turtle_lean(LsysTurtle *t);               // towards numbered tropisms, before a move
LsysVec3 turtle_heading(const LsysTurtle *t);  // unit, or one step on a lattice
Frame turtle_frame(const LsysTurtle *t);       // whatever the turtle keeps

// moves.c
TurtleAction act_draw, act_draw_no_vertex, act_move, act_move_no_vertex, act_move_to;
TurtleAction act_second_draw, act_second_move, act_step_scale, act_scale, act_scale_up, act_scale_down;
TurtleAction act_polygon_begin, act_polygon_vertex, act_polygon_end;

// pens.c
TurtleAction act_width, act_width_up, act_colour_up, act_colour_down, act_colour_add, act_colour_subtract;
LsysPen turtle_pen(const LsysTurtle *t);
double turtle_width(const LsysTurtle *t, double width);  // scaled, not negative

// sweep.c
TurtleAction act_cylinder_begin, act_cylinder_point, act_cylinder_end, act_cylinder_tangent, act_contour, act_sides;
TurtleAction act_patch_begin, act_patch_point, act_patch_draw;
bool turtle_spline_node(LsysTurtle *t);  // `.` and moves inside `{(n)`
bool turtle_spline_draw(LsysTurtle *t);  // `}`

// shapes.c
TurtleAction act_surface, act_circle, act_disc, act_sphere, act_box, act_label;
bool turtle_draw_surface(LsysTurtle *t, uint32_t kind, const double *arg);  // the module behind `~`
bool turtle_write_text(LsysTurtle *t, uint32_t kind, const double *arg);    // of a label that has one

#endif
