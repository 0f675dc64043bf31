// bigint.h -- natural numbers of any size: what exact counts of modules need, no more.
#ifndef LSYS_CORE_BIGINT_H
#define LSYS_CORE_BIGINT_H

#include "core/memory.h"

typedef struct LsysBig {
  uint64_t *limb;  // little-endian, without leading zeros: 0 has none
  size_t count, capacity;
} LsysBig;

// to += factor * a, where a is not to. False after printing that there is no memory.
bool lsys_big_add_product(LsysMemory *memory, LsysBig *to, const LsysBig *a, uint64_t factor);

void lsys_big_clear(LsysBig *a);  // a = 0
void lsys_big_free(LsysMemory *memory, LsysBig *a);

// The decimal digits as a string of *size bytes to be freed with lsys_memory_free; destroys a. NULL after printing why
// not.
char *lsys_big_decimal(LsysMemory *memory, LsysBig *a, size_t *size);

#endif
