// colours.h -- palettes, and colours that follow from how a figure was drawn.
#ifndef LSYS_SINKS_COLOURS_H
#define LSYS_SINKS_COLOURS_H

#include "turtle/geometry.h"
#include "turtle/turtle.h"

typedef struct LsysPalette {
  uint32_t rgb[256];  // 0xRRGGBB of each index
} LsysPalette;

typedef enum LsysColourBy {
  LSYS_BY_PEN,       // the turtle's colour index
  LSYS_BY_PROGRESS,  // from red around the hues to red, from the first segment to the last
  LSYS_BY_ORDER,     // how many brackets are open
  LSYS_BY_KIND,      // the module that draws; where all are alike, the last module that the turtle ignores
} LsysColourBy;

typedef struct LsysColours {
  LsysColourBy by;
  const char *list;  // colours of the first indices, separated by commas, instead of the palette's own; NULL
} LsysColours;

// The palette for a way of colouring. solid: things in the light, whose ink is lighter. The list was read before.
void lsys_palette_make(LsysPalette *palette, const LsysColours *colours, bool solid);

struct LsysOptions;
// --colour-by and --palette. False after printing what is wrong.
bool lsys_colours_read(const struct LsysOptions *given, LsysColours *colours);

// "#rrggbb", "#rgb" or a name. False if it is none.
bool lsys_colour_read(const char *text, size_t length, uint32_t *rgb);

// True if every part of the list is a colour and there are no more than 256.
bool lsys_colours_list(const char *list);

// Gives segments and polygons the colours that they are to have and hands them on.
typedef struct LsysRecolour {
  LsysGeometry geometry;  // what the turtle draws to
  LsysGeometry *next;
  LsysColourBy by;
  uint64_t total, drawn;  // segments in all, and up to now
} LsysRecolour;

// Where a turtle draws to so that `next` gets the colours; asks the turtle for what it needs.
LsysGeometry *lsys_recolour_begin(LsysRecolour *recolour, const LsysColours *colours, uint64_t segments,
                                  LsysTurtle *turtle, LsysGeometry *next);

#endif
