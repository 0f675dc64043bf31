// tee.h -- one derivation into several sinks.
#ifndef LSYS_SINKS_TEE_H
#define LSYS_SINKS_TEE_H

#include "sinks/sink.h"

#include <stddef.h>

typedef struct LsysTee {
  LsysSink sink;  // first
  LsysSink **sinks;
  size_t count;
  unsigned pass;
} LsysTee;

// Passes everything on to the sinks, each of which gets as many passes as it wants. Owns nothing.
void lsys_tee_init(LsysTee *tee, LsysSink **sinks, size_t count);

#endif
