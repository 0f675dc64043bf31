// memory.h -- the account that makes --max-memory hold: everything that can
// grow with the word is taken from it, by the driver, the sinks and the engines.
#ifndef LSYS_CORE_MEMORY_H
#define LSYS_CORE_MEMORY_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// No account (NULL) books nothing and refuses nothing.
typedef struct LsysMemory {
  _Atomic uint64_t used;
  uint64_t limit;  // bytes
} LsysMemory;

// Three quarters of the machine's memory.
uint64_t lsys_memory_default(void);

// Books bytes; false, with nothing booked and nothing printed, where that would pass the limit.
bool lsys_memory_take(LsysMemory *memory, uint64_t bytes);
void lsys_memory_give(LsysMemory *memory, uint64_t bytes);

// How many bytes may still be booked.
uint64_t lsys_memory_left(const LsysMemory *memory);

// The message for a refused booking of bytes more.
void lsys_memory_refuse(const LsysMemory *memory, uint64_t bytes);

// Zeroed memory for count elements of size bytes, booked; NULL after printing why not. Freed with the same count and
// size.
void *lsys_memory_alloc(LsysMemory *memory, size_t count, size_t size);
void lsys_memory_free(LsysMemory *memory, void *at, size_t count, size_t size);

// The same without a message: for what a run can do without.
void *lsys_memory_try(LsysMemory *memory, size_t count, size_t size);

// Doubles an array of *capacity elements (at least 64); the new part is not cleared.
// NULL after printing why not: the old array stays.
void *lsys_memory_grow(LsysMemory *memory, void *at, size_t *capacity, size_t size);

// Grows the array at *array, a pointer to elements of size bytes, until its *room is count elements or more. The new
// part is not cleared. False after printing why not: the array stays. Freed by lsys_memory_free with its room.
bool lsys_memory_fit(LsysMemory *memory, void *array, size_t *room, size_t count, size_t size);

#endif
