// svg.c -- a vector canvas that writes SVG: a group for each ink, in it paths of
// connected points, written relative to each other.
// Source: SVG 1.1, sections 8.3 (path data) and 11 (painting).
#include "sinks/film.h"
#include "sinks/vector.h"

#include <stdlib.h>

typedef struct Svg {
  LsysVector vector;
  LsysFilm *film;  // animated; NULL: one picture
} Svg;

// A group that is seen for its part of the film, the last step for three parts, over and over.
static bool begin_frame(Svg *s) {
  const LsysFilm *film = s->film;
  double parts = (double)film->steps + 3, from = (double)film->step / parts;
  double to = film->step == film->steps ? 1 : ((double)film->step + 1) / parts;
  bool first = film->step == 0, last = film->step == film->steps;
  lsys_vector_print(&s->vector,
                    "<g visibility=\"hidden\"><animate attributeName=\"visibility\" calcMode=\"discrete\" "
                    "repeatCount=\"indefinite\" dur=\"%gs\" values=\"%svisible%s\" keyTimes=\"0",
                    parts * film->seconds, first ? "" : "hidden;", last ? "" : ";hidden");
  if (!first) lsys_vector_print(&s->vector, ";%.6g", from);
  if (!last) lsys_vector_print(&s->vector, ";%.6g", to);
  return lsys_vector_print(&s->vector, "\"/>\n");
}

static bool open_page(LsysVector *vector, const LsysPage *page) {
  Svg *s = (Svg *)vector;
  if (s->film && s->film->begun) return begin_frame(s);
  lsys_vector_print(vector,
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%u\" height=\"%u\" viewBox=\"0 0 %u %u\">\n",
                    page->width, page->height, page->width, page->height);
  if (!page->transparent)
    lsys_vector_print(vector, "<rect width=\"%u\" height=\"%u\" fill=\"#%06x\"/>\n", page->width, page->height,
                      page->background);
  bool well = lsys_vector_print(vector, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"%s>\n",
                                page->antialias ? "" : " shape-rendering=\"crispEdges\"");
  if (!s->film) return well;
  s->film->begun = true;
  return begin_frame(s);
}

static void set_ink(LsysVector *vector, const LsysInk *ink) {
  lsys_vector_print(vector, "<g stroke=\"#%06x\" stroke-width=\"%.3g\">\n", ink->rgb, ink->width);
}

static void set_fill(LsysVector *vector, uint32_t rgb) {
  lsys_vector_print(vector, "<path fill=\"#%06x\" d=\"", rgb);
}

static char *put_pair(const LsysVector *vector, char *to, int64_t x, int64_t y) {
  to = lsys_vector_number(vector, to, x);
  if (y >= 0) *to++ = ' ';
  return lsys_vector_number(vector, to, y);
}

static char *put_move(const LsysVector *vector, char *to, int64_t x, int64_t y) {
  *to++ = vector->path ? 'm' : 'M';
  return vector->path ? put_pair(vector, to, x - vector->x, y - vector->y) : put_pair(vector, to, x, y);
}

static char *put_step(const LsysVector *vector, char *to, int64_t x, int64_t y) {
  int64_t dx = x - vector->x, dy = y - vector->y;
  *to++ = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
  if (dy == 0) return lsys_vector_number(vector, to, dx);
  if (dx == 0) return lsys_vector_number(vector, to, dy);
  return put_pair(vector, to, dx, dy);
}

static bool close_page(LsysVector *vector) {
  const LsysFilm *film = ((Svg *)vector)->film;
  if (film && !lsys_vector_print(vector, "</g>\n")) return false;
  return (film && film->step > 0) || lsys_vector_print(vector, "</g>\n</svg>\n");
}

static bool write_text(LsysVector *vector, const void *text, size_t size) {
  return lsys_out_write(vector->out, text, size);
}

static const LsysVectorFormat format = {
  .open = open_page,
  .ink = set_ink,
  .end_ink = "</g>\n",
  .begin_path = "<path d=\"",
  .end_path = "\"/>\n",
  .fill = set_fill,
  .end_fill = "z\"/>\n",
  .move = put_move,
  .step = put_step,
  .close = close_page,
  .write = write_text,
};

LsysSink *lsys_svg_create(LsysOut *out, const LsysPictureOptions *options) {
  Svg *s = calloc(1, sizeof *s);
  if (s && options->film && options->film->animate) s->film = options->film;
  return lsys_vector_create(s ? &s->vector : NULL, &format, out, options);
}
