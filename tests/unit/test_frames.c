// test_frames.c -- how the turtle stands: rotations against the matrices of
// ABOP p. 19 (seed 002, slide 40), frames that stay orthonormal, curves that
// stay on their lattice at every level.
#include "sample.h"
#include "turtle/turtle.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

// ---- rotations -----------------------------------------------------------

// The columns of a frame: H, L, U.
typedef struct Matrix {
  double at[3][3];
} Matrix;

static Matrix frame_of(const LsysPose *p) {
  return (Matrix){{{p->h.x, p->l.x, p->u.x}, {p->h.y, p->l.y, p->u.y}, {p->h.z, p->l.z, p->u.z}}};
}

static LsysPose pose_behind(const char *word) {
  LsysGeometry nothing = {0};
  Sample *s = sample(word, 90);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  assert_non_null(t);
  lsys_turtle_begin(t, 0, &nothing);
  assert_true(lsys_turtle_take(t, &s->word));
  LsysPose pose = lsys_turtle_pose(t);
  lsys_turtle_destroy(t);
  sample_release(s);
  return pose;
}

static Matrix product(const Matrix *a, const Matrix *b) {
  Matrix c = {{{0}}};
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++)
      for (int n = 0; n < 3; n++) c.at[i][k] += a->at[i][n] * b->at[n][k];
  return c;
}

static void assert_same(const Matrix *a, const Matrix *b, double tolerance, const char *word) {
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++)
      if (!(fabs(a->at[i][k] - b->at[i][k]) <= tolerance)) fail_msg("%s: row %d, column %d is wrong", word, i, k);
}

// [H' L' U'] = [H L U] R about one axis. The book prints R_U and R_L for a left-handed turn, against its own figure
// 1.18, in which + turns from H to L and & takes H down: these are their transposes. R_H is as printed.
static Matrix rotation(char axis, double degrees) {
  double c = cos(degrees * acos(-1) / 180), s = sin(degrees * acos(-1) / 180);
  switch (axis) {
  case 'U':
    return (Matrix){{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  case 'L':
    return (Matrix){{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
  default:
    return (Matrix){{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  }
}

static void rotates_by_the_matrices(void **state) {
  (void)state;
  static const struct {
    const char *symbol;
    char axis;
    double sign;
  } turns[] = {{"+", 'U', 1}, {"-", 'U', -1}, {"&", 'L', 1}, {"^", 'L', -1}, {"\\", 'H', 1}, {"/", 'H', -1}};
  const char *before[] = {"&(0)", "+(33)&(21)\\(77)", "/(-140)^(3)-(59)"};
  for (int i = 0; i < 3; i++) {
    LsysPose pose = pose_behind(before[i]);
    Matrix start = frame_of(&pose);
    for (int k = 0; k < 6; k++) {
      for (double degrees = -200; degrees <= 400; degrees += 12.5) {
        char word[128];
        snprintf(word, sizeof word, "%s%s(%g)", before[i], turns[k].symbol, degrees);
        pose = pose_behind(word);
        Matrix turned = frame_of(&pose), r = rotation(turns[k].axis, turns[k].sign * degrees);
        Matrix expected = product(&start, &r);
        assert_same(&turned, &expected, 1e-14, word);
      }
    }
  }
  LsysPose around = pose_behind("+(33)&(21)|"), start = pose_behind("+(33)&(21)");
  Matrix half = rotation('U', 180), from = frame_of(&start), turned = frame_of(&around),
         expected = product(&from, &half);
  assert_same(&turned, &expected, 1e-15, "|");
}

// `$` and `@v` roll so that L is horizontal; H stays (ABOP p. 57).
static void rolls_to_the_vertical(void **state) {
  (void)state;
  const char *words[] = {"+(40)&(30)/(50)$", "+(140)&(-70)\\(500)@v", "&(80)/(10)$"};
  const char *heads[] = {"+(40)&(30)/(50)", "+(140)&(-70)\\(500)", "&(80)/(10)"};
  for (int i = 0; i < 3; i++) {
    LsysPose pose = pose_behind(words[i]), before = pose_behind(heads[i]);
    assert_true(fabs(pose.l.y) < 1e-15 && pose.u.y >= 0);
    assert_true(pose.h.x == before.h.x && pose.h.y == before.h.y && pose.h.z == before.h.z);
  }
  LsysPose up = pose_behind("/(30)$"), same = pose_behind("/(30)");  // there is no horizontal L to choose
  assert_true(up.l.x == same.l.x && up.l.z == same.l.z);
}

static double dot(LsysVec3 a, LsysVec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Ten million turns about all axes, by the default angle and by arguments.
static void stays_orthonormal(void **state) {
  (void)state;
  enum { ROUND = 1000, ROUNDS = 10000 };
  static const char symbols[] = "+&/-^\\+&/|";
  char *word = malloc(ROUND * 8 + 1), *at = word;
  for (int i = 0; i < ROUND; i++) {
    *at++ = symbols[i * 7 % 10];
    if (i % 3 == 0) at += sprintf(at, "(%d)", i * 37 % 180);
  }
  *at = 0;
  LsysGeometry nothing = {0};
  Sample *s = sample(word, 22.5);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  lsys_turtle_begin(t, 0, &nothing);
  for (int i = 0; i < ROUNDS; i++) {
    assert_true(lsys_turtle_take(t, &s->word));
    if (i % 100) continue;
    LsysPose p = lsys_turtle_pose(t);
    assert_true(fabs(dot(p.h, p.h) - 1) < 1e-12 && fabs(dot(p.l, p.l) - 1) < 1e-12 && fabs(dot(p.u, p.u) - 1) < 1e-12);
    assert_true(fabs(dot(p.h, p.l)) < 1e-12 && fabs(dot(p.l, p.u)) < 1e-12 && fabs(dot(p.u, p.h)) < 1e-12);
  }
  lsys_turtle_destroy(t);
  sample_release(s);
  free(word);
}

// Sixteen turns by 22.5 degrees are a circle, about every axis, ten million times.
static void comes_back(void **state) {
  (void)state;
  enum { ROUND = 1600, ROUNDS = 6250 };
  for (const char *symbol = "+&/"; *symbol; symbol++) {
    char word[ROUND + 8] = "&(25)";
    memset(word + 5, *symbol, ROUND);
    LsysGeometry nothing = {0};
    Sample *s = sample(word, 22.5);
    LsysTurtle *t = lsys_turtle_create(&s->run);
    lsys_turtle_begin(t, 0, &nothing);
    assert_true(lsys_turtle_take(t, &(LsysWord){.sym = s->sym, .arg = s->arg, .nsym = 1, .narg = 1}));
    LsysPose start = lsys_turtle_pose(t);
    const LsysWord turns = {.sym = s->sym + 1, .nsym = ROUND};
    for (int i = 0; i < ROUNDS; i++) assert_true(lsys_turtle_take(t, &turns));
    LsysPose end = lsys_turtle_pose(t);
    Matrix a = frame_of(&start), b = frame_of(&end);
    assert_same(&a, &b, 1e-9, word);
    lsys_turtle_destroy(t);
    sample_release(s);
  }
}

// ---- lattices ------------------------------------------------------------

// Counts the points that are not a lattice point rounded once: step times whole numbers of the lattice's own axes.
typedef struct OnLattice {
  LsysGeometry geometry;
  double step;
  bool hex;
  uint64_t points, off;
} OnLattice;

static bool check_points(LsysGeometry *to, const LsysStrokes *batch) {
  OnLattice *l = (OnLattice *)to;
  const double h = 0.86602540378443864676;
  for (size_t i = 0; i < batch->points; i++) {
    const LsysVec3 *p = &batch->point[i];
    double left = rint(-p->x / l->step / (l->hex ? h : 1)), ahead = rint(p->y / l->step - (l->hex ? left / 2 : 0));
    double x = l->hex ? left * h : left, y = l->hex ? ahead + left * 0.5 : ahead;
    l->off += !(p->x == l->step * -x && p->y == l->step * y && p->z == 0);
    l->points++;
  }
  return true;
}

static void check_levels(const char *axiom, const char *const *rules, double angle, int levels, bool closed) {
  const double steps[] = {1, 0.1, 1.0 / 3};
  for (int level = 0; level <= levels; level++) {
    char *word = sample_rewrite(axiom, rules, level);
    Sample *s = sample(word, angle);
    for (int i = 0; i < 3; i++) {
      OnLattice on = {{.strokes = check_points}, steps[i], angle == 60, 0, 0};
      s->value[LSYS_SETTING_STEP] = steps[i];
      LsysTurtle *t = lsys_turtle_create(&s->run);
      lsys_turtle_begin(t, 0, &on.geometry);
      assert_true(lsys_turtle_take(t, &s->word) && lsys_turtle_end(t));
      LsysVec3 end = lsys_turtle_position(t);
      if (closed) assert_true(end.x == 0 && end.y == 0);
      assert_int_equal(on.off, 0);
      assert_true(on.points > 0 || level == 0);
      lsys_turtle_destroy(t);
    }
    sample_release(s);
    free(word);
  }
}

static void curves_stay_on_their_lattice(void **state) {
  (void)state;
  const char *koch[] = {"F=F-F++F-F", NULL}, *island[] = {"F=F-F+F+FF-F-F+F", NULL};
  const char *hilbert[] = {"L=+RF-LFL-FR+", "R=-LF+RFR+FL-", NULL};
  const char *gosper[] = {"F=F+G++G-F--FF-G+", "G=-F+GG++G+F--F-G", NULL};
  const char *e_curve[] = {"F=FF-G-G+F+F-G-GF+G+FFG-F+G+FF+G-FG-G-F+F+GG-",
                           "G=+FF-G-G+F+FG+F-GG-F-G+FGG-F-GF+F+G-G-F+F+GG", NULL};
  check_levels("F++F++F", koch, 60, 7, true);
  check_levels("F-F-F-F", island, 90, 5, true);
  check_levels("L", hilbert, 90, 8, false);
  check_levels("F", gosper, 60, 6, false);
  check_levels("-G", e_curve, 90, 3, false);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(rotates_by_the_matrices),
    cmocka_unit_test(rolls_to_the_vertical),
    cmocka_unit_test(stays_orthonormal),
    cmocka_unit_test(comes_back),
    cmocka_unit_test(curves_stay_on_their_lattice),
  };
  return cmocka_run_group_tests_name("frames", tests, NULL, NULL);
}
