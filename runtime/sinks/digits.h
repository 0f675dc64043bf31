// digits.h -- numbers written on a page.
#ifndef LSYS_SINKS_DIGITS_H
#define LSYS_SINKS_DIGITS_H

#include "sinks/picture.h"

// Writes a number, as printf gives it, to the right of a place. False to stop.
bool lsys_digits(LsysCanvas *canvas, const char *text, LsysPoint at, double height, uint32_t rgb);

#endif
