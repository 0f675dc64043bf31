// link.h -- from generated code to files: objects, programs, and temporary
// files that never outlive lsysc.
#ifndef LSYSC_DRIVER_LINK_H
#define LSYSC_DRIVER_LINK_H

#include "driver/options.h"

// The name that -o or the grammar's name asks for. NULL after printing why it cannot be written there.
const char *output_name(Arena *arena, const Options *options, const char *grammar);

// Writes size bytes as the file `name` ("-": standard output), whole or not at all. False after printing why.
bool output_write(Arena *arena, const char *name, const void *bytes, size_t size);

// What the back end wrote; empty where it had no part.
typedef struct Code {
  char *bytes;
  size_t size;
} Code;

// Links objects and the run time in folder `home` into the program `name`, whole or not at all. SIGINT and the like
// remove what is unfinished. False after printing why; the linker prints its own errors.
bool link_program(Arena *arena, const Options *options, const char *home, const char *name,
                  const Code objects[BACKEND_PARTS]);

#endif
