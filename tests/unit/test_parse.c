// test_parse.c -- from the text of a grammar to its Ast, which is compared by
// its dump, and to the messages about it.
#include "parsing.h"

#include <sys/stat.h>
#include <unistd.h>

static Parsed parse(const char *text) {
  return parse_bytes(parse_file, "t.lsys", text, strlen(text), &(ParseOptions){0});
}

static void reads(const char *text, const char *dump) {
  parse_reads(parse_file, "t.lsys", text, &(ParseOptions){0}, dump);
}

// There is exactly one error, and its message holds part.
static void refuses(const char *text, const char *part) {
  parse_says(parse_file, "t.lsys", text, &(ParseOptions){0}, 1, part);
}

// ---- words -------------------------------------------------------------------

static void test_symbols(void **state) {
  (void)state;
  reads("axiom: F_lF_l a_r1 x_12b a_ _b", "axiom word F_l F_l a_r 1 x_12 b a _ _ b\n");
  reads("axiom: A()B(1)C (2, x)", "axiom word (A) (B 1) (C 2 x)\n");
  reads("axiom: @v@vF?E(1)?P ?", "axiom word @v @v F (?E 1) ?P ?\n");
  reads("axiom: αβ_γ⚣ 0{.}#\"'~;%$&^\\/|!\n", "axiom word α β_γ ⚣ 0 { . } # \" ' ~ ; % $ & ^ \\ / | !\n");
}

static void test_typographic_variants(void **state) {
  (void)state;
  reads("ω : F − F – ∗ × ∼ ′ ’ ‘ · ", "axiom word F - F - * * ~ ' ' ' ·\n");
  reads("p : A(x) : x ≤ 3 ∧ ¬ (x ≠ 2 ∨ x ≥ 1) → A(x · 2 × 3 ∗ 4 − 1)",
        "production label p strict (A x) guard (&& (<= x 3) (! (|| (!= x 2) (>= x 1))))"
        " successor (A (- (* (* (* x 2) 3) 4) 1))\n");
  reads("A ⟶ B\nA −−> B\nA –> B", "production strict A successor B\nproduction strict A successor B\n"
                                  "production strict A successor B\n");
  reads("axiom: F\xC2\xA0G\xE2\x80\x89H", "axiom word F G H\n");
}

static void test_declared_names(void **state) {
  (void)state;
  reads("axiom: plantplantflowerplants\n#modules plant, plantflower", "axiom word plant plantflower plant s\n"
                                                                      "modules plant plantflower\n");
  reads("module Apex(age, vigor)\nw: ApexApex(1,2)A",
        "modules Apex parameters age vigor\naxiom word Apex (Apex 1 2) A\n");
  reads("module F_long\nw: F_longF_l", "modules F_long\naxiom word F_long F_l\n");
  reads("surface leaf: disc(1)\nw: ~leaf", "surface leaf value (disc 1)\naxiom word ~ leaf\n");
}

static void test_empty_words(void **state) {
  (void)state;
  reads("A -> ε\nA -> *\nA -> F * F", "production strict A successor\nproduction strict A successor\n"
                                      "production strict A successor F * F\n");
  reads("* < A > * -> B", "production strict A successor B\n");
  reads("w: ε", "axiom word\n");
  refuses("A ->", "unexpected end of the statement; expected a module");
}

static void test_start_words(void **state) {
  (void)state;
  reads("axiom: L,R\naxiom: F ,(2) G , ,() F", "axiom word L word R\naxiom word F (, 2) G word (,) F\n");
  reads("A -> B,C", "production strict A successor B , C\n");
}

// ---- productions -------------------------------------------------------------

static void test_arrows(void **state) {
  (void)state;
  reads("F--->X", "production strict F - successor X\n");
  reads("- --> +\n+->-", "production strict - successor +\nproduction strict + successor -\n");
  reads("B- < F > -G -> H", "production left B - strict F right - G successor H\n");
  refuses("A -> B -> C", "a production has one arrow");
  refuses("axiom: A -> B", "unexpected arrow behind `axiom:`");
  refuses("-> B", "unexpected `->`; expected a module");
}

static void test_labels(void **state) {
  (void)state;
  reads("p : A -> B\np1: A -> B\nh2_ : A -> B", "production label p strict A successor B\n"
                                                "production label p1 strict A successor B\n"
                                                "production label h2_ strict A successor B\n");
  reads("p : x > 1 -> B", "production label p strict x right 1 successor B\n");
  reads("#modules p p1\np : x > 1 -> B\np1 : x -> B", "modules p p1\nproduction strict p guard (> x 1) successor B\n"
                                                      "production strict p1 guard x successor B\n");
  reads("A : x -> B\np1(x) : x -> B", "production strict A guard x successor B\n"
                                      "production strict p (1 x) guard x successor B\n");
  reads("p1 : A(x) : x ? 1 : 0 -> B : x ? 2 : 3",
        "production label p1 strict (A x) guard (? x 1 0) successor B weight (? x 2 3)\n");
}

static void test_statement_blocks(void **state) {
  (void)state;
  reads("A(x) : { y = x; } y > 3 { z[1][2] = y = 2; } --> B : 0.5",
        "production strict (A x) before { (= target y value x) } guard (> y 3)"
        " after { (= target ([] 1 2)@z value (== y 2)) } successor B weight 0.5\n");
  reads("A : { x = 1; } --> B\nA : * {;} --> B", "production strict A before { (= target x value 1) } successor B\n"
                                                 "production strict A after { } successor B\n");
  reads("Start: {\n  if (a) if (b) x = 1; else x = 2; // } no end\n  while (1) { do x = 3; while (0); }\n}",
        "block Start actions { (if value a then { (if value b then { (= target x value 1) } else"
        " { (= target x value 2) }) }) (while value 1 then { (do value 0 then { (= target x value 3) }) }) }\n");
  reads("define: { array a[2] = { 1, 2 }, b[1][2]; array c[1] = { {3}, 4 }; }",
        "arrays a (sizes 2) (values 1 2) b (sizes 1 2) c (sizes 1) (values 3 4)\n");
  reads("p1 : {A} -> B", "production label p1 strict { A } successor B\n");
}

// ---- statements --------------------------------------------------------------

static void test_where_statements_end(void **state) {
  (void)state;
  reads("axiom: A(1,\n  2)B\nA(x,\n y) -> B(x\n,y)",
        "axiom word (A 1 2) B\nproduction strict (A x y) successor (B x y)\n");
  reads("A ->\n\n /* so */ B\nC -> D", "production strict A successor B\nproduction strict C successor D\n");
  reads("axiom: A \\  \n B\\\nC -> D", "axiom word A B \\\nproduction strict C successor D\n");
  reads("axiom: A /* over\n lines */ B\n//C -> D\nE -> F", "axiom word A B\nproduction strict E successor F\n");
  reads("axiom: {\nA -> {\nB -> C", "axiom word {\nproduction strict A successor {\nproduction strict B successor C\n");
  reads("\xEF\xBB\xBF"
        "axiom: A\r\nA -> B\r\n",
        "axiom word A\nproduction strict A successor B\n");
  reads("A -> F(\"(->:\")B(x)", "production strict A successor (F \"(->:\") (B x)\n");
}

static void test_unclosed(void **state) {
  (void)state;
  Parsed parsed = parse("axiom: A(1\nA -> B\nC(x -> D\nStart: { x = 1;\nangle: 3\nE -> F((1)\nsteps: 2");
  assert_int_equal(parsed.errors, 4);
  assert_string_equal(parsed.dump, "production strict A successor B\nsetting angle value 3\nsetting steps value 2\n");
  assert_non_null(strstr(parsed.messages, "t.lsys:1:9: error: `(` is never closed"));
  assert_non_null(strstr(parsed.messages, "t.lsys:2:1: note: the statement ends before this line"));
  assert_non_null(strstr(parsed.messages, "t.lsys:3:2: error: `(` is never closed"));
  assert_non_null(strstr(parsed.messages, "t.lsys:4:8: error: `{` is never closed"));
  assert_non_null(strstr(parsed.messages, "t.lsys:6:7: error: `(` is never closed"));
  parsed_free(&parsed);
  refuses("A -> B\n/* no end", "t.lsys:2:1: error: this comment is never closed");
}

static void test_settings(void **state) {
  (void)state;
  reads("derivation length: 5\nsteps: 6\nangle:7 /* a */\ndelta : 8\ntropism_x: 1\ntropism  x: 2\nturns: clockwise\n"
        "maximum depth: 3\nseed: 4",
        "setting steps value 5\nsetting steps value 6\nsetting angle value 7\nsetting angle value 8\n"
        "setting tropism_x value 1\nsetting tropism_x value 2\nsetting turns value clockwise\n"
        "maximum-depth value 3\nseed value 4\n");
  reads("size: 400x300\nbackground: #0d1b2a\ncamera: 30 , -20\nprojection: perspective",
        "page size 400x300\npage background #0d1b2a\npage camera 30,-20\npage projection perspective\n");
  reads("#modules seed\nseed : x -> seed", "modules seed\nproduction strict seed guard x successor seed\n");
}

static void test_other_statements(void **state) {
  (void)state;
  reads("decomposition\nhomomorphism: warnings\ninterpretation: no warnings\nproductions\nring lsystem\n"
        "ring L-system\nlsystem: 1\nendlsystem\ntable A:\ntables: A B 2",
        "decomposition\nhomomorphism\nwarnings\nhomomorphism\nproductions\nring\nring\nlsystem 1\nendlsystem\ntable A\n"
        "tables A B 2\n");
  reads("ignore: +-F_l @v\n#ignore f ∼ H\nconsider:\n#consider: G",
        "ignore + - F_l @v\nignore f ~ H\nconsider\nconsider G\n");
  reads("surface a: box(1,2,3)\nsurface b: ../x/leaf.obj /* file */\nsurface c: \"a b.s\"\n"
        "environment: occupancy(cell=0.5)\nenvironment: point\nenvironment: ./mine.so",
        "surface a value (box 1 2 3)\nsurface b value \"../x/leaf.obj\"\nsurface c value \"a b.s\"\n"
        "environment value (occupancy (== cell 0.5))\nenvironment value point\nenvironment value \"./mine.so\"\n");
  reads("param R = 1.5 in 1..2\nparam S = R*2\nparam T = .5 in -1e1..3.5",
        "param R value 1.5 low 1 high 2\n"
        "param S value (* R 2)\nparam T value 0.5 low (- 10) high 3.5\n");
  reads("#define A 1 /* one */\n#define B(x, y) x+y\n#define C (1)\n#define D\n#undef A",
        "define A value 1\ndefine B parameters x y value (+ x y)\ndefine C value 1\ndefine D value 1\nundef A\n");
  reads("# -> +\n#d -> #", "production strict # successor +\nproduction strict # d successor #\n");
}

static void test_guesses(void **state) {
  (void)state;
  refuses("axiom F", "`axiom` needs a `:` behind it");
  refuses("axoim: F", "unknown statement `axoim:`; did you mean `axiom`?");
  refuses("blub: F", "unknown statement `blub:`");
  refuses("F => FF", "a production's arrow is written `->`, not `=>`");
  refuses("F FF", "this is neither a statement nor a production");
  refuses("p1: F FF", "this production has no arrow");
  refuses("#defin X 3", "unknown directive `#defin`; did you mean `#define`?");
  refuses("A -> @vv@Gx", "unknown symbol `@Gx`");
  refuses("table A: F -> FF", "it stands on a line of its own behind `table NAME:`");
  refuses("decomposition: warn", "unknown option `warn`; expected `warnings` or `no warnings`");
}

// ---- expressions -------------------------------------------------------------

static void test_precedence(void **state) {
  (void)state;
  static const struct {
    const char *spelling;
    int precedence;
    bool right;
  } operators[] = {
#define BINARY(id, spelling, precedence, right, doc) {spelling, precedence, right},
#include "lsys/operators.def"
  };
  enum { COUNT = sizeof operators / sizeof *operators };
  for (int i = 0; i < COUNT; i++)
    for (int j = 0; j < COUNT; j++) {
      char text[100], dump[100];
      const char *a = operators[i].spelling, *b = operators[j].spelling;
      snprintf(text, sizeof text, "angle: x %s y %s z", a, b);
      bool left = operators[i].precedence > operators[j].precedence
               || (operators[i].precedence == operators[j].precedence && !operators[i].right);
      if (left)
        snprintf(dump, sizeof dump, "setting angle value (%s (%s x y) z)\n", b, a);
      else
        snprintf(dump, sizeof dump, "setting angle value (%s x (%s y z))\n", a, b);
      reads(text, dump);
    }
}

static void test_expressions(void **state) {
  (void)state;
  reads("angle: -x^2^-3*4", "setting angle value (* (- (^ x (^ 2 (- 3)))) 4)\n");
  reads("angle: !x == 1 and not y or z & w", "setting angle value (|| (&& (== (! x) 1) (! y)) (&& z w))\n");
  reads("angle: a ? b : c ? d : e", "setting angle value (? a b (? c d e))\n");
  reads("angle: f() + g(1, h[2][3])", "setting angle value (+ (f) (g 1 ([] 2 3)@h))\n");
}

static void test_numbers(void **state) {
  (void)state;
  reads("w: A(.5, 5., 1e3, 1.5E-2, 007)", "axiom word (A 0.5 5 1000 0.015 7)\n");
  refuses("w: A(1e999)", "number out of range");
  refuses("w: A(1e-999)", "number out of range");
  reads("w: A(0e-999)", "axiom word (A 0)\n");
}

static void test_expression_errors(void **state) {
  (void)state;
  refuses("A -> B(x+)", "t.lsys:1:10: error: unexpected `)`; expected an expression\n");
  refuses("A -> B(1))", "no `(` is open that this could close");
  refuses("A(2x) -> B", "unexpected `x`; expected `)`, `,` or an operator");
  refuses("A : x ** 2 -> B", "a power is written `^`");
  refuses("A : x <> 2 -> B", "not equal is written `!=`");
  refuses("#define X 3 // three", "a comment behind something is written `/* ... */`");
  refuses("w: X(\"a)", "this string is never closed");
  refuses("A : \"a -> B", "this string is never closed");
  refuses("A : -> B", "expected an expression, `{` or `*`");
  refuses("w: F(x@)", "unexpected character `@`");
}

static void test_lexical_errors(void **state) {
  (void)state;
  Parsed parsed = parse("A -> B\xFF\xFE\x80"
                        "C\xE9(x\xC0)\nw: \x01");
  assert_int_equal(parsed.errors, 4);
  assert_non_null(strstr(parsed.messages, "t.lsys:1:7: error: byte 0xFF is not valid UTF-8"));
  assert_non_null(strstr(parsed.messages, "t.lsys:1:11: error: byte 0xE9 is not valid UTF-8"));
  assert_non_null(strstr(parsed.messages, "t.lsys:1:14: error: byte 0xC0 is not valid UTF-8"));
  assert_non_null(strstr(parsed.messages, "t.lsys:2:4: error: a control character is no symbol"));
  parsed_free(&parsed);
}

static void test_comment_warning(void **state) {
  (void)state;
  Parsed parsed = parse("A -> B // C\nA -> B//\nA -> // B\nA -> B///// C");
  assert_int_equal(parsed.errors, 0);
  assert_non_null(strstr(parsed.messages, "t.lsys:1:8: warning: `//` is two modules here, not a comment"));
  assert_non_null(strstr(parsed.messages, "t.lsys:3:6: warning"));
  assert_null(strstr(parsed.messages, "t.lsys:2:"));
  assert_null(strstr(parsed.messages, "t.lsys:4:"));
  parsed_free(&parsed);
}

static void test_spans(void **state) {
  (void)state;
  Parsed parsed = parse("p1 : A(x) < B > C : x>1 -> D(x) [E] : 2*x  ");
  const AstProduction *p = parsed.ast->statements.at[0].production;
  const Span *spans[] = {&p->label_span,     &p->left.span,    &p->strict.span,
                         &p->right.span,     &p->guard->span,  &p->arrow_span,
                         &p->successor.span, &p->weight->span, &parsed.ast->statements.at[0].span};
  static const char *const texts[] = {"p1", "A(x)", "B", "C", "x>1", "->", "D(x) [E]", "2*x", NULL};
  for (int i = 0; texts[i]; i++) {
    assert_int_equal(spans[i]->end - spans[i]->begin, strlen(texts[i]));
    assert_memory_equal(parsed.ast->file->text + spans[i]->begin - parsed.ast->file->base, texts[i], strlen(texts[i]));
  }
  assert_int_equal(spans[8]->end - spans[8]->begin, 41);
  parsed_free(&parsed);
}

// ---- files -------------------------------------------------------------------

static void test_conditions(void **state) {
  (void)state;
  reads("#define X 3\n#if X > 2 & defined(X)\nA -> B\n#elif 1\nA -> C\n#else\nA -> D\n#endif",
        "define X value 3\nproduction strict A successor B\n");
  reads("#ifdef Y\n#if nonsense (\n#else\n#endif\nA -> B\n#else\nA -> C\n#endif", "production strict A successor C\n");
  reads("#define X 1\n#undef X\n#ifndef X\nA -> B\n#endif",
        "define X value 1\nundef X\nproduction strict A successor B\n");
  refuses("#if X\n#endif", "`X` is not defined here");
  refuses("#define X Y\n#define Y X\n#if X\n#endif", "is defined by itself");
  refuses("#if 1", "this `#if` has no `#endif`");
  refuses("#endif", "`#endif` without an `#if` before it");
  refuses("#if 0\n#else\n#else\n#endif", "behind the `#else` of the same `#if`");
}

static void write_file(const char *folder, const char *name, const char *text) {
  char path[200];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE *out = fopen(path, "w");
  assert_non_null(out);
  fputs(text, out);
  fclose(out);
}

static void test_includes(void **state) {
  (void)state;
  char folder[] = "/tmp/lsysc-parse-XXXXXX", path[200];
  assert_non_null(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/sub", folder);
  assert_int_equal(mkdir(path, 0700), 0);
  write_file(folder, "a", "A -> B\n#include \"sub/b\"\n");
  write_file(folder, "sub/b", "#include c\nB -> @\n#if 1\n");
  write_file(folder, "sub/c", "C -> D\n#include <../a>\n#include dir-file\n");
  write_file(folder, "dir-file", "E -> F\n");
  snprintf(path, sizeof path, "%s/main.lsys", folder);
  static const char text[] = "#include a /* so */\n#include nowhere\nw: A";
  write_file(folder, "main.lsys", text);
  const char *dirs[] = {folder};
  Parsed parsed =
    parse_bytes(parse_file, path, text, strlen(text), &(ParseOptions){.include_dirs = dirs, .include_count = 1});
  assert_string_equal(parsed.dump, "production strict A successor B\nproduction strict C successor D\n"
                                   "production strict E successor F\naxiom word A\n");
  assert_int_equal(parsed.errors, 4);
  assert_non_null(strstr(parsed.messages, "`../a` is being read already"));
  assert_non_null(strstr(parsed.messages, "in the file included at "));
  assert_non_null(strstr(parsed.messages, "cannot find the file `nowhere`"));
  assert_non_null(strstr(parsed.messages, "this `#if` has no `#endif`"));
  assert_non_null(strstr(parsed.messages, "sub/b:2:6: error: unknown symbol `@`"));
  parsed_free(&parsed);
  snprintf(path, sizeof path, "rm -r %s", folder);
  assert_int_equal(system(path), 0);
}

static void test_dialects(void **state) {
  (void)state;
  Parsed parsed = parse_bytes(parse_file, "t.lsys", "A -> B", 6, &(ParseOptions){.dialect = "nonsense"});
  assert_int_equal(parsed.errors, 1);
  assert_non_null(strstr(parsed.messages, "unknown dialect `nonsense`"));
  parsed_free(&parsed);
  parsed = parse("A -> B");
  assert_string_equal(parsed.ast->rules.dialect, "native");
  parsed_free(&parsed);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_symbols),
    cmocka_unit_test(test_typographic_variants),
    cmocka_unit_test(test_declared_names),
    cmocka_unit_test(test_empty_words),
    cmocka_unit_test(test_start_words),
    cmocka_unit_test(test_arrows),
    cmocka_unit_test(test_labels),
    cmocka_unit_test(test_statement_blocks),
    cmocka_unit_test(test_where_statements_end),
    cmocka_unit_test(test_unclosed),
    cmocka_unit_test(test_settings),
    cmocka_unit_test(test_other_statements),
    cmocka_unit_test(test_guesses),
    cmocka_unit_test(test_precedence),
    cmocka_unit_test(test_expressions),
    cmocka_unit_test(test_numbers),
    cmocka_unit_test(test_expression_errors),
    cmocka_unit_test(test_lexical_errors),
    cmocka_unit_test(test_comment_warning),
    cmocka_unit_test(test_spans),
    cmocka_unit_test(test_conditions),
    cmocka_unit_test(test_includes),
    cmocka_unit_test(test_dialects),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
