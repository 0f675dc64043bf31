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
  expect(&bush, "-n 0 --seed 1", "A(1)A(2)\n");
}

static void counts(void **state) {
  (void)state;
  expect(&algae, "-n 60 --count", "A\t2504730781961\nB\t1548008755920\ntotal\t4052739537881\n");
  expect(&algae, "-n 20 --format count", "A\t10946\nB\t6765\ntotal\t17711\n");
}

// Writes what A(x) with this key becomes, by the productions as they are read; returns the end.
static char *grow(char *to, unsigned steps, double x, uint64_t key) {
  if (steps == 0) return to + sprintf(to, "A(%g)", x);
  double weight = x > 0.2 ? 0.75 : 0;
  to += sprintf(to, "F(%g)", x);
  if (lsys_draw(key, 0) * (weight + 0.25) >= weight) return to;
  to += sprintf(to, "[");
  to = grow(to, steps - 1, x / 2, lsys_split(key, 2));
  to += sprintf(to, "]");
  return grow(to, steps - 1, x, lsys_split(key, 4));
}

// The draws follow from the keys: split(root, 0) and split(root, 1), then children 2 and 4.
static void keys_reach_the_grammar(void **state) {
  (void)state;
  static char wanted[OUTPUT];
  for (uint64_t seed = 1; seed <= 20; seed++) {
    uint64_t root = lsys_root(seed);
    char arguments[32], *end = grow(grow(wanted, 3, 1, lsys_split(root, 0)), 3, 2, lsys_split(root, 1));
    strcpy(end, "\n");
    sprintf(arguments, "--seed %u", (unsigned)seed);
    expect(&bush, arguments, wanted);
  }
}

// Long enough for the other threads to be started.
static void threads(void **state) {
  (void)state;
  // Pieces that are references, chunks, counts and text.
  static const LsysGrammar *const grammars[] = {&algae, &bush, &algae, &bush, &bush};
  static const char *const arguments[] = {"-n 40 --hash --threads", "-n 33 -D r=1 --seed 3 --hash --threads",
                                          "-n 40 --format count --threads", "-n 33 -D r=1 --seed 3 --count --threads",
                                          "-n 33 -D r=1 --seed 3 --range 1000000:2000 --threads"};
  static const unsigned counts[] = {2, 3, 7};
  for (int i = 0; i < 5; i++) {
    char command[128];
    static char wanted[OUTPUT];
    sprintf(command, "%s 1", arguments[i]);
    assert_int_equal(run(grammars[i], command), 0);
    strcpy(wanted, output);
    for (int j = 0; j < 3; j++) {
      sprintf(command, "%s %u", arguments[i], counts[j]);
      expect(grammars[i], command, wanted);
    }
  }
  refuse(&algae, "-n 1 --threads 0", "a number from 1 to");
  refuse(&algae, "-n 40 -o /dev/full --threads 3", "No space left on device");
}

// The letter at a place of a word that nobody could store: as the recursion of the productions says.
static void ranges(void **state) {
  (void)state;
  expect(&algae, "-n 1000 --range 100000000000000000000000000000000000:70",
         "ABABAABABAABAABABAABABAABAABABAABAABABAABABAABAABABAABABAABAABABAABAAB\n");
  static char full[OUTPUT];
  assert_int_equal(run(&algae, "-n 15"), 0);
  strcpy(full, output);
  size_t length = strlen(full) - 1;
  for (size_t first = 0; first < length + 20; first += 37) {
    char command[64], wanted[64];
    size_t from = first < length ? first : length, count = length - from < 50 ? length - from : 50;
    sprintf(wanted, "%.*s\n", (int)count, full + from);
    sprintf(command, "-n 15 --quiet --range %zu:50", first);
    expect(&algae, command, wanted);
  }
  expect(&bush, "--seed 7 --range 0:0", "\n");
  refuse(&algae, "-n 3 --range 3", "it is A:LEN");
  refuse(&algae, "-n 3 --range -3:4", "it is A:LEN");
}

// Without a growth matrix the word is derived and passed over; it ends early.
static void ranges_without_growth(void **state) {
  (void)state;
  assert_int_equal(run(&bush, "-n 5 -D r=1"), 0);
  static char full[OUTPUT];
  strcpy(full, output);
  assert_int_equal(run(&bush, "-n 5 -D r=1 --range 0:1"), 0);
  assert_memory_equal(output, full, strlen(output) - 1);
  assert_int_equal(output[strlen(output) - 1], '\n');
  for (int count = 1; count < 3; count++) {
    char command[64];
    sprintf(command, "-n 60 -D r=1 --range 5:1000 --hash --threads %d", count);
    assert_int_equal(run(&bush, command), 0);
    if (count == 1) strcpy(full, output);
    assert_string_equal(output, full);
  }
}

static void params(void **state) {
  (void)state;
  expect(&bush, "-n 0 -D r=0.25", "A(1)A(2)\n");
  refuse(&bush, "-D r=2", "r must be in 0..1");
  refuse(&bush, "-D q=1", "no param 'q'");
  refuse(&bush, "-D r=x", "'x' is not a number");
  refuse(&algae, "-n 1 -D r=1", "it declares none");
}

static void options(void **state) {
  (void)state;
  refuse(&algae, "", "how many steps?");
  refuse(&algae, "--coutn", "did you mean --count?");
  refuse(&algae, "--thre 2", "did you mean --threads?");
  refuse(&algae, "-n", "wants STEPS");
  refuse(&algae, "-n x", "a whole number");
  refuse(&algae, "-n 1 --format txet", "did you mean 'text'?");
  refuse(&algae, "-n 1 --axiom 2", "the grammar has 1 start word");
  refuse(&algae, "-n 1 --engine x", "the engines are expand and step");
  expect(&algae, "-n 5 --engine step", "ABAABABAABAAB\n");
  expect(&algae, "-n 5 --engine expand --progress --quiet", "ABAABABAABAAB\n");
  refuse(&algae, "-n 1 -o /nowhere/x.txt", "cannot write /nowhere/x.txt");
  refuse(&algae, "-n 30 -o /dev/full", "No space left on device");
  assert_int_equal(run(&bush, "--help"), 0);
  assert_non_null(strstr(output, "default 0.5, in 0..1"));
  assert_int_equal(run(&bush, "--help turtle"), 0);
  assert_non_null(strstr(output, "turn left"));
}

// Enough steps for a chain of frames: the message, not a crash.
static void too_deep(void **state) {
  (void)state;
#ifdef __SANITIZE_THREAD__
  skip();  // ThreadSanitizer itself keeps 65,536 frames at most
#endif
  refuse(&algae, "-n 10000000 --hash --max-memory 16M", "nested too deep");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(words),   cmocka_unit_test(counts),  cmocka_unit_test(keys_reach_the_grammar),
    cmocka_unit_test(threads), cmocka_unit_test(ranges),  cmocka_unit_test(ranges_without_growth),
    cmocka_unit_test(params),  cmocka_unit_test(options), cmocka_unit_test(too_deep),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
