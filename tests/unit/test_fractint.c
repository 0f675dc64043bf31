// test_fractint.c -- entries, statements and commands of Fractint's files.
#include "parsing.h"

#include "frontend/fractint.h"
#include "lsys/settings.h"

static Parsed parse(const char *text, const char *system) {
  return parse_bytes(fractint_parse, "test.l", text, strlen(text), &(ParseOptions){.system = system});
}

static void print_expr(FILE *out, const AstExpr *expr) {
  switch (expr->kind) {
  case AST_NUMBER:
    fprintf(out, "%g", expr->number);
    break;
  case AST_UNARY:
    fputc('-', out);
    print_expr(out, expr->a);
    break;
  case AST_BINARY:
    print_expr(out, expr->a);
    fputc(expr->op == OP_DIV ? '/' : '*', out);
    print_expr(out, expr->b);
    break;
  default:
    fprintf(out, "%s(", expr->name);
    print_expr(out, expr->args.at[0]);
    fputc(')', out);
  }
}

static void print_word(FILE *out, const AstWord *word) {
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    fputs(module->symbol, out);
    if (!module->args.count) continue;
    fputc('(', out);
    print_expr(out, module->args.at[0]);
    fputc(')', out);
  }
}

// Axiom and productions, separated by blanks.
static char *show(const Ast *ast) {
  char *text;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  for (size_t i = 0; i < ast->statements.count; i++) {
    const AstStatement *statement = &ast->statements.at[i];
    if (statement->kind == AST_AXIOM) print_word(out, &statement->words.at[0]);
    if (statement->kind != AST_PRODUCTION) continue;
    fputc(' ', out);
    print_word(out, &statement->production->strict);
    fputs("->", out);
    print_word(out, &statement->production->successor);
  }
  fclose(out);
  return text;
}

static void reads_as(const char *text, const char *expected) {
  Parsed result = parse(text, NULL);
  assert_string_equal(result.messages, "");
  char *shown = show(result.ast);
  assert_string_equal(shown, expected);
  free(shown);
  parsed_free(&result);
}

static void says(const char *text, const char *system, size_t errors, const char *message) {
  parse_says(fractint_parse, "test.l", text, &(ParseOptions){.system = system}, errors, message);
}

// ---- statements ------------------------------------------------------------

static void letters_have_no_case(void **state) {
  (void)state;
  reads_as("Koch { ANGLE 6\nAxiom F--f--F\n F=f+f--F+f\n}", "F--F--F F->F+F--F+F");
}

static void rules_of_one_letter_add_up(void **state) {
  (void)state;
  reads_as("K {\nangle 4\naxiom x\nx=f+\nf=\nX=f@1\nx=5y\n}", "X X->F+F@s(15)Y F->");
}

static void blanks_and_equals_separate(void **state) {
  (void)state;
  reads_as("K{\r\n  angle = 4 ; comment\r\n\taxiom=xy\r\n x = f ;=\r\n\r\n y\r\n}\r\n\x1a junk {", "XY X->F Y->");
}

static void any_printable_character_may_have_a_rule(void **state) {
  (void)state;
  reads_as("K { angle 4\naxiom f\"1,_\n\"=,\n1=2\n}", "FN_341N_44N_95 N_34->N_44 1->2");
}

static void settings_are_those_of_fractint(void **state) {
  (void)state;
  Parsed result = parse("K { angle 5\naxiom f\n}", NULL);
  const AstStatement *at = result.ast->statements.at;
  assert_int_equal(at[0].setting, LSYS_SETTING_ANGLE);
  assert_true(at[0].value->a->number / at[0].value->b->number == 72);
  assert_int_equal(at[1].setting, LSYS_SETTING_HEADING);
  assert_true(at[1].value->number == 0);
  assert_int_equal(at[2].setting, LSYS_SETTING_COLOUR);
  assert_true(at[2].value->number == 15);
  assert_int_equal(at[3].setting, LSYS_SETTING_STEPS);
  assert_string_equal(result.ast->rules.dialect, "fractint");
  parsed_free(&result);
}

// ---- commands --------------------------------------------------------------

static void commands_become_symbols(void **state) {
  (void)state;
  reads_as("K { angle 4\naxiom fgdm+-|![x]c3<1>2\\30/45\n}", "Ff@d@m+-|@x[X];(3)@n(1)@p(2)@a(30)@a(-45)");
}

static void numbers_may_be_roots_and_inverses(void **state) {
  (void)state;
  reads_as("K { angle 4\naxiom @.6@i3@q2@iq3@qi5.\n}", "@s(0.6)@s(1/3)@s(sqrt(2))@s(1/sqrt(3))@s(1/sqrt(5))");
}

static void colours_are_whole_and_below_256(void **state) {
  (void)state;
  reads_as("K { angle 4\naxiom c257<1.7><f\n}", ";(1)@n(1)@p(0)@n(0)F");
}

static void around_with_odd_angle_is_no_half_circle(void **state) {
  (void)state;
  reads_as("K { angle 5\naxiom |f\n}", "|(360/5*3)F");
}

static void odd_numbers_get_a_warning(void **state) {
  (void)state;
  says("K { angle 4\naxiom @f\n}", NULL, 0, "test.l:2:7: warning: `@` without a number multiplies the step by 0");
  says("K { angle 4\naxiom @1.2.3f\n}", NULL, 0, "test.l:2:8: warning: a number with two points");
}

// ---- brackets --------------------------------------------------------------

static void a_lone_close_ends_the_rule(void **state) {
  (void)state;
  Parsed result = parse("K { angle 4\naxiom x\nx=f]f\n}", NULL);
  char *shown = show(result.ast);
  assert_string_equal(shown, "X X->F");
  assert_non_null(strstr(result.messages, "test.l:3:4: warning: `]` without `[` ends the rule here"));
  free(shown);
  parsed_free(&result);
}

static void a_lone_open_is_an_error(void **state) {
  (void)state;
  says("K { angle 4\naxiom x\nx=f[f\n}", NULL, 1, "test.l:3:4: error: `[` is never closed");
}

// ---- errors ----------------------------------------------------------------

static void all_errors_are_shown(void **state) {
  (void)state;
  const char *text = "K { angle 2\naxoim f\n+=f\nx=f f\n}";
  says(text, NULL, 5, "test.l:1:11: error: `angle` wants a whole number from 3 to 50");
  says(text, NULL, 5, "test.l:2:1: error: unknown statement `axoim`");
  says(text, NULL, 5, "did you mean `axiom`?");
  says(text, NULL, 5, "test.l:3:1: error: `+` is a command and cannot have a rule");
  says(text, NULL, 5, "test.l:4:5: error: unexpected `f`");
  says(text, NULL, 5, "test.l:1:1: error: `K` has no `axiom`");
}

static void missing_parts_are_named(void **state) {
  (void)state;
  says("K { axiom\nangle\n}", NULL, 2, "`axiom` wants a string");
  says("K { axiom f\n}", NULL, 1, "`K` has no `angle`");
  says("", NULL, 1, "no L-system here");
  says("K { axiom f\nangle 4\n", NULL, 1, "test.l:1:3: error: `{` of `K` is not closed");
  says("K { angle 51\naxiom f\n}", NULL, 1, "3 to 50");
  says("K { angle 99999999999999999999\naxiom f\n}", NULL, 1, "3 to 50");
  says("K { angle 4\naxiom f\x01\n}", NULL, 1, "unprintable character (code 1)");
  says("K { angle 4\naxiom f\naxiom g\n}", NULL, 0, "test.l:3:1: warning: a second axiom");
}

// ---- several systems -------------------------------------------------------

static const char several[] = "Some words about the file\n"
                              "comment { not a system }\n"
                              "First (by me) { angle 4\naxiom f\n}\n"
                              "frm:Mandel { z = z*z }\n"
                              "Broken { angle 4\n"
                              "lsys:Second { ; with a comment }\n angle 4\naxiom g\n}\n"
                              "ANameLongerThanEighteenCharacters { angle 4\naxiom d }\n";

static void systems_are_chosen_by_name(void **state) {
  (void)state;
  const char *const names[][2] = {
    {"first", "F"}, {"SECOND", "f"}, {"anamelongerthaneig", "@d"}, {"ANameLongerThanEighteen", "@d"}};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    Parsed result = parse(several, names[i][0]);
    assert_string_equal(result.messages, "");
    char *shown = show(result.ast);
    assert_string_equal(shown, names[i][1]);
    free(shown);
    parsed_free(&result);
  }
}

static void the_first_is_the_default(void **state) {
  (void)state;
  says(several, NULL, 0, "test.l:3:1: note: `First` is the first of 3 systems; --system NAME picks another");
  says("A {\nB { angle 4\naxiom f }", NULL, 0, "`A` is skipped: its `{` is not closed");
}

static void unknown_systems_get_a_hint(void **state) {
  (void)state;
  says(several, "Frist", 1, "error: `test.l` has no system `Frist`");
  says(several, "Frist", 1, "did you mean `First`?");
  says(several, "Broken", 1, "`{` of `Broken` is not closed");
}

static void systems_are_listed(void **state) {
  (void)state;
  Arena *arena = arena_create();
  const SourceFile *file = sources_add(sources_create(arena), "test.l", several, strlen(several), (Span){0});
  char *text;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  fractint_list(file, out);
  fclose(out);
  assert_string_equal(text, "First\nSecond\nANameLongerThanEig\n");
  free(text);
  arena_destroy(arena);
}

static bool recognised(const char *text) {
  Arena *arena = arena_create();
  const SourceFile *file = sources_add(sources_create(arena), "test", text, strlen(text), (Span){0});
  bool result = fractint_recognise(file);
  arena_destroy(arena);
  return result;
}

static void files_are_recognised(void **state) {
  (void)state;
  assert_true(recognised(several));
  assert_true(recognised("; comment\nlsys:K { ; c\n Axiom f\nangle=4"));
  assert_false(recognised("axiom: F\nangle: 90\nF --> F{F}F\n"));
  assert_false(recognised("Start: {\n angle = 3;\n}\naxiom: A\n"));
  assert_false(recognised(""));
}

// ---- hostile files ---------------------------------------------------------

static void many_systems_and_long_rules(void **state) {
  (void)state;
  char *text;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  for (int i = 0; i < 20000; i++) fprintf(out, "S%d { angle 4\naxiom f\n}\n", i);
  fputs("Long { angle 4\naxiom x\nx=", out);
  for (int i = 0; i < 1000000; i++) fputc("f+[]"[i % 4], out);
  fputs("\n}\n", out);
  for (int i = 0; i < 200000; i++) fputs("a {\n", out);
  fclose(out);
  Parsed result = parse_bytes(fractint_parse, "test.l", text, size, &(ParseOptions){.system = "long"});
  assert_int_equal(result.errors, 0);
  const AstStatement *last = &result.ast->statements.at[result.ast->statements.count - 1];
  assert_int_equal(last->production->successor.modules.count, 1000000);
  parsed_free(&result);
  free(text);
}

static void every_prefix_and_every_byte_is_survived(void **state) {
  (void)state;
  parse_survives(fractint_parse, "K { angle 4\naxiom f[@iq2x]\nx=c1<2>3\\4/5\n}\n");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(letters_have_no_case),
    cmocka_unit_test(rules_of_one_letter_add_up),
    cmocka_unit_test(blanks_and_equals_separate),
    cmocka_unit_test(any_printable_character_may_have_a_rule),
    cmocka_unit_test(settings_are_those_of_fractint),
    cmocka_unit_test(commands_become_symbols),
    cmocka_unit_test(numbers_may_be_roots_and_inverses),
    cmocka_unit_test(colours_are_whole_and_below_256),
    cmocka_unit_test(around_with_odd_angle_is_no_half_circle),
    cmocka_unit_test(odd_numbers_get_a_warning),
    cmocka_unit_test(a_lone_close_ends_the_rule),
    cmocka_unit_test(a_lone_open_is_an_error),
    cmocka_unit_test(all_errors_are_shown),
    cmocka_unit_test(missing_parts_are_named),
    cmocka_unit_test(systems_are_chosen_by_name),
    cmocka_unit_test(the_first_is_the_default),
    cmocka_unit_test(unknown_systems_get_a_hint),
    cmocka_unit_test(systems_are_listed),
    cmocka_unit_test(files_are_recognised),
    cmocka_unit_test(many_systems_and_long_rules),
    cmocka_unit_test(every_prefix_and_every_byte_is_survived),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
