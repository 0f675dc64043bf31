// start.c -- whole commands, from fork to exit: what a person waits for.
#include "bench.h"
#include "measure.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Command {
  const char *name;
  const char *words[8];  // "LSYSC", "STATIC", "GRAMMAR" and "PROGRAM" stand for paths
} Command;

static const Command commands[] = {
  {"a process that ends", {"/bin/true"}},
  {"lsysc --help", {"LSYSC", "--help"}},
  {"lsysc check", {"LSYSC", "check", "GRAMMAR"}},
  {"lsysc interp -n 0", {"LSYSC", "interp", "GRAMMAR", "-n", "0"}},
  {"lsysc run -n 1", {"LSYSC", "run", "GRAMMAR", "-n", "1"}},
  {"lsysc -O0", {"LSYSC", "GRAMMAR", "-O0", "-o", "PROGRAM"}},
  {"lsysc -O2", {"LSYSC", "GRAMMAR", "-O2", "-o", "PROGRAM"}},
  {"the program -n 1", {"PROGRAM", "-n", "1"}},
  {"static lsysc --help", {"STATIC", "--help"}},
  {"static lsysc run -n 1", {"STATIC", "run", "GRAMMAR", "-n", "1"}},
  {"static lsysc -O0", {"STATIC", "GRAMMAR", "-O0", "-o", "PROGRAM"}},
  {"static lsysc -O2", {"STATIC", "GRAMMAR", "-O2", "-o", "PROGRAM"}},
};

typedef struct Paths {
  const char *lsysc, *with_llvm;
  char grammar[4096], program[4096];
} Paths;

typedef struct Job {
  const Command *command;
  const Paths *paths;
} Job;

static char *resolve(const Paths *paths, const char *word) {
  if (strcmp(word, "LSYSC") == 0) return (char *)paths->lsysc;
  if (strcmp(word, "STATIC") == 0) return (char *)paths->with_llvm;
  if (strcmp(word, "GRAMMAR") == 0) return (char *)paths->grammar;
  if (strcmp(word, "PROGRAM") == 0) return (char *)paths->program;
  return (char *)word;
}

static void run_command(void *data) {
  Job *job = data;
  pid_t child = fork();
  if (child == 0) {
    char *argv[9] = {0};
    for (int i = 0; i < 8 && job->command->words[i]; i++) argv[i] = resolve(job->paths, job->command->words[i]);
    int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    execv(argv[0], argv);
    _exit(127);
  }
  int status;
  if (child < 0 || waitpid(child, &status, 0) < 0 || status) {
    fprintf(stderr, "bench: %s failed\n", job->command->name);
    exit(1);
  }
}

void bench_start(const Options *options) {
  enum { COUNT = sizeof commands / sizeof *commands };
  Paths paths = {.lsysc = options->lsysc, .with_llvm = options->with_llvm};
  snprintf(paths.grammar, sizeof paths.grammar, "%s/twenty.lsys", options->grammars);
  snprintf(paths.program, sizeof paths.program, "/tmp/lsysc-bench-%d", (int)getpid());
  if (!options->json) printf("%-22s %10s\n", "a 20-production grammar", "ms");
  for (int i = 0; i < COUNT; i++) {
    if (!bench_wants(options, commands[i].name)) continue;
    if (strcmp(commands[i].words[0], "STATIC") == 0 && !options->with_llvm) continue;
    Job job = {&commands[i], &paths};
    Side side = {.name = commands[i].name, .run = run_command, .data = &job};
    measure(&side, 1, options->runs);
    double ms = 1e3 * median(side.seconds, options->runs);
    printf(options->json ? "{\"row\":\"%s\",\"milliseconds\":%.4g}\n" : "%-22s %10.1f\n", commands[i].name, ms);
    fflush(stdout);
  }
  unlink(paths.program);
}
