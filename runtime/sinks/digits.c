// digits.c -- numbers on a page, drawn as lines: digits, sign, point, exponent,
// nan and inf.
#include "sinks/digits.h"

#include <string.h>

// A glyph is strokes on a grid 2 wide and 4 high, points as pairs of digits x y, y down; blanks between strokes.
typedef struct Glyph {
  char character;
  const char *strokes;
} Glyph;

static const Glyph glyphs[] = {
  {'0', "0020240400"},      {'1', "011014 0424"},  {'2', "0020220204 0424"},
  {'3', "00202404 0222"},   {'4', "000222 2024"},  {'5', "200002222404"},
  {'6', "200004242202"},    {'7', "002014"},       {'8', "0020240400 0222"},
  {'9', "220200202404"},    {'.', "1414"},         {'-', "0222"},
  {'+', "0222 1113"},       {'e', "022221010424"}, {'n', "0402 02222224"},
  {'a', "0222240403 0323"}, {'i', "1214 1111"},    {'f', "211114 0222"},
};

static const Glyph *find(char character) {
  for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++) {
    if (glyphs[i].character == character) return &glyphs[i];
  }
  return NULL;
}

static bool draw_glyph(LsysCanvas *canvas, const Glyph *glyph, LsysPoint corner, double unit, const LsysInk *ink) {
  LsysPoint point[8];
  size_t n = 0;
  for (const char *c = glyph->strokes;; c += 2) {
    if (*c && *c != ' ') {
      point[n++] = (LsysPoint){corner.x + (c[0] - '0') * unit, corner.y + (c[1] - '0') * unit, corner.z};
      continue;
    }
    if (n >= 2 && !canvas->line(canvas, point, n, ink, false)) return false;
    n = 0;
    if (*c == 0) return true;
    c--;  // a blank is one character
  }
}

bool lsys_digits(LsysCanvas *canvas, const char *text, LsysPoint at, double height, uint32_t rgb) {
  double unit = height / 4;
  LsysInk ink = {unit * 0.55, rgb};
  LsysPoint corner = {at.x + unit, at.y - height / 2, at.z};
  for (; *text; text++) {
    const Glyph *glyph = find(*text);
    if (glyph && !draw_glyph(canvas, glyph, corner, unit, &ink)) return false;
    corner.x += 3 * unit;
  }
  return true;
}
