// png.c -- a canvas of pixels that becomes a PNG file when it is closed: bands of
// rows are filtered and packed on all threads.
// Source: PNG specification (ISO/IEC 15948), sections 9 (filters), 11 (chunks).
#include "core/memory.h"
#include "core/message.h"
#include "core/out.h"
#include "sinks/pack.h"
#include "sinks/press.h"
#include "sinks/stripes.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

typedef struct Png {
  LsysCanvas canvas;
  LsysOut *out;
  LsysPage page;
  LsysRaster *raster;
  LsysStripes *stripes;  // in which several threads draw lines; NULL: one does
  png_structp png;       // while the file is written
  uint32_t sum;          // of what was packed
} Png;

enum { BAND_BYTES = 1 << 18 };  // of pixels that are packed at once

// Rows from .. end-1.
typedef struct Band {
  uint32_t from, end;
} Band;

static bool reserve(LsysCanvas *canvas, const LsysPage *page) {
  Png *p = (Png *)canvas;
  p->page = *page;
  p->raster = page->solid ? lsys_raster_solid(page) : lsys_raster_flat(page);
  if (!p->raster || !p->raster->line_within || page->threads < 2) return p->raster != NULL;
  p->stripes = lsys_stripes_open(page, p->raster);
  return p->stripes != NULL;
}

// Of the size that was reserved, if one was.
static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  return ((Png *)canvas)->raster || reserve(canvas, page);
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  (void)joined;
  const Png *p = (const Png *)canvas;
  if (p->stripes) return lsys_stripes_add(p->stripes, point, count, ink);
  p->raster->line(p->raster, point, count, ink);
  return true;
}

// All lines until now are on the raster.
static bool draw(const Png *p) {
  return !p->stripes || lsys_stripes_draw(p->stripes);
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  const Png *p = (const Png *)canvas;
  return draw(p) && p->raster->fill(p->raster, point, normal, count, rgb);
}

static bool covered(const LsysCanvas *canvas, const LsysPoint *middle, double radius, const LsysInk *ink) {
  const LsysRaster *raster = ((const Png *)canvas)->raster;
  return raster->covered && draw((const Png *)canvas) && raster->covered(raster, middle, radius, ink);
}

// ---- the file ------------------------------------------------------------

static void write_bytes(png_structp png, png_bytep bytes, png_size_t size) {
  if (!lsys_out_write(png_get_io_ptr(png), bytes, size)) png_error(png, "");  // the message was printed
}

static void flush_bytes(png_structp png) {
  (void)png;
}

static void refuse(png_structp png, png_const_charp text) {
  if (*text) lsys_error("cannot write the PNG: %s", text);
  png_longjmp(png, 1);
}

static void keep_quiet(png_structp png, png_const_charp text) {
  (void)png;
  (void)text;
}

// An opaque picture has three bytes a pixel, a transparent one four.
static void drop_alpha(uint8_t *row, uint32_t width) {
  const uint8_t *from = row;
  for (uint8_t *end = row + 3 * (size_t)width; row < end; row += 3, from += 4) {
    row[0] = from[0];
    row[1] = from[1];
    row[2] = from[2];
  }
}

// So many bytes at a time.
enum { LANES = 16, MOST_SUMMED = 128 };
typedef uint8_t Bytes __attribute__((vector_size(LANES)));
typedef int8_t Signed __attribute__((vector_size(LANES)));
typedef uint16_t Shorts __attribute__((vector_size(LANES)));

static Bytes bytes_at(const uint8_t *at) {
  Bytes bytes;
  memcpy(&bytes, at, sizeof bytes);
  return bytes;
}

// The bytes as signed numbers, without their signs, added up.
static uint64_t magnitude(const uint8_t *at, size_t size) {
  uint64_t sum = 0;
  while (size >= LANES) {
    size_t n = size / LANES < MOST_SUMMED ? size / LANES : MOST_SUMMED;  // 16 bits hold their sums
    Shorts sums = {0};
    for (const uint8_t *end = at + n * LANES; at < end; at += LANES) {
      Bytes number = bytes_at(at), negative = (Bytes)((Signed)number < 0);
      Shorts positive = (Shorts)((number ^ negative) - negative);
      sums += (positive & 255) + (positive >> 8);
    }
    for (int i = 0; i < LANES / 2; i++) sum += sums[i];
    size -= n * LANES;
  }
  for (size_t i = 0; i < size; i++) sum += (uint64_t)abs((int8_t)at[i]);
  return sum;
}

static void subtract(uint8_t *to, const uint8_t *a, const uint8_t *b, size_t size) {
  size_t i = 0;
  for (; i + LANES <= size; i += LANES) {
    Bytes difference = bytes_at(a + i) - bytes_at(b + i);
    memcpy(to + i, &difference, sizeof difference);
  }
  for (; i < size; i++) to[i] = (uint8_t)(a[i] - b[i]);
}

// What the filter leaves of a row: itself, or what differs from the one above; whichever has the smaller numbers.
static void put_filtered(uint8_t *to, const uint8_t *row, const uint8_t *above, size_t size) {
  subtract(to + 1, row, above, size);
  bool up = magnitude(to + 1, size) < magnitude(row, size);
  *to = up ? PNG_FILTER_VALUE_UP : PNG_FILTER_VALUE_NONE;
  if (!up) memcpy(to + 1, row, size);
}

static size_t row_size(const Png *p) {
  return (size_t)p->page.width * (p->page.transparent ? 4 : 3);
}

static void read_row(const Png *p, uint32_t y, uint8_t *row) {
  p->raster->row(p->raster, y, row);
  if (!p->page.transparent) drop_alpha(row, p->page.width);
}

// Filters and packs a band of rows, on any thread. The scratch holds two rows of the raster and the filtered ones.
static bool put_band(const void *data, const void *block, size_t size, LsysPrepared *to) {
  (void)size;
  const Png *p = data;
  const Band *band = block;
  size_t filtered = row_size(p) + 1, room = (size_t)p->page.width * 4, rows = band->end - band->from;
  if (!lsys_memory_fit(to->memory, &to->scratch, &to->scratch_bytes, 2 * room + rows * filtered, 1)) return false;
  uint8_t *above = to->scratch, *row = above + room, *text = row + room, *at = text;
  if (band->from)
    read_row(p, band->from - 1, above);
  else
    memset(above, 0, room);
  for (uint32_t y = band->from; y < band->end; y++, at += filtered) {
    read_row(p, y, row);
    put_filtered(at, row, above, row_size(p));
    uint8_t *last = above;
    above = row;
    row = last;
  }
  return lsys_pack(text, (size_t)(at - text), to);
}

static bool write_chunk(png_structp png, const char *name, const void *bytes, size_t size) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_write_chunk(png, (png_const_bytep)name, bytes, size);
  return true;
}

static bool write_band(void *data, const LsysPrepared *packed) {
  Png *p = data;
  LsysPiece piece;
  memcpy(&piece, packed->data, sizeof piece);
  p->sum = lsys_pack_add(p->sum, &piece);
  return write_chunk(p->png, "IDAT", packed->data + sizeof piece, packed->used - sizeof piece);
}

static bool write_head(png_structp png, png_infop info, const Png *p) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, p->out, write_bytes, flush_bytes);
  png_set_IHDR(png, info, p->page.width, p->page.height, 8,
               p->page.transparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  return true;
}

static bool write_bands(const Png *p, LsysPress *press) {
  uint32_t rows = BAND_BYTES / (p->page.width * 4) + 1;
  for (uint32_t y = 0; y < p->page.height; y += rows) {
    Band *band = lsys_press_add(press, sizeof *band);
    if (!band) return false;
    *band = (Band){y, rows < p->page.height - y ? y + rows : p->page.height};
    if (!lsys_press_send(press)) return false;
  }
  return lsys_press_finish(press);
}

static bool write_file(Png *p, png_infop info) {
  p->sum = lsys_pack_begin();
  if (!write_head(p->png, info, p) || !write_chunk(p->png, "IDAT", LSYS_PACK_HEAD, LSYS_PACK_HEAD_SIZE)) return false;
  LsysPress *press = lsys_press_open(p->page.memory, p->page.threads, put_band, write_band, p);
  bool well = press && write_bands(p, press);
  lsys_press_close(press);
  uint8_t end[LSYS_PACK_END_SIZE];
  lsys_pack_end(p->sum, end);
  return well && write_chunk(p->png, "IDAT", end, sizeof end) && write_chunk(p->png, "IEND", NULL, 0);
}

static bool close_page(LsysCanvas *canvas) {
  Png *p = (Png *)canvas;
  if (!draw(p)) return false;
  p->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, refuse, keep_quiet);
  png_infop info = p->png ? png_create_info_struct(p->png) : NULL;
  bool ok = info && write_file(p, info);
  if (!info) lsys_error("out of memory");
  png_destroy_write_struct(&p->png, &info);
  return ok;
}

static void destroy(LsysCanvas *canvas) {
  LsysRaster *raster = ((Png *)canvas)->raster;
  lsys_stripes_close(((Png *)canvas)->stripes);
  if (raster) raster->destroy(raster);
  free(canvas);
}

LsysCanvas *lsys_png_canvas(LsysOut *out) {
  Png *p = calloc(1, sizeof *p);
  if (!p) {
    lsys_error("out of memory");
    return NULL;
  }
  p->canvas = (LsysCanvas){reserve, open_page, line, fill, close_page, destroy, covered};
  p->out = out;
  return &p->canvas;
}

LsysSink *lsys_png_create(LsysOut *out, const LsysPictureOptions *options) {
  LsysCanvas *canvas = lsys_png_canvas(out);
  return canvas ? lsys_picture_create(canvas, options) : NULL;
}
