// map.c -- a hash table; see map.h.
#include "support/map.h"

#include <stdbool.h>
#include <string.h>

typedef struct Entry {
  const char *name;
  uint64_t number, hash;
  uint32_t index;
} Entry;

struct Map {
  Arena *arena;
  Entry *entries;  // hash 0: free
  size_t capacity, count;
};

enum { FIRST_CAPACITY = 64 };

Map *map_create(Arena *arena) {
  Map *map = ARENA_NEW(arena, Map);
  map->arena = arena;
  map->capacity = FIRST_CAPACITY;
  map->entries = arena_array(arena, FIRST_CAPACITY, sizeof(Entry));
  return map;
}

// FNV-1a over the name, then SplitMix64's finaliser over it and the number; never 0.
static uint64_t hash_of(const char *name, uint64_t number) {
  uint64_t z = UINT64_C(0xCBF29CE484222325);
  for (const char *c = name; c && *c; c++) z = (z ^ (unsigned char)*c) * UINT64_C(0x100000001B3);
  z ^= number * UINT64_C(0x9E3779B97F4A7C15);
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  z ^= z >> 31;
  return z ? z : 1;
}

static bool same_name(const char *a, const char *b) {
  return a == b || (a && b && strcmp(a, b) == 0);
}

// The entry that holds the key or the free one where it belongs.
static Entry *locate(const Map *map, const char *name, uint64_t number, uint64_t hash) {
  for (size_t i = hash & (map->capacity - 1);; i = (i + 1) & (map->capacity - 1)) {
    Entry *entry = &map->entries[i];
    if (entry->hash == 0) return entry;
    if (entry->hash == hash && entry->number == number && same_name(entry->name, name)) return entry;
  }
}

uint32_t map_find(const Map *map, const char *name, uint64_t number) {
  const Entry *entry = locate(map, name, number, hash_of(name, number));
  return entry->hash ? entry->index : MAP_NONE;
}

static void grow(Map *map) {
  const Entry *old = map->entries;
  size_t count = map->capacity;
  map->entries = arena_array(map->arena, count, 2 * sizeof(Entry));
  map->capacity = 2 * count;
  for (size_t i = 0; i < count; i++)
    if (old[i].hash) *locate(map, old[i].name, old[i].number, old[i].hash) = old[i];
}

uint32_t *map_place(Map *map, const char *name, uint64_t number) {
  if (map->count >= map->capacity / 2) grow(map);
  uint64_t hash = hash_of(name, number);
  Entry *entry = locate(map, name, number, hash);
  if (entry->hash == 0) {
    *entry = (Entry){name, number, hash, MAP_NONE};
    map->count++;
  }
  return &entry->index;
}
