// transcript.c -- cases whose whole output stands in a file beside them,
// NAME.expected: messages about a wrong grammar, sessions of the shell.
#include "golden.h"

#include <stdlib.h>
#include <string.h>

static const char *with_suffix(Case *test, const char *suffix) {
  const char *dot = strrchr(test->path, '.');
  return arena_printf(test->arena, "%.*s%s", (int)(dot - test->path), test->path, suffix);
}

static void compare(Case *test, const char *found, size_t size) {
  const char *path = with_suffix(test, ".expected");
  const char *expected = text_read(test->arena, path);
  if (expected && strcmp(expected, found) == 0) {
    case_pass(test);
  } else if (test->bless) {
    if (text_write(path, found, size))
      case_pass(test);
    else
      case_fail(test, 0, "cannot write %s", path);
  } else if (!expected) {
    case_fail(test, 0, "there is no %s (--bless writes it)", path);
  } else {
    case_fail(test, 0, "differs from %s", path);
    text_report_difference(test->report, expected, found);
  }
}

// `// options: ...` in the file: options for lsysc.
static const char *options_in(Arena *arena, const char *text) {
  const char *mark = strstr(text, "options:");
  if (!mark) return "";
  mark += strlen("options:");
  size_t length = strcspn(mark, "\n");
  return arena_copy(arena, mark, length);
}

// lsysc check NAME in the folder of the case: what stands on standard error.
void errors_run(Case *test) {
  const char *text = text_read(test->arena, test->path);
  const char *slash = strrchr(test->path, '/');
  if (!text) {
    case_fail(test, 0, "cannot be read");
    return;
  }
  Strings argv = {0};
  *VEC_PUSH(test->arena, &argv) = test->lsysc;
  *VEC_PUSH(test->arena, &argv) = "check";
  text_split(test->arena, &argv, options_in(test->arena, text));
  *VEC_PUSH(test->arena, &argv) = slash + 1;
  *VEC_PUSH(test->arena, &argv) = NULL;
  const char *folder = arena_copy(test->arena, test->path, (size_t)(slash - test->path));
  Result result = process_run(test->arena, &argv, folder, false);
  bool error = strstr(result.err, "error:") != NULL;
  if (result.late || result.status != (error ? 1 : 0))
    case_fail(test, 0, "status %d does not fit the messages\n%s", result.status, result.err);
  else if (result.size > 0)
    case_fail(test, 0, "`check` printed to standard output: %s", result.out);
  else
    compare(test, result.err, strlen(result.err));
}

// A shell script in an empty folder; $CASES is the folder of the cases, lsysc is in PATH.
void cli_run(Case *test) {
  Strings argv = {0};
  *VEC_PUSH(test->arena, &argv) = "sh";
  *VEC_PUSH(test->arena, &argv) = test->path;
  *VEC_PUSH(test->arena, &argv) = NULL;
  const char *slash = strrchr(test->path, '/');
  setenv("CASES", arena_copy(test->arena, test->path, (size_t)(slash - test->path)), 1);
  Result result = process_run(test->arena, &argv, test->folder, true);
  if (result.late)
    case_fail(test, 0, "took over %d s", PROCESS_SECONDS);
  else
    compare(test, result.out, result.size);
}
