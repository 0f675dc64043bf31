// map.h -- from a name and a number to an index, in an arena.
//
// The key is the name's text and the number; either may be left out (NULL, 0).
// Open addressing with a power of two of places, at most half of them taken.
#ifndef LSYSC_SUPPORT_MAP_H
#define LSYSC_SUPPORT_MAP_H

#include "support/arena.h"

#include <stdint.h>

#define MAP_NONE UINT32_MAX

typedef struct Map Map;

Map *map_create(Arena *arena);

// The index of a key, MAP_NONE if it has none.
uint32_t map_find(const Map *map, const char *name, uint64_t number);

// The place of a key's index; a new key's is MAP_NONE. Valid until the next map_place. The name is not copied.
uint32_t *map_place(Map *map, const char *name, uint64_t number);

#endif
