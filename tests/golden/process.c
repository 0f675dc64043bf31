// process.c -- runs a program and keeps what it printed.
#include "golden.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

typedef VEC(char) Bytes;

static void child(const Strings *argv, const char *folder, int out, int err) {
  int null = open("/dev/null", O_RDONLY);
  if (dup2(null, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(127);
  if (folder && chdir(folder) != 0) _exit(127);
  setrlimit(RLIMIT_CPU, &(struct rlimit){PROCESS_SECONDS, PROCESS_SECONDS + 5});
  setpgid(0, 0);  // so that a process that hangs is ended with all that it started
  execvp(argv->at[0], (char *const *)argv->at);
  fprintf(stderr, "cannot run %s: %s\n", argv->at[0], strerror(errno));
  _exit(127);
}

// Appends what there is to read; false at the end of the file.
static bool drain(Arena *arena, int file, Bytes *bytes) {
  char block[1 << 16];
  ssize_t size = read(file, block, sizeof block);
  for (ssize_t i = 0; i < size; i++) *VEC_PUSH(arena, bytes) = block[i];
  return size > 0;
}

static int milliseconds_left(time_t end) {
  time_t now = time(NULL);
  return now < end ? (int)(end - now) * 1000 : 0;
}

Result process_run(Arena *arena, const Strings *argv, const char *folder, bool merge) {
  int out[2], err[2];
  if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) abort();
  fflush(NULL);
  pid_t pid = fork();
  if (pid == 0) child(argv, folder, out[1], merge ? out[1] : err[1]);
  close(out[1]), close(err[1]);

  Result result = {0};
  Bytes text[2] = {{0}, {0}};
  struct pollfd files[2] = {{.fd = out[0], .events = POLLIN}, {.fd = err[0], .events = POLLIN}};
  time_t end = time(NULL) + WALL_SECONDS;
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (poll(files, 2, milliseconds_left(end)) == 0) {
      result.late = true;
      kill(-pid, SIGKILL);
    }
    for (int i = 0; i < 2; i++)
      if (files[i].fd >= 0 && files[i].revents && !drain(arena, files[i].fd, &text[i])) files[i].fd = -1;
  }
  close(out[0]), close(err[0]);
  int status;
  waitpid(pid, &status, 0);
  result.late |= WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.size = text[0].count;
  *VEC_PUSH(arena, &text[0]) = '\0';
  *VEC_PUSH(arena, &text[1]) = '\0';
  result.out = text[0].at;
  result.err = text[1].at;
  return result;
}
