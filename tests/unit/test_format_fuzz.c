// test_format_fuzz.c -- random turtle words through every format: symbols with
// any arguments, nan and infinite ones too, brackets and polygons that do not
// close. A format either refuses the figure with a message and leaves no file,
// or writes one that parses. TURTLE_FUZZ=N tries N words instead of some.
#include "lsys/abi.h"
#include "lsys/keys.h"
#include "pdf.h"
#include "sample.h"

#include <ctype.h>
#include <fcntl.h>
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include <cmocka.h>

enum { WORDS = 150, LONGEST = 60 };

// ---- words ---------------------------------------------------------------

static uint64_t draw(uint64_t *state, uint64_t below) {
  *state = lsys_mix64(*state + LSYS_GOLDEN);
  return *state % below;
}

static void put_argument(uint64_t *state, char **at) {
  static const char *const odd[] = {"nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "-0", "1e17", "-3"};
  static const char *const plain[] = {"0", "1", "2", "0.5", "30", "90", "-45", "3", "0.1", "-1"};
  bool strange = draw(state, 12) == 0;
  *at = stpcpy(*at, strange ? odd[draw(state, 9)] : plain[draw(state, 10)]);
}

// Half of the modules walk, turn and branch; the others are any symbol of the table.
static void put_module(uint64_t *state, char **at) {
  static const char *const often[] = {"F", "F", "F", "f", "+", "-", "&",   "/",  "[",
                                      "]", "{", "}", ".", "!", "'", "@Gs", "@Gc"};
  const char *symbol = often[draw(state, sizeof often / sizeof *often)];
  int most = 2;
  if (draw(state, 2)) {
    const LsysTurtleInfo *info = &lsys_turtle[1 + draw(state, LSYS_TURTLE_COUNT - 1)];
    symbol = info->symbol;
    most = info->most + 1;
  }
  *at = stpcpy(*at, symbol);
  uint64_t arguments = strcmp(symbol, "[") && strcmp(symbol, "]") ? draw(state, (uint64_t)most + 1) : 0;
  for (uint64_t i = 0; i < arguments; i++) {
    *(*at)++ = i ? ',' : '(';
    put_argument(state, at);
  }
  if (arguments) *(*at)++ = ')';
}

static void make_word(uint64_t seed, char *word) {
  uint64_t state = lsys_mix64(seed), modules = 1 + draw(&state, LONGEST);
  for (uint64_t i = 0; i < modules; i++) put_module(&state, &word);
  *word = 0;
}

// ---- readers -------------------------------------------------------------

typedef struct File {
  uint8_t *bytes;
  size_t size;
  const char *why;  // it does not parse
} File;

static File read_file(const char *path) {
  File f = {0};
  FILE *in = fopen(path, "rb");
  if (!in) return f;
  fseek(in, 0, SEEK_END);
  f.size = (size_t)ftell(in);
  rewind(in);
  f.bytes = calloc(1, f.size + 1);
  if (fread(f.bytes, 1, f.size, in) != f.size) f.why = "cannot be read";
  fclose(in);
  unlink(path);
  return f;
}

// A JSON value; returns what stands behind it, NULL if it is none. Lists and objects may nest to a depth of 20.
static const char *skip_json(const char *at, int depth);

static const char *skip_blank(const char *at) {
  while (*at == ' ' || *at == '\n') at++;
  return at;
}

static const char *skip_string(const char *at) {
  if (*at++ != '"') return NULL;
  while (*at && *at != '"' && *at != '\\') at++;
  return *at == '"' ? at + 1 : NULL;
}

static const char *skip_number(const char *at) {
  const char *start = at += *at == '-';
  if (!isdigit((unsigned char)*at)) return NULL;
  while (isdigit((unsigned char)*at)) at++;
  if (*start == '0' && at > start + 1) return NULL;
  if (*at == '.') {
    if (!isdigit((unsigned char)*++at)) return NULL;
    while (isdigit((unsigned char)*at)) at++;
  }
  if (*at != 'e' && *at != 'E') return at;
  at++;
  at += *at == '+' || *at == '-';
  if (!isdigit((unsigned char)*at)) return NULL;
  while (isdigit((unsigned char)*at)) at++;
  return at;
}

static const char *skip_list(const char *at, int depth) {
  char close = *at == '[' ? ']' : '}';
  at = skip_blank(at + 1);
  if (*at == close) return at + 1;
  for (;;) {
    if (close == '}') {
      at = skip_string(skip_blank(at));
      if (!at || *(at = skip_blank(at)) != ':') return NULL;
      at++;
    }
    at = skip_json(at, depth + 1);
    if (!at) return NULL;
    at = skip_blank(at);
    if (*at == close) return at + 1;
    if (*at++ != ',') return NULL;
  }
}

static const char *skip_json(const char *at, int depth) {
  at = skip_blank(at);
  if (depth > 20) return NULL;
  if (*at == '[' || *at == '{') return skip_list(at, depth);
  if (*at == '"') return skip_string(at);
  if (strncmp(at, "true", 4) == 0) return at + 4;
  if (strncmp(at, "false", 5) == 0) return at + 5;
  return skip_number(at);
}

static const char *check_json(const File *f) {
  const char *end = skip_json((const char *)f->bytes, 0);
  return end && skip_blank(end) == (const char *)f->bytes + f->size ? NULL : "is no JSON";
}

// Tags that close in the order in which they opened, attributes in quotes, numbers that are finite.
static const char *check_svg(const File *f) {
  const char *open[16];
  int depth = 0;
  const char *text = (const char *)f->bytes;
  if (strstr(text, "nan") || strstr(text, "inf")) return "has numbers that are not finite";
  for (const char *at = strchr(text, '<'); at; at = strchr(at, '<')) {
    const char *name = at[1] == '/' ? at + 2 : at + 1;
    size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyz");
    const char *end = strchr(at, '>');
    if (!end || !length) return "has a tag that does not end";
    if (name[-1] == '/') {
      if (!depth || strncmp(open[--depth], name, length)) return "closes another tag than it opened";
    } else if (end[-1] != '/') {
      if (depth == 16) return "nests too deep";
      open[depth++] = name;
    }
    at = end;
  }
  return depth ? "has a tag that is not closed" : NULL;
}

static const char *check_pdf(const File *f) {
  PdfFile pdf;
  const char *why = pdf_read(&pdf, f->bytes, f->size);
  free(pdf.content);
  return why;
}

static const char *check_png(const File *f) {
  png_image image = {.version = PNG_IMAGE_VERSION};
  if (!png_image_begin_read_from_memory(&image, f->bytes, f->size)) return "is no PNG";
  image.format = PNG_FORMAT_RGBA;
  void *pixels = malloc(PNG_IMAGE_SIZE(image));
  bool well = png_image_finish_read(&image, NULL, pixels, 0, NULL);
  free(pixels);
  return well ? NULL : "has no pixels";
}

static uint32_t number(const uint8_t *at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

// Places and normals of so many vertices, all of `stride` bytes.
static const char *check_floats(const uint8_t *at, size_t count, size_t stride) {
  for (size_t i = 0; i < count; i++, at += stride) {
    float v[6];
    memcpy(v, at, sizeof v);
    for (int k = 0; k < 6; k++)
      if (!isfinite(v[k])) return "has places that are not finite";
    if (!(fabsf(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] - 1) < 1e-4f)) return "has normals that are no unit vectors";
  }
  return NULL;
}

static size_t element(const char *head, const char *name) {
  char line[64];
  snprintf(line, sizeof line, "element %s ", name);
  const char *at = strstr(head, line);
  return at ? strtoul(at + strlen(line), NULL, 10) : 0;
}

static const char *check_ply(const File *f) {
  const char *head = (const char *)f->bytes, *end = strstr(head, "end_header\n");
  if (strncmp(head, "ply\n", 4) || !end) return "is no PLY";
  size_t vertices = element(head, "vertex"), faces = element(head, "face"), edges = element(head, "edge");
  const uint8_t *at = (const uint8_t *)end + 11;
  if (f->bytes + f->size != at + 27 * vertices + 13 * faces + 8 * edges) return "has another size than its head says";
  const uint8_t *face = at + 27 * vertices;
  for (size_t i = 0; i < faces; i++, face += 13)
    for (int k = 0; k < 3; k++)
      if (number(face + 1 + 4 * k) >= vertices) return "has a face without its vertices";
  for (size_t i = 0; i < 2 * edges; i++)
    if (number(face + 4 * i) >= vertices) return "has an edge without its vertices";
  return check_floats(at, vertices, 27);
}

static const char *check_glb(const File *f) {
  if (f->size < 20 || number(f->bytes) != 0x46546c67 || number(f->bytes + 8) != f->size) return "is no GLB";
  uint32_t json = number(f->bytes + 12);
  if (json % 4 || 20 + (size_t)json > f->size) return "has no JSON";
  char *text = strndup((const char *)f->bytes + 20, json);
  const char *end = skip_json(text, 0);
  bool well = end && *skip_blank(end) == 0;
  const char *count = strstr(text, "\"count\":");
  size_t vertices = count ? strtoul(count + 8, NULL, 10) : 0;
  free(text);
  if (!well) return "has a head that is no JSON";
  return vertices ? check_floats(f->bytes + 28 + json, vertices, 28) : NULL;
}

static const char *check_obj(const File *f) {
  unsigned long vertices = 0;
  for (const char *at = (const char *)f->bytes; *at; at = strchr(at, '\n') + 1) {
    double x[3];
    unsigned long v[3], n[3];
    if (!strchr(at, '\n')) return "ends within a line";
    if (strncmp(at, "v ", 2) == 0) {
      vertices++;
      if (sscanf(at + 2, "%lf %lf %lf", &x[0], &x[1], &x[2]) != 3 || !isfinite(x[0] + x[1] + x[2]))
        return "has odd places";
    } else if (strncmp(at, "f ", 2) == 0) {
      if (sscanf(at + 2, "%lu//%lu %lu//%lu %lu//%lu", &v[0], &n[0], &v[1], &n[1], &v[2], &n[2]) != 6)
        return "has odd faces";
      for (int i = 0; i < 3; i++)
        if (v[i] < 1 || v[i] > vertices || n[i] != v[i]) return "has a face without its vertices";
    } else if (strncmp(at, "l ", 2) == 0) {
      if (sscanf(at + 2, "%lu %lu", &v[0], &v[1]) != 2 || v[0] > vertices || v[1] > vertices) return "has odd lines";
    }
  }
  return NULL;
}

// ---- runs ----------------------------------------------------------------

static void init(LsysRun *run, const uint8_t *given) {
  (void)given;
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) run->value[i] = lsys_settings[i].value;
  run->value[LSYS_SETTING_ANGLE] = run->root % 3 ? 25 : 90;
  run->value[LSYS_SETTING_WIDTH] = run->root % 5 ? 1 : 0;
}

typedef struct Format {
  const char *path;
  const char *(*check)(const File *f);
  const char *options[4];
} Format;

static const Format formats[] = {
  {"fuzz.svg", check_svg, {NULL}},
  {"fuzz.svg", check_svg, {"--colour-by", "progress", NULL}},
  {"fuzz.svg", check_svg, {"--projection", "perspective", NULL}},
  {"fuzz.pdf", check_pdf, {NULL}},
  {"fuzz.pdf", check_pdf, {"--projection=perspective", NULL}},
  {"fuzz.png", check_png, {"--size", "60x40", NULL}},
  {"fuzz.png", check_png, {"--size", "70", "--camera=20,30", NULL}},
  {"fuzz.png", check_png, {"--size", "9x90", "--background=transparent", NULL}},
  {"fuzz.obj", check_obj, {NULL}},
  {"fuzz.ply", check_ply, {NULL}},
  {"fuzz.ply", check_ply, {"--sides", "5", "--colour-by=order", NULL}},
  {"fuzz.glb", check_glb, {NULL}},
  {"fuzz.glb", check_glb, {"--sides=3", "--colour-by=kind", NULL}},
  {"fuzz.json", check_json, {NULL}},
};

// The exit status of a program that draws the word.
static int run(const LsysGrammar *grammar, const Format *format) {
  const char *argv[12] = {"fuzz", "--quiet", "-n", "0", "-o", format->path};
  int argc = 6;
  for (int i = 0; i < 4 && format->options[i]; i++) argv[argc++] = format->options[i];
  fflush(stderr);
  int kept = dup(STDERR_FILENO), nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDERR_FILENO);
  int status = lsys_main(grammar, argc, (char **)argv);
  fflush(stderr);
  dup2(kept, STDERR_FILENO);
  close(kept);
  close(nowhere);
  return status;
}

// Returns how many formats could show it.
static unsigned draw_word(uint64_t seed, const char *text) {
  unsigned shown = 0;
  Sample *s = sample(text, 90);
  LsysAxiom axiom = {s->word};
  s->grammar.abi_version = LSYS_ABI_VERSION;
  s->grammar.axioms = &axiom;
  s->grammar.value_count = LSYS_SETTING_COUNT;
  s->grammar.seed = seed;
  s->grammar.room_sym = 1;
  s->grammar.init = init;
  for (uint32_t i = 0; i < s->grammar.kind_count; i++) s->kind[i].flags = LSYS_KIND_TERMINAL;
  for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
    int status = run(&s->grammar, &formats[i]);
    shown += status == 0;
    File f = read_file(formats[i].path);
    if (status == 0 && !f.bytes) f.why = "is not there";
    if (status && f.bytes) f.why = "is there after an error";
    if (status == 0 && !f.why) f.why = formats[i].check(&f);
    free(f.bytes);
    if (f.why)
      fail_msg("word %llu, %s (%s) %s: %s", (unsigned long long)seed, formats[i].path,
               formats[i].options[0] ? formats[i].options[0] : "", f.why, text);
  }
  unlink("fuzz.mtl");
  sample_release(s);
  return shown;
}

static void files_parse(void **state) {
  (void)state;
  const char *more = getenv("TURTLE_FUZZ");
  uint64_t words = more ? strtoull(more, NULL, 10) : WORDS, shown = 0;
  for (uint64_t seed = 0; seed < words; seed++) {
    char text[LONGEST * 200];
    make_word(seed, text);
    shown += draw_word(seed, text);
  }
  assert_true(shown > words * (sizeof formats / sizeof *formats) / 2);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(files_parse)};
  return cmocka_run_group_tests_name("format fuzz", tests, NULL, NULL);
}
