// picture.h -- figures on a page: a sink that measures the word's figures in a
// first pass, fits them side by side to a page, and draws them in a second one
// to a canvas (SVG, PDF, PNG) that knows pixels only.
#ifndef LSYS_SINKS_PICTURE_H
#define LSYS_SINKS_PICTURE_H

#include "sinks/colours.h"
#include "sinks/sink.h"

#include <stddef.h>

typedef struct LsysPictureOptions {
  uint32_t width, height;  // of the page in pixels; 0: the longer side 1000, the other as the figure asks
  double line_width;       // pixels of a width of 1; nan: chosen so that the figure looks well
  uint32_t background;     // 0xRRGGBB
  bool transparent;        // no background
  bool antialias;
  double azimuth,
    elevation;  // of the camera, in degrees; nan: from before, or a little from the side for figures in space
  bool perspective;
  LsysColours colours;
  struct LsysFilm *film;  // that it is a picture of; NULL
} LsysPictureOptions;

// 1000 pixels, white, anti-aliased.
extern const LsysPictureOptions lsys_picture_defaults;

struct LsysOptions;
// Reads the options of pictures, and what the grammar says where they are not given. False after printing what is
// wrong.
bool lsys_picture_options(const struct LsysOptions *given, const LsysGrammar *grammar, LsysPictureOptions *options);

// A place on the page in pixels: x to the right, y down, z towards the viewer.
typedef struct LsysPoint {
  double x, y, z;
} LsysPoint;

typedef struct LsysPage {
  uint32_t width, height;
  uint32_t background;
  bool transparent, antialias;
  bool solid;                 // figures have depth: what is nearer hides what is behind it, and light falls on it
  double detail;              // mean length of a segment in pixels
  struct LsysMemory *memory;  // that what is drawn is booked on; NULL: none
  unsigned threads;           // that may work for it; 0: one
} LsysPage;

typedef struct LsysInk {
  double width;  // in pixels, > 0
  uint32_t rgb;
} LsysInk;

typedef struct LsysCanvas LsysCanvas;

// What a picture format does. Each returns false to stop after printing an error.
struct LsysCanvas {
  // May be NULL: takes what a page of this size will need, before anything is measured.
  bool (*reserve)(LsysCanvas *canvas, const LsysPage *page);
  bool (*open)(LsysCanvas *canvas, const LsysPage *page);
  // count >= 2 connected points. joined: they go on from the last point of the line before.
  bool (*line)(LsysCanvas *canvas, const LsysPoint *point, size_t count, const LsysInk *ink, bool joined);
  // A filled polygon, non-zero winding. normal: one a point for smooth light, y up and z towards the viewer, or NULL.
  bool (*fill)(LsysCanvas *canvas, const LsysPoint *point, const LsysVec3 *normal, size_t count, uint32_t rgb);
  bool (*close)(LsysCanvas *canvas);
  void (*destroy)(LsysCanvas *canvas);
  // May be NULL: whether lines in this ink change nothing if all their points are that near to one.
  bool (*covered)(const LsysCanvas *canvas, const LsysPoint *middle, double radius, const LsysInk *ink);
};

// A sink of two passes that draws to canvas and destroys it in the end. NULL after printing why.
LsysSink *lsys_picture_create(LsysCanvas *canvas, const LsysPictureOptions *options);

// A canvas that draws figures in space, lit and from back to front, on one without depth, which it destroys in the
// end; other figures as they come. NULL after printing why.
LsysCanvas *lsys_canvas_sorted(LsysCanvas *inner);

// Sinks over an output; the output is not committed. NULL after printing why.
struct LsysOut;
LsysSink *lsys_svg_create(struct LsysOut *out, const LsysPictureOptions *options);
LsysSink *lsys_pdf_create(struct LsysOut *out, const LsysPictureOptions *options);
LsysSink *lsys_png_create(struct LsysOut *out, const LsysPictureOptions *options);

// The canvas of a PNG alone, which has `covered` where the page is not solid. NULL after printing why.
LsysCanvas *lsys_png_canvas(struct LsysOut *out);

#endif
