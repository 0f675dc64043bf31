// grammar_fuzz.c -- random grammars through all engines (tests/README.md).
//
// Worker processes each take every k-th grammar and note in shared memory
// which one they are at; the parent starts a new worker where one died. A
// grammar on which the engines differ is reduced and written as a test case.
#include "engines.h"

#include <dlfcn.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_JOBS = 64, LATEST = 60, MOST_FAILURES = 10 };
static const double LONGEST = 20000;  // modules of a word

typedef struct Options {
  uint64_t first, count;
  uint64_t sample;  // every so many grammars are tried thoroughly; 0: none
  int jobs;
  bool print;
  const char *backend, *lsysc, *keep;
} Options;

// One worker's; shared with the parent.
typedef struct Progress {
  uint64_t at;      // the grammar that is being tried
  Lengths lengths;  // of a failing one, in the first worker's
  uint64_t verdicts[VERDICTS], thorough, modules;
} Progress;

typedef struct Fuzz {
  Options options;
  Engines engines;
  Progress *progress;
  pid_t workers[MOST_JOBS];
  int failures;
} Fuzz;

// ---- options -----------------------------------------------------------------

static void usage(FILE *out) {
  fputs("grammar_fuzz [--first N] [--count N] [--jobs N] [--sample N] [--backend FILE] [--lsysc FILE] [--keep FOLDER]\n"
        "grammar_fuzz --print N\n"
        "Grammar number N is the same on every machine. --backend: lsysc-llvm.so, for the JIT. --lsysc: the\n"
        "compiler. Every sample-th grammar is tried as executables and with long words, too. --keep: where failing "
        "grammars are written.\n",
        out);
}

static bool number(const char *text, uint64_t *value) {
  char *end;
  errno = 0;
  *value = strtoull(text, &end, 10);
  return !errno && end != text && !*end;
}

static bool read_options(Options *options, int argc, char **argv) {
  *options = (Options){.first = 1, .count = 2000, .sample = 50, .jobs = (int)sysconf(_SC_NPROCESSORS_ONLN)};
  for (int i = 1; i < argc; i += 2) {
    const char *name = argv[i], *value = argv[i + 1];
    uint64_t jobs = 0;
    if (!value) return false;
    bool known = strcmp(name, "--first") == 0   ? number(value, &options->first)
               : strcmp(name, "--count") == 0   ? number(value, &options->count)
               : strcmp(name, "--sample") == 0  ? number(value, &options->sample)
               : strcmp(name, "--jobs") == 0    ? number(value, &jobs) && jobs > 0
               : strcmp(name, "--print") == 0   ? (options->print = number(value, &options->first))
               : strcmp(name, "--backend") == 0 ? (options->backend = value) != NULL
               : strcmp(name, "--lsysc") == 0   ? (options->lsysc = value) != NULL
                                                : strcmp(name, "--keep") == 0 && (options->keep = value) != NULL;
    if (!known) return false;
    if (jobs) options->jobs = (int)(jobs < MOST_JOBS ? jobs : MOST_JOBS);
  }
  if (options->jobs < 1 || options->jobs > MOST_JOBS) options->jobs = 1;
  return true;
}

// ---- workers -------------------------------------------------------------------

static bool is_thorough(const Fuzz *fuzz, uint64_t grammar) {
  return fuzz->options.sample && grammar % fuzz->options.sample == 0;
}

// Tries grammars from `at` on, every jobs-th; ends the process at one that fails.
static _Noreturn void work(const Fuzz *fuzz, int worker, uint64_t at) {
  Progress *progress = &fuzz->progress[worker];
  for (; at < fuzz->options.first + fuzz->options.count; at += (uint64_t)fuzz->options.jobs) {
    progress->at = at;
    alarm(LATEST);
    Arena *arena = arena_create();
    FuzzGrammar *grammar = fuzz_generate(arena, at, LONGEST);
    bool thorough = is_thorough(fuzz, at);
    Lengths lengths = {0};
    Verdict verdict = engines_compare(&fuzz->engines, grammar, thorough, &lengths);
    arena_destroy(arena);
    if (verdict != VERDICT_AGREE) _exit((int)verdict);
    progress->verdicts[VERDICT_AGREE]++;
    progress->thorough += thorough;
    progress->modules += lengths.word;
  }
  _exit(VERDICT_AGREE);
}

static void start(Fuzz *fuzz, int worker, uint64_t at) {
  fflush(NULL);
  fuzz->workers[worker] = fork();
  if (fuzz->workers[worker] == 0) work(fuzz, worker, at);
}

static Verdict verdict_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? VERDICT_LATE : VERDICT_CRASH;
  return WEXITSTATUS(status) < VERDICT_CRASH ? (Verdict)WEXITSTATUS(status) : VERDICT_CRASH;
}

// ---- failures ------------------------------------------------------------------

typedef struct Wanted {
  const Engines *engines;
  Verdict verdict;
  bool thorough;
} Wanted;

static bool still_fails(const FuzzGrammar *grammar, void *data) {
  const Wanted *wanted = data;
  return !fuzz_too_long(grammar, LONGEST)
      && engines_compare_apart(wanted->engines, grammar, wanted->thorough, NULL, false) == wanted->verdict;
}

static void write_case(const FuzzGrammar *grammar, Verdict verdict, const Lengths *lengths, FILE *out) {
  fprintf(out, "// Reduced from random grammar %" PRIu64 ", on which engines once did not agree (%s).\n",
          grammar->number, verdict_names[verdict]);
  fuzz_print(grammar, out);
  fprintf(out, "// test: -n %d\n// length: %" PRIu64 "\n", grammar->steps, lengths->word);
  fprintf(out, "// test: -n %d --homomorphism\n// length: %" PRIu64 "\n", grammar->steps, lengths->figure);
}

static void report(Fuzz *fuzz, uint64_t at, Verdict verdict) {
  Arena *arena = arena_create();
  FuzzGrammar *grammar = fuzz_generate(arena, at, LONGEST);
  Wanted wanted = {&fuzz->engines, verdict, is_thorough(fuzz, at)};
  fuzz->failures++;
  fprintf(stderr, "grammar %" PRIu64 ": %s; reducing\n", at, verdict_names[verdict]);
  if (still_fails(grammar, &wanted)) {
    bool thorough = wanted.thorough;
    wanted.thorough = false;  // that is faster, if it fails, too
    if (thorough && !still_fails(grammar, &wanted)) wanted.thorough = true;
    grammar = fuzz_reduce(arena, grammar, still_fails, &wanted);
  } else {
    fputs("it does not happen again\n", stderr);
  }
  Lengths *lengths = &fuzz->progress->lengths;
  engines_compare_apart(&fuzz->engines, grammar, wanted.thorough, lengths, true);
  write_case(grammar, verdict, lengths, stderr);
  if (fuzz->options.keep) {
    const char *path = arena_printf(arena, "%s/fuzz-%" PRIu64 ".lsys", fuzz->options.keep, at);
    FILE *out = fopen(path, "w");
    if (out) {
      write_case(grammar, verdict, lengths, out);
      fclose(out);
      fprintf(stderr, "written to %s\n", path);
    }
  }
  arena_destroy(arena);
}

// ---- the run -------------------------------------------------------------------

static int run(Fuzz *fuzz) {
  int running = 0;
  for (int worker = 0; worker < fuzz->options.jobs; worker++, running++)
    start(fuzz, worker, fuzz->options.first + (uint64_t)worker);
  while (running > 0) {
    int status;
    pid_t ended = wait(&status);
    int worker = 0;
    while (worker < fuzz->options.jobs && fuzz->workers[worker] != ended) worker++;
    if (ended < 0 || worker == fuzz->options.jobs) return EXIT_FAILURE;
    running--;
    Verdict verdict = verdict_of(status);
    if (verdict == VERDICT_AGREE) continue;
    uint64_t at = fuzz->progress[worker].at;
    fuzz->progress[worker].verdicts[verdict]++;
    report(fuzz, at, verdict);
    if (fuzz->failures >= MOST_FAILURES) continue;
    start(fuzz, worker, at + (uint64_t)fuzz->options.jobs);
    running++;
  }
  return fuzz->failures ? EXIT_FAILURE : EXIT_SUCCESS;
}

static void summarise(const Fuzz *fuzz) {
  Progress all = {0};
  for (int worker = 0; worker < fuzz->options.jobs; worker++) {
    for (int verdict = 0; verdict < VERDICTS; verdict++)
      all.verdicts[verdict] += fuzz->progress[worker].verdicts[verdict];
    all.thorough += fuzz->progress[worker].thorough;
    all.modules += fuzz->progress[worker].modules;
  }
  printf("grammars %" PRIu64 "..%" PRIu64 ":", fuzz->options.first, fuzz->options.first + fuzz->options.count - 1);
  for (int verdict = 0; verdict < VERDICTS; verdict++)
    if (all.verdicts[verdict] || verdict == VERDICT_AGREE)
      printf(" %" PRIu64 " %s,", all.verdicts[verdict], verdict_names[verdict]);
  printf(" %" PRIu64 " thoroughly; %" PRIu64 " modules\n", all.thorough, all.modules);
}

static bool load_backend(Fuzz *fuzz) {
  if (!fuzz->options.backend) return true;
  void *module = dlopen(fuzz->options.backend, RTLD_NOW | RTLD_LOCAL);
  fuzz->engines.backend = module ? dlsym(module, "lsysc_backend") : NULL;
  if (!fuzz->engines.backend) fprintf(stderr, "grammar_fuzz: %s\n", dlerror());
  return fuzz->engines.backend != NULL;
}

int main(int argc, char **argv) {
  Fuzz fuzz = {0};
  if (!read_options(&fuzz.options, argc, argv)) {
    usage(stderr);
    return EXIT_FAILURE;
  }
  if (fuzz.options.print) {
    Arena *arena = arena_create();
    fuzz_print(fuzz_generate(arena, fuzz.options.first, LONGEST), stdout);
    arena_destroy(arena);
    return EXIT_SUCCESS;
  }
  char folder[] = "/tmp/grammar_fuzz.XXXXXX";
  if (!load_backend(&fuzz) || !mkdtemp(folder)) return EXIT_FAILURE;
  fuzz.engines.lsysc = fuzz.options.lsysc;
  fuzz.engines.folder = folder;
  fuzz.engines.nowhere = fopen("/dev/null", "w");
  fuzz.progress =
    mmap(NULL, MOST_JOBS * sizeof *fuzz.progress, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (fuzz.progress == MAP_FAILED || !fuzz.engines.nowhere) return EXIT_FAILURE;
  int status = run(&fuzz);
  summarise(&fuzz);
  rmdir(folder);
  return status;
}
