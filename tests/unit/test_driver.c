// test_driver.c -- lsys_main on two grammars written by hand (grammars.h):
// words, counts, hashes, params, errors.
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "grammars.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_ARGUMENTS = 12, OUTPUT = 1 << 16 };

static char output[OUTPUT];

// Runs `program arguments` (separated by blanks) with standard output and error in `output`; the exit status.
static int run(const LsysGrammar *grammar, const char *arguments) {
  char text[256], *argv[MOST_ARGUMENTS + 2] = {(char *)"plant"};
  int argc = 1;
  snprintf(text, sizeof text, "%s", arguments);
  for (char *word = strtok(text, " "); word && argc <= MOST_ARGUMENTS; word = strtok(NULL, " ")) argv[argc++] = word;
  fflush(stdout);
  FILE *file = tmpfile();
  int old_out = dup(STDOUT_FILENO), old_err = dup(STDERR_FILENO);
  dup2(fileno(file), STDOUT_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  int status = lsys_main(grammar, argc, argv);
  fflush(stdout);
  dup2(old_out, STDOUT_FILENO);
  dup2(old_err, STDERR_FILENO);
  close(old_out);
  close(old_err);
  rewind(file);
  output[fread(output, 1, OUTPUT - 1, file)] = 0;
  fclose(file);
  return status;
}

static void expect(const LsysGrammar *grammar, const char *arguments, const char *wanted) {
  assert_int_equal(run(grammar, arguments), 0);
  assert_string_equal(output, wanted);
}

static void refuse(const LsysGrammar *grammar, const char *arguments, const char *message) {
  assert_int_equal(run(grammar, arguments), 1);
  if (!strstr(output, message)) fail_msg("wanted '%s' in '%s'", message, output);
}

static void words(void **state) {
  (void)state;
  expect(&algae, "-n 0", "A\n");
  expect(&algae, "-n 5", "ABAABABAABAAB\n");
  expect(&algae, "-n5 --format=text", "ABAABABAABAAB\n");
  expect(&row, "-n 0 --seed 1", "A(1)A(2)\n");
}

static void counts(void **state) {
  (void)state;
  expect(&algae, "-n 60 --count", "A\t2504730781961\nB\t1548008755920\ntotal\t4052739537881\n");
  expect(&algae, "-n 20 --format count", "A\t10946\nB\t6765\ntotal\t17711\n");
}

// The draws follow from the keys: split(root, 0) and split(root, 1), then children 2.
static void keys_reach_the_grammar(void **state) {
  (void)state;
  char wanted[256] = "";
  uint64_t root = lsys_root(7);
  for (int i = 0; i < 2; i++) {
    uint64_t key = lsys_split(root, (uint64_t)i);
    double x = i + 1;
    unsigned depth = 0;
    char *at = wanted + strlen(wanted);
    for (int steps = 3; steps; steps--, x /= 2, key = lsys_split(key, 2)) {
      at += sprintf(at, "F(%g)", x);
      if (lsys_draw(key, 0) * ((x > 0.2 ? 0.75 : 0) + 0.25) >= (x > 0.2 ? 0.75 : 0)) goto closed;
      at += sprintf(at, "[");
      depth++;
    }
    at += sprintf(at, "A(%g)", x);
  closed:
    while (depth--) at += sprintf(at, "]");
  }
  strcat(wanted, "\n");
  expect(&row, "--seed 7", wanted);
}

static void params(void **state) {
  (void)state;
  expect(&row, "-n 0 -D r=0.25", "A(1)A(2)\n");
  refuse(&row, "-D r=2", "r must be in 0..1");
  refuse(&row, "-D q=1", "no param 'q'");
  refuse(&row, "-D r=x", "'x' is not a number");
  refuse(&algae, "-n 1 -D r=1", "it declares none");
}

static void options(void **state) {
  (void)state;
  refuse(&algae, "", "how many steps?");
  refuse(&algae, "--coutn", "did you mean --count?");
  refuse(&algae, "-n", "wants STEPS");
  refuse(&algae, "-n x", "a whole number");
  refuse(&algae, "-n 1 --format txet", "did you mean 'text'?");
  refuse(&algae, "-n 1 --axiom 2", "the grammar has 1 start word");
  refuse(&algae, "-n 1 -o /nowhere/x.txt", "cannot write /nowhere/x.txt");
  refuse(&algae, "-n 30 -o /dev/full", "No space left on device");
  assert_int_equal(run(&row, "--help"), 0);
  assert_non_null(strstr(output, "default 0.5, in 0..1"));
  assert_int_equal(run(&row, "--help turtle"), 0);
  assert_non_null(strstr(output, "turn left"));
}

// Enough steps for a chain of frames: the message, not a crash.
static void too_deep(void **state) {
  (void)state;
  refuse(&algae, "-n 10000000 --hash --max-memory 16M", "nested too deep");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(words),  cmocka_unit_test(counts),  cmocka_unit_test(keys_reach_the_grammar),
    cmocka_unit_test(params), cmocka_unit_test(options), cmocka_unit_test(too_deep),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
