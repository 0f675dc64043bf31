// palette.c -- palettes, made of few colours each; and colours as text.
#include "sinks/colours.h"

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

// From what is old to what is young: dark bark, bark, leaves, fresh leaves.
static const uint32_t seasons[5] = {0x4a3626, 0x8a6c42, 0x4f8a3a, 0x86bb3f, 0xd6dc5a};

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

// Colour i of 256 that go evenly through the stops.
static uint32_t on_ramp(const uint32_t *stop, int stops, int i) {
  double at = i * (stops - 1) / 255.0;
  int low = at < stops - 1 ? (int)at : stops - 1;
  return low == stops - 1 ? stop[low] : between(stop[low], stop[low + 1], at - low);
}

static bool is_ramp(LsysColourBy by) {
  return by == LSYS_BY_PROGRESS || by == LSYS_BY_AGE;
}

static uint32_t own_colour(LsysColourBy by, int i, bool solid) {
  switch (by) {
  case LSYS_BY_PROGRESS:
    return on_ramp(rainbow, sizeof rainbow / sizeof *rainbow, i);
  case LSYS_BY_AGE:
    return on_ramp(seasons, sizeof seasons / sizeof *seasons, i);
  case LSYS_BY_ORDER:
  case LSYS_BY_KIND:
    return i < 12 ? distinct[i] : golden(i);
  case LSYS_BY_PEN:
    break;
  }
  if (i == 0 && solid) return BARK;
  return i < 16 ? plant[i] : golden(i);
}

// The colours of a list that was read before; returns how many.
static int read_list(const char *list, uint32_t *rgb) {
  int count = 0;
  while (*list && count < LSYS_MOST_COLOURS) {
    size_t length = strcspn(list, ",");
    lsys_colour_read(list, length, &rgb[count++]);
    list += length + (list[length] == ',');
  }
  return count;
}

void lsys_palette_make(LsysPalette *palette, const LsysColours *colours, const LsysGrammar *grammar, bool solid) {
  uint32_t given[LSYS_MOST_COLOURS];
  int count = 0;
  if (colours->list) {
    count = read_list(colours->list, given);
  } else if (grammar && colours->by == LSYS_BY_PEN) {
    count = (int)grammar->colour_count;
    if (count) memcpy(given, grammar->colours, (size_t)count * sizeof *given);
  }
  bool ramp = count && is_ramp(colours->by);
  for (int i = 0; i < LSYS_MOST_COLOURS; i++)
    palette->rgb[i] = ramp ? on_ramp(given, count, i) : i < count ? given[i] : own_colour(colours->by, i, solid);
}

bool lsys_colours_list(const char *list) {
  for (int count = 0; count < LSYS_MOST_COLOURS; count++) {
    size_t length = strcspn(list, ",");
    uint32_t rgb;
    if (!lsys_colour_read(list, length, &rgb)) return false;
    list += length;
    if (*list++ == 0) return true;
  }
  return false;
}
