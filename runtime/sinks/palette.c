// palette.c -- palettes, made of few colours each; and colours as text.
#include "sinks/colours.h"

#include <stdlib.h>
#include <string.h>

// Index 0 is an ink that suits curves and bark. From 1 on it goes from leaf green
// over light green and yellow to flower colours, since plants count upwards from
// the trunk; from 16 on hues go round in golden steps, so that neighbours differ.
static const uint32_t plant[16] = {
  0x41342a, 0x4d8b3c, 0x5f9e3f, 0x3f7f3f, 0x73ad48, 0x8bbb52, 0xa3c75c, 0xbcd067,
  0xd6d46c, 0xe9c25a, 0xe8a14b, 0xdf7d43, 0xd15b45, 0xb8436a, 0x8d4b94, 0x5a5fae,
};

static const uint32_t BARK = 0x8a6c52;  // index 0 in the light: a dark ink would hide the shades

// Red, blue, green, yellow, ...: as different as can be.
static const uint32_t distinct[12] = {
  0xd23b35, 0x2f6fc4, 0x3d9a46, 0xe8b62c, 0x8d4bb5, 0x25a3a8,
  0xe57f2e, 0xcf5a9b, 0x8a5a34, 0x7d8a2e, 0x6c7a86, 0x20406e,
};

// Around the hues and back: red, orange, yellow, green, blue, purple, red.
static const uint32_t rainbow[7] = {0xd62f2a, 0xec8a22, 0xe6c926, 0x37a24a, 0x2b63c6, 0x8a3fb0, 0xd62f2a};

// One channel of a colour of hue 0..6 (red, yellow, green, cyan, blue, magenta) with medium saturation.
static uint32_t channel(double hue) {
  while (hue >= 6) hue -= 6;
  double full = hue < 1 ? hue : hue < 3 ? 1 : hue < 4 ? 4 - hue : 0;
  return (uint32_t)(70 + 140 * full);
}

static uint32_t golden(int index) {
  double turn = index * 0.61803398874989485, hue = 6 * (turn - (int)turn);
  return channel(hue + 2) << 16 | channel(hue) << 8 | channel(hue + 4);
}

static uint32_t between(uint32_t a, uint32_t b, double t) {
  uint32_t rgb = 0;
  for (int shift = 0; shift < 24; shift += 8)
    rgb |= (uint32_t)((a >> shift & 255) * (1 - t) + (b >> shift & 255) * t + 0.5) << shift;
  return rgb;
}

static uint32_t own_colour(LsysColourBy by, int i, bool solid) {
  switch (by) {
  case LSYS_BY_PROGRESS: {
    double at = i * 6 / 255.0;
    int low = at < 6 ? (int)at : 5;
    return between(rainbow[low], rainbow[low + 1], at - low);
  }
  case LSYS_BY_ORDER:
  case LSYS_BY_KIND:
    return i < 12 ? distinct[i] : golden(i);
  case LSYS_BY_PEN:
    break;
  }
  if (i == 0 && solid) return BARK;
  return i < 16 ? plant[i] : golden(i);
}

void lsys_palette_make(LsysPalette *palette, const LsysColours *colours, bool solid) {
  for (int i = 0; i < 256; i++) palette->rgb[i] = own_colour(colours->by, i, solid);
  const char *at = colours->list;
  for (int i = 0; at && *at && i < 256; i++) {
    size_t length = strcspn(at, ",");
    lsys_colour_read(at, length, &palette->rgb[i]);
    at += length + (at[length] == ',');
  }
}

// ---- text ----------------------------------------------------------------

typedef struct NamedColour {
  const char *name;
  uint32_t rgb;
} NamedColour;

static const NamedColour named[] = {
  {"white", 0xffffff},  {"black", 0x000000}, {"grey", 0x808080},  {"gray", 0x808080},   {"paper", 0xfbf7ec},
  {"night", 0x10141c},  {"red", 0xc23b22},   {"green", 0x2e8b3d}, {"blue", 0x2d6cb5},   {"yellow", 0xf4d35e},
  {"orange", 0xe57f2e}, {"brown", 0x7a5533}, {"pink", 0xe58fb0},  {"purple", 0x8d4bb5},
};

bool lsys_colour_read(const char *text, size_t length, uint32_t *rgb) {
  for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
    if (strlen(named[i].name) == length && strncmp(named[i].name, text, length) == 0) {
      *rgb = named[i].rgb;
      return true;
    }
  }
  if (!length || *text != '#') return false;
  size_t digits = strspn(text + 1, "0123456789abcdefABCDEF");
  if (digits + 1 < length || (length != 7 && length != 4)) return false;
  uint32_t value = 0;
  for (size_t i = 1; i < length; i++) {
    char digit[2] = {text[i]};
    value = value << 4 | (uint32_t)strtoul(digit, NULL, 16);
  }
  *rgb = length == 7 ? value : (value & 0xf00) * 0x1100 | (value & 0xf0) * 0x110 | (value & 0xf) * 0x11;
  return true;
}

bool lsys_colours_list(const char *list) {
  int count = 0;
  for (;; count++) {
    size_t length = strcspn(list, ",");
    uint32_t rgb;
    if (count == 256 || !lsys_colour_read(list, length, &rgb)) return false;
    list += length;
    if (*list++ == 0) return true;
  }
}
