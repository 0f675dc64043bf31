// derive.c -- a grammar with expectations in its comments, run by every engine.
//
// Every test of a case is run through the interpreter, the JIT, and programs
// compiled with -O0 and -O2, the latter also on 2 and 7 threads. All must print
// the same bytes, and what they print must be what the comments say.
// tests/README.md describes the comments.
#include "expect.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- engines -------------------------------------------------------------------

// Each line of the table is one way to derive: the reference first.
static const struct {
  const char *name, *command, *more;  // command: of lsysc, or the level at which a program was compiled
  bool compiled;
  bool hash_only;
} engines[] = {
  {"interp", "interp", "", false, false},
  {"run", "run -O1", "", false, false},
  {"-O0", "-O0", "", true, false},
  {"-O2", "-O2", "", true, false},
  {"-O2 --threads 2", "-O2", "--threads 2", true, true},
  {"-O2 --threads 7", "-O2", "--threads 7", true, true},
  {"-O2 --engine step", "-O2", "--engine step", true, true},
};
enum { ENGINE_COUNT = sizeof engines / sizeof *engines };

typedef struct Derivation {
  Case *test;
  const char *grammar;  // path
  FileOptions file;
  bool threads;  // programs know --threads
} Derivation;

static const char *program_path(const Derivation *d, const char *level) {
  return arena_printf(d->test->arena, "%s/program%s", d->test->folder, level);
}

static bool compile(const Derivation *d, const char *level) {
  Case *test = d->test;
  Strings argv = {0};
  *VEC_PUSH(test->arena, &argv) = test->lsysc;
  *VEC_PUSH(test->arena, &argv) = level;
  text_split(test->arena, &argv, d->file.options);
  *VEC_PUSH(test->arena, &argv) = d->grammar;
  *VEC_PUSH(test->arena, &argv) = "-o";
  *VEC_PUSH(test->arena, &argv) = program_path(d, level);
  *VEC_PUSH(test->arena, &argv) = NULL;
  Result result = process_run(test->arena, &argv, NULL, true);
  if (result.status == 0) return true;
  case_fail(test, 0, "lsysc %s ended with status %d%s\n%s", level, result.status, result.late ? " (too slow)" : "",
            result.out);
  return false;
}

// Runs one engine with the test's options and what asks for one view of the result: "--count", "--hash", ...
static Result run_engine(const Derivation *d, int engine, const char *options, const char *view) {
  Case *test = d->test;
  Strings argv = {0};
  if (engines[engine].compiled) {
    *VEC_PUSH(test->arena, &argv) = program_path(d, engines[engine].command);
  } else {
    *VEC_PUSH(test->arena, &argv) = test->lsysc;
    text_split(test->arena, &argv, engines[engine].command);
    text_split(test->arena, &argv, d->file.options);
    *VEC_PUSH(test->arena, &argv) = d->grammar;
  }
  text_split(test->arena, &argv, options);
  text_split(test->arena, &argv, engines[engine].more);
  text_split(test->arena, &argv, view);
  *VEC_PUSH(test->arena, &argv) = NULL;
  return process_run(test->arena, &argv, test->folder, false);
}

// ---- one view, all engines -------------------------------------------------------

static bool agree(const Test *t, View view, const Result *a, const Result *b) {
  if (a->status != b->status || b->late) return false;
  if (t->fails) return true;
  return view == VIEW_STATS ? expect_same_stats(t, a->out, b->out)
                            : a->size == b->size && !memcmp(a->out, b->out, a->size);
}

static bool shows_failure(const Test *t, const Result *result) {
  return t->fails ? result->status == 1 && strstr(result->err, t->fails) : result->status == 0 && !result->late;
}

// What the reference printed, after all engines have printed the same; NULL after reporting a failure.
static const Result *run_view(const Derivation *d, const Test *t, const char *options, View view) {
  Result *reference = ARENA_NEW(d->test->arena, Result);
  for (int engine = 0; engine < (d->file.interp_only ? 1 : ENGINE_COUNT); engine++) {
    if (engines[engine].hash_only && (view != VIEW_HASH || !d->threads)) continue;
    Result result = run_engine(d, engine, options, view_options[view]);
    if (!shows_failure(t, &result)) {
      case_fail(d->test, t->line, "%s %s %s: status %d%s\n%s", engines[engine].name, options, view_options[view],
                result.status, result.late ? " (too slow)" : "", result.err);
      return NULL;
    }
    if (engine == 0) {
      *reference = result;
    } else if (!agree(t, view, reference, &result)) {
      case_fail(d->test, t->line, "%s differs from %s with %s %s", engines[engine].name, engines[0].name, options,
                view_options[view]);
      text_report_difference(d->test->report, reference->out, result.out);
      return NULL;
    }
  }
  return reference;
}

static bool run_once(const Derivation *d, Test *t, const char *options) {
  for (View view = 0; view < VIEW_COUNT; view++) {
    if (!expect_needs(t, view)) continue;
    const Result *result = run_view(d, t, options, view);
    if (!result) return false;
    if (!t->fails && !expect_holds(d->test, t, view, result->out)) return false;
  }
  return true;
}

// ---- seeds -----------------------------------------------------------------------

static bool run_seeds(const Derivation *d, Test *t) {
  for (unsigned long seed = t->first_seed; seed <= t->last_seed; seed++)
    if (!run_once(d, t, arena_printf(d->test->arena, "%s --seed %lu", t->options, seed))) return false;
  return expect_all_came(d->test, t);
}

// Frequencies need more seeds than every engine can be run with: the -O2 program alone, where there is one.
static bool run_frequencies(const Derivation *d, Test *t) {
  for (unsigned long seed = t->first_seed; seed <= t->last_seed; seed++) {
    Result result =
      run_engine(d, d->file.interp_only ? 0 : 3, arena_printf(d->test->arena, "%s --seed %lu", t->options, seed), "");
    if (result.status != 0 || !expect_outcome(t, result.out)) {
      case_fail(d->test, t->line, "seed %lu gave: %s", seed, result.out);
      return false;
    }
  }
  return expect_frequencies(d->test, t);
}

static bool knows_threads(const Derivation *d) {
  return strstr(run_engine(d, 3, "--help", "").out, "--threads") != NULL;
}

static void run_tests(Derivation *d, const Tests *tests) {
  if (!d->file.interp_only) {
    if (!compile(d, "-O0") || !compile(d, "-O2")) return;
    d->threads = knows_threads(d);
  }
  for (size_t i = 0; i < tests->count; i++) {
    Test *t = &tests->at[i];
    bool passed = t->frequencies ? run_frequencies(d, t) : t->seeded ? run_seeds(d, t) : run_once(d, t, t->options);
    if (passed) case_pass(d->test);
  }
}

// The expectations of a file that has to stay as it was published stand beside it, in NAME.test.
static const char *expectations_of(Case *test) {
  const char *dot = strrchr(test->path, '.');
  const char *beside = arena_printf(test->arena, "%.*s.test", (int)(dot - test->path), test->path);
  const char *text = text_read(test->arena, beside);
  return text ? text : text_read(test->arena, test->path);
}

void derive_run(Case *test) {
  const char *text = expectations_of(test);
  if (!text) {
    case_fail(test, 0, "cannot be read");
    return;
  }
  Derivation d = {.test = test, .grammar = test->path};
  Tests tests = {0};
  if (!expect_read(test, text, 0, &tests, &d.file)) return;
  if (tests.count == 0)
    case_fail(test, 0, "has no `test:`");
  else
    run_tests(&d, &tests);
}

void derive_text(Case *test, const char *grammar, unsigned line) {
  const char *text = text_read(test->arena, grammar);
  Derivation d = {.test = test, .grammar = grammar};
  Tests tests = {0};
  if (text && expect_read(test, text, line, &tests, &d.file) && tests.count > 0) run_tests(&d, &tests);
}
