// test_fmt.c -- grammars printed in the native notation, and read back.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frontend/fmt.h"
#include "support/diag.h"

#include <stdlib.h>
#include <string.h>

typedef void Print(const Ast *ast, FILE *out);

static char *print_file(const char *name, const char *text, Print *how) {
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  const SourceFile *file = sources_add(sources, name, text, strlen(text), (Span){0});
  DiagOptions options;
  diag_options_default(&options);
  options.no_warnings = true;
  Diag *diag = diag_create(arena, sources, &options);
  const Ast *ast = parse_file(arena, sources, diag, file, &(ParseOptions){0});
  assert_int_equal(diag_errors(diag), 0);
  char *printed;
  size_t size;
  FILE *out = open_memstream(&printed, &size);
  how(ast, out);
  fclose(out);
  arena_destroy(arena);
  return printed;
}

static char *print(const char *text, Print *how) {
  return print_file("test", text, how);
}

// Printing gives `expected`, printing that changes nothing, and both are the same Ast.
static void prints(const char *text, const char *expected) {
  char *once = print(text, fmt_print), *twice = print(once, fmt_print);
  char *before = print(text, ast_dump), *after = print(once, ast_dump);
  assert_string_equal(once, expected);
  assert_string_equal(twice, expected);
  assert_string_equal(before, after);
  free(once);
  free(twice);
  free(before);
  free(after);
}

static void same(const char *text) {
  prints(text, text);
}

// ---- words -------------------------------------------------------------------

static void modules_stay_as_far_apart_as_they_were(void **state) {
  (void)state;
  prints("axiom:F [  +F]F\n", "axiom: F [ +F]F\n");
  same("axiom: F(1, 2)[+F]\n");
  prints("A → BC\n", "A --> BC\n");
  same("A --> *\n");
  same("axiom: ,()F,(3)\n");
  same("axiom: F, G, *\n");
}

static void blanks_stand_where_symbols_would_join(void **state) {
  (void)state;
  same("axiom: F_l F_lF x _ y\n");
  same("axiom: x_1 2 x_12 ? E ?E\n");
  same("#modules plant pl\naxiom: p l a n t plant pl ant\n");
  same("axiom: / *F/ /F\n");
  same("axiom: F \\ F\\\naxiom: F \\()\n");
}

// ---- expressions ---------------------------------------------------------------

static void parentheses_stand_where_they_must(void **state) {
  (void)state;
  prints("A(x) --> B((x+1)*2, (x*2)+1, x-(1-2), (x-1)-2)\n", "A(x) --> B((x+1)*2, x*2+1, x-(1-2), x-1-2)\n");
  prints("A(x) --> B(-x^2, (-x)^2, (2^3)^x, 2^(3^x), -(-x), x-(-1))\n",
         "A(x) --> B(-x^2, (-x)^2, (2^3)^x, 2^3^x, -(-x), x-(-1))\n");
  prints("A(x) : (x>1)&(x<3)|!(x=2) --> B\n", "A(x) : x > 1 && x < 3 || !(x == 2) --> B\n");
  same("A(x) : (x ? 1 : 2) --> B(x ? 1 : x > 2 ? 3 : 4, (x ? 1 : 2)+1) : (x ? 1 : 2)\n");
  same("A(x) --> B(sin(x), atan(x, 2), min(1, x, 3))\n");
}

static void numbers_are_spelled_as_before(void **state) {
  (void)state;
  same("axiom: F(.1, 1.50, 1e3, 0.1, 100000000000000000000)\n");
}

// ---- statements ----------------------------------------------------------------

static void productions_have_all_their_parts(void **state) {
  (void)state;
  prints("p1:A(x)<B(y)>C[+D]:x>y->EF:0.5\n", "p1 : A(x) < B(y) > C[+D] : x > y --> EF : 0.5\n");
  same("A(0) --> B\n");
  same("A(x) : { y = x+1; if (y > 2) { y = 0; } else { y = 1; } } y < 3 { z = y; } --> B(z)\n");
  same("A : { stop(1); } * --> B\n");
}

static void other_statements(void **state) {
  (void)state;
  prints("derivation length: 5\nω: A\ndelta: 30\n#ignore +-\nconsider: A B\nseed: 3\n",
         "steps: 5\naxiom: A\nangle: 30\nignore: +-\nconsider: A B\nseed: 3\n");
  same("turns: clockwise\n#define K 3\n#define f(x, y) x*y\n#undef K\nparam P = 3 in -1..10\nparam Q = 2\n");
  same("module Apex(age, vigor)\n#modules a b\nring lsystem\nlsystem: one\naxiom: A\nendlsystem\n");
  same("decomposition\nmaximum depth: 3\nA --> B\nhomomorphism\nA --> F\nproductions\nA --> C\n");
  prints("decomposition: no warnings\nA --> B\nhomomorphism : /* x */ warnings\nA --> F\n",
         "decomposition\nA --> B\nhomomorphism: warnings  /* x */\nA --> F\n");
  same("table day:\nA --> B\ntable night:\nA --> C\ntables: day night\n");
  same("Start: {\n  x = 1;\n  while (x < 3) {\n    x = x+1;\n  }\n  do {\n    x = 2;\n  } while (x > 5);\n}\n");
  same("define: {\n  array a[2][3] = {1, 2, 3, 4, 5, 6};\n  array b[4];\n}\n");
  same("surface leaf: disc(2)\nsurface stem: \"stem.obj\"\nenvironment: occupancy(1)\n");
}

static void long_statements_become_one_line(void **state) {
  (void)state;
  prints("A(x,\n  y) -->\n  B(x,\n    y)\n", "A(x, y) --> B(x, y)\n");
}

// ---- what is between statements --------------------------------------------------

static void comments_stay(void **state) {
  (void)state;
  prints("/* one\n   two */\n\n\n  // three\naxiom: A  /* four */  \nA -> B /* five */ C\n /* six */ B -> C\n// end",
         "/* one\n   two */\n\n// three\naxiom: A  /* four */\nA --> B C  /* five */\n/* six */\nB --> C\n// end\n");
}

static void conditions_stay(void **state) {
  (void)state;
  same("#define X 1\n#if X\nA --> B\n#else\nA  -->  C\n#endif\n");
}

static void blocks_keep_comments_behind_them(void **state) {
  (void)state;
  prints("Start: { x = 1; /* why */ }\n", "Start: {\n  x = 1;\n}  /* why */\n");
}

static void an_empty_file_stays_empty(void **state) {
  (void)state;
  same("");
  prints("\n\n  \n", "");
  same("// only a comment\n");
}

// ---- other notations -------------------------------------------------------------

static void fractint_becomes_native(void **state) {
  (void)state;
  char *printed = print(
    "; file\nK { ; by me\n  angle 5\n  axiom f|@iq2x\n  x=[/30c3<1f]; twice\n  x=,\n}\nL { ; other\n}\n", fmt_print);
  assert_string_equal(printed, "// by me\n// twice\nangle: 360/5\nheading: 0\ncolour: 15\nsteps: 2\n"
                               "axiom: F|(360/5*3)@s(1/sqrt(2))X\nX --> [@a(-30);(3)@n(1)F]N_44\n");
  free(printed);
}

static void cpfg_becomes_native(void **state) {
  (void)state;
  char *printed = print_file("test.l",
                             "/* one */\n#define R 3\nLsystem: 1\nignore: +\nderivation length: R\nAxiom: A=F_l@;\n"
                             "consider: F\nA > [B]C] --> B : 2\nA > B]C --> *\nA --> F(2^3^2) /* two */\nB --> A\n"
                             "endlsystem\n",
                             fmt_print);
  assert_string_equal(printed, "// one\nlsystem: 1\nsteps: 3\naxiom: AN_61F _lN_64059\nconsider: F\n"
                               "A > [B@]]C@] --> B : 2\nA > B@] /* cpfg looks on behind the branch */ --> * : 1\n"
                               "A --> F((2^3)^2) : 1  /* two */\nB --> A\nendlsystem\n");
  free(printed);
}

static void mws_becomes_native(void **state) {
  (void)state;
  char *printed = print(
    "# one\n#axiom\nB\n\n#rules\n# two\nB -> #stochastic\np=3 FB\np=1 *\n#stochastic end\n#end rules\n", fmt_print);
  assert_string_equal(printed, "turns: clockwise\n// one\naxiom: B\n\n// two\nB --> FB : 3\nB --> * : 1\n");
  free(printed);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(modules_stay_as_far_apart_as_they_were),
    cmocka_unit_test(blanks_stand_where_symbols_would_join),
    cmocka_unit_test(parentheses_stand_where_they_must),
    cmocka_unit_test(numbers_are_spelled_as_before),
    cmocka_unit_test(productions_have_all_their_parts),
    cmocka_unit_test(other_statements),
    cmocka_unit_test(long_statements_become_one_line),
    cmocka_unit_test(comments_stay),
    cmocka_unit_test(conditions_stay),
    cmocka_unit_test(blocks_keep_comments_behind_them),
    cmocka_unit_test(an_empty_file_stays_empty),
    cmocka_unit_test(fractint_becomes_native),
    cmocka_unit_test(cpfg_becomes_native),
    cmocka_unit_test(mws_becomes_native),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
