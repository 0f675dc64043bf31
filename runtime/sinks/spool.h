// spool.h -- bytes kept in a nameless temporary file until they can be appended
// to an output: what a format wants behind something that is not known yet.
#ifndef LSYS_SINKS_SPOOL_H
#define LSYS_SINKS_SPOOL_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct LsysOut;

typedef struct LsysSpool {
  FILE *file;
  uint64_t size;
} LsysSpool;

// False after printing why there is no temporary file.
bool lsys_spool_open(LsysSpool *spool);
bool lsys_spool_write(LsysSpool *spool, const void *bytes, size_t size);
// Appends everything that was written.
bool lsys_spool_copy(LsysSpool *spool, struct LsysOut *out);
// Appends what another spool holds.
bool lsys_spool_append(LsysSpool *spool, LsysSpool *other);
void lsys_spool_close(LsysSpool *spool);

#endif
