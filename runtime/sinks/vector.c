// vector.c -- a canvas of inks and paths of connected points, in text that a
// format phrases. Connected lines of one ink become one path.
// Invariant: a path is open only in a group of one ink.
#include "sinks/vector.h"

#include "core/message.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
  PATH_POINTS = 4096,  // a path of more is split: viewers work path by path
  LONGEST = 1000,      // characters that are printed at once
};

// ---- text ----------------------------------------------------------------

static void flush(LsysVector *v) {
  if (!v->failed && v->filled) v->failed = !v->format->write(v, v->text, v->filled);
  v->filled = 0;
}

static char *room(LsysVector *v, size_t size) {
  if (size > sizeof v->text - v->filled) flush(v);
  return v->text + v->filled;
}

static void put(LsysVector *v, const char *text) {
  size_t length = strlen(text);
  memcpy(room(v, length), text, length);
  v->filled += length;
}

bool lsys_vector_print(LsysVector *v, const char *format, ...) {
  va_list args;
  va_start(args, format);
  int length = vsnprintf(room(v, LONGEST), LONGEST, format, args);
  va_end(args);
  if (length >= 0 && length < LONGEST) v->filled += (size_t)length;
  return !v->failed;
}

char *lsys_vector_number(const LsysVector *v, char *to, int64_t parts) {
  int decimals = v->decimals;
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
  char digits[LSYS_VECTOR_NUMBER], *d = digits;
  for (; parts || decimals > 0; parts /= 10) {
    *d++ = (char)('0' + parts % 10);
    if (--decimals == 0) *d++ = '.';
  }
  while (d > digits) *to++ = *--d;
  return to;
}

// ---- paths ---------------------------------------------------------------

static int64_t in_parts(const LsysVector *v, double pixels) {
  return (int64_t)llrint(pixels * v->parts);
}

typedef char *PutPlace(const LsysVector *v, char *to, int64_t x, int64_t y);

static void go(LsysVector *v, const LsysPoint *p, PutPlace *put_place) {
  int64_t x = in_parts(v, p->x), y = in_parts(v, p->y);
  char *to = room(v, 2 * LSYS_VECTOR_NUMBER + 8);
  v->filled += (size_t)(put_place(v, to, x, y) - to);
  v->x = x;
  v->y = y;
}

static void end_path(LsysVector *v) {
  if (v->path) put(v, v->format->end_path);
  v->path = false;
}

static void end_group(LsysVector *v) {
  end_path(v);
  if (v->group) put(v, v->format->end_ink);
  v->group = false;
}

static void begin_group(LsysVector *v, const LsysInk *ink) {
  if (v->group && ink->rgb == v->ink.rgb && ink->width == v->ink.width) return;
  end_group(v);
  v->group = true;
  v->ink = *ink;
  v->format->ink(v, ink);
}

static void begin_path(LsysVector *v, const LsysPoint *p) {
  if (v->points >= PATH_POINTS) end_path(v);
  if (!v->path) {
    put(v, v->format->begin_path);
    v->points = 0;
  }
  go(v, p, v->format->move);
  v->path = true;
}

// ---- the canvas ----------------------------------------------------------

static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  LsysVector *v = (LsysVector *)canvas;
  // A hundredth of a pixel, finer where segments are that short.
  v->decimals = page->detail >= 1 ? 2 : page->detail >= 0.1 ? 3 : 4;
  v->parts = pow(10, v->decimals);
  return v->format->open(v, page) && !v->failed;
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  LsysVector *v = (LsysVector *)canvas;
  begin_group(v, ink);
  bool goes_on =
    joined && v->path && v->points < PATH_POINTS && in_parts(v, point->x) == v->x && in_parts(v, point->y) == v->y;
  if (!goes_on) begin_path(v, point);
  for (size_t i = 1; i < count; i++) go(v, &point[i], v->format->step);
  v->points += (uint32_t)count;
  return !v->failed;
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  (void)normal;
  LsysVector *v = (LsysVector *)canvas;
  end_group(v);
  v->format->fill(v, rgb);
  go(v, point, v->format->move);
  for (size_t i = 1; i < count; i++) go(v, &point[i], v->format->step);
  put(v, v->format->end_fill);
  return !v->failed;
}

static bool close_page(LsysCanvas *canvas) {
  LsysVector *v = (LsysVector *)canvas;
  end_group(v);
  flush(v);
  if (v->failed || !v->format->close(v)) return false;
  flush(v);
  return !v->failed;
}

static void destroy(LsysCanvas *canvas) {
  LsysVector *v = (LsysVector *)canvas;
  v->format->destroy(v);
}

LsysSink *lsys_vector_create(LsysVector *v, const LsysVectorFormat *format, LsysOut *out,
                             const LsysPictureOptions *options) {
  if (!v) {
    lsys_error("out of memory");
    return NULL;
  }
  v->canvas = (LsysCanvas){NULL, open_page, line, fill, close_page, destroy};
  v->format = format;
  v->out = out;
  LsysCanvas *canvas = lsys_canvas_sorted(&v->canvas);
  return canvas ? lsys_picture_create(canvas, options) : NULL;
}
