// places.h -- how many different places a drawn figure passes through: a curve
// whose every segment leads to a new one does not touch itself (ABOP p. 12: FASS).
#ifndef LSYS_TURTLE_PLACES_H
#define LSYS_TURTLE_PLACES_H

#include "turtle/geometry.h"

typedef struct LsysPlaces {
  LsysGeometry geometry;      // what the turtle draws to
  LsysGeometry *next;         // where everything goes on to; NULL: nowhere
  struct LsysMemory *memory;  // that it books on; NULL: none
  uint64_t *slot;             // hashes of places, 0 free
  uint64_t count, room;       // different places; size of the table, a power of two
  bool full;                  // too many to count
} LsysPlaces;

void lsys_places_begin(LsysPlaces *places, struct LsysMemory *memory, LsysGeometry *next);
void lsys_places_free(LsysPlaces *places);

#endif
