// arena.c -- blocks of growing size, chained; an allocation is a bump.
#include "support/arena.h"

#include "support/vec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Block {
  struct Block *next;
  size_t used, size;
  max_align_t data[];
} Block;

struct Arena {
  Block *blocks;  // the newest first; only it has room
};

enum { FIRST_BLOCK = 1 << 16, LARGEST_BLOCK = 1 << 24, ALIGNMENT = 16 };

static _Noreturn void out_of_memory(void) {
  fputs("lsysc: error: out of memory\n", stderr);
  exit(1);
}

static Block *block_create(size_t size, Block *next) {
  if (size > SIZE_MAX - sizeof(Block)) out_of_memory();
  Block *block = calloc(1, sizeof(Block) + size);
  if (!block) out_of_memory();
  block->next = next;
  block->size = size;
  return block;
}

Arena *arena_create(void) {
  Arena *arena = malloc(sizeof *arena);
  if (!arena) out_of_memory();
  arena->blocks = block_create(FIRST_BLOCK, NULL);
  return arena;
}

void arena_destroy(Arena *arena) {
  if (!arena) return;
  for (Block *block = arena->blocks, *next; block; block = next) {
    next = block->next;
    free(block);
  }
  free(arena);
}

void *arena_alloc(Arena *arena, size_t size) {
  if (size > SIZE_MAX - ALIGNMENT) out_of_memory();
  size = (size + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
  Block *block = arena->blocks;
  if (block->size - block->used < size) {
    size_t next = block->size < LARGEST_BLOCK ? block->size * 2 : LARGEST_BLOCK;
    block = arena->blocks = block_create(size > next ? size : next, block);
  }
  void *result = (char *)block->data + block->used;
  block->used += size;
  return result;
}

void *arena_array(Arena *arena, size_t count, size_t size) {
  size_t bytes;
  if (__builtin_mul_overflow(count, size, &bytes)) out_of_memory();
  return arena_alloc(arena, bytes);
}

char *arena_copy(Arena *arena, const char *text, size_t length) {
  char *copy = arena_array(arena, length + 1, 1);
  if (length) memcpy(copy, text, length);
  return copy;
}

char *arena_vprintf(Arena *arena, const char *format, va_list args) {
  va_list again;
  va_copy(again, args);
  int length = vsnprintf(NULL, 0, format, again);
  va_end(again);
  if (length < 0) return arena_copy(arena, "", 0);
  char *text = arena_array(arena, (size_t)length + 1, 1);
  vsnprintf(text, (size_t)length + 1, format, args);
  return text;
}

char *arena_printf(Arena *arena, const char *format, ...) {
  va_list args;
  va_start(args, format);
  char *text = arena_vprintf(arena, format, args);
  va_end(args);
  return text;
}

void *vec_grow(Arena *arena, void *at, size_t count, size_t *capacity, size_t size) {
  size_t wanted = *capacity ? *capacity : 2;
  if (__builtin_mul_overflow(wanted, (size_t)2, &wanted)) out_of_memory();
  void *grown = arena_array(arena, wanted, size);
  if (count) memcpy(grown, at, count * size);
  *capacity = wanted;
  return grown;
}
