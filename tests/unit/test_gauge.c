// test_gauge.c -- what is measured on several threads is, to the last bit, what one measure finds.
#include "sinks/gauge.h"

#include "core/memory.h"
#include "lsys/keys.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

enum { BATCHES = 300, STROKES = 40, POINTS = 30 };

static double random_number(uint64_t *seed) {
  *seed = lsys_mix64(*seed + 1);
  return (double)(*seed >> 40) / 1000 - 5000;
}

// Batches of strokes, and now and then something else.
static void draw(LsysGeometry *to, uint64_t seed) {
  static LsysVec3 point[STROKES * POINTS];
  LsysStroke stroke[STROKES];
  for (int i = 0; i < BATCHES; i++) {
    uint32_t count = 0;
    for (uint32_t s = 0; s < STROKES; s++) {
      stroke[s] = (LsysStroke){count, 2 + s % (POINTS - 1), {1 + s % 3, (uint8_t)(s % 5), 0}, false};
      for (uint32_t k = 0; k < stroke[s].count; k++)
        point[count++] = (LsysVec3){random_number(&seed), random_number(&seed), random_number(&seed)};
    }
    LsysStrokes batch = {point, stroke, STROKES, count};
    assert_true(to->strokes(to, &batch));
    if (i % 50 == 0) assert_true(to->polygon(to, point, 7, &stroke[0].pen));
    if (i % 70 == 0) assert_true(to->ball(to, point, 3, false, &stroke[0].pen));
    if (i % 90 == 0) assert_true(to->label(to, point, "1", &stroke[0].pen));
  }
}

static void threads_change_nothing(void **state) {
  (void)state;
  LsysMeasure alone;
  lsys_measure_begin(&alone, true);
  draw(&alone.geometry, 1);
  for (unsigned threads = 0; threads <= 7; threads++) {
    LsysMemory memory = {.limit = UINT64_MAX};
    LsysGauge gauge = {0};
    for (int figure = 0; figure < 2; figure++) {
      LsysGeometry *to = lsys_gauge_begin(&gauge, &memory, threads);
      assert_non_null(to);
      draw(to, 1);
      assert_true(lsys_gauge_end(&gauge));
      const LsysMeasure *m = &gauge.measure;
      assert_true(m->length == alone.length && m->segments == alone.segments);
      assert_true(m->polygons == alone.polygons && m->balls == alone.balls);
      assert_memory_equal(m->of_colour, alone.of_colour, sizeof m->of_colour);
      assert_memory_equal(&m->low, &alone.low, sizeof m->low);
      assert_memory_equal(&m->high, &alone.high, sizeof m->high);
      assert_true(m->thinnest == alone.thinnest && m->thickest == alone.thickest && m->odd == alone.odd);
    }
    lsys_gauge_close(&gauge);
    assert_int_equal(memory.used, 0);
  }
}

static void memory_runs_out(void **state) {
  (void)state;
  LsysMemory memory = {.limit = 1000};
  LsysGauge gauge = {0};
  assert_null(lsys_gauge_begin(&gauge, &memory, 2));
  lsys_gauge_close(&gauge);
  assert_int_equal(memory.used, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(threads_change_nothing), cmocka_unit_test(memory_runs_out)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
