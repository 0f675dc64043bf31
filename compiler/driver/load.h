// load.h -- where lsysc's own files are, and the back end that it loads from there.
#ifndef LSYSC_DRIVER_LOAD_H
#define LSYSC_DRIVER_LOAD_H

#include "codegen/backend.h"

// The folder of liblsysrt.a and lsysc-llvm.so: $LSYSC_HOME, else ../lib/lsysc beside the folder of the executable.
const char *home_find(Arena *arena);

// The back end, loaded from home at the first call. NULL after printing why it cannot be loaded.
const Backend *backend_load(Arena *arena, const char *home);

#endif
