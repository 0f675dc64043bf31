// palette.c -- the colours of the indices 0..255.
//
// Index 0 is an ink that suits curves and bark. From 1 on it goes from leaf green
// over light green and yellow to flower colours, since plants count upwards from
// the trunk; from 16 on hues go round in golden steps, so that neighbours differ.
#include "sinks/picture.h"

static const uint32_t first[16] = {
  0x41342a, 0x4d8b3c, 0x5f9e3f, 0x3f7f3f, 0x73ad48, 0x8bbb52, 0xa3c75c, 0xbcd067,
  0xd6d46c, 0xe9c25a, 0xe8a14b, 0xdf7d43, 0xd15b45, 0xb8436a, 0x8d4b94, 0x5a5fae,
};

static const uint32_t BARK = 0x8a6c52;  // index 0 in the light: a dark ink would hide the shades

// One channel of a colour of hue 0..6 (red, yellow, green, cyan, blue, magenta) with medium saturation.
static uint32_t channel(double hue) {
  while (hue >= 6) hue -= 6;
  double full = hue < 1 ? hue : hue < 3 ? 1 : hue < 4 ? 4 - hue : 0;
  return (uint32_t)(70 + 140 * full);
}

uint32_t lsys_palette(uint8_t index, bool solid) {
  if (solid && index == 0) return BARK;
  if (index < 16) return first[index];
  double turn = index * 0.61803398874989485, hue = 6 * (turn - (int)turn);
  return channel(hue + 2) << 16 | channel(hue) << 8 | channel(hue + 4);
}
