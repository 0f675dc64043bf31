// lettering.c -- texts on a page, drawn as lines, so that they look the same in
// every format: ASCII and some signs more; a box stands for all other characters.
#include "sinks/lettering.h"

#include <math.h>
#include <string.h>

enum {
  UNITS = 6,  // of a capital's height
  LINE = 12,  // units from one line to the next
  SPACE = 2,  // units between characters
  MOST = 24,  // points of a stroke
  BLANK = ' ',
};

// A glyph is strokes on a grid, points as pairs of digits x y, y down: capitals from 0 to 6, small letters from 2, and
// down to 8. Blanks stand between strokes; the rightmost point says how wide it is.
static const char *const ascii[] = {
  "0004 0606", "0002 1012", "1016 3036 0242 0444", "413010010213334445361605 2026", "4006 0010110100 3646453536",
  "4612112031320405162644", "0002", "10010516", "00111506", "2125 0244 0442", "2125 0343", "1607", "0333", "0606",
  "3006",
  // 0 to 9
  "100105162635312010", "011016 0626", "01102031320636", "01102031322313 233435261605", "26200434",
  "300002223335261605", "3120100105162635342303", "003016", "13020110203132231304051626353423",
  "0516263531201001021333",
  // : ; < = > ? @
  "0303 0606", "1313 1607", "310335", "0232 0434", "013305", "011020313214 1616", "34242232344441301001051646",
  // A to Z
  "062046 1333", "06003041423303 3344453606", "4130100105163645", "06003041453606", "40000646 0333", "400006 0333",
  "41301001051636454323", "0006 4046 0343", "0020 1016 0626", "3035261605", "0006 4004 2246", "000646", "0600234046",
  "06004640", "100105163645413010", "06003041423303", "100105163645413010 2446", "06003041423303 2346",
  "413010010213334445361605", "0040 2026", "000516364540", "002640", "0016233640", "0046 4006", "002340 2326",
  "00400646",
  // [ \ ] ^ _ `
  "10000616", "0036", "00101606", "021022", "0737", "0011",
  // a to z
  "3322120305162635 3236", "0006 0312223335261605", "3322120305162635", "3036 3322120305162635", "04343322120305162635",
  "201116 0222", "3237281807 3322120305162635", "0006 0312223336", "0206 0000", "121708 1010", "0006 3205 1436",
  "000516", "0206 03122326 23324346", "0206 0312223336", "120305162635332212", "0208 0312223335261605",
  "3238 3322120305162635", "0206 031222", "3212031424352606", "101526 0222", "0205162635 3236", "022642", "0216243642",
  "0236 3206", "0226 4218", "02320636",
  // { | } ~
  "20111203141526", "0007", "00111223141506", "04132433"};

static const struct {
  uint32_t character;
  const char *strokes;
} others[] = {
  {0xB0, "1001122110"},                       // degree
  {0xB1, "2024 0242 0646"},                   // plus-minus
  {0xB5, "0208 0205162635 3236"},             // micro
  {0xB7, "0303"},                             // middle dot
  {0xD7, "0236 3206"},                        // times
  {0xDF, "0601102031320223 23343526"},        // sharp s
  {0xE4, "3322120305162635 3236 0000 3030"},  // a, o, u with two dots
  {0xF6, "120305162635332212 0000 3030"},
  {0xFC, "0205162635 3236 0000 3030"},
};

static const char unknown[] = "0006363000";

// ---- characters --------------------------------------------------------------

// The next character, and the text behind it. What is no UTF-8 is taken byte by byte.
static uint32_t next_character(const char **text) {
  const uint8_t *at = (const uint8_t *)*text;
  unsigned more = *at >= 0xF0 ? 3 : *at >= 0xE0 ? 2 : *at >= 0xC0 ? 1 : 0, i = 1;
  uint32_t character = more ? *at & (0x3Fu >> more) : *at;
  for (; i <= more && (at[i] & 0xC0) == 0x80; i++) character = character << 6 | (at[i] & 0x3F);
  *text += i;
  return character;
}

static const char *strokes_of(uint32_t character) {
  if (character > BLANK && character - BLANK <= sizeof ascii / sizeof *ascii) return ascii[character - BLANK - 1];
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (others[i].character == character) return others[i].strokes;
  return character <= BLANK ? "" : unknown;
}

static int width_of(const char *strokes) {
  int width = 0;
  for (const char *c = strokes; *c; c += *c == ' ' ? 1 : 2)
    if (*c - '0' > width) width = *c - '0';
  return width;
}

// In units, of the longest line.
static void measure(const char *text, int *width, int *lines) {
  int line = 0;
  *width = 0;
  for (*lines = 1; *text;) {
    uint32_t character = next_character(&text);
    line += width_of(strokes_of(character)) + SPACE;
    if (character == '\n') {
      line = 0;
      ++*lines;
    }
    if (line > *width) *width = line;
  }
}

// ---- strokes -----------------------------------------------------------------

static bool draw_glyph(LsysCanvas *canvas, const char *strokes, LsysPoint corner, double unit, const LsysInk *ink) {
  LsysPoint point[MOST];
  size_t n = 0;
  for (const char *c = strokes;; c += 2) {
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

// Where something of a size begins so that it ends on the page.
static double onto(double begin, double size, double page) {
  return fmax(fmin(begin, page - size), fmin(begin, 0));
}

bool lsys_lettering(LsysCanvas *canvas, const LsysPage *page, const char *text, LsysPoint at, double height,
                    uint32_t rgb) {
  int width, lines;
  measure(text, &width, &lines);
  double unit = height / UNITS;
  LsysInk ink = {unit * 0.8, rgb};
  LsysPoint start = {onto(at.x + SPACE * unit, width * unit, page->width),
                     onto(at.y - height / 2, (lines - 1) * LINE * unit + 9 * unit, page->height), at.z};
  for (LsysPoint corner = start; *text;) {
    uint32_t character = next_character(&text);
    const char *strokes = strokes_of(character);
    if (!draw_glyph(canvas, strokes, corner, unit, &ink)) return false;
    corner.x += (width_of(strokes) + SPACE) * unit;
    if (character == '\n') corner = (LsysPoint){start.x, corner.y + LINE * unit, at.z};
  }
  return true;
}
