// pdf.c -- a vector canvas that writes PDF: one page, whose content is
// compressed while it is drawn, piece by piece, on any thread; its length is an
// object behind it, so that nothing has to be kept. The same picture gives the
// same bytes: no date, no name. A pixel is 1/96 inch, as in SVG.
// Source: ISO 32000-1, sections 7.5 (file structure), 8.4 and 8.5 (graphics
// state, paths), 14.11.2 (page boundaries).
#include "core/message.h"
#include "sinks/pack.h"
#include "sinks/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  CATALOG = 1,
  PAGES,
  PAGE,
  CONTENT,
  LENGTH,
  OBJECTS,
};

static const double POINT = 0.75;                         // of a pixel: 72/96
static const double LONGEST_SIDE = 14400;                 // in units of the page; a longer one has bigger units
static const uint64_t MOST_BYTES = UINT64_C(9999999999);  // a place in the file has ten digits

typedef struct Pdf {
  LsysVector vector;
  uint32_t sum;    // of the content's text up to now
  uint64_t begin;  // of the file in the output
  uint64_t place[OBJECTS];
} Pdf;

static uint64_t here(const Pdf *p) {
  return lsys_out_size(p->vector.out) - p->begin;
}

static void begin_object(Pdf *p, int object) {
  p->place[object] = here(p);
  lsys_out_print(p->vector.out, "%d 0 obj\n", object);
}

static void put_page(Pdf *p, const LsysPage *page, double unit) {
  LsysOut *out = p->vector.out;
  begin_object(p, CATALOG);
  lsys_out_print(out, "<</Type/Catalog/Pages %d 0 R>>\nendobj\n", PAGES);
  begin_object(p, PAGES);
  lsys_out_print(out, "<</Type/Pages/Kids[%d 0 R]/Count 1>>\nendobj\n", PAGE);
  begin_object(p, PAGE);
  lsys_out_print(out, "<</Type/Page/Parent %d 0 R/MediaBox[0 0 %.9g %.9g]", PAGES, page->width * POINT / unit,
                 page->height * POINT / unit);
  if (unit > 1) lsys_out_print(out, "/UserUnit %g", unit);
  lsys_out_print(out, "/Resources<<>>/Contents %d 0 R>>\nendobj\n", CONTENT);
}

// A colour as three numbers; their third digit is finer than 1/255.
static void put_colour(LsysVector *vector, uint32_t rgb, const char *operator) {
  lsys_vector_print(vector, "%.3g %.3g %.3g %s\n", (rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0,
                    (rgb & 255) / 255.0, operator);
}

static bool open_page(LsysVector *vector, const LsysPage *page) {
  Pdf *p = (Pdf *)vector;
  p->begin = lsys_out_size(vector->out);
  double unit = fmax(ceil(fmax(page->width, page->height) * POINT / LONGEST_SIDE), 1);
  lsys_out_print(vector->out, "%%PDF-1.6\n%%\xe2\xe3\xcf\xd3\n");  // bytes over 127: a binary file
  put_page(p, page, unit);
  begin_object(p, CONTENT);
  lsys_out_print(vector->out, "<</Length %d 0 R/Filter/FlateDecode>>\nstream\n", LENGTH);
  p->place[LENGTH] = here(p);
  p->sum = lsys_pack_begin();
  lsys_out_write(vector->out, LSYS_PACK_HEAD, LSYS_PACK_HEAD_SIZE);
  // From here on places are pixels, y down; lines end and bend round.
  lsys_vector_print(vector, "%.9g 0 0 %.9g 0 %.9g cm\n1 J 1 j\n", POINT / unit, -POINT / unit,
                    page->height * POINT / unit);
  if (page->transparent) return true;
  put_colour(vector, page->background, "rg");
  return lsys_vector_print(vector, "0 0 %u %u re f\n", page->width, page->height);
}

static void set_ink(LsysVector *vector, const LsysInk *ink) {
  put_colour(vector, ink->rgb, "RG");
  lsys_vector_print(vector, "%.3f w\n", ink->width);
}

static void set_fill(LsysVector *vector, uint32_t rgb) {
  put_colour(vector, rgb, "rg");
}

static char *put_point(const LsysVector *vector, char *to, int64_t x, int64_t y, char operator) {
  to = lsys_vector_number(vector, to, x);
  *to++ = ' ';
  to = lsys_vector_number(vector, to, y);
  *to++ = ' ';
  *to++ = operator;
  *to++ = '\n';
  return to;
}

static char *put_move(const LsysVector *vector, char *to, int64_t x, int64_t y) {
  return put_point(vector, to, x, y, 'm');
}

static char *put_step(const LsysVector *vector, char *to, int64_t x, int64_t y) {
  return put_point(vector, to, x, y, 'l');
}

static bool pack(const void *text, size_t size, LsysPrepared *to) {
  if (size <= INT32_MAX) return lsys_pack(text, size, to);
  lsys_error("the picture has a polygon that does not fit a PDF; write an .svg");  // of 10^8 corners
  return false;
}

static bool write_piece(LsysVector *vector, const void *bytes, size_t size) {
  Pdf *p = (Pdf *)vector;
  LsysPiece piece;
  memcpy(&piece, bytes, sizeof piece);
  p->sum = lsys_pack_add(p->sum, &piece);
  return lsys_out_write(vector->out, (const char *)bytes + sizeof piece, size - sizeof piece);
}

static bool end_stream(const Pdf *p) {
  uint8_t end[LSYS_PACK_END_SIZE];
  lsys_pack_end(p->sum, end);
  return lsys_out_write(p->vector.out, end, sizeof end);
}

static bool close_page(LsysVector *vector) {
  Pdf *p = (Pdf *)vector;
  LsysOut *out = vector->out;
  if (!end_stream(p)) return false;
  uint64_t length = here(p) - p->place[LENGTH];
  lsys_out_print(out, "\nendstream\nendobj\n");
  begin_object(p, LENGTH);
  lsys_out_print(out, "%llu\nendobj\n", (unsigned long long)length);
  uint64_t table = here(p);
  if (table > MOST_BYTES) {
    lsys_error("the picture does not fit a PDF, which has at most 10^10 bytes; write an .svg");
    return false;
  }
  lsys_out_print(out, "xref\n0 %d\n0000000000 65535 f \n", OBJECTS);
  for (int i = 1; i < OBJECTS; i++) lsys_out_print(out, "%010llu 00000 n \n", (unsigned long long)p->place[i]);
  return lsys_out_print(out, "trailer\n<</Size %d/Root %d 0 R>>\nstartxref\n%llu\n%%%%EOF\n", OBJECTS, CATALOG,
                        (unsigned long long)table);
}

static const LsysVectorFormat format = {
  .open = open_page,
  .ink = set_ink,
  .end_ink = "",
  .begin_path = "",
  .end_path = "S\n",
  .fill = set_fill,
  .end_fill = "f\n",
  .move = put_move,
  .step = put_step,
  .close = close_page,
  .pack = pack,
  .write = write_piece,
};

LsysSink *lsys_pdf_create(LsysOut *out, const LsysPictureOptions *options) {
  Pdf *p = calloc(1, sizeof *p);
  return lsys_vector_create(p ? &p->vector : NULL, &format, out, options);
}
