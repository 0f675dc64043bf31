// out.c -- buffered output to a temporary file that is moved into place when it
// is complete, or straight to standard output and devices.
// Invariant: a temporary file exists only while its name is in `temporaries`,
// so that a signal can remove it.
#include "core/out.h"

#include "core/message.h"
#include "core/signals.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
  BUFFER = 1 << 17,
  ROOM = 1 << 16,
  DIRECT = 1 << 14,  // from so many bytes on, a call of the system takes less time than a copy
};

struct LsysOut {
  char *path;       // as messages show it
  char *target;     // where the file goes; NULL: written directly
  char *temporary;  // its name until then
  int descriptor;
  bool failed, seekable;
  size_t filled;
  uint64_t flushed;  // bytes handed to the system
  char buffer[BUFFER];
};

static bool fail(LsysOut *out, int error) {
  if (!out->failed) lsys_error("cannot write %s: %s", out->path, strerror(error));
  out->failed = true;
  return false;
}

// Creates a file of our own beside the target, so that the move stays on one
// file system. Its name is registered before it exists: no signal leaves it behind.
static bool create_temporary(LsysOut *out) {
  const char *slash = strrchr(out->target, '/');
  int folder = slash ? (int)(slash + 1 - out->target) : 0;
  for (unsigned attempt = 0; attempt < 100; attempt++) {
    char *name;
    if (asprintf(&name, "%.*s.%s.%ld.%u.part", folder, out->target, out->target + folder, (long)getpid(), attempt) < 0)
      return false;
    bool added = lsys_temporary_add(name);
    if (!added)
      errno = EMFILE;
    else
      out->descriptor = open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (added && out->descriptor >= 0) {
      out->temporary = name;
      return true;
    }
    int error = errno;
    if (added) lsys_temporary_remove(name);
    free(name);
    errno = error;
    if (error != EEXIST) return false;
  }
  return false;
}

static bool open_file(LsysOut *out, const char *path) {
  struct stat status;
  bool exists = stat(path, &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    out->descriptor = open(path, O_WRONLY | O_CLOEXEC);
    return out->descriptor >= 0;
  }
  if (exists && access(path, W_OK) != 0) return false;
  // A link keeps pointing to what it points to.
  out->target = exists ? realpath(path, NULL) : strdup(path);
  if (!out->target || !create_temporary(out)) return false;
  if (exists) (void)fchmod(out->descriptor, status.st_mode & 0777);
  out->seekable = true;
  return true;
}

static void destroy(LsysOut *out) {
  free(out->path);
  free(out->target);
  free(out->temporary);
  free(out);
}

LsysOut *lsys_out_open(const char *path) {
  LsysOut *out = calloc(1, sizeof *out);
  if (out) out->path = strdup(strcmp(path, "-") ? path : "standard output");
  if (!out || !out->path) {
    lsys_error("out of memory");
    free(out);
    return NULL;
  }
  if (strcmp(path, "-") == 0) {
    out->descriptor = STDOUT_FILENO;
    return out;
  }
  if (open_file(out, path)) return out;
  fail(out, errno);
  destroy(out);
  return NULL;
}

static bool write_all(LsysOut *out, const char *bytes, size_t size) {
  while (size) {
    ssize_t written = write(out->descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(out, errno);
    bytes += written;
    size -= (size_t)written;
    out->flushed += (uint64_t)written;
  }
  return true;
}

static bool flush(LsysOut *out) {
  size_t size = out->filled;
  out->filled = 0;
  return !out->failed && write_all(out, out->buffer, size);
}

bool lsys_out_write(LsysOut *out, const void *bytes, size_t size) {
  if (out->failed) return false;
  bool direct = size >= DIRECT;
  if ((direct || size > BUFFER - out->filled) && !flush(out)) return false;
  if (direct) return write_all(out, bytes, size);
  memcpy(out->buffer + out->filled, bytes, size);
  out->filled += size;
  return true;
}

bool lsys_out_print(LsysOut *out, const char *format, ...) {
  va_list args;
  va_start(args, format);
  char *text;
  int length = vasprintf(&text, format, args);
  va_end(args);
  if (length < 0) return fail(out, ENOMEM);
  bool well = lsys_out_write(out, text, (size_t)length);
  free(text);
  return well;
}

char *lsys_out_room(LsysOut *out, size_t size) {
  if (size > ROOM) abort();
  if (size > BUFFER - out->filled) flush(out);
  return out->buffer + out->filled;
}

void lsys_out_filled(LsysOut *out, size_t size) {
  out->filled += size;
}

bool lsys_out_seekable(const LsysOut *out) {
  return out->seekable;
}

bool lsys_out_patch(LsysOut *out, uint64_t at, const void *bytes, size_t size) {
  if (!flush(out)) return false;
  const char *from = bytes;
  while (size) {
    ssize_t written = pwrite(out->descriptor, from, size, (off_t)at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(out, errno);
    from += written;
    at += (uint64_t)written;
    size -= (size_t)written;
  }
  return true;
}

uint64_t lsys_out_size(const LsysOut *out) {
  return out->flushed + out->filled;
}

bool lsys_out_commit(LsysOut *out) {
  bool well = flush(out);
  if (out->descriptor != STDOUT_FILENO && close(out->descriptor) != 0 && well) well = fail(out, errno);
  if (out->temporary) {
    if (well && rename(out->temporary, out->target) != 0) well = fail(out, errno);
    if (!well) unlink(out->temporary);
    lsys_temporary_remove(out->temporary);
  }
  destroy(out);
  return well;
}

void lsys_out_abandon(LsysOut *out) {
  if (out->descriptor != STDOUT_FILENO) close(out->descriptor);
  if (out->temporary) {
    unlink(out->temporary);
    lsys_temporary_remove(out->temporary);
  }
  destroy(out);
}
