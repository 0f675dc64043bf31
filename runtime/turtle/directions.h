// directions.h -- the directions that a turtle in the page can have when it
// turns by multiples of one angle: a table, so that any number of turns is exact.
#ifndef LSYS_TURTLE_DIRECTIONS_H
#define LSYS_TURTLE_DIRECTIONS_H

#include "turtle/vector.h"

typedef enum LatticeShape {
  LATTICE_NONE,    // coordinates are the page's
  LATTICE_SQUARE,  // along the first heading and 90 degrees to its left, in steps
  LATTICE_HEX,     // along the first heading and 60 degrees to its left, in steps
} LatticeShape;

typedef struct Directions {
  uint32_t count;  // index k is the first heading turned left by k*360/count degrees
  uint32_t angle;  // index of one default turn to the left
  bool exact;      // the default angle is a whole number of indices
  Pair *at;        // unit steps, in lattice coordinates
  LatticeShape lattice;
  double first_cos, first_sin;  // of the first heading
} Directions;

// Makes the table for turns by `angle` degrees from the first heading `first`.
// fine: also whole degrees where possible. on_lattice: use a lattice if there is one for the angle.
// False if memory ran out.
bool directions_create(Directions *d, double angle, double first, bool fine, bool on_lattice);
void directions_destroy(Directions *d);

// The index of a turn to the left by any number of degrees; false if it is none of the table.
bool directions_find(const Directions *d, double degrees, uint32_t *index);

// From lattice coordinates to the page; step is the length of a lattice step.
static inline Pair directions_out(const Directions *d, double step, Pair p) {
  if (d->lattice == LATTICE_NONE) return p;
  bool hex = d->lattice == LATTICE_HEX;
  double ahead = hex ? p[0] + p[1] * 0.5 : p[0];
  double left = hex ? p[1] * 0.86602540378443864676 : p[1];
  const Pair first = {d->first_cos, d->first_sin}, across = {-d->first_sin, d->first_cos};
  return step * (first * ahead + across * left);
}

#endif
