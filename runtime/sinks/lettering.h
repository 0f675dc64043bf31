// lettering.h -- texts written on a page.
#ifndef LSYS_SINKS_LETTERING_H
#define LSYS_SINKS_LETTERING_H

#include "sinks/picture.h"

// Writes a text, UTF-8, to the right of a place, its capitals of that height around it; more lines below. What would
// stand beyond the edges of the page is moved onto it, as far as there is room. False to stop.
bool lsys_lettering(LsysCanvas *canvas, const LsysPage *page, const char *text, LsysPoint at, double height,
                    uint32_t rgb);

#endif
