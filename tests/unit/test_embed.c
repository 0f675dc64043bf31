// test_embed.c -- lsys_derive: the word in the hands of one's own program.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "grammars.h"
#include "lsys/lsys.h"

#include <string.h>

typedef struct Seen {
  char text[64];
  uint64_t modules;
  bool stops;
} Seen;

static bool receive(void *data, uint32_t axiom, const LsysWord *part) {
  Seen *seen = data;
  assert_int_equal(axiom, 0);
  for (uint64_t i = 0; i < part->nsym; i++)
    if (seen->modules + i + 1 < sizeof seen->text) seen->text[seen->modules + i] = "AB"[part->sym[i]];
  seen->modules += part->nsym;
  return !seen->stops;
}

static void word_in_parts(void **state) {
  (void)state;
  Seen seen = {0};
  assert_true(lsys_derive(&algae, (const char *const[]){"-n", "5", NULL}, receive, &seen));
  assert_string_equal(seen.text, "ABAABABAABAAB");
  seen = (Seen){0};
  assert_true(lsys_derive(&algae, (const char *const[]){"-n30", "--threads=2", NULL}, receive, &seen));
  assert_int_equal(seen.modules, 2178309);
}

static void stopping(void **state) {
  (void)state;
  Seen seen = {.stops = true};
  assert_false(lsys_derive(&algae, (const char *const[]){"-n", "30", NULL}, receive, &seen));
  assert_in_range(seen.modules, 1, 1 << 20);
}

static void wrong_options(void **state) {
  (void)state;
  Seen seen = {0};
  assert_false(lsys_derive(&algae, (const char *const[]){"--setps", "5", NULL}, receive, &seen));
  assert_false(lsys_derive(&algae, (const char *const[]){"--help", NULL}, receive, &seen));
  assert_false(lsys_derive(&algae, (const char *const[]){NULL}, receive, &seen));
  LsysGrammar old = algae;
  old.abi_version = 0;
  assert_false(lsys_derive(&old, (const char *const[]){"-n", "5", NULL}, receive, &seen));
  assert_int_equal(seen.modules, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(word_in_parts),
    cmocka_unit_test(stopping),
    cmocka_unit_test(wrong_options),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
