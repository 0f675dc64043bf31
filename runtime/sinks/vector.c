// vector.c -- a canvas of inks and paths of connected points, in text that a
// format phrases. Connected lines of one ink become one path. What is drawn is
// collected in blocks, of which other threads may make text: no group and no
// path goes on from one into the next.
// Invariant: a path is open only in a group of one ink.
#include "sinks/vector.h"

#include "core/memory.h"
#include "core/message.h"
#include "lsys/number.h"
#include "sinks/press.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  BLOCK = 2048,    // segments of which text is made at once, so that no path is longer: viewers work path by path
  LONGEST = 1000,  // characters that are printed at once
};

// In a block, before its points.
typedef struct Item {
  double width;  // of a line; 0: a polygon
  uint32_t rgb;
  uint32_t joined;
  uint64_t count;
} Item;

typedef struct Place {
  double x, y;
} Place;

// ---- text ----------------------------------------------------------------

static bool keep(LsysPrepared *to, const char *text, size_t size) {
  char *at = lsys_prepared_room(to, size);
  if (!at) return false;
  memcpy(at, text, size);
  to->used += size;
  return true;
}

// Text between blocks.
static bool write_text(LsysVector *v) {
  if (!v->format->pack) return v->format->write(v, v->text, v->filled);
  LsysPrepared packed = {0};
  bool well = v->format->pack(v->text, v->filled, &packed) && v->format->write(v, packed.data, packed.used);
  lsys_memory_free(NULL, packed.data, packed.room, 1);
  return well;
}

static void flush(LsysVector *v) {
  if (!v->failed && v->filled) v->failed = !(v->to ? keep(v->to, v->text, v->filled) : write_text(v));
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
  if (parts < 0) *to++ = '-';
  uint64_t all = parts < 0 ? -(uint64_t)parts : (uint64_t)parts;
  // Constants, by which dividing is multiplying.
  uint64_t whole = v->decimals == 2 ? all / 100 : v->decimals == 3 ? all / 1000 : all / 10000;
  uint32_t pixel = v->decimals == 2 ? 100 : v->decimals == 3 ? 1000 : 10000, rest = (uint32_t)(all - whole * pixel);
  if (whole || !rest) to = lsys_whole_print(to, whole);
  if (!rest) return to;
  *to++ = '.';
  char *end = to + v->decimals;
  for (char *at = end; at > to; rest /= 10) *--at = (char)('0' + rest % 10);
  while (end[-1] == '0') end--;
  return end;
}

// ---- paths ---------------------------------------------------------------

static int64_t in_parts(const LsysVector *v, double pixels) {
  return (int64_t)llrint(pixels * v->parts);
}

typedef char *PutPlace(const LsysVector *v, char *to, int64_t x, int64_t y);

static void go(LsysVector *v, const Place *p, PutPlace *put_place) {
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

static void begin_path(LsysVector *v, const Place *p) {
  if (!v->path) put(v, v->format->begin_path);
  go(v, p, v->format->move);
  v->path = true;
}

static void put_line(LsysVector *v, const Item *line, const Place *point) {
  begin_group(v, &(LsysInk){line->width, line->rgb});
  bool goes_on = line->joined && v->path && in_parts(v, point->x) == v->x && in_parts(v, point->y) == v->y;
  if (!goes_on) begin_path(v, point);
  for (uint64_t i = 1; i < line->count; i++) go(v, &point[i], v->format->step);
}

static void put_fill(LsysVector *v, const Item *fill, const Place *point) {
  end_group(v);
  v->format->fill(v, fill->rgb);
  go(v, point, v->format->move);
  for (uint64_t i = 1; i < fill->count; i++) go(v, &point[i], v->format->step);
  put(v, v->format->end_fill);
}

// ---- blocks --------------------------------------------------------------

static bool put_text(const LsysVector *whole, const void *block, size_t size, LsysPrepared *to) {
  LsysVector v;
  v.format = whole->format;
  v.decimals = whole->decimals;
  v.parts = whole->parts;
  v.to = to;
  v.group = v.path = v.failed = false;
  v.filled = 0;
  for (const char *at = block, *end = at + size; at < end;) {
    const Item *item = (const Item *)(const void *)at;
    const Place *point = (const Place *)(const void *)(at + sizeof *item);
    (item->width > 0 ? put_line : put_fill)(&v, item, point);
    at = (const char *)(point + item->count);
  }
  end_group(&v);
  flush(&v);
  return !v.failed;
}

// Text that is packed is made in the thread's scratch.
static bool put_block(const void *data, const void *block, size_t size, LsysPrepared *to) {
  const LsysVector *v = data;
  if (!v->format->pack) return put_text(v, block, size, to);
  LsysPrepared text = {.memory = to->memory, .data = to->scratch, .room = to->scratch_bytes};
  bool well = put_text(v, block, size, &text);
  to->scratch = text.data;
  to->scratch_bytes = text.room;
  return well && v->format->pack(text.data, text.used, to);
}

static bool write_block(void *data, const LsysPrepared *text) {
  LsysVector *v = data;
  return v->format->write(v, text->data, text->used);
}

static bool add(LsysVector *v, const Item *item, const LsysPoint *point) {
  char *at = lsys_press_add(v->press, sizeof *item + item->count * sizeof(Place));
  if (!at) return false;
  memcpy(at, item, sizeof *item);
  Place *place = (Place *)(void *)(at + sizeof *item);
  for (uint64_t i = 0; i < item->count; i++) place[i] = (Place){point[i].x, point[i].y};
  return true;
}

// So much was drawn: where blocks end must not depend on how lines come in pieces.
static bool count_segments(LsysVector *v, size_t count) {
  if (count < BLOCK - v->segments) {
    v->segments += (uint32_t)count;
    return true;
  }
  v->segments = 0;
  return lsys_press_send(v->press);
}

// ---- the canvas ----------------------------------------------------------

static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  LsysVector *v = (LsysVector *)canvas;
  // A hundredth of a pixel, finer where segments are that short.
  v->decimals = page->detail >= 1 ? 2 : page->detail >= 0.1 ? 3 : 4;
  v->parts = pow(10, v->decimals);
  v->press = lsys_press_open(page->memory, page->threads, put_block, write_block, v);
  if (!v->press || !v->format->open(v, page)) return false;
  flush(v);
  return !v->failed;
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  LsysVector *v = (LsysVector *)canvas;
  for (size_t left = count - 1, n; left; left -= n, point += n, joined = true) {
    n = left < BLOCK - v->segments ? left : BLOCK - v->segments;
    if (!add(v, &(Item){ink->width, ink->rgb, joined, n + 1}, point) || !count_segments(v, n)) return false;
  }
  return true;
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  (void)normal;
  LsysVector *v = (LsysVector *)canvas;
  return !count || (add(v, &(Item){.rgb = rgb, .count = count}, point) && count_segments(v, count));
}

static bool close_page(LsysCanvas *canvas) {
  LsysVector *v = (LsysVector *)canvas;
  if (!lsys_press_finish(v->press) || !v->format->close(v)) return false;
  flush(v);
  return !v->failed;
}

static void destroy(LsysCanvas *canvas) {
  LsysVector *v = (LsysVector *)canvas;
  lsys_press_close(v->press);
  free(v);
}

LsysSink *lsys_vector_create(LsysVector *v, const LsysVectorFormat *format, LsysOut *out,
                             const LsysPictureOptions *options) {
  if (!v) {
    lsys_error("out of memory");
    return NULL;
  }
  v->canvas = (LsysCanvas){NULL, open_page, line, fill, close_page, destroy, NULL};
  v->format = format;
  v->out = out;
  LsysCanvas *canvas = lsys_canvas_sorted(&v->canvas);
  return canvas ? lsys_picture_create(canvas, options) : NULL;
}
