// test_check.c -- from the text of a grammar to its Program, and to the messages
// about it. What a Program holds is compared by its dump.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frontend/program.h"
#include "support/diag.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct Result {
  Arena *arena;
  const Program *program;
  char *messages, *dump;
} Result;

static Result check_bytes(const char *text, size_t length, bool all_warnings) {
  Result result = {.arena = arena_create()};
  size_t size;
  DiagOptions options;
  diag_options_default(&options);
  if (all_warnings) diag_option(&options, "all");
  options.colour = COLOUR_NEVER;
  options.out = open_memstream(&result.messages, &size);
  Sources *sources = sources_create(result.arena);
  const SourceFile *file = sources_add(sources, "t.lsys", text, length, (Span){0, 0});
  Diag *diag = diag_create(result.arena, sources, &options);
  Ast *ast = parse_file(result.arena, sources, diag, file, &(ParseOptions){0});
  if (diag_errors(diag) == 0) result.program = check(result.arena, ast, diag);
  fclose(options.out);
  FILE *dump = open_memstream(&result.dump, &size);
  if (result.program) program_dump(result.program, dump);
  fclose(dump);
  return result;
}

static Result checked(const char *text) {
  return check_bytes(text, strlen(text), false);
}

static void release(Result *result) {
  arena_destroy(result->arena);
  free(result->messages);
  free(result->dump);
}

static void expect_part(const char *whole, const char *part) {
  if (!strstr(whole, part)) fail_msg("expected\n  %s\nin\n%s", part, whole);
}

// The grammar is accepted in silence and its dump holds each of the parts (up to NULL).
static void accepts(const char *text, ...) {
  Result result = checked(text);
  assert_string_equal(result.messages, "");
  assert_non_null(result.program);
  va_list parts;
  va_start(parts, text);
  for (const char *part; (part = va_arg(parts, const char *));) expect_part(result.dump, part);
  va_end(parts);
  release(&result);
}

static void refuses(const char *text, const char *message) {
  Result result = checked(text);
  assert_null(result.program);
  expect_part(result.messages, message);
  release(&result);
}

static void warns(const char *text, const char *message) {
  Result result = check_bytes(text, strlen(text), true);
  if (!result.program) fail_msg("%s", result.messages);
  expect_part(result.messages, message);
  release(&result);
}

static void is_silent(const char *text) {
  accepts(text, NULL);
}

// ---- kinds ---------------------------------------------------------------------

static void kinds_are_numbered_in_file_order(void **state) {
  (void)state;
  accepts("#modules stem leaf\nignore: Z\nC < B(x) > D --> stem E\naxiom: A B(1)\nB(2) --> A(1)\n",
          "kind 0: C/0\nkind 1: B/1\nkind 2: D/0\nkind 3: stem/0\nkind 4: E/0\nkind 5: A/0\nkind 6: A/1\n", NULL);
  accepts("axiom: A\nA > =B@] --> [A]\n", "kind 0: A/0\nkind 1: B/0\nkind 2: [/0\nkind 3: ]/0\naxiom", NULL);
}

static void declared_arguments(void **state) {
  (void)state;
  accepts("module Apex(age, vigor)\naxiom: Apex(0,1)\n", "kind 0: Apex/2 (age,vigor)", NULL);
  refuses("module Apex(age, vigor)\naxiom: Apex(0)\n", "2:8: error: `Apex` takes 2 arguments (age, vigor), not 1");
  refuses("module Apex(age, age)\naxiom: A\n", "1:18: error: two arguments of `Apex` are called `age`");
  refuses("axiom: A[(1)B]\n", "`[` takes no arguments");
}

// ---- names -----------------------------------------------------------------------

static void parameters_are_slots_in_order(void **state) {
  (void)state;
  accepts("axiom: A(1)\nA(l) < A(0) > A(-2) : l > 1 --> A(l)\n", "A(l) < A($1) > A($2)  --> A(l)\n",
          "match $1 == 0 && $2 == -2\n", "guard l > 1\n", NULL);
  refuses("axiom: A(1)\nA(x) < A(x) --> A\n",
          "2:10: error: parameter `x` is used twice\n    2 | A(x) < A(x) --> A\n      |          ^\n"
          "t.lsys:2:3: note: the first `x` is here\n");
  refuses("axiom: A(1)\nA(x+1) --> A\n", "2:3: error: a parameter of a predecessor is a name or a number");
}

static void unknown_names(void **state) {
  (void)state;
  refuses("#define length 2\naxiom: F(lenght)\n", "2:10: error: unknown name `lenght`; did you mean `length`?");
  refuses("axiom: F(1)\nF(width) --> F(widht)\n", "did you mean `width`?");
  refuses("axiom: F(q)\n", "unknown name `q`\n");
  refuses("axiom: F(sine(2))\n", "unknown function `sine`; did you mean `sin`?");
  refuses("#define a 1\n#undef a\naxiom: F(a)\n", "2:8: note: `a` was undefined here");
  Result twice = checked("axiom: A(1)\nA(x) : y > 1 && y < 2 --> A(y)\n");
  char *first = strstr(twice.messages, "unknown name `y`");
  assert_non_null(first);
  assert_null(strstr(first + 1, "unknown name `y`"));
  release(&twice);
}

static void definitions_are_seen_by_position(void **state) {
  (void)state;
  accepts("axiom: A(a)B(a)\n#define a 1\n#undef a\n#define a 2\nB(x) --> B(a)\n", "axiom 0: A(a)", NULL);
  Result result = checked("axiom: A(a)B(a)\n#define a 1\n#undef a\n#define a 2\nB(x) --> B(a)\n");
  const Program *program = result.program;
  assert_int_equal(program->axioms[0].at[0].args[0]->slot, LSYS_SETTING_COUNT + 0);
  assert_int_equal(program->lsystems[0].productions.at[0]->successor.at[0].args[0]->slot, LSYS_SETTING_COUNT + 1);
  release(&result);
  warns("#define a 1\n#define a 2\naxiom: A(a)\n", "2:9: warning: `a` is defined twice [-Wredefined]");
  refuses("param a = 1\n#define a 2\naxiom: A(a)\n", "`a` is defined twice");
}

static void values_are_ordered(void **state) {
  (void)state;
  accepts("#define a b*2\n#define b c(1)\n#define c(x) x+d\n#define d 4\naxiom: A(a)\n",
          "define d = 4\ndefine b = c(1)\ndefine a = b * 2\n", "function c(x) = x + d\n", NULL);
  refuses("#define a a+1\naxiom: A(a)\n", "1:11: error: `a` is defined by itself\n");
  refuses("#define a b\n#define b c(1)\n#define c(x) a\naxiom: A\n", "`a` is defined by itself: it needs `b`\n");
  refuses("#define f(x) f(x-1)\naxiom: A\n", "1:14: error: `f` calls itself, which a #define cannot\n");
}

static void params_have_ranges(void **state) {
  (void)state;
  accepts("param a = 2*3 in 1..10\naxiom: A(a)\n", "param a = 6 in 1..10\n", NULL);
  refuses("param a = 12 in 1..10\naxiom: A(a)\n", "1:11: error: the default of `a` is 12, which is not in its range");
  refuses("param a = 12 in 10..1\naxiom: A(a)\n", "the range of `a` is empty: 10 is above 1");
}

static void hidden_definitions_get_a_note(void **state) {
  (void)state;
  Result result = checked("#define c 1\naxiom: A(c)\nA(c) --> A(c)\n");
  expect_part(result.messages, "3:3: note: here the parameter `c` hides the #define of that name");
  assert_non_null(result.program);
  release(&result);
}

// ---- calls ---------------------------------------------------------------------------

static void numbers_of_arguments(void **state) {
  (void)state;
  refuses("axiom: A(sin(1,2))\n", "1:10: error: `sin` takes 1 argument, not 2");
  refuses("axiom: A(atan())\n", "`atan` takes 1 or 2 arguments, not 0");
  refuses("axiom: A(min())\n", "`min` takes at least 1 argument, not 0");
  refuses("#define f(x,y) x\naxiom: A(f(1))\n", "2:10: error: `f` takes 2 arguments, not 1");
  refuses("#define f(x) x\naxiom: A(f)\n", "`f` is a function and needs its arguments: `f(...)`");
  refuses("axiom: A(1)\nA(x) --> A(x(2))\n", "`x` is a number and takes no arguments");
}

static void calls_are_numbered_in_file_order(void **state) {
  (void)state;
  accepts("#define f(x) ran(x)\naxiom: A(ran(1))\nA(x) : ran(x) > nran(0,1) --> A(bran(1,1)) : ran(2)\n", "ran@1(x)",
          "ran@2(1)", "guard ran@3(x) > nran@4(0, 1)", "A(bran@5(1, 1))", "weight ran@6(2)", "6 calls", NULL);
}

static void numbers_are_folded(void **state) {
  (void)state;
  accepts("#define h (2*3)^0.5\n#define k -2^2\naxiom: A(1/3+h, 2^0.7, sin(30))\n", "define h = 2.449489742783178\n",
          "define k = -4\n", "A(0.3333333333333333 + h,2^0.7,sin(30))", NULL);
}

// ---- words and contexts ------------------------------------------------------------------

static void brackets_balance(void **state) {
  (void)state;
  warns("axiom: A\nA --> F[+A[F]\n", "2:8: warning: this `[` is not closed in the successor [-Wbrackets]");
  warns("axiom: F]A\nA --> F\n", "1:9: warning: this `]` closes no `[` of the axiom");
}

static void contexts(void **state) {
  (void)state;
  accepts("axiom: AS\nBC < S > G[H]M --> T\n", "B C < S > G [ H ] M  --> T", NULL);
  accepts("axiom: AS\nA[ < S > =@] --> T\n", "A [ < S > = @]  --> T", NULL);
  refuses("axiom: A\nA[B] < S --> T\n", "2:2: error: in a left context `[` can only stand last");
  refuses("axiom: A\nS > A]B --> T\n", "2:6: error: this `]` closes no `[` of the right context");
  refuses("axiom: A\n[ --> A\n", "`[` cannot be replaced");
  accepts("axiom: AFl\nFl --> A\n", "lsystem 0 pseudo", NULL);
}

static void ignored_symbols(void **state) {
  (void)state;
  accepts("ignore: +F\naxiom: F+F(1)A\nA < A --> B\n", "  ignore F/0 +/0 F/1\n", NULL);
  accepts("consider: A\naxiom: F[A]\nA < A --> B\n", "  ignore F/0 B/0\n", NULL);
  warns("ignore: +\naxiom: A+\nA+ < A --> B\n", "3:2: warning: this context is never found: contexts do not see `+`");
}

// ---- sections -------------------------------------------------------------------------------

static void sections(void **state) {
  (void)state;
  accepts("axiom: A\nA --> B\ndecomposition\nmaximum depth: 5\nB --> C\nhomomorphism: warnings\nseed: 7\nC --> F\n",
          "decomposition depth 5\n  production 1: B", "homomorphism depth 1 seed 7 warnings\n  production 2: C", NULL);
  refuses("axiom: A\nmaximum depth: 3\n",
          "2:1: error: `maximum depth:` belongs behind `decomposition` or `homomorphism`");
  refuses("axiom: A\ndecomposition\nA < B --> C\n", "3:1: error: a decomposition has no contexts");
  warns("axiom: A\nhomomorphism\nmaximum depth: 3\nA --> FA\n", "only the maximum depth of 3 ends it");
}

static void tables(void **state) {
  (void)state;
  accepts("axiom: A\nB --> C\ntable one:\nA --> B\ntable two:\nA --> AA\ntables: two one two\n",
          "  tables two one two\n", "production 0: B", "production 1 in table one: A", NULL);
  refuses("axiom: A\ntable one:\nA --> B\ntables: onw\n", "4:9: error: unknown table `onw`; did you mean `one`?");
  refuses("axiom: A\ntable one:\nA --> B\n", "2:7: error: no step uses table `one`");
}

static void subsystems(void **state) {
  (void)state;
  accepts("axiom: ?(leaf,2)A$\nlsystem: leaf\nA --> AA\nendlsystem\nA --> B\n", "axiom 0: ?(1,2) A $\n",
          "lsystem 1 leaf\n  production 0: A", NULL);
  accepts("axiom: ?(k)A$?(1)$\n#define k 1\nlsystem: leaf\nA --> AA\nendlsystem\n", "axiom 0: ?(k) A $ ?(1) $\n", NULL);
  refuses("axiom: ?(2)A$\nlsystem: leaf\nA --> AA\nendlsystem\n", "1:10: error: unknown L-system `2`");
  refuses("axiom: ?(laef)A$\nlsystem: leaf\nA --> AA\nendlsystem\n", "unknown L-system `laef`; did you mean `leaf`?");
}

static void blocks(void **state) {
  (void)state;
  accepts("define: { array a[2][3] = {1, 2}; }\nStart: { n = 3; }\nEndEach: { n = n + 1; }\naxiom: A(n)\n"
          "A(x) : { y = x*2; a[0][1] = y; n = y; } y < 9 { z = y; } --> A(z)\n",
          "global n\n", "array a[2][3]", "end each\n  n = n + 1\n",
          "before\n      y = x * 2\n      a[0][1] = y\n      n = y\n", "guard y < 9", NULL);
  refuses("Start: { n = 3; }\n#define k n+1\naxiom: A(k)\n", "2:11: error: `n` has no value yet");
  refuses("#define n 1\nStart: { n = 3; }\naxiom: A(n)\n", "`n` is a constant and cannot be assigned");
}

// ---- warnings ----------------------------------------------------------------------------------

static void weights(void **state) {
  (void)state;
  is_silent("axiom: A\nA --> B : 33\nA --> C : 33\nA --> D : 34\n");
  is_silent("axiom: A\nA --> B : 0.1\nA --> C : 0.2\nA --> D : 0.7\n");
  is_silent("axiom: A\nA --> B : 3\nA --> C : 1\nA --> D : 1\n");
  is_silent("axiom: A(1)\nA(x) : x > 1 --> B : 0.3\nA(x) : x > 1 --> C : 0.3\nA(x) --> D : 0.4\n");
  is_silent("axiom: A\nA --> B : 0.4\nA --> C : 0.6\nB < A --> D : 0.5\n");
  warns("axiom: A\nA --> B : 0.33\nA --> C : 0.33\nA --> D : 0.33\n",
        "2:11: warning: these weights sum to 0.99, not to 1 or 100 [-Wweights]");
  warns("axiom: A\nA --> B : 0.5\n", "no other production competes with this one");
  warns("axiom: A\nA --> B : 0\nA --> C : 1\n", "a production of weight 0 is never chosen");
}

static void unreachable_productions(void **state) {
  (void)state;
  const char *never = "3:1: warning: this production never applies: an earlier one is always taken before it";
  warns("axiom: A\nA --> B\nB < A --> C\n", never);
  warns("axiom: A\nA --> B : 2\nA --> C\n", never);
  warns("axiom: A(1)\nA(x) : x > 1 --> B\nA(y) : y > 1 --> C\n", never);
  warns("axiom: A\nB < A --> B\nCB < A > D --> C\n", never);
  warns("axiom: A\nA --> B\nAB --> C\n", never);
  is_silent("axiom: A\nA > B --> C\nA --> B\n");
  is_silent("axiom: A(1)\nA(x) : ran(x) > 1 --> B\nA(x) : ran(x) > 1 --> C\n");
  is_silent("axiom: A(1)\nA(x) : x > 1 --> B : 1\nA(x) --> C\nA(x) : x > 2 --> C : 1\n");
}

static void doubtful_values(void **state) {
  (void)state;
  warns("axiom: A(1)\nA(x) --> A(x/0)\n", "2:14: warning: division by 0");
  warns("#define z 0\naxiom: A(1)\nA(x) --> A(x%z)\n", "division by 0");
  warns("axiom: A(1)\nA(x) : 2 > 1 --> A(x)\n", "this condition always holds [-Wconstant-guard]");
  warns("angle: 0.7854\naxiom: F\n", "angles are in degrees; 0.7854 radians are 45");
  warns("step: 5\nsteps: 1\naxiom: F\n", "`step:` is the length of F");
  warns("axiom: F(1)\nF --> FF\n", "`F` without arguments never stands in a word, only `F` with 1 argument");
  warns("#define a 1\naxiom: F\n", "`a` is never used [-Wunused-define]");
  warns("axiom: F(1)\nF(x) --> F(1)\n", "parameter `x` is never used [-Wunused-parameter]");
  refuses("steps: 2.5\naxiom: F\n", "the number of steps is a whole number");
}

// ---- sizes ---------------------------------------------------------------------------------------

static void a_long_axiom_is_quick(void **state) {
  (void)state;
  enum { MODULES = 1000000 };
  char *text = malloc(8 + MODULES + 2), *at = text + sprintf(text, "axiom: ");
  for (int i = 0; i < MODULES; i++) *at++ = (char)('A' + i % 26);
  *at++ = '\n';
  clock_t begin = clock();
  Result result = check_bytes(text, (size_t)(at - text), false);
  double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
  assert_non_null(result.program);
  assert_int_equal(result.program->axioms[0].count, MODULES);
  assert_true(seconds < 5);
  release(&result);
  free(text);
}

static void long_chains_do_not_recurse(void **state) {
  (void)state;
  enum { LINKS = 20000 };
  char *text = NULL;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  for (int i = 0; i < LINKS; i++) fprintf(out, "#define a%d a%d+a%d\n", i, i + 1, i + 1);
  fprintf(out, "#define a%d 0\naxiom: A(a0)\n", LINKS);
  fclose(out);
  Result result = check_bytes(text, size, false);
  assert_non_null(result.program);
  assert_true(result.program->values[0].known);
  release(&result);
  free(text);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(kinds_are_numbered_in_file_order),
    cmocka_unit_test(declared_arguments),
    cmocka_unit_test(parameters_are_slots_in_order),
    cmocka_unit_test(unknown_names),
    cmocka_unit_test(definitions_are_seen_by_position),
    cmocka_unit_test(values_are_ordered),
    cmocka_unit_test(params_have_ranges),
    cmocka_unit_test(hidden_definitions_get_a_note),
    cmocka_unit_test(numbers_of_arguments),
    cmocka_unit_test(calls_are_numbered_in_file_order),
    cmocka_unit_test(numbers_are_folded),
    cmocka_unit_test(brackets_balance),
    cmocka_unit_test(contexts),
    cmocka_unit_test(ignored_symbols),
    cmocka_unit_test(sections),
    cmocka_unit_test(tables),
    cmocka_unit_test(subsystems),
    cmocka_unit_test(blocks),
    cmocka_unit_test(weights),
    cmocka_unit_test(unreachable_productions),
    cmocka_unit_test(doubtful_values),
    cmocka_unit_test(a_long_axiom_is_quick),
    cmocka_unit_test(long_chains_do_not_recurse),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
