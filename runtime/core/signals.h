// signals.h -- SIGINT, SIGTERM and SIGHUP end the program at once, without
// leaving temporary files.
#ifndef LSYS_CORE_SIGNALS_H
#define LSYS_CORE_SIGNALS_H

#include <stdbool.h>

// Installs the handlers (a signal that is ignored stays so); SIGPIPE becomes a write error.
void lsys_signals_install(void);

// Registers a file that a signal removes. The text must live until it is taken out. False if there are too many.
bool lsys_temporary_add(const char *path);
void lsys_temporary_remove(const char *path);

#endif
