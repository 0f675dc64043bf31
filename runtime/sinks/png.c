// png.c -- a canvas of pixels that becomes a PNG file when it is closed.
#include "core/memory.h"
#include "core/message.h"
#include "core/out.h"
#include "sinks/raster.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

typedef struct Png {
  LsysCanvas canvas;
  LsysOut *out;
  LsysPage page;
  LsysRaster *raster;
} Png;

static bool reserve(LsysCanvas *canvas, const LsysPage *page) {
  Png *p = (Png *)canvas;
  p->page = *page;
  p->raster = page->solid ? lsys_raster_solid(page) : lsys_raster_flat(page);
  return p->raster != NULL;
}

// Of the size that was reserved, if one was.
static bool open_page(LsysCanvas *canvas, const LsysPage *page) {
  return ((Png *)canvas)->raster || reserve(canvas, page);
}

static bool line(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined) {
  (void)joined;
  LsysRaster *raster = ((Png *)canvas)->raster;
  raster->line(raster, point, count, ink);
  return true;
}

static bool fill(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb) {
  LsysRaster *raster = ((Png *)canvas)->raster;
  return raster->fill(raster, point, normal, count, rgb);
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
  for (uint32_t x = 0; x < width; x++) memmove(row + 3 * (size_t)x, row + 4 * (size_t)x, 3);
}

static void write_rows(png_structp png, const Png *p, uint8_t *row) {
  for (uint32_t y = 0; y < p->page.height; y++) {
    p->raster->row(p->raster, y, row);
    if (!p->page.transparent) drop_alpha(row, p->page.width);
    png_write_row(png, row);
  }
}

static bool write_file(png_structp png, png_infop info, const Png *p, uint8_t *row) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, p->out, write_bytes, flush_bytes);
  png_set_IHDR(png, info, p->page.width, p->page.height, 8,
               p->page.transparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE | PNG_FILTER_UP);
  png_write_info(png, info);
  write_rows(png, p, row);
  png_write_end(png, info);
  return true;
}

static bool close_page(LsysCanvas *canvas) {
  Png *p = (Png *)canvas;
  uint8_t *row = lsys_memory_alloc(p->page.memory, p->page.width, 4);
  png_structp png = row ? png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, refuse, keep_quiet) : NULL;
  png_infop info = png ? png_create_info_struct(png) : NULL;
  bool ok = info && write_file(png, info, p, row);
  if (row && !info) lsys_error("out of memory");
  png_destroy_write_struct(&png, &info);
  lsys_memory_free(p->page.memory, row, p->page.width, 4);
  return ok;
}

static void destroy(LsysCanvas *canvas) {
  LsysRaster *raster = ((Png *)canvas)->raster;
  if (raster) raster->destroy(raster);
  free(canvas);
}

LsysSink *lsys_png_create(LsysOut *out, const LsysPictureOptions *options) {
  Png *p = calloc(1, sizeof *p);
  if (!p) {
    lsys_error("out of memory");
    return NULL;
  }
  p->canvas = (LsysCanvas){reserve, open_page, line, fill, close_page, destroy};
  p->out = out;
  return lsys_picture_create(&p->canvas, options);
}
