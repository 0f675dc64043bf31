// test_parse_limits.c -- long words, long tokens and deep nesting: read, or refused with one message, in little time.
#include "parsing.h"

#include <time.h>

static Parsed parse(const char *text) {
  return parse_bytes(parse_file, "t.lsys", text, strlen(text), &(ParseOptions){0});
}

static void refuses(const char *text, const char *message) {
  parse_says(parse_file, "t.lsys", text, &(ParseOptions){0}, 1, message);
}

static void test_long_words(void **state) {
  (void)state;
  static const char *const parts[] = {"F", "[", "A(1)", "F_l"};
  for (int i = 0; i < 4; i++) {
    char *text = repeated("#modules FFFG\naxiom: ", parts[i], 1000000, "");
    clock_t begin = clock();
    Parsed parsed = parse(text);
    assert_true((double)(clock() - begin) / CLOCKS_PER_SEC < 10);
    assert_int_equal(parsed.errors, 0);
    assert_int_equal(parsed.ast->statements.at[1].words.at[0].modules.count, 1000000);
    parsed_free(&parsed);
    free(text);
  }
}

static void test_long_tokens(void **state) {
  (void)state;
  static const char *const read[][3] = {
    {"#define A ", "a", ""}, {"w: F(", "1", ".0e-100000)"}, {"w: F(\"", "s", "\")"},      {"w: /*", "c", "*/ F"},
    {"tables: ", "t", ""},   {"surface s: ", "f", ""},      {"#modules ", "m", "\nw: m"}, {"p1", "1", ": F -> F"},
    {"w: F_", "1", ""},      {"environment: ", "e", " (1)"}};
  for (size_t i = 0; i < sizeof read / sizeof *read; i++) {
    char *text = repeated(read[i][0], read[i][1], 100000, read[i][2]);
    Parsed parsed = parse(text);
    assert_int_equal(parsed.errors, 0);
    parsed_free(&parsed);
    free(text);
  }
  static const char *const refused[][3] = {{"", "x", ": 3"},      {"", "y", ""},  {"A : a ", "z", " -> B"},
                                           {"w: F(\"", "s", ")"}, {"#", "d", ""}, {"w: F(", "9", ")"},
                                           {"#include ", "i", ""}};
  for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
    char *text = repeated(refused[i][0], refused[i][1], 100000, refused[i][2]);
    refuses(text, "");
    free(text);
  }
}

static void test_costly_conditions(void **state) {
  (void)state;
  char text[4000] = "#define A0 1\n";
  for (int i = 1; i < 60; i++) {
    char line[40];
    snprintf(line, sizeof line, "#define A%d A%d+A%d\n", i, i - 1, i - 1);
    strcat(text, line);
  }
  strcat(text, "#if A59\n#endif\n");
  refuses(text, "this condition takes too long to evaluate");
}

static void test_deep_nesting(void **state) {
  (void)state;
  static const char *const nests[][3] = {{"w: A(", "(", "1"},
                                         {"w: A(", "-", "1)"},
                                         {"w: A(1", "+1", ")"},
                                         {"w: A(", "f(", "1"},
                                         {"w: A(1", "^1", ")"},
                                         {"Start: ", "{", ""},
                                         {"Start: {", "if(1) ", "x=1;}"},
                                         {"Start: {", "do ", "x=1;}"},
                                         {"w: A(", "a?b:", "1)"},
                                         {"w: A(", "1?", "1"},
                                         {"define: { array a[1] =", "{", "1"},
                                         {"w: A(x", "[1", ""}};
  for (size_t i = 0; i < sizeof nests / sizeof *nests; i++) {
    char *text = repeated(nests[i][0], nests[i][1], 100000, nests[i][2]);
    refuses(text, "");
    free(text);
  }
  refuses(nests[1][0], "never closed");
  char *text = repeated("w: A(1", "+1", 999, ")");
  Parsed parsed = parse(text);
  assert_int_equal(parsed.errors, 0);
  parsed_free(&parsed);
  free(text);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_long_words),
    cmocka_unit_test(test_long_tokens),
    cmocka_unit_test(test_costly_conditions),
    cmocka_unit_test(test_deep_nesting),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
