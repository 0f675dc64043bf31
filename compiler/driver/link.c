// link.c -- objects to programs by the system's C compiler.
//
// A file appears under its name only when it is complete: it is written under
// a temporary name in the same folder and renamed. While temporary files exist
// the signals that end a program are blocked and waited for beside the linker,
// so that no handler and no global state is needed to remove them.
#include "driver/link.h"
#include "driver/report.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// ---- names -----------------------------------------------------------------

static const char *suffix_of(const Options *options) {
  if (options->program) return "";
  switch (options->backend.emit) {
  case EMIT_OBJECT:
    return ".o";
  case EMIT_ASSEMBLY:
    return ".s";
  case EMIT_LLVM:
    return ".ll";
  case EMIT_BITCODE:
    return ".bc";
  }
  return "";
}

// plants/fern.lsys -> fern, in the current folder.
static const char *stem(Arena *arena, const char *grammar) {
  const char *slash = strrchr(grammar, '/');
  const char *base = slash ? slash + 1 : grammar;
  const char *dot = strrchr(base, '.');
  return arena_copy(arena, base, dot && dot > base ? (size_t)(dot - base) : strlen(base));
}

// Whether writing to name would destroy something that is no output of ours.
static bool is_safe(const Options *options, const char *name, const char *grammar) {
  struct stat old, source;
  if (stat(name, &old) != 0) return true;
  if (S_ISDIR(old.st_mode)) return report_error("`%s` is a folder; choose another name with -o", name);
  if (stat(grammar, &source) == 0 && old.st_dev == source.st_dev && old.st_ino == source.st_ino)
    return report_error("the output `%s` is the grammar itself; choose another name with -o", name);
  if (!options->program) return true;
  if (!S_ISREG(old.st_mode)) return report_error("`%s` is no regular file; a program cannot be written there", name);
  if (!(old.st_mode & 0111) && old.st_size > 0)
    return report_error("`%s` exists and is no program; remove it or choose another name with -o", name);
  return true;
}

const char *output_name(Arena *arena, const Options *options, const char *grammar) {
  const char *name = options->output;
  if (!name && strcmp(grammar, "-") == 0) name = "a.out";
  if (!name) name = arena_printf(arena, "%s%s", stem(arena, grammar), suffix_of(options));
  if (strcmp(name, "-") != 0) return is_safe(options, name, grammar) ? name : NULL;
  if (options->program) return report_error("a program cannot be written to standard output"), NULL;
  return name;
}

// ---- temporary files ---------------------------------------------------------

typedef struct Guard {
  sigset_t ending, before;
} Guard;

static Guard guard_begin(void) {
  Guard guard;
  sigemptyset(&guard.ending);
  const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ, SIGCHLD};
  for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) sigaddset(&guard.ending, signals[i]);
  sigprocmask(SIG_BLOCK, &guard.ending, &guard.before);
  return guard;
}

// A signal that came meanwhile acts now.
static void guard_end(const Guard *guard) {
  sigprocmask(SIG_SETMASK, &guard->before, NULL);
}

// A new, empty file beside name: "plant" gives ".plant-Xw3k9q.o".
static char *temporary(Arena *arena, const char *name, const char *suffix, int *file) {
  const char *slash = strrchr(name, '/');
  int folder = slash ? (int)(slash + 1 - name) : 0;
  char *path = arena_printf(arena, "%.*s.%s-XXXXXX%s", folder, name, name + folder, suffix);
  *file = mkstemps(path, (int)strlen(suffix));
  if (*file >= 0) return path;
  report_error("cannot write `%s`: %s", name, strerror(errno));
  return NULL;
}

static bool write_all(int file, const char *bytes, size_t size) {
  while (size > 0) {
    ssize_t done = write(file, bytes, size);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    bytes += done;
    size -= (size_t)done;
  }
  return true;
}

// What open() would have given a new file: mkstemp's 0600 is meant for secrets.
static mode_t usual_mode(mode_t bits) {
  mode_t mask = umask(0);
  umask(mask);
  return bits & ~mask;
}

// Writes and closes file.
static bool fill(int file, const char *name, const void *bytes, size_t size) {
  bool done = write_all(file, bytes, size);
  int error = errno;
  if (close(file) != 0 && done) done = false, error = errno;
  return done || report_error("cannot write `%s`: %s", name, strerror(error));
}

static bool move(const char *from, const char *to, mode_t bits) {
  if (chmod(from, usual_mode(bits)) == 0 && rename(from, to) == 0) return true;
  report_error("cannot write `%s`: %s", to, strerror(errno));
  unlink(from);
  return false;
}

bool output_write(Arena *arena, const char *name, const void *bytes, size_t size) {
  struct stat old;
  if (strcmp(name, "-") == 0) return fill(dup(STDOUT_FILENO), "standard output", bytes, size);
  if (stat(name, &old) == 0 && !S_ISREG(old.st_mode)) {
    int file = open(name, O_WRONLY | O_CLOEXEC);
    return file < 0 ? report_error("cannot write `%s`: %s", name, strerror(errno)) : fill(file, name, bytes, size);
  }
  Guard guard = guard_begin();
  int file;
  char *path = temporary(arena, name, "", &file);
  bool done = path && fill(file, name, bytes, size);
  if (path && !done) unlink(path);
  done = done && move(path, name, 0666);
  guard_end(&guard);
  return done;
}

// ---- the linker --------------------------------------------------------------

// The words of a command: `gcc -static` are two.
static void add_words(Arena *arena, Strings *argv, const char *words) {
  for (words += strspn(words, " "); *words; words += strspn(words, " ")) {
    size_t length = strcspn(words, " ");
    *VEC_PUSH(arena, argv) = arena_copy(arena, words, length);
    words += length;
  }
}

static void show(const Strings *argv) {
  for (size_t i = 0; argv->at[i]; i++) fprintf(stderr, "%s%s", i ? " " : "", argv->at[i]);
  fputc('\n', stderr);
}

// Waits for the linker and takes its status. False when a signal that ends lsysc came first: the linker is ended too,
// and the signal stays pending until guard_end.
static bool wait_for(pid_t child, const Guard *guard, int *status) {
  for (;;) {
    int signal = sigwaitinfo(&guard->ending, NULL);
    if (signal == SIGCHLD) {
      if (waitpid(child, status, WNOHANG) == child) return true;
    } else if (signal > 0) {
      kill(child, signal);
      waitpid(child, status, 0);
      raise(signal);
      return false;
    }
  }
}

static bool run_linker(const Strings *argv, const Guard *guard) {
  signal(SIGCHLD, SIG_DFL);  // who started lsysc may have had it ignored
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &guard->before);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child;
  int error = posix_spawnp(&child, argv->at[0], NULL, &attributes, (char *const *)argv->at, environ);
  posix_spawnattr_destroy(&attributes);
  if (error)
    return report_error("cannot run the linker `%s`: %s; install a C compiler or name one with --linker", argv->at[0],
                        strerror(error));
  int status;
  if (!wait_for(child, guard, &status)) return false;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  if (WIFSIGNALED(status)) return report_error("the linker `%s` was ended by signal %d", argv->at[0], WTERMSIG(status));
  return report_error("linking failed: `%s` ended with status %d", argv->at[0], WEXITSTATUS(status));
}

static bool link_objects(Arena *arena, const Options *options, const char *home, const Strings *objects,
                         const char *program, const Guard *guard) {
  Strings argv = {0};
  add_words(arena, &argv, options->linker);
  if (argv.count == 0) return report_error("`--linker` names no command");
  *VEC_PUSH(arena, &argv) = "-o";
  *VEC_PUSH(arena, &argv) = program;
  for (size_t i = 0; i < objects->count; i++) *VEC_PUSH(arena, &argv) = objects->at[i];
  *VEC_PUSH(arena, &argv) = arena_printf(arena, "%s/liblsysrt.a", home);
  add_words(arena, &argv, LSYSC_LINK_FLAGS);
  *VEC_PUSH(arena, &argv) = NULL;
  if (options->verbose) show(&argv);
  return run_linker(&argv, guard);
}

// Temporary files with the objects; paths holds the names of those that exist, also where one could not be written.
static bool write_objects(Arena *arena, const char *name, const Code *objects, Strings *paths) {
  for (int i = 0; i < BACKEND_PARTS; i++) {
    int file;
    if (objects[i].size == 0) continue;
    char *path = temporary(arena, name, ".o", &file);
    if (!path) return false;
    *VEC_PUSH(arena, paths) = path;
    if (!fill(file, path, objects[i].bytes, objects[i].size)) return false;
  }
  return true;
}

bool link_program(Arena *arena, const Options *options, const char *home, const char *name,
                  const Code objects[BACKEND_PARTS]) {
  Guard guard = guard_begin();
  Strings paths = {0};
  int file;
  bool written = write_objects(arena, name, objects, &paths);
  char *program = written ? temporary(arena, name, "", &file) : NULL;
  bool done = program && close(file) == 0 && link_objects(arena, options, home, &paths, program, &guard);
  for (size_t i = 0; i < paths.count; i++) unlink(paths.at[i]);
  if (program && !done) unlink(program);
  done = done && move(program, name, 0777);
  guard_end(&guard);
  return done;
}
