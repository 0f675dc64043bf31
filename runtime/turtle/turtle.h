// turtle.h -- reads a word and draws: packed words in, geometry out.
//
// The symbols, their arguments and defaults are those of turtle.def; the
// settings (angle, step, width, colour, turns, heading) come from run->value.
#ifndef LSYS_TURTLE_TURTLE_H
#define LSYS_TURTLE_TURTLE_H

#include "turtle/geometry.h"

typedef struct LsysTurtle LsysTurtle;

// A turtle for words of the run's grammar, which must outlive it. run->value is
// read here, so it must be initialised. NULL after printing why.
LsysTurtle *lsys_turtle_create(const LsysRun *run);
void lsys_turtle_destroy(LsysTurtle *turtle);

// True if no symbol of the grammar leaves the plane of the page: every z is 0.
bool lsys_turtle_flat(const LsysTurtle *turtle);

// Strokes shall know how many brackets were open where they were drawn (LsysPen.mark): they end at `[`, too.
void lsys_turtle_by_depth(LsysTurtle *turtle);

// Strokes shall know the step in which the modules that draw them were born (LsysPen.mark, LsysRun.born).
void lsys_turtle_by_age(LsysTurtle *turtle);

// What is drawn shall have the colour of the module that draws it, counted from 0 in the grammar's order; where all
// segments are drawn by one kind, of the last module that the turtle ignores, counted likewise.
void lsys_turtle_by_kind(LsysTurtle *turtle);

// True if a tropism of the settings is in effect from the start.
bool lsys_turtle_bends(const LsysRun *run);

// True if the grammar has generalised cylinders, whose widths are lengths: then all widths are.
bool lsys_turtle_widths_are_lengths(const LsysTurtle *turtle);

// Starts the word of an axiom, drawn to `to`: the turtle stands at the origin, its state as the settings say.
void lsys_turtle_begin(LsysTurtle *turtle, uint32_t axiom, LsysGeometry *to);

// Draws the next part of the word. False if the geometry wants to stop or memory ran out (printed).
// Odd words have a defined result and one warning a turtle: `]` without `[` and `}` without `{` do nothing,
// a module with an argument that is nan or infinite does nothing, a negative width is 0.
bool lsys_turtle_take(LsysTurtle *turtle, const LsysWord *part);

// Ends the word: hands on what is left. A polygon that was not closed is not drawn (warning).
bool lsys_turtle_end(LsysTurtle *turtle);

// Where the turtle stands.
LsysVec3 lsys_turtle_position(const LsysTurtle *turtle);

// How it stands: place, frame (orthonormal, H x L = U) and pen.
typedef struct LsysPose {
  LsysVec3 at, h, l, u;
  double width;
  uint8_t colour;
} LsysPose;
LsysPose lsys_turtle_pose(const LsysTurtle *turtle);

// Lets the turtle take any pose, from now on and by lsys_turtle_set_pose; it is slower then.
void lsys_turtle_free(LsysTurtle *turtle);

// Lets the turtle remember where lines end, and say nothing of odd words.
void lsys_turtle_watch(LsysTurtle *turtle);

// The end of the last line on the turtle's path, its first place if there is none; returns how many are on it.
uint32_t lsys_turtle_drawn(const LsysTurtle *turtle, LsysVec3 *end);

// Puts a free turtle elsewhere. False if the geometry wants to stop.
bool lsys_turtle_set_pose(LsysTurtle *turtle, const LsysPose *pose);

#endif
