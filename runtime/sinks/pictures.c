// pictures.c -- the picture formats as the command line and the grammar ask for
// them: texts to LsysPictureOptions. What the command line says counts first.
#include "core/formats.h"
#include "core/message.h"
#include "lsys/settings.h"
#include "sinks/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PIXELS = 65535 };

static bool read_side(const char **text, uint32_t *side) {
  char *end;
  unsigned long value = strtoul(*text, &end, 10);
  if (**text < '0' || **text > '9' || value < 1 || value > MOST_PIXELS) return false;
  *side = (uint32_t)value;
  *text = end;
  return true;
}

// "800x600", or "800": a square.
static bool read_size(const char *at, LsysPictureOptions *options) {
  if (!read_side(&at, &options->width)) return false;
  options->height = options->width;
  if (*at != 'x' && *at != 'X') return *at == 0;
  at++;
  return read_side(&at, &options->height) && *at == 0;
}

static bool read_background(const char *text, LsysPictureOptions *options) {
  options->transparent = strcmp(text, "transparent") == 0;
  return options->transparent || lsys_colour_read(text, strlen(text), &options->background);
}

static bool read_antialias(const char *text, LsysPictureOptions *options) {
  options->antialias = strcmp(text, "on") == 0;
  return options->antialias || strcmp(text, "off") == 0;
}

static bool read_line_width(const char *text, LsysPictureOptions *options) {
  options->line_width = strtod(text, NULL);
  return options->line_width > 0 && isfinite(options->line_width);
}

static bool read_camera(const char *text, LsysPictureOptions *options) {
  char *end;
  options->azimuth = strtod(text, &end);
  if (end == text || *end != ',') return false;
  const char *second = end + 1;
  options->elevation = strtod(second, &end);
  return end != second && *end == 0 && isfinite(options->azimuth) && isfinite(options->elevation);
}

static bool read_projection(const char *text, LsysPictureOptions *options) {
  options->perspective = strcmp(text, "perspective") == 0;
  return options->perspective || strcmp(text, "orthographic") == 0;
}

typedef struct Reader {
  bool (*read)(const char *text, LsysPictureOptions *options);
  const char *wanted;
} Reader;

// How the text of each option is read.
static const Reader readers[LSYS_OPTION_COUNT_] = {
  [LSYS_OPTION_PAGE_SIZE] = {read_size, "a size is WIDTHxHEIGHT in pixels, from 1 to 65535"},
  [LSYS_OPTION_CAMERA] = {read_camera, "it is two angles in degrees, AZIMUTH,ELEVATION, such as 30,20"},
  [LSYS_OPTION_PROJECTION] = {read_projection, "it is orthographic or perspective"},
  [LSYS_OPTION_BACKGROUND] = {read_background, "a colour is #rrggbb, a name such as white or paper, or transparent"},
  [LSYS_OPTION_ANTIALIAS] = {read_antialias, "it is on or off"},
  [LSYS_OPTION_LINE_WIDTH] = {read_line_width, "it is the width in pixels of a line of width 1, more than 0"},
};

// The option that says the same as a setting of the grammar.
static const LsysOption option_of[LSYS_PAGE_COUNT] = {
#define PAGE(id, keyword, others, form, option, doc) [LSYS_PAGE_##id] = LSYS_OPTION_##option,
#include "lsys/settings.def"
};

const char *lsys_page_wrong(LsysPageSetting setting, const char *text) {
  const Reader *reader = &readers[option_of[setting]];
  LsysPictureOptions options;
  return reader->read(text, &options) ? NULL : reader->wanted;
}

bool lsys_picture_options(const LsysOptions *given, const LsysGrammar *grammar, LsysPictureOptions *options) {
  *options = lsys_picture_defaults;
  for (int i = 0; i < LSYS_PAGE_COUNT && grammar->page; i++)
    if (grammar->page[i]) readers[option_of[i]].read(grammar->page[i], options);
  for (int i = 0; i < LSYS_OPTION_COUNT_; i++) {
    if (!readers[i].read || !given->at[i].given || readers[i].read(given->at[i].text, options)) continue;
    lsys_error("--%s %s: %s", lsys_options[i].name, given->at[i].text, readers[i].wanted);
    return false;
  }
  return lsys_colours_read(given, &options->colours);
}

static LsysSink *make(const LsysSinkContext *context, LsysSink *create(LsysOut *, const LsysPictureOptions *)) {
  LsysPictureOptions options;
  if (!lsys_picture_options(context->options, context->grammar, &options)) return NULL;
  options.film = context->film;
  return create(context->out, &options);
}

LsysSink *lsys_sink_svg(const LsysSinkContext *context) {
  return make(context, lsys_svg_create);
}

LsysSink *lsys_sink_pdf(const LsysSinkContext *context) {
  return make(context, lsys_pdf_create);
}

LsysSink *lsys_sink_png(const LsysSinkContext *context) {
  return make(context, lsys_png_create);
}
