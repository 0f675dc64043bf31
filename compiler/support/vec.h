// vec.h -- growable arrays that live in an arena.
//
//   typedef VEC(Production) Productions;      struct { Production *at; size_t count, capacity; }
//   *VEC_PUSH(arena, &list) = production;     VEC_PUSH gives the address of a new, zeroed element
//
// Growing leaves the old block in the arena: pointers to elements may go
// stale, indices do not.
#ifndef LSYSC_SUPPORT_VEC_H
#define LSYSC_SUPPORT_VEC_H

#include "support/arena.h"

#define VEC(Type)                                                                                                      \
  struct {                                                                                                             \
    Type *at;                                                                                                          \
    size_t count, capacity;                                                                                            \
  }

#define VEC_PUSH(arena, vec)                                                                                           \
  ((vec)->count == (vec)->capacity                                                                                     \
     ? (void)((vec)->at = vec_grow((arena), (vec)->at, (vec)->count, &(vec)->capacity, sizeof *(vec)->at))             \
     : (void)0,                                                                                                        \
   &(vec)->at[(vec)->count++])

// Twice the capacity (at least 4), with the first count elements copied.
void *vec_grow(Arena *arena, void *at, size_t count, size_t *capacity, size_t size);

#endif
