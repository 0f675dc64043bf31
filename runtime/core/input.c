// input.c -- see lsys/input.h. The file is looked at after it is open, so that no other can take its place meanwhile.
#include "lsys/input.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

FILE *lsys_input_open(const char *path, const char **why) {
  int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a FIFO would wait for someone to write
  struct stat info;
  if (file < 0 || fstat(file, &info) != 0) {
    *why = strerror(errno);
  } else if (!S_ISREG(info.st_mode)) {
    *why = S_ISDIR(info.st_mode) ? "is a directory" : "is not a file";
  } else {
    FILE *stream = fdopen(file, "r");
    if (stream) return stream;
    *why = strerror(errno);
  }
  if (file >= 0) close(file);
  return NULL;
}
