// signals.c -- removal of temporary files in a signal handler: nothing but
// loads, unlink and raise, all async-signal-safe.
#include "core/signals.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <unistd.h>

enum { TEMPORARIES = 64 };

// A signal handler can reach process-wide state only.
static const char *_Atomic temporaries[TEMPORARIES];

static void end(int signal) {
  for (int i = 0; i < TEMPORARIES; i++) {
    const char *path = atomic_load(&temporaries[i]);
    if (path) unlink(path);
  }
  raise(signal);  // SA_RESETHAND: with the default action now
}

void lsys_signals_install(void) {
  static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
    struct sigaction old, action = {.sa_handler = end, .sa_flags = (int)SA_RESETHAND};
    if (sigaction(ending[i], NULL, &old) == 0 && old.sa_handler == SIG_IGN) continue;
    sigemptyset(&action.sa_mask);
    sigaction(ending[i], &action, NULL);
  }
  // Writing then fails and is reported: a closed pipe, a limit of the size of files.
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

bool lsys_temporary_add(const char *path) {
  for (int i = 0; i < TEMPORARIES; i++) {
    const char *none = NULL;
    if (atomic_compare_exchange_strong(&temporaries[i], &none, path)) return true;
  }
  return false;
}

void lsys_temporary_remove(const char *path) {
  for (int i = 0; i < TEMPORARIES; i++) {
    const char *same = path;
    if (atomic_compare_exchange_strong(&temporaries[i], &same, NULL)) return;
  }
}
