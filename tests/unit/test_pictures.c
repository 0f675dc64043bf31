// test_pictures.c -- SVG, PDF and PNG files of hand-packed words, read back:
// numbers in the path data, operators of a page, pixels on and beside lines.
#include "core/out.h"
#include "pdf.h"
#include "sample.h"
#include "sinks/picture.h"

#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include <cmocka.h>

enum { INK = 0x41342a };  // index 0 of the palette

typedef LsysSink *Create(LsysOut *out, const LsysPictureOptions *options);

static const char *const PATH = "test_pictures.out";

static bool draw(Sample *s, Create *create, const LsysPictureOptions *options) {
  LsysOut *out = lsys_out_open(PATH);
  LsysSink *sink = create(out, options);
  bool well = true;
  for (unsigned pass = 0; well && pass < sink->passes; pass++)
    for (uint32_t axiom = 0; well && axiom < s->grammar.axiom_count; axiom++)
      well = sink->begin(sink, &s->run, axiom, pass) && sink->take(sink, &s->word) && sink->end(sink);
  well = well && sink->finish(sink);
  sink->destroy(sink);
  if (well) return lsys_out_commit(out);
  lsys_out_abandon(out);
  return false;
}

static char *svg_of(const char *word, double angle, uint32_t axioms, const LsysPictureOptions *options) {
  Sample *s = sample(word, angle);
  s->grammar.axiom_count = axioms;
  assert_true(draw(s, lsys_svg_create, options));
  sample_release(s);
  FILE *file = fopen(PATH, "r");
  char *text = calloc(1, 1 << 16);
  assert_true(fread(text, 1, 65535, file) > 0);
  fclose(file);
  unlink(PATH);
  return text;
}

static void assert_holds(const char *text, const char *part) {
  if (!strstr(text, part)) fail_msg("no %s in\n%s", part, text);
}

static void svg_fits_the_page(void **state) {
  (void)state;
  char *text = svg_of("F-F-F-F", 90, 1, &lsys_picture_defaults);
  assert_holds(text, "viewBox=\"0 0 1000 1000\"");
  assert_holds(text, "<path d=\"M40 960v-920h920v920h-920\"/>");
  free(text);
}

static void svg_joins_and_groups(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = options.height = 100;
  options.line_width = 2;
  char *text = svg_of("F[;F]F[+F]!(3)F", 90, 1, &options);
  // The second F goes on from the first one in another group, since the branch between them has another colour.
  assert_holds(text, "stroke-width=\"2\">\n<path d=\"M65.33 96v-30.67\"/>\n</g>");
  assert_holds(text, "stroke-width=\"6\"");
  free(text);
}

static void figures_stand_side_by_side(void **state) {
  (void)state;
  char *text = svg_of("F", 90, 2, &lsys_picture_defaults);
  assert_holds(text, "viewBox=\"0 0 154 1000\"");
  assert_holds(text, "M40.2 960v-920m73.6 920v-920");
  free(text);
}

static void polygons_are_filled(void **state) {
  (void)state;
  char *text = svg_of("{f-f-f-f}", 90, 1, &lsys_picture_defaults);
  assert_holds(text, "d=\"M40 960v-920h920v920h-920z\"");
  free(text);
}

static void nothing_and_too_much(void **state) {
  (void)state;
  free(svg_of("AB", 90, 1, &lsys_picture_defaults));
  Sample *s = sample("F(1e308)F(1e308)", 90);
  assert_false(draw(s, lsys_svg_create, &lsys_picture_defaults));
  assert_int_equal(access(PATH, F_OK), -1);
  sample_release(s);
}

// By progress the hues go round: from red. A stroke is cut where its colour changes.
static void colours_by_progress_and_order(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.colours.by = LSYS_BY_PROGRESS;
  char *text = svg_of("FFFFFFFFF", 90, 1, &options);
  assert_holds(text, "stroke=\"#d62f2a");
  int groups = 0;
  for (char *at = text; (at = strstr(at, "<path")); at++) groups++;
  assert_int_equal(groups, 9);
  free(text);
  options.colours = (LsysColours){LSYS_BY_ORDER, "red,#00f,#123456"};
  text = svg_of("F[+F[+F]]", 90, 1, &options);
  assert_holds(text, "stroke=\"#c23b22");
  assert_holds(text, "stroke=\"#0000ff");
  assert_holds(text, "stroke=\"#123456");
  free(text);
}

// The page of the PDF that a word gives; its content is to be freed.
static PdfFile pdf_of(const char *word, double angle, const LsysPictureOptions *options) {
  static uint8_t bytes[1 << 20];
  Sample *s = sample(word, angle);
  assert_true(draw(s, lsys_pdf_create, options));
  sample_release(s);
  FILE *file = fopen(PATH, "rb");
  size_t size = fread(bytes, 1, sizeof bytes - 1, file);
  fclose(file);
  unlink(PATH);
  bytes[size] = 0;
  PdfFile pdf;
  const char *why = pdf_read(&pdf, bytes, size);
  if (why) fail_msg("the PDF of %s %s", word, why);
  return pdf;
}

// A pixel is 3/4 of a point; y goes down; connected lines are one path.
static void pdf_draws_what_svg_draws(void **state) {
  (void)state;
  PdfFile pdf = pdf_of("F-F-F-F", 90, &lsys_picture_defaults);
  assert_true(pdf.box[0] == 0 && pdf.box[1] == 0 && pdf.box[2] == 750 && pdf.box[3] == 750);
  assert_holds(pdf.content, "0.75 0 0 -0.75 0 750 cm\n1 J 1 j\n1 1 1 rg\n0 0 1000 1000 re f\n");
  assert_holds(pdf.content, "40 960 m\n40 40 l\n960 40 l\n960 960 l\n40 960 l\nS\n");
  assert_int_equal(pdf.count['m'], 1);
  assert_int_equal(pdf.count['l'], 4);
  assert_int_equal(pdf.count['S'], 1);
  free(pdf.content);
}

static void pdf_has_inks_and_polygons(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = options.height = 100;
  options.line_width = 2;
  options.transparent = true;
  options.colours.list = "#ff0000,#008000";
  PdfFile pdf = pdf_of("F[;F]F[;{+f+f+f}]!(3)F@o", 90, &options);
  assert_holds(pdf.content, "1 0 0 RG\n2.000 w\n");
  assert_holds(pdf.content, "0 0.502 0 RG\n2.000 w\n");
  assert_holds(pdf.content, "1 0 0 RG\n6.000 w\n");
  assert_holds(pdf.content, "0 0.502 0 rg\n");
  assert_null(strstr(pdf.content, "re f"));
  assert_int_equal(pdf.count['f'], 1);
  free(pdf.content);
}

// What was drawn fills more than one buffer of the compression; a page longer than 14400 units has bigger ones.
static void pdf_may_be_big(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = options.height = 60000;
  enum { TURNS = 20000 };
  char *word = malloc(4 * TURNS + 1), *at = word;
  for (int i = 0; i < TURNS; i++) at = stpcpy(at, i % 3 ? "F-" : "F+F");
  PdfFile pdf = pdf_of(word, 7, &options);
  assert_true(pdf.box[2] == 11250);  // 45000 points in units of 4
  assert_int_equal(pdf.count['l'], TURNS + (TURNS + 2) / 3);
  assert_int_equal(pdf.count['m'], pdf.count['S']);
  free(pdf.content);
  free(word);
}

// Pixels of the PNG that a word gives, RGBA; to be freed.
static uint8_t *png_of(const char *word, double angle, const LsysPictureOptions *options) {
  Sample *s = sample(word, angle);
  assert_true(draw(s, lsys_png_create, options));
  sample_release(s);
  png_image image = {.version = PNG_IMAGE_VERSION};
  assert_true(png_image_begin_read_from_file(&image, PATH));
  assert_int_equal(image.width, options->width);
  assert_int_equal(image.height, options->height);
  image.format = PNG_FORMAT_RGBA;
  uint8_t *pixels = malloc(PNG_IMAGE_SIZE(image));
  assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
  unlink(PATH);
  return pixels;
}

static uint32_t pixel(const uint8_t *pixels, uint32_t width, uint32_t x, uint32_t y) {
  const uint8_t *p = pixels + 4 * (y * width + x);
  return (uint32_t)p[0] << 24 | p[1] << 16 | p[2] << 8 | p[3];
}

static void png_covers_lines(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = 51;
  options.height = 100;
  options.line_width = 5;
  uint8_t *p = png_of("F", 90, &options);
  uint32_t ink = (uint32_t)INK << 8 | 0xff;
  for (uint32_t y = 10; y < 90; y++) {
    assert_int_equal(pixel(p, 51, 25, y), ink);
    assert_int_equal(pixel(p, 51, 23, y), ink);
    assert_int_equal(pixel(p, 51, 22, y), 0xffffffff);
  }
  free(p);
  options.transparent = true;
  p = png_of("F", 90, &options);
  assert_int_equal(pixel(p, 51, 25, 50), ink);
  assert_int_equal(pixel(p, 51, 1, 50) & 0xff, 0);
  free(p);
}

// Half a pixel of ink makes half a shade, and drawing it twice does not darken it.
static void png_smooths_edges(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = 51;
  options.height = 100;
  options.line_width = 6;
  uint8_t *p = png_of("F|F", 90, &options);
  uint32_t ink = INK >> 16, edge = pixel(p, 51, 22, 50) >> 24;
  assert_true(abs((int)edge - (int)(255 + ink) / 2) <= 1);
  free(p);
}

static void png_fills_polygons(void **state) {
  (void)state;
  LsysPictureOptions options = lsys_picture_defaults;
  options.width = options.height = 100;
  uint8_t *p = png_of("{f-f-f-f}", 90, &options);
  uint32_t ink = (uint32_t)INK << 8 | 0xff;
  assert_int_equal(pixel(p, 100, 5, 5), ink);
  assert_int_equal(pixel(p, 100, 94, 94), ink);
  assert_int_equal(pixel(p, 100, 50, 3), 0xffffffff);
  assert_int_equal(pixel(p, 100, 3, 50), 0xffffffff);
  free(p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(svg_fits_the_page),
    cmocka_unit_test(svg_joins_and_groups),
    cmocka_unit_test(polygons_are_filled),
    cmocka_unit_test(figures_stand_side_by_side),
    cmocka_unit_test(png_covers_lines),
    cmocka_unit_test(nothing_and_too_much),
    cmocka_unit_test(colours_by_progress_and_order),
    cmocka_unit_test(pdf_draws_what_svg_draws),
    cmocka_unit_test(pdf_has_inks_and_polygons),
    cmocka_unit_test(pdf_may_be_big),
    cmocka_unit_test(png_smooths_edges),
    cmocka_unit_test(png_fills_polygons),
  };
  return cmocka_run_group_tests_name("pictures", tests, NULL, NULL);
}
