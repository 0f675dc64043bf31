// unit.c -- programs with cmocka tests: each of their tests counts.
#include "golden.h"

#include <stdlib.h>
#include <string.h>

// The number in cmocka's line "[  PASSED  ] 7 test(s)."; 0 if there is none.
static size_t tests_in(const char *text, const char *mark) {
  const char *at = strstr(text, mark);
  return at ? strtoul(at + strlen(mark), NULL, 10) : 0;
}

void unit_run(Case *test) {
  Strings argv = {0};
  *VEC_PUSH(test->arena, &argv) = test->path;
  *VEC_PUSH(test->arena, &argv) = NULL;
  Result result = process_run(test->arena, &argv, test->folder, true);
  test->passed += tests_in(result.out, "[  PASSED  ] ");
  if (result.status == 0) return;
  case_fail(test, 0, "ended with status %d%s\n%s", result.status, result.late ? " (too slow)" : "", result.out);
  size_t failed = tests_in(result.out, "[  FAILED  ] ");
  if (failed > 1) test->failed += failed - 1;
}
