// load.c -- the way to lsysc-llvm.so. Starting LLVM costs 20 to 30 ms, so
// help, check and interp never come here.
#include "driver/load.h"
#include "driver/report.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifndef LSYSC_STATIC_LLVM
#include <dlfcn.h>
#endif

const char *home_find(Arena *arena) {
  const char *given = getenv("LSYSC_HOME");
  if (given && *given) return given;
  char path[PATH_MAX];
  ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
  for (int up = 0; up < 2; up++)  // off with "/lsysc", off with "/bin"
    while (length > 0 && path[--length] != '/') {
    }
  return arena_printf(arena, "%.*s/lib/lsysc", length > 0 ? (int)length : 0, path);
}

#ifdef LSYSC_STATIC_LLVM

const Backend *backend_load(Arena *arena, const char *home) {
  (void)arena, (void)home;
  return &lsysc_backend;
}

#else

const Backend *backend_load(Arena *arena, const char *home) {
  const char *path = arena_printf(arena, "%s/lsysc-llvm.so", home);
  void *module = dlopen(path, RTLD_LAZY | RTLD_LOCAL);  // stays loaded until the process ends
  const Backend *backend = module ? dlsym(module, "lsysc_backend") : NULL;
  if (!backend)
    report_error("cannot load the code generator: %s\n"
                 "lsysc: note: `interp` needs none; LSYSC_HOME names the folder that holds lsysc-llvm.so",
                 dlerror());
  return backend;
}

#endif
