// pictures.c -- the picture formats as the command line asks for them: options
// to LsysPictureOptions.
#include "core/formats.h"
#include "core/message.h"
#include "sinks/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PIXELS = 65535 };

static bool read_side(const char **text, uint32_t *side) {
  char *end;
  unsigned long value = strtoul(*text, &end, 10);
  if (end == *text || value < 1 || value > MOST_PIXELS) return false;
  *side = (uint32_t)value;
  *text = end;
  return true;
}

// "800x600", or "800": a square.
static bool read_size(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  const char *at = value->text;
  bool well = *at != '-' && read_side(&at, &options->width);
  options->height = options->width;
  if (well && (*at == 'x' || *at == 'X')) {
    at++;
    well = *at != '-' && read_side(&at, &options->height);
  }
  if (well && *at == 0) return true;
  lsys_error("--size %s: a size is WIDTHxHEIGHT in pixels, from 1 to %d", value->text, MOST_PIXELS);
  return false;
}

static bool read_background(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  options->transparent = strcmp(value->text, "transparent") == 0;
  if (options->transparent || lsys_colour_read(value->text, strlen(value->text), &options->background)) return true;
  lsys_error("--background %s: a colour is #rrggbb, a name such as white or paper, or transparent", value->text);
  return false;
}

static bool read_antialias(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  bool on = strcmp(value->text, "on") == 0;
  if (!on && strcmp(value->text, "off")) {
    lsys_error("--antialias %s: it is on or off", value->text);
    return false;
  }
  options->antialias = on;
  return true;
}

static bool read_line_width(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  options->line_width = value->real;
  if (value->real > 0 && isfinite(value->real)) return true;
  lsys_error("--line-width %s: it is the width in pixels of a line of width 1, more than 0", value->text);
  return false;
}

static bool read_camera(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  char *end;
  options->azimuth = strtod(value->text, &end);
  bool well = end != value->text && *end == ',';
  const char *second = end + well;
  options->elevation = strtod(second, &end);
  well = well && end != second && *end == 0;
  if (well && isfinite(options->azimuth) && isfinite(options->elevation)) return true;
  lsys_error("--camera %s: it is two angles in degrees, AZIMUTH,ELEVATION, such as 30,20", value->text);
  return false;
}

static bool read_projection(const LsysOptionValue *value, LsysPictureOptions *options) {
  if (!value->given) return true;
  options->perspective = strcmp(value->text, "perspective") == 0;
  if (options->perspective || strcmp(value->text, "orthographic") == 0) return true;
  lsys_error("--projection %s: it is orthographic or perspective", value->text);
  return false;
}

bool lsys_picture_options(const LsysOptions *given, LsysPictureOptions *options) {
  *options = lsys_picture_defaults;
  return read_size(&given->at[LSYS_OPTION_PAGE_SIZE], options) && read_camera(&given->at[LSYS_OPTION_CAMERA], options)
      && read_projection(&given->at[LSYS_OPTION_PROJECTION], options)
      && read_background(&given->at[LSYS_OPTION_BACKGROUND], options)
      && read_antialias(&given->at[LSYS_OPTION_ANTIALIAS], options) && lsys_colours_read(given, &options->colours)
      && read_line_width(&given->at[LSYS_OPTION_LINE_WIDTH], options);
}

static LsysSink *make(const LsysSinkContext *context, LsysSink *create(LsysOut *, const LsysPictureOptions *)) {
  LsysPictureOptions options;
  if (!lsys_picture_options(context->options, &options)) return NULL;
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
