// colour.c -- text to a colour.
#include "lsys/colour.h"

#include <string.h>

typedef struct NamedColour {
  const char *name;
  uint32_t rgb;
} NamedColour;

static const NamedColour named[] = {
#define COLOUR(name, rgb) {#name, rgb},
#include "lsys/colours.def"
};

// The value of a hexadecimal digit, 16 of anything else.
static uint32_t digit(char c) {
  if (c >= '0' && c <= '9') return (uint32_t)(c - '0');
  if (c >= 'a' && c <= 'f') return (uint32_t)(c - 'a') + 10;
  return c >= 'A' && c <= 'F' ? (uint32_t)(c - 'A') + 10 : 16;
}

bool lsys_colour_read(const char *text, size_t length, uint32_t *rgb) {
  for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
    if (strlen(named[i].name) == length && strncmp(named[i].name, text, length) == 0) {
      *rgb = named[i].rgb;
      return true;
    }
  }
  if ((length != 7 && length != 4) || *text != '#') return false;
  uint32_t value = 0;
  for (size_t i = 1; i < length; i++) {
    uint32_t one = digit(text[i]);
    if (one == 16) return false;
    value = value << 4 | one;
    if (length == 4) value = value << 4 | one;
  }
  *rgb = value;
  return true;
}
