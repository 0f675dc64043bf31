// test_meshes.c -- OBJ, PLY and GLB files read back by readers written for the
// test: counts, indices, bounds, and whether tubes are closed.
#include "core/out.h"
#include "lsys/surface.h"
#include "sample.h"
#include "sinks/model.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include <cmocka.h>

static void draw(const char *path, const char *word, LsysModel *model, LsysOut *out, uint32_t sides) {
  Sample *s = sample(word, 90);
  LsysSink *sink = lsys_model_create(model, &(LsysModelOptions){.line_width = 100, .sides = sides});
  for (unsigned pass = 0; pass < sink->passes; pass++)
    assert_true(sink->begin(sink, &s->run, 0, pass) && sink->take(sink, &s->word) && sink->end(sink));
  assert_true(sink->finish(sink));
  sink->destroy(sink);
  assert_true(lsys_out_commit(out));
  assert_int_equal(access(path, F_OK), 0);
  sample_release(s);
}

// The whole file, with a zero behind it.
static uint8_t *contents(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  fseek(file, 0, SEEK_END);
  *size = (size_t)ftell(file);
  rewind(file);
  uint8_t *bytes = calloc(1, *size + 1);
  assert_int_equal(fread(bytes, 1, *size, file), *size);
  fclose(file);
  unlink(path);
  return bytes;
}

// Triangles as the readers give them: places of vertices, and numbers of corners.
typedef struct Soup {
  size_t vertices, triangles, edges;
  float (*place)[3];
  uint32_t (*corner)[3];
} Soup;

static void release(Soup *soup) {
  free(soup->place);
  free(soup->corner);
}

static size_t element(const char *head, const char *name) {
  char line[64];
  snprintf(line, sizeof line, "element %s ", name);
  const char *at = strstr(head, line);
  return at ? strtoul(at + strlen(line), NULL, 10) : 0;
}

static Soup read_ply(const char *path) {
  size_t size;
  uint8_t *bytes = contents(path, &size);
  const char *head = (const char *)bytes;
  assert_int_equal(strncmp(head, "ply\nformat binary_little_endian 1.0\n", 36), 0);
  Soup soup = {element(head, "vertex"), element(head, "face"), element(head, "edge"), NULL, NULL};
  const uint8_t *at = (const uint8_t *)strstr(head, "end_header\n") + 11;
  soup.place = calloc(soup.vertices + 1, sizeof *soup.place);
  soup.corner = calloc(soup.triangles + 1, sizeof *soup.corner);
  for (size_t i = 0; i < soup.vertices; i++, at += 27) memcpy(soup.place[i], at, 12);
  for (size_t i = 0; i < soup.triangles; i++, at += 13) {
    assert_int_equal(*at, 3);
    memcpy(soup.corner[i], at + 1, 12);
  }
  at += 8 * soup.edges;
  assert_ptr_equal(at, bytes + size);
  free(bytes);
  return soup;
}

static uint32_t number(const uint8_t *at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

// The number behind a key in JSON text.
static double after(const char *from, const char *key) {
  const char *at = strstr(from, key);
  assert_non_null(at);
  return strtod(at + strlen(key), NULL);
}

static Soup read_glb(const char *path) {
  size_t size;
  uint8_t *bytes = contents(path, &size);
  assert_int_equal(number(bytes), 0x46546c67);
  assert_int_equal(number(bytes + 8), size);
  uint32_t json_size = number(bytes + 12);
  char *json = strndup((const char *)bytes + 20, json_size);
  const uint8_t *binary = bytes + 20 + json_size + 8;
  assert_int_equal(number(binary - 8) + 28 + json_size, size);
  Soup soup = {.vertices = (size_t)after(json, "5126,\"count\":")};
  soup.place = calloc(soup.vertices, sizeof *soup.place);
  float low = INFINITY;
  for (size_t i = 0; i < soup.vertices; i++) {
    memcpy(soup.place[i], binary + 28 * i, 12);
    low = fminf(low, soup.place[i][1]);
  }
  float bound;
  assert_int_equal(sscanf(strstr(json, "\"min\":["), "\"min\":[%*[^,],%f", &bound), 1);
  assert_true(bound == low);
  const char *mode = strstr(json, "\"mode\":4");
  if (mode) {
    soup.triangles = (size_t)after(json, "5125,\"count\":") / 3;
    soup.corner = calloc(soup.triangles, sizeof *soup.corner);
    memcpy(soup.corner, binary + 28 * soup.vertices, 12 * soup.triangles);
  }
  free(json);
  free(bytes);
  return soup;
}

// What a closed surface that is oriented outwards encloses.
static double volume(const Soup *s) {
  double sum = 0;
  for (size_t i = 0; i < s->triangles; i++) {
    for (int k = 0; k < 3; k++) assert_true(s->corner[i][k] < s->vertices);
    const float *a = s->place[s->corner[i][0]], *b = s->place[s->corner[i][1]], *c = s->place[s->corner[i][2]];
    double x = (double)(b[1] * c[2] - b[2] * c[1]), y = (double)(b[2] * c[0] - b[0] * c[2]),
           z = (double)(b[0] * c[1] - b[1] * c[0]);
    sum += (double)a[0] * x + (double)a[1] * y + (double)a[2] * z;
  }
  return sum / 6;
}

// A square tube: the cross-section is half the square of its diagonal, here of the width.
static void tubes_are_closed(void **state) {
  (void)state;
  const char *words[] = {"F", "FF", "F+F", "F&F+F", "F|F", "F(3)"};
  const double lengths[] = {1, 2, 2, 3, 2, 3}, extents[] = {1, 2, 1, 0, 0, 3};  // 0: the camera's view is another
  for (int i = 0; i < 6; i++) {
    LsysOut *out = lsys_out_open("t.ply");
    draw("t.ply", words[i], lsys_ply_create(out), out, 4);
    Soup soup = read_ply("t.ply");
    if (extents[i] > 0) {
      double width = 100 * extents[i] / 920;  // 100 pixels of a page of 1000, of which the longest side takes 920
      assert_true(fabs(volume(&soup) - lengths[i] * width * width / 2) < 1e-6);
    }
    assert_true(volume(&soup) > 0);
    release(&soup);
  }
}

static void lines_are_edges(void **state) {
  (void)state;
  LsysOut *out = lsys_out_open("t.ply");
  draw("t.ply", "F+F[-F]F", lsys_ply_create(out), out, 1);
  Soup soup = read_ply("t.ply");
  assert_int_equal(soup.edges, 4);
  assert_int_equal(soup.triangles, 0);
  release(&soup);
}

static void glb_holds_the_same(void **state) {
  (void)state;
  const char *word = "F;F&(30)+F{f+f+f}@O(0.5)";
  LsysOut *out = lsys_out_open("t.glb");
  draw("t.glb", word, lsys_glb_create(out), out, 6);
  Soup glb = read_glb("t.glb");
  out = lsys_out_open("t.ply");
  draw("t.ply", word, lsys_ply_create(out), out, 6);
  Soup ply = read_ply("t.ply");
  assert_int_equal(glb.vertices, ply.vertices);
  assert_int_equal(glb.triangles, ply.triangles);
  assert_memory_equal(glb.place, ply.place, glb.vertices * sizeof *glb.place);
  assert_memory_equal(glb.corner, ply.corner, glb.triangles * sizeof *glb.corner);
  release(&glb);
  release(&ply);
}

static void obj_reads_back(void **state) {
  (void)state;
  const char *word = "F;F&(30)+F{f+f+f}@O(0.5)";
  LsysOut *out = lsys_out_open("t.obj");
  draw("t.obj", word, lsys_obj_create(out, lsys_out_open("t.mtl"), strdup("t.mtl")), out, 6);
  LsysSurface surface;
  char why[256];
  assert_true(lsys_surface_read("t.obj", &surface, why, sizeof why));
  out = lsys_out_open("t.ply");
  draw("t.ply", word, lsys_ply_create(out), out, 6);
  Soup ply = read_ply("t.ply");
  assert_int_equal(surface.vertices, ply.vertices);
  assert_int_equal(surface.triangles, ply.triangles);
  size_t size;
  char *mtl = (char *)contents("t.mtl", &size);
  assert_non_null(strstr(mtl, "newmtl c0\n"));
  assert_non_null(strstr(mtl, "newmtl c1\n"));
  assert_null(strstr(mtl, "newmtl c2\n"));
  free(mtl);
  lsys_surface_free(&surface);
  release(&ply);
  unlink("t.obj");
}

static void empty_models(void **state) {
  (void)state;
  LsysOut *out = lsys_out_open("t.ply");
  draw("t.ply", "ABf", lsys_ply_create(out), out, 0);
  Soup soup = read_ply("t.ply");
  assert_int_equal(soup.vertices, 0);
  release(&soup);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(tubes_are_closed), cmocka_unit_test(lines_are_edges), cmocka_unit_test(glb_holds_the_same),
    cmocka_unit_test(obj_reads_back),   cmocka_unit_test(empty_models),
  };
  return cmocka_run_group_tests_name("meshes", tests, NULL, NULL);
}
