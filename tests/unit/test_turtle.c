// test_turtle.c -- the turtle by geometry: end points, boxes and numbers of
// segments of words that are packed here by hand.
#include "lsys/abi.h"
#include "sample.h"
#include "turtle/measure.h"
#include "turtle/places.h"
#include "turtle/tree.h"
#include "turtle/turtle.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

// Draws the word in parts of at most `part` modules; only for words without arguments if part is finite.
static LsysVec3 draw(Sample *s, LsysMeasure *m, uint64_t part) {
  lsys_measure_begin(m, true);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  assert_non_null(t);
  lsys_turtle_begin(t, 0, &m->geometry);
  for (uint64_t i = 0; i < s->word.nsym; i += part) {
    uint64_t n = s->word.nsym - i < part ? s->word.nsym - i : part;
    LsysWord piece = {.sym = s->sym + i, .arg = s->arg, .nsym = n, .narg = s->word.narg};
    assert_true(lsys_turtle_take(t, &piece));
  }
  assert_true(lsys_turtle_end(t));
  LsysVec3 end = lsys_turtle_position(t);
  lsys_turtle_destroy(t);
  return end;
}

static LsysVec3 draw_text(const char *text, double angle, LsysMeasure *m) {
  Sample *s = sample(text, angle);
  LsysVec3 end = draw(s, m, UINT64_MAX);
  sample_release(s);
  return end;
}

static void assert_at(LsysVec3 p, double x, double y, double z) {
  if (fabs(p.x - x) > 1e-12 || fabs(p.y - y) > 1e-12 || fabs(p.z - z) > 1e-12)
    fail_msg("(%.17g, %.17g, %.17g) is not (%g, %g, %g)", p.x, p.y, p.z, x, y, z);
}

static void starts_up_the_page(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("F", 90, &m), 0, 1, 0);
  assert_at(draw_text("F(3)", 90, &m), 0, 3, 0);
  assert_at(draw_text("+F", 90, &m), -1, 0, 0);
  assert_at(draw_text("-F", 90, &m), 1, 0, 0);
  assert_at(draw_text("|F", 90, &m), 0, -1, 0);
  assert_at(draw_text("+F", 60, &m), -sqrt(3) / 2, 0.5, 0);
  assert_at(draw_text("+(30)F(2)", 90, &m), -1, sqrt(3), 0);
}

// The signs of rotations in space, each seen alone: & takes H away from U, / takes L away from U.
static void turns_in_space(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("&F", 90, &m), 0, 0, -1);
  assert_at(draw_text("^F", 90, &m), 0, 0, 1);
  assert_at(draw_text("/+F", 90, &m), 0, 0, -1);
  assert_at(draw_text("\\+F", 90, &m), 0, 0, 1);
  assert_at(draw_text("&|F", 90, &m), 0, 0, 1);
  assert_at(draw_text("&(30)F(2)", 90, &m), 0, sqrt(3), -1);
}

static void takes_settings(void **state) {
  (void)state;
  LsysMeasure m;
  Sample *s = sample("F+F", 90);
  s->value[LSYS_SETTING_STEP] = 0.1;
  s->value[LSYS_SETTING_TURNS] = 1;
  s->value[LSYS_SETTING_HEADING] = 0;
  assert_at(draw(s, &m, UINT64_MAX), 0.1, -0.1, 0);
  sample_release(s);
}

static void brackets_return(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("F[+F]F", 60, &m), 0, 2, 0);
  assert_int_equal(m.segments, 3);
  assert_at(draw_text("F[;!(3)&F]F", 60, &m), 0, 2, 0);
  assert_int_equal(m.of_colour[0], 2);
  assert_int_equal(m.of_colour[1], 1);
  assert_true(m.thinnest == 1 && m.thickest == 3);
}

static void moves_without_drawing(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("FfF", 90, &m), 0, 3, 0);
  assert_int_equal(m.segments, 2);
  assert_at(draw_text("ff", 90, &m), 0, 2, 0);
  assert_false(lsys_measure_any(&m));
}

// A curve that closes does so exactly, and a part boundary changes nothing.
static void check_curve(const char *axiom, const char *const *rules, double angle, int steps, uint64_t segments,
                        LsysVec3 size, double x, double y) {
  char *word = sample_rewrite(axiom, rules, steps);
  Sample *s = sample(word, angle);
  for (uint64_t part = 1; part < 10000; part = part * 7 + 4) {
    LsysMeasure m;
    LsysVec3 end = draw(s, &m, part);
    assert_int_equal(m.segments, segments);
    assert_true(end.x == x && end.y == y);
    assert_true(fabs(m.high.x - m.low.x - size.x) < 1e-9 && fabs(m.high.y - m.low.y - size.y) < 1e-9);
    assert_true(fabs(m.length - (double)segments) < 1e-6);
  }
  sample_release(s);
  free(word);
}

static void curves_close(void **state) {
  (void)state;
  const char *koch[] = {"F=F-F++F-F", NULL}, *island[] = {"F=F-F+F+FF-F-F+F", NULL};
  const char *hilbert[] = {"L=+RF-LFL-FR+", "R=-LF+RFR+FL-", NULL};
  const double h = sqrt(3) / 2;
  check_curve("F++F++F", koch, 60, 5, 3072, (LsysVec3){h * 324, 243, 0}, 0, 0);
  check_curve("F-F-F-F", island, 90, 3, 2048, (LsysVec3){106, 106, 0}, 0, 0);
  check_curve("L", hilbert, 90, 6, 4095, (LsysVec3){63, 63, 0}, -0.0, 63);
}

// 25.7 degrees is no whole fraction of a circle: 3600 turns of it are 257 circles.
static void does_not_drift(void **state) {
  (void)state;
  LsysMeasure m;
  Sample *s = sample("+", 25.7);
  lsys_measure_begin(&m, false);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  lsys_turtle_begin(t, 0, &m.geometry);
  enum { N = 3600 };
  uint8_t many[N];
  memset(many, s->sym[0], N);
  for (int i = 0; i < 3000; i++) assert_true(lsys_turtle_take(t, &(LsysWord){.sym = many, .nsym = N}));
  lsys_turtle_destroy(t);
  sample_release(s);
  s = sample("F+", 25.7);
  char *round = malloc(2 * N + 1);
  for (int i = 0; i < N; i++) memcpy(round + 2 * i, "F+", 3);
  LsysVec3 end = draw_text(round, 25.7, &m);
  assert_true(fabs(end.x) < 1e-10 && fabs(end.y) < 1e-10);
  free(round);
  sample_release(s);
}

static void odd_words_have_a_result(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("F]]F", 90, &m), 0, 2, 0);
  assert_at(draw_text("F(nan)+(inf)F", 90, &m), 0, 1, 0);
  assert_at(draw_text("F}F", 90, &m), 0, 2, 0);
  assert_at(draw_text("{fF", 90, &m), 0, 2, 0);
  assert_int_equal(m.polygons, 0);
  draw_text("!(-3)F", 90, &m);
  assert_true(m.thinnest == 0);
  draw_text("{}{.}", 90, &m);
  assert_int_equal(m.polygons, 0);
}

static void many_open_brackets(void **state) {
  (void)state;
  enum { N = 1000000 };
  LsysMeasure m;
  char *word = malloc(2 * N + 2);
  memset(word, '[', N);
  word[N] = 'F';
  memset(word + N + 1, ']', N);
  word[2 * N + 1] = 0;
  assert_at(draw_text(word, 90, &m), 0, 0, 0);
  assert_int_equal(m.segments, 1);
  word[N + 1] = 0;
  assert_at(draw_text(word, 90, &m), 0, 1, 0);
  free(word);
}

// The leaf of ABOP fig. 1.25 and a polygon in a polygon.
static void polygons(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("{-f+f+f-|-f+f+f}", 22.5, &m), 0, 0, 0);
  assert_int_equal(m.polygons, 1);
  draw_text("{f+f{f+f+f}+f}", 90, &m);
  assert_int_equal(m.polygons, 2);
  assert_true(m.low.x == -2 && m.high.y == 1);
}

// The symbols that Fractint's commands become.
static void scales_and_second_directions(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("F@s(0.5)F@s(4)FF(1)", 90, &m), 0, 1 + 0.5 + 2 + 1, 0);
  assert_at(draw_text("[@s(3)F]F", 90, &m), 0, 1, 0);
  assert_at(draw_text("+F@x+F[@x+F]-F", 90, &m), -2, 1, 0);
  assert_at(draw_text("@dF@a(90)@d@x@a(180)@d@m", 90, &m), 1, 2, 0);
  assert_int_equal(m.segments, 4);
  assert_at(draw_text("|(90)F@x|(90)F", 90, &m), -1, -1, 0);
}

// Discs, spheres and boxes; in space a disc lies in the plane of H and L.
static void draws_shapes(void **state) {
  (void)state;
  LsysMeasure m;
  draw_text("F@c(4)", 90, &m);
  assert_int_equal(m.balls, 1);
  assert_at(m.low, -2, -1, 0);
  assert_at(m.high, 2, 3, 0);
  draw_text("&(90)@c(4)", 90, &m);
  assert_int_equal(m.polygons, 1);
  assert_at(m.high, 2, 0, 2);
  draw_text("@O(2)@o(nan)@O(-1)@O(0)", 90, &m);
  assert_int_equal(m.balls, 1);
  draw_text("@B(3,2,1)", 90, &m);
  assert_int_equal(m.polygons, 6);
  assert_at(m.low, -1, 0, -0.5);
  assert_at(m.high, 1, 3, 0.5);
  draw_text("!(5)@O", 90, &m);
  assert_at(m.high, 2.5, 2.5, 2.5);
}

// ~X draws X where the turtle stands, scaled by its argument, whatever the turtle would make of the symbol.
static void draws_surfaces(void **state) {
  (void)state;
  static const double vertex[] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};
  static const uint32_t corner[] = {0, 1, 2, 0, 2, 3};
  const LsysSurface surfaces[] = {
    {.name = "F", .form = LSYS_SURFACE_MESH, .vertices = 4, .triangles = 2, .vertex = vertex, .corner = corner},
    {.name = "D", .form = LSYS_SURFACE_SPHERE, .size = {2}}};
  LsysMeasure m;
  Sample *s = sample("F~F(2)~D~X~D(3)", 90);
  s->grammar.surfaces = surfaces;
  s->grammar.surface_count = 2;
  assert_at(draw(s, &m, UINT64_MAX), 0, 1, 0);
  assert_int_equal(m.meshes, 1);
  assert_int_equal(m.balls, 2);
  assert_at(m.low, -3, -2, -3);
  assert_at(m.high, 3, 5, 6);
  sample_release(s);
}

// A straight cylinder of width 2 from (0,0) to (0,3), its mesh as high; and one through the places of a path.
static void sweeps_cylinders(void **state) {
  (void)state;
  LsysMeasure m;
  draw_text("!(2)@!(4)@Gsf(3)@Ge(5)", 90, &m);
  assert_int_equal(m.meshes, 1);
  assert_at(m.low, -1, 0, -1);
  assert_at(m.high, 1, 3, 1);
  draw_text("@Gs[f(2)@Gc]f(3)@Ge", 90, &m);  // the branch does not move the cylinder's last node
  assert_int_equal(m.meshes, 2);
  draw_text("!(2)@!(4){(1)ff+ff}", 90, &m);
  assert_int_equal(m.meshes, 4);
  assert_true(m.low.x <= -2 && m.low.x > -2.5 && m.high.y > 2.5 && m.high.y < 3.5);
  draw_text("@Gcf@Ge@Gs@Ge{(1)}{(1)f}", 90, &m);
  assert_int_equal(m.meshes, 1);
}

// Sixteen control points on a square grid give the flat square; a patch that was not begun gives nothing.
static void draws_patches(void **state) {
  (void)state;
  LsysMeasure m;
  char word[1024] = "@PS(1)", *at = word + strlen(word);
  for (int i = 0; i < 16; i++) at += sprintf(at, "@M(%d,%d)@PC(1,%d,%d)", i / 4, i % 4, i / 4, i % 4);
  strcpy(at, "@PD(1,3)@PD(2)@PC(1,4,0)");
  draw_text(word, 90, &m);
  assert_int_equal(m.meshes, 1);
  assert_at(m.low, 0, 0, 0);
  assert_at(m.high, 3, 3, 0);
}

// Symbols that set the turtle's state outright.
static void set_the_state(void **state) {
  (void)state;
  LsysMeasure m;
  assert_at(draw_text("@M(3,4)F", 90, &m), 3, 5, 0);
  assert_at(draw_text("@M(3,4,5)F", 90, &m), 3, 5, 5);
  assert_at(draw_text("@R(1,0)F", 90, &m), 1, 0, 0);
  assert_at(draw_text("@R(0,0,2)F+(90)F", 90, &m), -1, 0, 1);
  assert_at(draw_text("@R(0,1,0,1,0,0)&F", 90, &m), -1, 0, 0);
  assert_at(draw_text("@D(2)F[@D(3)F(2)]F", 90, &m), 0, 4, 0);
  assert_at(m.high, 0, 8, 0);
  assert_at(draw_text("@D(2)@s(0.5)F F(3)", 90, &m), 0, 7, 0);  // @D scales lengths that are given, too, @s does not
}

// ABOP p. 58: each segment turns H by e |H x T| radians towards T, and never beyond it.
static void bends_towards_the_tropism(void **state) {
  (void)state;
  LsysMeasure m;
  for (int space = 0; space < 2; space++) {
    Sample *s = sample(space ? "F/F" : "FF", 90);
    s->value[LSYS_SETTING_TROPISM_X] = 1;
    s->value[LSYS_SETTING_ELASTICITY] = 0.5;
    assert_at(draw(s, &m, UINT64_MAX), sin(0.5), 1 + cos(0.5), 0);
    s->value[LSYS_SETTING_ELASTICITY] = 50;
    assert_at(draw(s, &m, UINT64_MAX), 1, 1, 0);
    sample_release(s);
  }
  Sample *s = sample("F@Ts(1,0.5)FF[@Ti(1,9)]@Td(1,0.5)F", 90);
  s->value[LSYS_SETTING_TROPISM_X] = 1;
  assert_at(draw(s, &m, UINT64_MAX), sin(0.5) + sin(0.5 + 0.5 * cos(0.5)), 2 + cos(0.5) + cos(0.5 + 0.5 * cos(0.5)), 0);
  sample_release(s);
}

// Where the turtle gets to with tropisms 1 and 2: x, y, z, elasticity, increment, angle, torque of each.
static LsysVec3 lean(const char *text, const double *first, const double *second) {
  LsysMeasure m;
  Sample *s = sample(text, 90);
  const size_t size = LSYS_TROPISM_SETTINGS * sizeof *first;
  if (first) memcpy(&s->value[LSYS_SETTING_TROPISM_1_X], first, size);
  if (second) memcpy(&s->value[LSYS_SETTING_TROPISM_2_X], second, size);
  LsysVec3 end = draw(s, &m, UINT64_MAX);
  sample_release(s);
  return end;
}

// Numbered tropisms bend before a move, by |H x V| radians, V the sum of their vectors times their elasticities.
static void leans_to_numbered_tropisms(void **state) {
  (void)state;
  const double right[7] = {1, 0, 0, 0.5, 0.1}, up[7] = {0, 1, 0, 0.4}, back[7] = {0, 0, -1, 0.3};
  const double level[7] = {0, 1, 0, 0.5, 0, 90}, plagio[7] = {1, 0, 0, 0.5, 0, 90}, slant[7] = {1, 0, 0, 0.5, 0, 60};
  const double two = 0.5 + 0.5 * cos(0.5);
  assert_at(lean("FF", right, NULL), sin(0.5) + sin(two), cos(0.5) + cos(two), 0);
  assert_at(lean("F/F", right, NULL), sin(0.5) + sin(two), cos(0.5) + cos(two), 0);
  assert_at(lean("f", right, NULL), sin(0.5), cos(0.5), 0);
  assert_at(lean("F", right, up), sin(0.5), cos(0.5), 0);
  assert_at(lean("F", up, back), 0, cos(0.3), -sin(0.3));
  assert_at(lean("[@Td(1)]@Ts(2)F", right, back), sin(0.5), cos(0.5), 0);
  assert_at(lean("@Td(1)@Ts(2,0)F", right, back), sin(0.4), cos(0.4), 0);
  assert_at(lean("@Ts(1,0.25)@Ti(1)@Ts(3,9)F", right, NULL), sin(0.35), cos(0.35), 0);
  assert_at(lean("@Ts(1,50)F", right, NULL), sin(1), cos(1), 0);
  assert_at(lean("F", plagio, NULL), 0, 1, 0);
  assert_at(lean("F", level, NULL), 0, cos(0.5), sin(0.5));
  assert_at(lean("F", slant, NULL), sin(0.25), cos(0.25), 0);
}

// Torques roll -U towards their vector; bending keeps the roll of the last line or @Tf, and so does @Tp.
static void rolls_by_torques_and_back(void **state) {
  (void)state;
  const double right[7] = {1, 0, 0, 0.5}, left[7] = {-1, 0, 0, 0.5, 0, 0, 1};
  const double two = 0.5 + 0.5 * cos(0.5);
  assert_at(lean("F@Ts(1,0)+F", left, NULL), -cos(0.5), 1, sin(0.5));
  assert_at(lean("F@Ts(1,0)@Ts(2,0)+F", right, left), sin(0.5) - cos(0.5) * cos(0.5 * cos(0.5)),
            cos(0.5) + sin(0.5) * cos(0.5 * cos(0.5)), sin(0.5 * cos(0.5)));
  assert_at(lean("F/F@Ts(1,0)+F", right, NULL), sin(0.5) + sin(two) - cos(two), cos(0.5) + cos(two) + sin(two), 0);
  assert_at(lean("F/@TfF@Ts(1,0)+F", right, NULL), sin(0.5) + sin(two), cos(0.5) + cos(two), -1);
  assert_at(lean("F/++F", NULL, NULL), 0, 0, 0);
  assert_at(lean("F/+@Tp+F", NULL, NULL), -1, 1, 0);
  assert_at(lean("F/@Tf+@Tp+F", NULL, NULL), 0, 0, 0);
  assert_at(lean("F/@Tp+F", NULL, NULL), 0, 1, -1);
  assert_at(lean("F[/@Tf]/+@Tp+F", NULL, NULL), -1, 1, 0);
}

// Axes by Gravelius' orders, streams by Strahler's; brackets without segments are no branches.
static void orders_of_trees(void **state) {
  (void)state;
  static const struct {
    const char *word;
    uint64_t segments[3], axes[3], streams[3];
    uint32_t strahler;
  } cases[] = {
    {"FFF[]", {3}, {1}, {1}, 1},
    {"F[+F]F[-F]F", {3, 2}, {1, 2}, {3, 1}, 2},
    {"F[+F][-F]", {1, 2}, {1, 2}, {2, 1}, 2},
    {"F[+F[F]F][-F[F]F]", {1, 4, 2}, {1, 2, 2}, {4, 2, 1}, 3},
    {"F[+F[F]F]F[F]F", {3, 3, 1}, {1, 2, 1}, {4, 2, 1}, 3},
    {"F[+F[F]F]F", {2, 2, 1}, {1, 1, 1}, {3, 1}, 2},
    {"F[f][]F]F[F", {3, 1}, {1, 1}, {1}, 1},
    {"f[]", {0}, {0}, {0}, 0},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    Sample *s = sample(cases[i].word, 30);
    LsysTree *tree = lsys_tree_create(&s->run);
    lsys_tree_begin(tree);
    assert_true(lsys_tree_take(tree, &s->word));
    lsys_tree_end(tree);
    const LsysTreeOrders *orders = lsys_tree_orders(tree);
    assert_int_equal(orders->strahler, cases[i].strahler);
    for (int k = 0; k < 3; k++) {
      assert_int_equal(orders->segments[k + 1], cases[i].segments[k]);
      assert_int_equal(orders->axes[k + 1], cases[i].axes[k]);
      assert_int_equal(orders->streams[k + 1], cases[i].streams[k]);
    }
    lsys_tree_destroy(tree);
    sample_release(s);
  }
}

// A FASS curve visits one place more than it has segments.
static void counts_places(void **state) {
  (void)state;
  const char *hilbert[] = {"L=+RF-LFL-FR+", "R=-LF+RFR+FL-", NULL};
  char *word = sample_rewrite("L", hilbert, 6);
  Sample *s = sample(word, 90);
  LsysPlaces places;
  lsys_places_begin(&places, NULL, NULL);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  lsys_turtle_begin(t, 0, &places.geometry);
  assert_true(lsys_turtle_take(t, &s->word) && lsys_turtle_end(t));
  assert_int_equal(places.count, 4096);
  lsys_turtle_destroy(t);
  lsys_places_free(&places);
  sample_release(s);
  free(word);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(starts_up_the_page),
    cmocka_unit_test(turns_in_space),
    cmocka_unit_test(takes_settings),
    cmocka_unit_test(brackets_return),
    cmocka_unit_test(curves_close),
    cmocka_unit_test(does_not_drift),
    cmocka_unit_test(moves_without_drawing),
    cmocka_unit_test(scales_and_second_directions),
    cmocka_unit_test(polygons),
    cmocka_unit_test(orders_of_trees),
    cmocka_unit_test(counts_places),
    cmocka_unit_test(draws_shapes),
    cmocka_unit_test(sweeps_cylinders),
    cmocka_unit_test(draws_patches),
    cmocka_unit_test(draws_surfaces),
    cmocka_unit_test(set_the_state),
    cmocka_unit_test(bends_towards_the_tropism),
    cmocka_unit_test(leans_to_numbered_tropisms),
    cmocka_unit_test(rolls_by_torques_and_back),
    cmocka_unit_test(odd_words_have_a_result),
    cmocka_unit_test(many_open_brackets),
  };
  return cmocka_run_group_tests_name("turtle", tests, NULL, NULL);
}
