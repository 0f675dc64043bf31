// test_mws.c -- the course notation of sections between `#` lines.
#include "parsing.h"

#include "frontend/mws.h"

static void reads_as(const char *text, const char *expected) {
  Parsed parsed = parse_bytes(mws_parse, "test.txt", text, strlen(text), &(ParseOptions){0});
  assert_string_equal(parsed.messages, "");
  char *dumped;
  size_t size;
  FILE *out = open_memstream(&dumped, &size);
  ast_dump(parsed.ast, out);
  fclose(out);
  assert_string_equal(dumped, expected);
  free(dumped);
  parsed_free(&parsed);
}

static void says(const char *text, size_t errors, const char *message) {
  parse_says(mws_parse, "test.txt", text, &(ParseOptions){0}, errors, message);
}

#define TURNS "setting turns value clockwise\n"

static void sections_and_rules(void **state) {
  (void)state;
  reads_as("#axiom\nB(1)A\n\n# a comment\n#rules\nA->AC\n  B(a) : a<2 -> B(a+0.1)\r\nC -> *\n#end rules\n",
           TURNS "axiom word (B 1) A\nproduction strict A successor A C\n"
                 "production strict (B a) guard (< a 2) successor (B (+ a 0.1))\nproduction strict C successor\n");
}

static void both_orders_of_end(void **state) {
  (void)state;
  reads_as("#AXIOM\nA\n#rules\n#rules  end", TURNS "axiom word A\n");
}

static void alternatives_share_a_head(void **state) {
  (void)state;
  reads_as(
    "#axiom\nB\n#rules\nB(x) : x>1 -> #stochastic\np=3 B(x)A\np = 1/2 [+A]\np=1 *\n#end stochastic\nA->B\n#end rules",
    TURNS "axiom word B\nproduction strict (B x) guard (> x 1) successor (B x) A weight 3\n"
          "production strict (B x) guard (> x 1) successor [ + A ] weight (/ 1 2)\n"
          "production strict (B x) guard (> x 1) successor weight 1\nproduction strict A successor B\n");
}

static void errors_point_at_their_line(void **state) {
  (void)state;
  says("", 1, "test.txt:1:1: error: no axiom: wanted `#axiom`");
  says("A->B\n#axiom\nA\n", 1, "test.txt:1:1: error: a line outside of `#axiom` and `#rules`");
  says("#axiom\nA\nB\n", 1, "test.txt:3:1: error: a second axiom; wanted `#rules`");
  says("#axiom\nA\n#rules\nA B\n#end rules", 1, "test.txt:4:1: error: wanted a rule such as `A -> AB`");
  says("#axiom\nA\n#rules\nA(x -> B\n#end rules", 1, "test.txt:4:2: error:");
  says("#axiom\nA\n#rules\nA -> #stochastic\n#end rules", 1, "test.txt:4:1: error: `#stochastic` is not closed");
  says("#axiom\nA\n#rules\nA -> #stochastic\n#stochastic end\n#end rules", 1, "test.txt:4:1: error: no alternatives");
  says("#axiom\nA\n#rules\nA -> #stochastic\n3 B\n#stochastic end\n#end rules", 1, "test.txt:5:1: error: wanted `p=`");
  says("#axiom\nA\n#rules\nA -> #stochastic\np=1\n#stochastic end\n#end rules", 1, "wanted a successor");
  says("#axiom\nA\n#rules\nA -> #stochastic\np=( B\n#stochastic end\n#end rules", 1, "test.txt:5:");
  says("#axiom\nA\n#rules\n#stochastic\n#end rules", 1, "wanted a predecessor before `#stochastic`");
  says("#axiom\nA\n#stochastic end\n", 1, "an end of alternatives without `#stochastic`");
  says("#axiom\nA\n#end rules\n", 1, "an end of rules without `#rules`");
}

static void oddities_get_warnings(void **state) {
  (void)state;
  says("#axiom\nA\n#rulse\n", 0, "test.txt:3:1: warning: this is a comment; did you mean `#rules`?");
  says("#axiom\nA\n#rules\nA->B\n", 0, "test.txt:3:1: warning: `#rules` is not closed by `#end rules`");
}

static void files_are_recognised(void **state) {
  (void)state;
  const char *const texts[] = {"# c\n#axiom\nA\n", "#define X 1\naxiom: A\n", ""};
  for (int i = 0; i < 3; i++) {
    Arena *arena = arena_create();
    const SourceFile *file = sources_add(sources_create(arena), "test", texts[i], strlen(texts[i]), (Span){0});
    assert_int_equal(mws_recognise(file), i == 0);
    arena_destroy(arena);
  }
}

static void every_prefix_and_every_byte_is_survived(void **state) {
  (void)state;
  parse_survives(mws_parse,
                 "#axiom\nB(1)\n#rules\nB(a):a<2->[B]\nA->#stochastic\np=3 A\n#stochastic end\n#rules end\n");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(sections_and_rules),
    cmocka_unit_test(both_orders_of_end),
    cmocka_unit_test(alternatives_share_a_head),
    cmocka_unit_test(errors_point_at_their_line),
    cmocka_unit_test(oddities_get_warnings),
    cmocka_unit_test(files_are_recognised),
    cmocka_unit_test(every_prefix_and_every_byte_is_survived),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
