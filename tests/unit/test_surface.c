// test_surface.c -- surfaces read from OBJ files and from cpfg's.
#include "lsys/surface.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

static bool read_text(const char *path, const char *text, LsysSurface *surface, char *why) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
  bool well = lsys_surface_read(path, surface, why, 256);
  unlink(path);
  return well;
}

static void reads_obj(void **state) {
  (void)state;
  LsysSurface s;
  char why[256];
  assert_true(read_text("t.obj",
                        "# a square and a triangle\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 2\n"
                        "f 1//1 2//1 3//1 4//1\nusemtl x\nf -4/1/1 -2/1/1 -1/1/-1\n",
                        &s, why));
  assert_int_equal(s.vertices, 4);
  assert_int_equal(s.triangles, 3);
  assert_non_null(s.normal);
  assert_true(s.normal[2] == 1);
  lsys_surface_free(&s);
  assert_true(read_text("t.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", &s, why));
  assert_null(s.normal);
  lsys_surface_free(&s);
}

static void refuses_bad_obj(void **state) {
  (void)state;
  const char *const texts[][2] = {
    {"v 0 0 0\nf 1 2 3\n", "line 2: a face names a vertex or normal that is not there"},
    {"v 0 0\n", "line 1: three numbers should stand here"},
    {"v 0 0 nan\n", "line 1: three numbers should stand here"},
    {"v 0 0 0\nf 1 1\n", "line 2: a face needs three vertices"},
    {"v 0 0 0\nf 0 1 1\n", "line 2: a face names a vertex or normal that is not there"},
    {"", "there is no face in it"},
  };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    LsysSurface s;
    char why[256];
    assert_false(read_text("t.obj", texts[i][0], &s, why));
    assert_string_equal(why, texts[i][1]);
    assert_null(s.vertex);
  }
  LsysSurface s;
  char why[256];
  assert_false(lsys_surface_read("no such file.obj", &s, why, sizeof why));
  assert_string_equal(why, "No such file or directory");
  assert_false(lsys_surface_read(".", &s, why, sizeof why));
  assert_string_equal(why, "is a directory");
  assert_false(lsys_surface_read("/dev/zero", &s, why, sizeof why));
  assert_string_equal(why, "is not a file");
}

// A flat patch from (0,0) to (3,6) about the contact point (0,0), of size 2, whose heading is x.
static void reads_patches(void **state) {
  (void)state;
  LsysSurface s;
  char why[256];
  assert_true(read_text("t.s",
                        "0 3  0 6  0 0\nPRECISION S: 5 T: 5\nCONTACT POINT  X: 0.00 Y: 0.00 Z: 0.00\n"
                        "END POINT  X: 0.00 Y: 0.00 Z: 0.00\nHEADING  X: 1.00 Y: 0.00 Z: 0.00\n"
                        "UP  X: 0.00 Y: 0.00 Z: 1.00\nSIZE: 2.000000\nPatch_0\n"
                        "TOP COLOR: 0 DIFFUSE: 0.00 BOTTOM COLOR: 0 DIFFUSE: 0.00\nAL: ~ A: ~ AR: ~ \nL: ~ R: ~ \n"
                        "BL: ~ B: ~ BR: ~ \n0 0 0  1 0 0  2 0 0  3 0 0\n0 2 0  1 2 0  2 2 0  3 2 0\n"
                        "0 4 0  1 4 0  2 4 0  3 4 0\n0 6 0  1 6 0  2 6 0  3 6 0\n",
                        &s, why));
  assert_int_equal(s.vertices, 81);
  assert_int_equal(s.triangles, 128);
  const double *last = s.vertex + 3 * 80;  // (3, 6): 1.5 ahead, 3 to the left of the heading
  assert_true(fabs(last[0] + 3) < 1e-12 && fabs(last[1] - 1.5) < 1e-12 && fabs(last[2]) < 1e-12);
  lsys_surface_free(&s);
  assert_false(read_text("t.s", "0 1 0 1\nSIZE: 0\n", &s, why));
  assert_false(read_text("t.s", "0 1 0 1\nhello\n", &s, why));
  assert_string_equal(why, "line 2: this is no head of a cpfg surface");
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(reads_obj), cmocka_unit_test(refuses_bad_obj),
                                     cmocka_unit_test(reads_patches)};
  return cmocka_run_group_tests_name("surface", tests, NULL, NULL);
}
