// palette.c -- the colours of the indices 0..255.
//
// Index 0 is an ink that suits every curve. The first indices go from bark to
// leaf, since plants count upwards from the trunk; from 16 on hues go round in
// golden steps, so that neighbours differ.
#include "sinks/picture.h"

static const uint32_t first[16] = {
  0x2f2a26, 0x5a4632, 0x6b5d2f, 0x5d7a2c, 0x3f8a34, 0x2f9e4c, 0x57b05a, 0x8cbf4a,
  0xd9b93b, 0xe08a2e, 0xd8572a, 0xc23b4e, 0xb0428f, 0x7a4fb0, 0x3f67b8, 0x2a93b5,
};

// One channel of a colour of hue 0..6 (red, yellow, green, cyan, blue, magenta) with medium saturation.
static uint32_t channel(double hue) {
  while (hue >= 6) hue -= 6;
  double full = hue < 1 ? hue : hue < 3 ? 1 : hue < 4 ? 4 - hue : 0;
  return (uint32_t)(70 + 140 * full);
}

uint32_t lsys_palette(uint8_t index) {
  if (index < 16) return first[index];
  double turn = index * 0.61803398874989485, hue = 6 * (turn - (int)turn);
  return channel(hue + 2) << 16 | channel(hue) << 8 | channel(hue + 4);
}
