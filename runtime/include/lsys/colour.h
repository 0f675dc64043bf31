// colour.h -- colours as text: in grammars (`colours:`) and on command lines.
#ifndef LSYS_COLOUR_H
#define LSYS_COLOUR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LSYS_MOST_COLOURS = 256 };  // of a palette

// "#rrggbb", "#rgb" or a name of colours.def to 0xRRGGBB. False if it is none.
bool lsys_colour_read(const char *text, size_t length, uint32_t *rgb);

#endif
