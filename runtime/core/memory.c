// memory.c -- booked allocation. The account counts what was asked for, not
// pages touched: a bound that can be kept on every machine.
#include "core/memory.h"

#include "core/message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LEAST_CAPACITY = 64 };

uint64_t lsys_memory_default(void) {
  long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || size <= 0) return UINT64_C(1) << 30;
  return (uint64_t)pages * (uint64_t)size / 4 * 3;
}

bool lsys_memory_take(LsysMemory *memory, uint64_t bytes) {
  if (!memory) return true;
  uint64_t used = atomic_load_explicit(&memory->used, memory_order_relaxed);
  do {
    if (bytes > memory->limit || used > memory->limit - bytes) return false;
  } while (!atomic_compare_exchange_weak_explicit(&memory->used, &used, used + bytes, memory_order_relaxed,
                                                  memory_order_relaxed));
  return true;
}

void lsys_memory_give(LsysMemory *memory, uint64_t bytes) {
  if (memory) atomic_fetch_sub_explicit(&memory->used, bytes, memory_order_relaxed);
}

uint64_t lsys_memory_left(const LsysMemory *memory) {
  if (!memory) return UINT64_MAX;
  uint64_t used = atomic_load_explicit(&memory->used, memory_order_relaxed);
  return used < memory->limit ? memory->limit - used : 0;
}

// A size for people: three digits, in the unit that fits.
typedef struct SizeText {
  char text[24];
} SizeText;

static SizeText size_text(uint64_t bytes) {
  static const char *const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  double size = (double)bytes;
  unsigned unit = 0;
  for (; size >= 1000 && unit < 4; unit++) size /= 1024;
  SizeText result;
  snprintf(result.text, sizeof result.text, "%.3g %s", size, units[unit]);
  return result;
}

void lsys_memory_refuse(const LsysMemory *memory, uint64_t bytes) {
  if (!memory) {
    lsys_error("out of memory: %s more are wanted", size_text(bytes).text);
    return;
  }
  lsys_error("out of memory: %s are in use, %s more are wanted, and --max-memory is %s",
             size_text(atomic_load(&memory->used)).text, size_text(bytes).text, size_text(memory->limit).text);
}

static size_t product(size_t count, size_t size) {
  size_t bytes;
  return __builtin_mul_overflow(count, size, &bytes) ? SIZE_MAX : bytes;
}

void *lsys_memory_try(LsysMemory *memory, size_t count, size_t size) {
  size_t bytes = product(count, size);
  if (!lsys_memory_take(memory, bytes)) return NULL;
  void *at = calloc(count ? count : 1, size);
  if (!at) lsys_memory_give(memory, bytes);
  return at;
}

void *lsys_memory_alloc(LsysMemory *memory, size_t count, size_t size) {
  void *at = lsys_memory_try(memory, count, size);
  if (!at) lsys_memory_refuse(memory, product(count, size));
  return at;
}

void lsys_memory_free(LsysMemory *memory, void *at, size_t count, size_t size) {
  if (!at) return;
  free(at);
  lsys_memory_give(memory, (uint64_t)count * size);
}

// The array of `before` bytes with room for `wanted` elements; NULL after printing why not, and the array stays.
static void *move(LsysMemory *memory, void *at, size_t before, size_t wanted, size_t size) {
  size_t bytes = product(wanted, size);
  void *grown = NULL;
  // Both arrays stand side by side while the old one is copied.
  if (lsys_memory_take(memory, bytes)) {
    grown = realloc(at, bytes);
    lsys_memory_give(memory, grown ? before : bytes);
  }
  if (!grown) lsys_memory_refuse(memory, bytes);
  return grown;
}

void *lsys_memory_grow(LsysMemory *memory, void *at, size_t *capacity, size_t size) {
  size_t wanted = *capacity ? *capacity : LEAST_CAPACITY / 2, before = at ? *capacity * size : 0;
  if (__builtin_mul_overflow(wanted, (size_t)2, &wanted)) wanted = SIZE_MAX;
  void *grown = move(memory, at, before, wanted, size);
  if (grown) *capacity = wanted;
  return grown;
}

bool lsys_memory_fit(LsysMemory *memory, void *array, size_t *room, size_t count, size_t size) {
  if (count <= *room) return true;
  size_t wanted = *room < LEAST_CAPACITY / 2 ? LEAST_CAPACITY : 2 * *room;
  if (wanted < count) wanted = count;
  void *old;
  memcpy(&old, array, sizeof old);
  void *grown = move(memory, old, *room * size, wanted, size);
  if (!grown) return false;
  memcpy(array, &grown, sizeof grown);
  *room = wanted;
  return true;
}
