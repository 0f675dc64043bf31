// places.c -- a set of places, each known by a 64-bit hash of its coordinates,
// rounded so that two ways to the same one agree. Of 2^18 places the chance
// that two hashes collide is 2^-29.
#include "turtle/places.h"

#include "core/memory.h"

#include <math.h>

enum { MOST_PLACES = 1 << 18 };

static const double GRAIN = 1e6;  // places nearer than a millionth of a unit are one

static uint64_t hash(const LsysVec3 *p) {
  uint64_t h = 0;
  const double coordinate[3] = {p->x, p->y, p->z};
  for (int i = 0; i < 3; i++) {
    double rounded = rint(coordinate[i] * GRAIN);
    int64_t whole = fabs(rounded) < 0x1p62 ? (int64_t)rounded : 0;
    h = lsys_mix64(h ^ (uint64_t)whole) + LSYS_GOLDEN;
  }
  return h ? h : 1;
}

static void insert(LsysPlaces *s, uint64_t h) {
  uint64_t i = h & (s->room - 1);
  while (s->slot[i] && s->slot[i] != h) i = (i + 1) & (s->room - 1);
  if (s->slot[i] == h) return;
  s->slot[i] = h;
  s->count++;
}

static bool grow(LsysPlaces *s) {
  LsysPlaces bigger = {.room = s->room ? 2 * s->room : 1024};
  if (s->count >= MOST_PLACES) return false;
  bigger.slot = lsys_memory_try(s->memory, bigger.room, sizeof *bigger.slot);
  if (!bigger.slot) return false;
  for (uint64_t i = 0; i < s->room; i++) {
    if (s->slot[i]) insert(&bigger, s->slot[i]);
  }
  lsys_places_free(s);
  s->slot = bigger.slot;
  s->room = bigger.room;
  return true;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysPlaces *s = (LsysPlaces *)to;
  for (size_t i = 0; i < batch->points && !s->full; i++) {
    if (2 * s->count >= s->room && !grow(s)) s->full = true;
    if (!s->full) insert(s, hash(&batch->point[i]));
  }
  return !s->next || s->next->strokes(s->next, batch);
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  LsysGeometry *next = ((LsysPlaces *)to)->next;
  return !next || !next->polygon || next->polygon(next, vertices, count, pen);
}

static bool mesh(LsysGeometry *to, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  LsysGeometry *next = ((LsysPlaces *)to)->next;
  return !next || !next->mesh || next->mesh(next, mesh, place, pen);
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  LsysGeometry *next = ((LsysPlaces *)to)->next;
  return !next || !next->ball || next->ball(next, centre, diameter, disc, pen);
}

void lsys_places_begin(LsysPlaces *s, LsysMemory *memory, LsysGeometry *next) {
  *s = (LsysPlaces){.geometry = {strokes, polygon, mesh, ball, NULL}, .next = next, .memory = memory};
}

void lsys_places_free(LsysPlaces *s) {
  lsys_memory_free(s->memory, s->slot, s->room, sizeof *s->slot);
  s->slot = NULL;
}
