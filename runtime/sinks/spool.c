// spool.c -- temporary files ($TMPDIR, else /tmp) without a name: they vanish with the process.
#include "sinks/spool.h"

#include "core/message.h"
#include "core/out.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { COPY = 1 << 16 };

static bool fail(void) {
  lsys_error("cannot use a temporary file: %s", strerror(errno));
  return false;
}

bool lsys_spool_open(LsysSpool *spool) {
  const char *folder = getenv("TMPDIR");
  char path[4096];
  *spool = (LsysSpool){0};
  int length = snprintf(path, sizeof path, "%s/lsysXXXXXX", folder && *folder ? folder : "/tmp");
  if (length < 0 || (size_t)length >= sizeof path) errno = ENAMETOOLONG;
  int descriptor = length > 0 && (size_t)length < sizeof path ? mkstemp(path) : -1;
  if (descriptor < 0) return fail();
  unlink(path);
  spool->file = fdopen(descriptor, "w+");
  if (spool->file) return true;
  close(descriptor);
  return fail();
}

bool lsys_spool_write(LsysSpool *spool, const void *bytes, size_t size) {
  spool->size += size;
  return fwrite(bytes, 1, size, spool->file) == size || fail();
}

bool lsys_spool_copy(LsysSpool *spool, LsysOut *out) {
  char buffer[COPY];
  if (fflush(spool->file) != 0 || fseek(spool->file, 0, SEEK_SET) != 0) return fail();
  size_t size;
  while ((size = fread(buffer, 1, sizeof buffer, spool->file)) > 0) {
    if (!lsys_out_write(out, buffer, size)) return false;
  }
  return !ferror(spool->file) || fail();
}

bool lsys_spool_append(LsysSpool *spool, LsysSpool *other) {
  char buffer[COPY];
  if (fflush(other->file) != 0 || fseek(other->file, 0, SEEK_SET) != 0) return fail();
  size_t size;
  while ((size = fread(buffer, 1, sizeof buffer, other->file)) > 0) {
    if (!lsys_spool_write(spool, buffer, size)) return false;
  }
  return !ferror(other->file) || fail();
}

void lsys_spool_close(LsysSpool *spool) {
  if (spool->file) fclose(spool->file);
  spool->file = NULL;
}
