// svg.c -- a canvas that streams SVG: a group for each ink, in it paths of
// connected points, written relative to each other in whole parts of a pixel.
// Source: SVG 1.1, sections 8.3 (path data) and 11 (painting).
#include "core/message.h"
#include "core/out.h"
#include "sinks/film.h"
#include "sinks/picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  PATH_POINTS = 4096,  // a path of more is split: viewers work path by path
  NUMBER_ROOM = 24,    // characters that a coordinate takes at most
};

typedef struct Svg {
  LsysCanvas canvas;
  LsysOut *out;
  LsysFilm *film;  // animated; NULL: one picture
  int decimals;
  double parts;  // of a pixel: 10^decimals
  bool group, path;
  LsysInk ink;      // of the open group
  int64_t x, y;     // the last point written, in parts
  uint32_t points;  // in the open path
} Svg;

// Writes parts/10^decimals without trailing zeros: "-12.5". Returns the end.
static char *put_number(char *to, int64_t parts, int decimals) {
  if (parts < 0) {
    *to++ = '-';
    parts = -parts;
  }
  if (parts == 0) {
    *to++ = '0';
    return to;
  }
  while (decimals && parts % 10 == 0) {
    parts /= 10;
    decimals--;
  }
  char digits[NUMBER_ROOM], *d = digits;
  for (; parts || decimals > 0; parts /= 10) {
    *d++ = (char)('0' + parts % 10);
    if (--decimals == 0) *d++ = '.';
  }
  while (d > digits) *to++ = *--d;
  return to;
}

static bool end_path(Svg *s) {
  if (!s->path) return true;
  s->path = false;
  return lsys_out_write(s->out, "\"/>\n", 4);
}

static bool end_group(Svg *s) {
  if (!end_path(s)) return false;
  if (!s->group) return true;
  s->group = false;
  return lsys_out_write(s->out, "</g>\n", 5);
}

static bool begin_group(Svg *s, const LsysInk *ink) {
  if (s->group && ink->rgb == s->ink.rgb && ink->width == s->ink.width) return true;
  if (!end_group(s)) return false;
  s->group = true;
  s->ink = *ink;
  return lsys_out_print(s->out, "<g stroke=\"#%06x\" stroke-width=\"%.3g\">\n", ink->rgb, ink->width);
}

static int64_t in_parts(const Svg *s, double pixels) {
  return (int64_t)llrint(pixels * s->parts);
}

static char *put_pair(const Svg *s, char *to, int64_t x, int64_t y) {
  to = put_number(to, x, s->decimals);
  if (y >= 0) *to++ = ' ';
  return put_number(to, y, s->decimals);
}

// A group that is seen for its part of the film, the last step for three parts, over and over.
static bool begin_frame(Svg *s) {
  const LsysFilm *film = s->film;
  double parts = (double)film->steps + 3, from = (double)film->step / parts;
  double to = film->step == film->steps ? 1 : ((double)film->step + 1) / parts;
  bool first = film->step == 0, last = film->step == film->steps;
  lsys_out_print(s->out,
                 "<g visibility=\"hidden\"><animate attributeName=\"visibility\" calcMode=\"discrete\" "
                 "repeatCount=\"indefinite\" dur=\"%gs\" values=\"%svisible%s\" keyTimes=\"0",
                 parts * film->seconds, first ? "" : "hidden;", last ? "" : ";hidden");
  if (!first) lsys_out_print(s->out, ";%.6g", from);
  if (!last) lsys_out_print(s->out, ";%.6g", to);
  return lsys_out_print(s->out, "\"/>\n");
}

static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  Svg *s = (Svg *)canvas;
  // A hundredth of a pixel, finer where segments are that short.
  s->decimals = page->detail >= 1 ? 2 : page->detail >= 0.1 ? 3 : 4;
  s->parts = pow(10, s->decimals);
  if (s->film && s->film->begun) return begin_frame(s);
  lsys_out_print(s->out,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%u\" height=\"%u\" viewBox=\"0 0 %u %u\">\n",
                 page->width, page->height, page->width, page->height);
  if (!page->transparent)
    lsys_out_print(s->out, "<rect width=\"%u\" height=\"%u\" fill=\"#%06x\"/>\n", page->width, page->height,
                   page->background);
  lsys_out_print(s->out, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"%s>\n",
                 page->antialias ? "" : " shape-rendering=\"crispEdges\"");
  if (!s->film) return lsys_out_write(s->out, "", 0);
  s->film->begun = true;
  return begin_frame(s);
}

static bool begin_path(Svg *s, const LsysPoint *p) {
  if (s->points >= PATH_POINTS && !end_path(s)) return false;
  int64_t x = in_parts(s, p->x), y = in_parts(s, p->y);
  char *room = lsys_out_room(s->out, 64 + 2 * NUMBER_ROOM), *to = room;
  if (s->path) {
    *to++ = 'm';
    to = put_pair(s, to, x - s->x, y - s->y);
  } else {
    to += sprintf(to, "<path d=\"M");
    to = put_pair(s, to, x, y);
    s->points = 0;
  }
  lsys_out_filled(s->out, (size_t)(to - room));
  s->path = true;
  s->x = x;
  s->y = y;
  return true;
}

static char *put_step(Svg *s, char *to, const LsysPoint *p) {
  int64_t x = in_parts(s, p->x), y = in_parts(s, p->y), dx = x - s->x, dy = y - s->y;
  s->x = x;
  s->y = y;
  if (dy == 0) {
    *to++ = 'h';
    return put_number(to, dx, s->decimals);
  }
  if (dx == 0) {
    *to++ = 'v';
    return put_number(to, dy, s->decimals);
  }
  *to++ = 'l';
  return put_pair(s, to, dx, dy);
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  Svg *s = (Svg *)canvas;
  if (!begin_group(s, ink)) return false;
  bool goes_on =
    joined && s->path && s->points < PATH_POINTS && in_parts(s, point->x) == s->x && in_parts(s, point->y) == s->y;
  if (!goes_on && !begin_path(s, point)) return false;
  for (size_t i = 1; i < count; i++) {
    char *room = lsys_out_room(s->out, 2 + 2 * NUMBER_ROOM);
    lsys_out_filled(s->out, (size_t)(put_step(s, room, &point[i]) - room));
  }
  s->points += (uint32_t)count;
  return true;
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  (void)normal;
  Svg *s = (Svg *)canvas;
  if (!end_group(s)) return false;
  lsys_out_print(s->out, "<path fill=\"#%06x\" d=\"M", rgb);
  for (size_t i = 0; i < count; i++) {
    char *room = lsys_out_room(s->out, 2 + 2 * NUMBER_ROOM), *to = room;
    if (i) {
      to = put_step(s, to, &point[i]);
    } else {
      s->x = in_parts(s, point->x);
      s->y = in_parts(s, point->y);
      to = put_pair(s, to, s->x, s->y);
    }
    lsys_out_filled(s->out, (size_t)(to - room));
  }
  return lsys_out_print(s->out, "z\"/>\n");
}

static bool close_page(LsysCanvas *canvas) {
  Svg *s = (Svg *)canvas;
  if (!end_group(s)) return false;
  if (s->film && !lsys_out_print(s->out, "</g>\n")) return false;
  return (s->film && s->film->step > 0) || lsys_out_print(s->out, "</g>\n</svg>\n");
}

static void destroy(LsysCanvas *canvas) {
  free(canvas);
}

LsysSink *lsys_svg_create(LsysOut *out, const LsysPictureOptions *options) {
  Svg *s = calloc(1, sizeof *s);
  if (!s) {
    lsys_error("out of memory");
    return NULL;
  }
  s->canvas = (LsysCanvas){NULL, open_page, line, fill, close_page, destroy};
  s->out = out;
  if (options->film && options->film->animate) s->film = options->film;
  LsysCanvas *canvas = lsys_canvas_sorted(&s->canvas);
  return canvas ? lsys_picture_create(canvas, options) : NULL;
}
