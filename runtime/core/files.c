// files.c -- fopen, fscanf and fclose of a grammar's blocks: files have numbers from 1.
// Invariant: what is open hangs on the run and is closed when a derivation ends.
#include "core/files.h"

#include "core/message.h"
#include "core/stream.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_FILES = 32 };

struct LsysFiles {
  FILE *at[MOST_FILES];
};

FILE *lsys_files_at(LsysRun *run, double number, const char *what) {
  bool possible = run->files && number >= 1 && number <= MOST_FILES && number == floor(number);
  FILE *file = possible ? run->files->at[(int)number - 1] : NULL;
  if (!file) lsys_fail(run, "%s: %.17g is no open file", what, number);
  return file;
}

double lsys_fopen(LsysRun *run, const char *name, const char *mode) {
  LsysMemory *memory = ((LsysWorker *)run)->memory;
  if (!run->files) run->files = lsys_memory_alloc(memory, 1, sizeof *run->files);
  if (!run->files) lsys_fail(run, "fopen: out of memory");
  for (int i = 0; i < MOST_FILES; i++) {
    if (run->files->at[i]) continue;
    if (!(run->files->at[i] = fopen(name, mode))) lsys_fail(run, "cannot open %s: %s", name, strerror(errno));
    struct stat info;  // a directory can be opened, but not be read
    if (fstat(fileno(run->files->at[i]), &info) == 0 && S_ISDIR(info.st_mode))
      lsys_fail(run, "cannot open %s: %s", name, strerror(EISDIR));
    return i + 1;
  }
  lsys_fail(run, "fopen: %d files are open already", MOST_FILES);
}

// False where something could not be written, now or before.
static bool finish(FILE *file) {
  bool bad = ferror(file);
  return fclose(file) == 0 && !bad;
}

void lsys_fclose(LsysRun *run, double file) {
  FILE *stream = lsys_files_at(run, file, "fclose");
  run->files->at[(int)file - 1] = NULL;
  if (!finish(stream)) lsys_fail(run, "fclose: cannot write the file: %s", strerror(errno));
}

double lsys_fscanf(LsysRun *run, double file) {
  double value;
  return fscanf(lsys_files_at(run, file, "fscanf"), "%lf", &value) == 1 ? value : NAN;
}

bool lsys_files_close(LsysRun *run) {
  if (!run->files) return true;
  bool well = true;
  for (int i = 0; i < MOST_FILES; i++) {
    if (!run->files->at[i] || finish(run->files->at[i])) continue;
    lsys_error("cannot write a file of the grammar: %s", strerror(errno));
    well = false;
  }
  lsys_memory_free(((LsysWorker *)run)->memory, run->files, 1, sizeof *run->files);
  run->files = NULL;
  return well;
}
