// test_parts.c -- deterministic figures as shared parts: sizes, end points and
// boxes agree with those of the figure drawn segment by segment.
#include "sample.h"
#include "turtle/measure.h"
#include "turtle/parts.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

enum { STEPS = 5, RULES = 4 };

// A D0L-system: "F=F[+F]F" are its rules, words are strings of symbols without arguments.
typedef struct System {
  const char *axiom, *rule[RULES];
  double angle;
  bool has_box;
} System;

static char *rewrite(const System *system, const char *word) {
  char *next = calloc(1, strlen(word) * 64 + 1), *out = next;
  for (; *word; word++) {
    const char *successor = NULL;
    for (int i = 0; i < RULES && system->rule[i]; i++)
      if (system->rule[i][0] == *word) successor = system->rule[i] + 2;
    if (successor)
      out = stpcpy(out, successor);
    else
      *out++ = *word;
  }
  return next;
}

// The word after STEPS steps.
static char *derive(const System *system) {
  char *word = strdup(system->axiom);
  for (int i = 0; i < STEPS; i++) {
    char *next = rewrite(system, word);
    free(word);
    word = next;
  }
  return word;
}

static void no_expand(LsysStream *out, const LsysWord *in, uint64_t steps) {
  (void)out;
  (void)in;
  (void)steps;
}

// A sample of the axiom whose run has what parts need.
typedef struct Fixture {
  Sample *sample;
  LsysBlock block[64][2];
  const LsysBlock *blocks[64];
  uint64_t levels[64];
  uint8_t sym[64][256];
  LsysAxiom axiom;
  uint32_t row[65];
} Fixture;

static void add_rule(Fixture *f, const char *rule) {
  char symbol[4] = {rule[0]};
  uint8_t kind = sample_kind(f->sample, symbol, 0);
  uint64_t n = 0;
  for (const char *c = rule + 2; *c; c++) {
    symbol[0] = *c;
    f->sym[kind][n++] = sample_kind(f->sample, symbol, 0);
  }
  f->block[kind][1] = (LsysBlock){.sym = f->sym[kind], .nsym = n};
  f->levels[kind] = 2;
}

static Fixture *fixture(const System *system) {
  Fixture *f = calloc(1, sizeof *f);
  f->sample = sample(system->axiom, system->angle);
  for (int i = 0; i < RULES && system->rule[i]; i++) add_rule(f, system->rule[i]);
  LsysGrammar *g = &f->sample->grammar;
  for (uint32_t k = 0; k < g->kind_count; k++) {
    f->blocks[k] = f->block[k];
    f->sample->kind[k].flags = LSYS_KIND_FIXED | (f->levels[k] ? 0 : LSYS_KIND_TERMINAL);
  }
  f->axiom.word = f->sample->word;
  g->axioms = &f->axiom;
  g->expand = no_expand;
  g->growth.row = f->row;
  f->sample->run.steps = STEPS;
  f->sample->run.block = f->blocks;
  f->sample->run.block_levels = f->levels;
  return f;
}

static void release(Fixture *f) {
  sample_release(f->sample);
  free(f);
}

static LsysVec3 draw(const System *system, LsysMeasure *m) {
  char *word = derive(system);
  Sample *s = sample(word, system->angle);
  lsys_measure_begin(m, true);
  LsysTurtle *t = lsys_turtle_create(&s->run);
  lsys_turtle_begin(t, 0, &m->geometry);
  assert_true(lsys_turtle_take(t, &s->word) && lsys_turtle_end(t));
  LsysVec3 end = lsys_turtle_position(t);
  lsys_turtle_destroy(t);
  sample_release(s);
  free(word);
  return end;
}

static void assert_near(double a, double b) {
  if (fabs(a - b) > 1e-9 * (1 + fabs(b))) fail_msg("%.17g is not %.17g", a, b);
}

static void assert_near_each(LsysVec3 a, LsysVec3 b) {
  assert_near(a.x, b.x);
  assert_near(a.y, b.y);
  assert_near(a.z, b.z);
}

static void parts_agree_with_drawings(void **state) {
  (void)state;
  static const System systems[] = {
    {"F-F-F-F", {"F=F-F+F+FF-F-F+F"}, 90, true},
    {"F++F++F", {"F=F-F++F-F"}, 60, true},
    {"L", {"L=+RF-LFL-FR+", "R=-LF+RFR+FL-"}, 90, true},
    {"X", {"X=F[+X][-X]FX", "F=FF"}, 25.7, true},
    {"F", {"F=FF-[-F+F+F]+[+F-F-F]"}, 22.5, true},
    {"Fa", {"F=F;[+F]!f'F", "a=aF"}, 36, true},
    {"A", {"A={f+f+f+f}[+A]fA"}, 45, true},
    {"A", {"A=[&FL!A]/////'[&FL!A]///////'[&FL!A]", "F=S/////F", "S=FL", "L=['''^^{-f+f+f-|-f+f+f}]"}, 22.5, false},
    {"A", {"A=FB-F^B^F[&&A]", "B=/F&[+B]A|F"}, 90, true},
  };
  for (size_t i = 0; i < sizeof systems / sizeof *systems; i++) {
    Fixture *f = fixture(&systems[i]);
    LsysMeasure m;
    LsysVec3 end = draw(&systems[i], &m);
    LsysParts parts;
    LsysPart whole;
    LsysPose start;
    assert_null(lsys_parts_create(&parts, &f->sample->run));
    assert_true(lsys_parts_figure(&parts, 0, &start, &whole));
    assert_near(whole.segments, (double)m.segments);
    assert_near(whole.polygons, (double)m.polygons);
    assert_near(whole.length, m.length);
    assert_near_each(whole.exit.at, end);
    LsysVec3 low, high;
    assert_int_equal(lsys_support_box(&parts.directions, whole.support, &low, &high), systems[i].has_box);
    if (systems[i].has_box) {
      assert_near_each(low, m.low);
      assert_near_each(high, m.high);
    }
    lsys_parts_destroy(&parts);
    release(f);
  }
}

static void says_why_not(void **state) {
  (void)state;
  static const System systems[] = {
    {"F", {"F=F[F"}, 90, false}, {"F", {"F=F$F"}, 90, false},   {"{F}", {"F=FF"}, 90, false},
    {"F", {"F=F~F"}, 90, false}, {"F[F]", {"[=FF"}, 90, false},
  };
  for (size_t i = 0; i < sizeof systems / sizeof *systems; i++) {
    Fixture *f = fixture(&systems[i]);
    LsysParts parts;
    const char *why = lsys_parts_create(&parts, &f->sample->run);
    assert_non_null(why);
    assert_true(*why);
    release(f);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(parts_agree_with_drawings), cmocka_unit_test(says_why_not)};
  return cmocka_run_group_tests_name("parts", tests, NULL, NULL);
}
