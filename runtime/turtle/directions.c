// directions.c -- the table of directions: from an angle to the smallest full
// circle of its multiples.
#include "turtle/directions.h"

#include "lsys/functions.h"

#include <stdlib.h>

enum { MOST_DIRECTIONS = 4096 };

static uint32_t divisor(uint32_t a, uint32_t b) {
  while (b) {
    uint32_t rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

// The least number of equal turns in a full circle of which the angle is a multiple, 0 if it is too big.
// An angle such as 25.7 is a multiple of 360/3600 only up to the rounding of its decimals.
static uint32_t full_circle(double angle) {
  for (uint32_t n = 1; n <= MOST_DIRECTIONS; n++) {
    double turns = angle * n / 360;
    if (fabs(turns - rint(turns)) <= 1e-13 * (1 + fabs(turns))) return n;
  }
  return 0;
}

static uint32_t common(uint32_t a, uint32_t b) {
  uint64_t both = (uint64_t)a / divisor(a, b) * b;
  return both <= MOST_DIRECTIONS ? (uint32_t)both : a;
}

static LatticeShape lattice_of(uint32_t circle) {
  if (circle == 1 || circle == 2 || circle == 4) return LATTICE_SQUARE;
  return circle == 3 || circle == 6 ? LATTICE_HEX : LATTICE_NONE;
}

static Pair lattice_step(LatticeShape shape, uint32_t k) {
  static const double square[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  static const double hex[6][2] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
  const double *p = shape == LATTICE_SQUARE ? square[k] : hex[k];
  return (Pair){p[0], p[1]};
}

bool directions_create(Directions *d, double angle, double first, bool fine, bool on_lattice) {
  uint32_t circle = full_circle(angle);
  *d = (Directions){.exact = circle != 0, .first_cos = lsys_cos(first), .first_sin = lsys_sin(first)};
  if (on_lattice) d->lattice = lattice_of(circle);
  if (d->lattice) {
    d->count = d->lattice == LATTICE_SQUARE ? 4 : 6;
  } else {
    d->count = common(circle ? circle : 1, 2);  // `|` is half a circle
    if (fine) d->count = common(d->count, 360);
  }
  d->at = aligned_alloc(sizeof(Pair), d->count * sizeof(Pair));
  if (!d->at) return false;
  for (uint32_t k = 0; k < d->count; k++) {
    double degrees = k * 360.0 / d->count, c = lsys_cos(degrees), s = lsys_sin(degrees);
    d->at[k] = d->lattice ? lattice_step(d->lattice, k)
                          : (Pair){d->first_cos * c - d->first_sin * s, d->first_sin * c + d->first_cos * s};
  }
  if (d->exact) {
    double turns = fmod(rint(angle * d->count / 360), d->count);
    d->angle = (uint32_t)(turns < 0 ? turns + d->count : turns);
  }
  return true;
}

void directions_destroy(Directions *d) {
  free(d->at);
  d->at = NULL;
}

bool directions_find(const Directions *d, double degrees, uint32_t *index) {
  double turns = degrees * d->count / 360;
  if (turns != rint(turns)) return false;
  turns = fmod(turns, d->count);
  *index = (uint32_t)(turns < 0 ? turns + d->count : turns);
  return true;
}
