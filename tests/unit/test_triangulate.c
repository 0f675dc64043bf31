// test_triangulate.c -- triangles have the area of their polygon, none is turned over, and 10^5 vertices take a moment.
#include "turtle/triangulate.h"

#include "core/memory.h"
#include "turtle/vector.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <unistd.h>

enum { MANY = 100000 };

// In a plane of space: the page turned and moved.
static LsysVec3 tilted(double x, double y) {
  return (LsysVec3){x * 0.6 - y * 0.3 + 5, x * 0.5 + y * 0.7 - 2, y * 0.4 - x * 0.2 + 1};
}

// Orientation and area of what the cutter made; simple: the triangles fill the polygon and nothing else.
static void check(const PolygonCutter *c, const LsysVec3 *vertex, uint32_t count, bool simple) {
  LsysVec3 normal = polygon_normal(vertex, count);
  double whole = vec_length(normal), sum = 0;
  unsigned *used = calloc(count, sizeof *used);
  normal = vec_scale(normal, 1 / whole);
  for (uint32_t i = 0; i < count - 2; i++) {
    const uint32_t *t = c->triangle + 3 * (size_t)i;
    assert_true(t[0] < count && t[1] < count && t[2] < count);
    LsysVec3 a = vertex[t[0]], ab = vec_sum(vertex[t[1]], 1, a, -1), ac = vec_sum(vertex[t[2]], 1, a, -1);
    double twice = vec_dot(vec_cross(ab, ac), normal);
    if (simple) assert_true(twice > -1e-9 * whole);
    sum += twice;
    for (int k = 0; k < 3; k++) used[t[k]]++;
  }
  for (uint32_t i = 0; i < count; i++) assert_true(used[i] > 0);
  assert_true(fabs(sum - whole) <= 1e-9 * whole);
  free(used);
}

static void cut(const LsysVec3 *vertex, uint32_t count, bool simple) {
  LsysMemory memory = {.limit = UINT64_MAX};
  PolygonCutter cutter = {.memory = &memory};
  assert_true(polygon_triangles(&cutter, vertex, count));
  check(&cutter, vertex, count, simple);
  polygon_cutter_free(&cutter);
  assert_int_equal(memory.used, 0);
}

// Vertex i of n of a polygon.
typedef LsysVec3 Shape(uint32_t i, uint32_t n);

static LsysVec3 circle(uint32_t i, uint32_t n) {
  double angle = i * 6.283185307179586 / n;
  return tilted(cos(angle), sin(angle));
}

// Teeth as long as the whole.
static LsysVec3 comb(uint32_t i, uint32_t n) {
  if (i == 0) return tilted(n, -1);
  return i == n - 1 ? tilted(-1, -1) : tilted(n - i, i % 2 ? 0 : n);
}

// A band that is wound up: there and back.
static LsysVec3 spiral(uint32_t i, uint32_t n) {
  bool back = i >= n / 2;
  double at = back ? n - 1 - i : i, angle = at * 0.1, radius = 1 + angle + (back ? 2 : 0);
  return tilted(radius * cos(angle), radius * sin(angle));
}

// Spikes of different lengths around a hub.
static LsysVec3 star(uint32_t i, uint32_t n) {
  double angle = i * 6.283185307179586 / n, radius = i % 2 ? 1 : 2 + i * 7919u % 1000 / 1000.0;
  return tilted(radius * cos(angle), radius * sin(angle));
}

// Steps with corners of one height and place: many in line.
static LsysVec3 stairs(uint32_t i, uint32_t n) {
  uint32_t half = n / 2, k = i < half ? i : n - 1 - i;
  return tilted((k + 1) / 2 + (i < half ? 1 : 0), k / 2);
}

// A square whose sides are all corners in line, but for what is rounded.
static LsysVec3 square(uint32_t i, uint32_t n) {
  uint32_t side = n / 4, k = i % side;
  switch (i / side) {
  case 0:
    return tilted(k, 0);
  case 1:
    return tilted(side, k);
  case 2:
    return tilted(side - k, side);
  default:
    return tilted(0, side - k);
  }
}

// Steps of a quarter turn each, on a lattice: Koch's quadratic island, its sides in line here and there.
static LsysVec3 *koch(uint32_t steps, uint32_t *count) {
  static const int turns[] = {1, -1, -1, 0, 1, 1, -1, 0}, way[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  uint32_t n = 4;
  for (uint32_t i = 0; i < steps; i++) n *= 8;
  LsysVec3 *vertex = malloc(n * sizeof *vertex);
  int x = 0, y = 0, heading = 0;
  for (uint32_t i = 0; i < n; i++) {
    vertex[i] = tilted(x, y);
    x += way[heading & 3][0];
    y += way[heading & 3][1];
    uint32_t k = i + 1;
    while (k % 8 == 0 && k < n / 4 * 4 && k % (n / 4)) k /= 8;
    heading += k % (n / 4) ? turns[k % 8 - 1] : 3;
  }
  *count = n;
  return vertex;
}

static LsysVec3 *make(Shape *shape, uint32_t n) {
  LsysVec3 *vertex = malloc(n * sizeof *vertex);
  for (uint32_t i = 0; i < n; i++) vertex[i] = shape(i, n);
  return vertex;
}

static Shape *const shapes[] = {circle, comb, spiral, star, stairs, square};

static void all_of(uint32_t n) {
  for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
    LsysVec3 *vertex = make(shapes[i], n);
    cut(vertex, n, true);
    free(vertex);
  }
}

static void small_ones(void **state) {
  (void)state;
  all_of(8);
  all_of(30);
  all_of(100);
  all_of(1000);
}

static void many_vertices(void **state) {
  (void)state;
  alarm(60);  // one that tries every vertex against every other takes longer
  all_of(MANY);
  alarm(0);
}

static void lattices(void **state) {
  (void)state;
  alarm(60);
  for (uint32_t steps = 1; steps <= 5; steps++) {
    uint32_t count;
    LsysVec3 *vertex = koch(steps, &count);
    cut(vertex, count, true);
    free(vertex);
  }
  alarm(0);
}

// The order of the vertices of a polygon that crosses itself does not matter to its area.
static void crossing_ones(void **state) {
  (void)state;
  const LsysVec3 star_of_five[] = {{0, 1, 0}, {-0.6, -0.8, 0}, {1, 0.3, 0}, {-1, 0.3, 0}, {0.6, -0.8, 0}};
  cut(star_of_five, 5, false);
  const LsysVec3 eight[] = {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 3, 0}, {-1, 2, 0}};
  cut(eight, 5, false);
  LsysVec3 *tangle = malloc(MANY * sizeof *tangle);
  uint64_t x = 1;
  for (uint32_t i = 0; i < MANY; i++) {
    x = x * 6364136223846793005u + 1442695040888963407u;
    tangle[i] = tilted((double)(x >> 44), (double)(x >> 24 & 0xfffff));
  }
  PolygonCutter cutter = {0};
  alarm(60);
  assert_true(polygon_triangles(&cutter, tangle, MANY));
  alarm(0);
  polygon_cutter_free(&cutter);
  free(tangle);
}

// Places that come twice, spikes, corners in line, and nothing but a line.
static void degenerate_ones(void **state) {
  (void)state;
  const LsysVec3 twice[] = {{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 2, 0}, {0, 0, 0}};
  cut(twice, 7, true);
  const LsysVec3 spike[] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 5, 0}, {1, 2, 0}, {0, 2, 0}};
  cut(spike, 7, true);
  const LsysVec3 in_line[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  cut(in_line, 8, true);
  PolygonCutter cutter = {0};
  const LsysVec3 line[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  assert_true(polygon_triangles(&cutter, line, 4));
  assert_true(polygon_triangles(&cutter, line, 2));
  polygon_cutter_free(&cutter);
}

static void memory_runs_out(void **state) {
  (void)state;
  LsysMemory memory = {.limit = 1 << 20};
  PolygonCutter cutter = {.memory = &memory};
  LsysVec3 *vertex = make(comb, MANY);
  assert_false(polygon_triangles(&cutter, vertex, MANY));
  assert_true(polygon_triangles(&cutter, vertex, 100));
  polygon_cutter_free(&cutter);
  assert_int_equal(memory.used, 0);
  free(vertex);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(small_ones),    cmocka_unit_test(many_vertices),   cmocka_unit_test(lattices),
    cmocka_unit_test(crossing_ones), cmocka_unit_test(degenerate_ones), cmocka_unit_test(memory_runs_out),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
