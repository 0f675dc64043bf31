// main.c -- finds the cases, runs them side by side, adds up.
//
//   golden --lsysc PATH [--bless] [-j N] [--only TEXT] [--skip TEXT] FILE-OR-FOLDER...
//
// Each case is run by a process of its own, which writes its counts and its
// report into a file that the parent prints when the case has ended.
#include "golden.h"

#include <dirent.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Runner {
  Arena *arena;
  const char *lsysc, *only, *skip;
  bool bless;
  long jobs;
  Strings cases;
  struct Job {
    pid_t pid;
    FILE *report;
    size_t which;
  } * running;
  size_t passed, failed;
} Runner;

void case_pass(Case *test) {
  test->passed++;
}

void case_fail(Case *test, unsigned line, const char *format, ...) {
  test->failed++;
  fprintf(test->report, "%s:", test->path);
  if (line) fprintf(test->report, "%u:", line);
  fputc(' ', test->report);
  va_list args;
  va_start(args, format);
  vfprintf(test->report, format, args);
  va_end(args);
  fputc('\n', test->report);
}

// ---- cases -----------------------------------------------------------------------

static bool ends_with(const char *text, const char *end) {
  size_t length = strlen(text), tail = strlen(end);
  return length >= tail && strcmp(text + length - tail, end) == 0;
}

typedef void CaseFunction(Case *test);

// How a file is run; NULL: it is no case.
static CaseFunction *function_of(const char *path) {
  const char *base = strrchr(path, '/') + 1;
  bool grammar = ends_with(path, ".lsys") || ends_with(path, ".l") || ends_with(path, ".txt");
  if (ends_with(path, ".md")) return docs_run;
  if (strstr(path, "/cases/cli/")) return ends_with(path, ".sh") ? cli_run : NULL;
  if (strstr(path, "/cases/errors/")) return grammar ? errors_run : NULL;
  if (grammar) return derive_run;
  return strncmp(base, "test_", 5) == 0 && !strchr(base, '.') && access(path, X_OK) == 0 ? unit_run : NULL;
}

static int by_name(const struct dirent **a, const struct dirent **b) {
  return strcmp((*a)->d_name, (*b)->d_name);
}

// Folders are walked one level of subfolders after the other; names with a dot in front, "include" and files that are
// no case are left out.
static void find(Runner *runner, const char *path) {
  struct stat status;
  if (stat(path, &status) != 0) {
    fprintf(stderr, "golden: there is no %s\n", path);
    exit(2);
  }
  if (!S_ISDIR(status.st_mode)) {
    bool wanted = (!runner->only || strstr(path, runner->only)) && !(runner->skip && strstr(path, runner->skip));
    if (wanted && function_of(path)) *VEC_PUSH(runner->arena, &runner->cases) = path;
    return;
  }
  struct dirent **entries;
  int count = scandir(path, &entries, NULL, by_name);
  for (int i = 0; i < count; i++) {
    const char *name = entries[i]->d_name;
    if (name[0] != '.' && strcmp(name, "include") != 0 && strcmp(name, "CMakeFiles") != 0)
      find(runner, arena_printf(runner->arena, "%s/%s", path, name));
    free(entries[i]);
  }
  if (count >= 0) free(entries);
}

// ---- running ---------------------------------------------------------------------

static void remove_folder(const char *path) {
  Arena *arena = arena_create();
  Strings argv = {0};
  *VEC_PUSH(arena, &argv) = "rm";
  *VEC_PUSH(arena, &argv) = "-rf";
  *VEC_PUSH(arena, &argv) = path;
  *VEC_PUSH(arena, &argv) = NULL;
  process_run(arena, &argv, NULL, true);
  arena_destroy(arena);
}

static void run_case(const Runner *runner, const char *path, FILE *report) {
  Arena *arena = arena_create();
  const char *base = getenv("TMPDIR");
  char *folder = arena_printf(arena, "%s/lsysc-test-XXXXXX", base ? base : "/tmp");
  if (!mkdtemp(folder)) {
    perror(folder);
    exit(2);
  }
  Case test = {.arena = arena, .path = path, .lsysc = runner->lsysc, .bless = runner->bless, .report = report};
  test.folder = folder;
  function_of(path)(&test);
  remove_folder(folder);
  fprintf(report, "%zu %zu", test.passed, test.failed);
  arena_destroy(arena);
}

static void start(Runner *runner, struct Job *job, size_t which) {
  *job = (struct Job){.report = tmpfile(), .which = which};
  fflush(NULL);
  job->pid = fork();
  if (job->pid != 0) return;
  run_case(runner, runner->cases.at[which], job->report);
  fflush(job->report);
  _exit(0);
}

// Prints a report, and takes the counts off its end.
static void collect(Runner *runner, struct Job *job, int status) {
  VEC(char) text = {0};
  rewind(job->report);
  for (int c = getc(job->report); c != EOF; c = getc(job->report)) *VEC_PUSH(runner->arena, &text) = (char)c;
  *VEC_PUSH(runner->arena, &text) = '\0';
  fclose(job->report);
  char *counts = strrchr(text.at, '\n');
  counts = counts ? counts + 1 : text.at;
  size_t passed, failed;
  if (status != 0 || sscanf(counts, "%zu %zu", &passed, &failed) != 2) {
    printf("%s: the test driver itself failed\n%s\n", runner->cases.at[job->which], text.at);
    runner->failed++;
  } else {
    runner->passed += passed;
    runner->failed += failed;
    fwrite(text.at, 1, (size_t)(counts - text.at), stdout);
  }
  job->pid = 0;
}

static void wait_for_one(Runner *runner) {
  int status;
  pid_t pid = wait(&status);
  for (long i = 0; i < runner->jobs; i++)
    if (runner->running[i].pid == pid) collect(runner, &runner->running[i], status);
}

static void run_all(Runner *runner) {
  size_t next = 0, alive = 0, count = runner->cases.count;
  runner->running = arena_array(runner->arena, (size_t)runner->jobs, sizeof *runner->running);
  while (next < count || alive > 0) {
    if (next < count && alive < (size_t)runner->jobs) {
      struct Job *job = runner->running;
      while (job->pid != 0) job++;
      start(runner, job, next++);
      alive++;
    } else {
      wait_for_one(runner);
      alive--;
    }
  }
}

static const char *absolute(Arena *arena, const char *path) {
  char full[PATH_MAX];
  if (realpath(path, full)) return arena_copy(arena, full, strlen(full));
  fprintf(stderr, "golden: there is no %s\n", path);
  exit(2);
}

// What all cases see: lsysc is found by its name alone.
static void set_environment(Arena *arena, const char *lsysc) {
  const char *path = getenv("PATH");
  setenv("PATH", arena_printf(arena, "%.*s:%s", (int)(strrchr(lsysc, '/') - lsysc), lsysc, path ? path : "/usr/bin"),
         1);
  setenv("LC_ALL", "C.UTF-8", 1);
  unsetenv("LSYSC_HOME");
  // LLVM keeps what it allocated, and the leak checker cannot trace the threads of its JIT.
  setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
}

int main(int argc, char **argv) {
  Runner runner = {.arena = arena_create(), .jobs = sysconf(_SC_NPROCESSORS_ONLN)};
  Strings roots = {0};
  for (int i = 1; i < argc; i++) {
    bool more = i + 1 < argc;
    if (strcmp(argv[i], "--bless") == 0)
      runner.bless = true;
    else if (strcmp(argv[i], "--lsysc") == 0 && more)
      runner.lsysc = absolute(runner.arena, argv[++i]);
    else if (strcmp(argv[i], "--only") == 0 && more)
      runner.only = argv[++i];
    else if (strcmp(argv[i], "--skip") == 0 && more)
      runner.skip = argv[++i];
    else if (strcmp(argv[i], "-j") == 0 && more)
      runner.jobs = atol(argv[++i]);
    else
      *VEC_PUSH(runner.arena, &roots) = absolute(runner.arena, argv[i]);
  }
  if (!runner.lsysc || roots.count == 0 || runner.jobs < 1) {
    fputs("usage: golden --lsysc PATH [--bless] [-j N] [--only TEXT] [--skip TEXT] FILE-OR-FOLDER...\n", stderr);
    return 2;
  }
  set_environment(runner.arena, runner.lsysc);
  for (size_t i = 0; i < roots.count; i++) find(&runner, roots.at[i]);
  run_all(&runner);
  printf("%zu passed, %zu failed\n", runner.passed, runner.failed);
  bool failed = runner.failed > 0 || runner.passed == 0;
  arena_destroy(runner.arena);
  return failed;
}
