// sink.c -- memory for what sinks prepare on other threads.
#include "sinks/sink.h"

#include "core/memory.h"

char *lsys_prepared_room(LsysPrepared *prepared, size_t size) {
  while (prepared->room - prepared->used < size) {
    char *grown = lsys_memory_grow(prepared->memory, prepared->data, &prepared->room, 1);
    if (!grown) return NULL;
    prepared->data = grown;
  }
  return prepared->data + prepared->used;
}
