// colours.h -- palettes, and colours that follow from how a figure was drawn.
#ifndef LSYS_SINKS_COLOURS_H
#define LSYS_SINKS_COLOURS_H

#include "lsys/colour.h"
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
  LSYS_BY_AGE,       // the step in which the module that draws was born
} LsysColourBy;

typedef struct LsysColours {
  LsysColourBy by;
  const char *list;  // colours of the first indices, separated by commas, instead of the palette's own; NULL
} LsysColours;

// The palette for a way of colouring: of the list, which was read before, or of the grammar's `colours:` (NULL: no
// grammar), and then its own. By progress and by age the list's colours are the stops of a ramp. solid: things in the
// light, whose ink is lighter.
void lsys_palette_make(LsysPalette *palette, const LsysColours *colours, const LsysGrammar *grammar, bool solid);

struct LsysOptions;
// --colour-by and --palette. False after printing what is wrong.
bool lsys_colours_read(const struct LsysOptions *given, LsysColours *colours);

// True if every part of the list is a colour and there are no more than 256.
bool lsys_colours_list(const char *list);

// Gives segments and polygons the colours that they are to have and hands them on.
typedef struct LsysRecolour {
  LsysGeometry geometry;  // what the turtle draws to
  LsysGeometry *next;
  LsysColourBy by;
  uint64_t total, drawn;  // segments in all, and up to now; by age: steps
} LsysRecolour;

// Where a turtle draws to so that `next` gets the colours of a figure of so many segments, derived in so many steps;
// asks the turtle for what it needs.
LsysGeometry *lsys_recolour_begin(LsysRecolour *recolour, const LsysColours *colours, uint64_t segments, uint64_t steps,
                                  LsysTurtle *turtle, LsysGeometry *next);

#endif
