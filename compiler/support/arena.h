// arena.h -- memory of one compilation: allocated piece by piece, released at once.
#ifndef LSYSC_SUPPORT_ARENA_H
#define LSYSC_SUPPORT_ARENA_H

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

typedef struct Arena Arena;

// A new, empty arena. Never returns NULL: running out of memory prints a
// message and exits with status 1, here and in every function below.
Arena *arena_create(void);
void arena_destroy(Arena *arena);

// size bytes, zeroed, aligned for any type; size 0 gives a valid pointer.
void *arena_alloc(Arena *arena, size_t size);

// count objects of size bytes each, zeroed; overflow counts as out of memory.
void *arena_array(Arena *arena, size_t count, size_t size);

// A copy of length bytes with a NUL behind them.
char *arena_copy(Arena *arena, const char *text, size_t length);

// printf into the arena.
char *arena_printf(Arena *arena, const char *format, ...) __attribute__((format(printf, 2, 3)));
char *arena_vprintf(Arena *arena, const char *format, va_list args);

#define ARENA_NEW(arena, Type) ((Type *)arena_alloc((arena), sizeof(Type)))

#endif
