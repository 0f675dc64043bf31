// test_cpfg.c -- what cpfg's files write differently: macros, lines, keywords, operators.
#include "parsing.h"

static Parsed parse(const char *text) {
  return parse_bytes(parse_file, "t.l", text, strlen(text), &(ParseOptions){.dialect = "cpfg"});
}

static void reads(const char *text, const char *dump) {
  parse_reads(parse_file, "t.l", text, &(ParseOptions){.dialect = "cpfg"}, dump);
}

// There is exactly one error, and its message holds part.
static void refuses(const char *text, const char *part) {
  parse_says(parse_file, "t.l", text, &(ParseOptions){.dialect = "cpfg"}, 1, part);
}

static void test_lines(void **state) {
  (void)state;
  reads("A --> B\n\tC\n\tD\nE --> F", "production strict A successor B C D\nproduction strict E successor F\n");
  reads("A(x) :\n\t{ y = 1;\nif (y) { y = 2; }\n\t} x > 1 {y = 3;}\n\t--> B",
        "production strict (A x) before { (= target y value 1) (if value y then { (= target y value 2) }) }"
        " guard (> x 1) after { (= target y value 3) } successor B\n");
  reads("\t/* a comment */\nA --> B", "production strict A successor B\n");
}

static void test_keywords(void **state) {
  (void)state;
  reads("Lsystem: 1\nDerivation Length: 3\nAxiom: F\nSTART EACH: {n=1;}\nMaximum depth: 2\nRing Lsystem\nEndLsystem",
        "lsystem 1\nsetting steps value 3\naxiom word F\nblock StartEach actions { (= target n value 1) }\n"
        "maximum-depth value 2\nring\nendlsystem\n");
  reads("p1 : x --> w\nw : x --> p",
        "production strict p 1 guard x successor w\nproduction strict w guard x successor p\n");
}

static void test_symbols(void **state) {
  (void)state;
  reads("Axiom: F_l,(2),@#(1)?E(1)", "axiom word F _ l (, 2) , (@# 1) (?E 1)\n");
  reads("C-> D --> *", "production strict C - right D successor\n");
  reads("A > [B=]] --> C", "production strict A right [ B = ] ] successor C\n");
  reads("Consider: ?PHF[]!\nIgnore: +-[]", "consider ?P H ?H F ?F !\nignore + -\n");
}

static void test_expressions(void **state) {
  (void)state;
  reads("A(x) : x <> 2 --> B(2^3^2,-x^2,-2*x)",
        "production strict (A x) guard (!= x 2) successor (B (^ (^ 2 3) 2) (^ (- x) 2) (* (- 2) x))\n");
  reads("Start: {x - 1; fscanf(f,\"%lf\",&x,&a[1]);}",
        "block Start actions { (eval value (- x 1)) (eval value (fscanf f \"%lf\" x ([] 1)@a)) }\n");
}

static void test_rules(void **state) {
  (void)state;
  Parsed parsed = parse("Axiom: A");
  assert_string_equal(parsed.ast->rules.dialect, "cpfg");
  assert_true(parsed.ast->rules.literal_context_brackets && parsed.ast->rules.unweighted_counts_one
              && parsed.ast->rules.last_ignore_counts);
  parsed_free(&parsed);
}

static void test_macros(void **state) {
  (void)state;
  reads("#define N 1 + 2 /* so */\nA --> B(N*2)", "production strict A successor (B (+ 1 (* 2 2)))\n");
  reads("#define TURN +(9)F\nAxiom: TURN[TURN]TURNF", "axiom word (+ 9) F [ (+ 9) F ] T U R N F\n");
  reads("#define MAX(a,b) ((a)>(b)?(a):(b))\nA --> B(MAX(1,MAX(2,3)),MAX (4, f(5,6)))",
        "production strict A successor (B (? (> 1 (? (> 2 3) 2 3)) 1 (? (> 2 3) 2 3)) (? (> 4 (f 5 6)) 4 (f 5 6)))\n");
  reads("#define A B\n#define B A\nAxiom: A", "axiom word A\n");
  reads("#define S 3\nA --> B(\"S\", S) /* S */", "production strict A successor (B \"S\" 3)\n");
  reads("#define EMPTY\n#define P() F\nEMPTY\nAxiom: P()EMPTY[P]", "axiom word F [ P ]\n");
}

static void test_macro_scope(void **state) {
  (void)state;
  reads("Axiom: X\n#define X F\nA --> X\n#undef X\nB --> X",
        "axiom word X\nproduction strict A successor F\nproduction strict B successor X\n");
  reads("#define D 1\n#define E D+1\n#if E*2 == 3 && defined(D) && !defined(F)\nA --> B\n#else\nA --> "
        "C\n#endif\n#ifdef D\nD"
        " --> E\n#endif",
        "production strict A successor B\nproduction strict 1 successor 1 + 1\n");
}

static void test_macro_messages(void **state) {
  (void)state;
  Parsed parsed = parse("#define STEP x+\n\nA(x) --> F(1)\n\tG(STEP)\n#define F2(a) a");
  assert_int_equal(parsed.errors, 1);
  assert_string_equal(parsed.messages, "t.l:4:8: error: unexpected `)`; expected an expression\n"
                                       "    4 | \tG(STEP)\n"
                                       "      | \t      ^\n");
  parsed_free(&parsed);
  parsed = parse("#define STEP x+*\nA(x) --> G(STEP)");
  assert_string_equal(parsed.messages, "t.l:2:12: error: unexpected `*`; expected an expression\n"
                                       "    2 | A(x) --> G(STEP)\n"
                                       "      |            ^~~~\n"
                                       "t.l:1:9: note: from this macro\n"
                                       "    1 | #define STEP x+*\n"
                                       "      |         ^~~~\n");
  parsed_free(&parsed);
  refuses("#define M(a,b) a\nAxiom: A(M(1,2,3))", "macro `M` needs 2 arguments, not 3");
  refuses("#define 3 4", "`#define` needs a name");
  refuses("#define M(a,3) a", "the parameters of a macro are names");
}

static void test_macro_growth(void **state) {
  (void)state;
  char text[2000] = "#define A0 F\n";
  for (int i = 1; i < 40; i++) {
    char line[40];
    snprintf(line, sizeof line, "#define A%d A%d A%d\n", i, i - 1, i - 1);
    strcat(text, line);
  }
  strcat(text, "Axiom: A39");
  refuses(text, "the macros here become longer than");
  char *nested = malloc(1 << 16);
  strcpy(nested, "#define M(x) (x)\nAxiom: A(");
  for (int i = 0; i < 2000; i++) strcat(nested, "M(");
  for (int i = 0; i < 2000; i++) strcat(nested, ")");
  strcat(nested, ")");
  refuses(nested, "macros are nested too deep");
  free(nested);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_lines),       cmocka_unit_test(test_keywords),       cmocka_unit_test(test_symbols),
    cmocka_unit_test(test_expressions), cmocka_unit_test(test_rules),          cmocka_unit_test(test_macros),
    cmocka_unit_test(test_macro_scope), cmocka_unit_test(test_macro_messages), cmocka_unit_test(test_macro_growth),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
