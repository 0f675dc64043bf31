// layout.h -- figures on a page: measured boxes in, scale and places out.
#ifndef LSYS_SINKS_LAYOUT_H
#define LSYS_SINKS_LAYOUT_H

#include "sinks/picture.h"
#include "turtle/measure.h"

// Where a figure lies: a point p is at (x + p.x * scale, y - p.y * scale) on the page.
typedef struct LsysFigure {
  bool drawn;
  uint64_t segments;
  LsysVec3 low, high;  // its box, in the coordinates that the page shows
  double x, y;
} LsysFigure;

typedef struct LsysLayout {
  LsysFigure *figure;  // of each start word
  uint32_t figures;
  uint64_t segments;  // of all figures
  double length, thinnest, thickest;
  double scale;  // pixels of a step
  double unit;   // pixels of a width of 1
} LsysLayout;

// Room for that many figures, none drawn. False after printing that memory ran out.
bool lsys_layout_create(LsysLayout *layout, uint32_t figures);
void lsys_layout_destroy(LsysLayout *layout);

// Takes in what one start word's figure measured. False after printing that it has no finite size.
bool lsys_layout_add(LsysLayout *layout, uint32_t which, const LsysMeasure *measure);

// Tells the user if no figure was drawn at all: an empty picture is hardly what was meant.
void lsys_layout_tell_empty(const LsysLayout *layout);

// What the options say of a page; the rest of it stays.
void lsys_layout_page(const LsysPictureOptions *options, LsysPage *page);

// What draws a width of so many pixels: 0 is still seen, and one that covers the page from any place is as good as any
// greater one.
LsysInk lsys_layout_ink(const LsysPage *page, double pixels, uint32_t rgb);

// Fits the figures side by side, their feet on one line, to a page, of the options' size or
// of one that suits them.
void lsys_layout_fit(LsysLayout *layout, const LsysPictureOptions *options, LsysPage *page);

#endif
