// d0l.c -- Koch, Hilbert and plant 1.24 e: whatever letter is left with few
// enough steps is copied from a block that stays in the cache, so that the
// only memory traffic is the output.
#include "baselines/baseline.h"

#include <string.h>

enum { BLOCK = 1 << 16, LEVELS = 64 };

// A letter's words by steps, as far as they fit into a block.
typedef struct Ladder {
  uint8_t *at[LEVELS];
  size_t length[LEVELS];
  unsigned levels;
  bool warm;
  uint8_t bytes[2 * BLOCK];
} Ladder;

static inline uint8_t *put(uint8_t *out, const Ladder *ladder, unsigned steps) {
  put_block(out, ladder->at[steps], ladder->length[steps], ladder->warm);
  return out + ladder->length[steps];
}

static void ladder_start(Ladder *ladder, uint8_t letter) {
  ladder->warm = false;
  ladder->bytes[0] = letter;
  ladder->at[0] = ladder->bytes;
  ladder->length[0] = 1;
  ladder->levels = 1;
}

// Where the word of the next level goes; NULL when it would not fit.
static uint8_t *ladder_next(Ladder *ladder, size_t length) {
  uint8_t *end = ladder->at[ladder->levels - 1] + ladder->length[ladder->levels - 1];
  if (ladder->levels == LEVELS || length > BLOCK || end + length > ladder->bytes + sizeof ladder->bytes) return NULL;
  ladder->length[ladder->levels] = length;
  return ladder->at[ladder->levels++] = end;
}

// ---- F --> F-F+F+FF-F-F+F ------------------------------------------------

enum { KOCH_F, KOCH_MINUS, KOCH_PLUS };

static uint8_t *koch_f(uint8_t *out, const Ladder *f, unsigned steps);

static uint8_t *koch_once(uint8_t *out, const Ladder *f, unsigned below) {
  static const uint8_t turns[] = {KOCH_MINUS, KOCH_PLUS, KOCH_PLUS, 0, KOCH_MINUS, KOCH_MINUS, KOCH_PLUS};
  for (int i = 0; i < 8; i++) {
    out = koch_f(out, f, below);
    if (i < 7 && i != 3) *out++ = turns[i];
  }
  return out;
}

static uint8_t *koch_f(uint8_t *out, const Ladder *f, unsigned steps) {
  return steps < f->levels ? put(out, f, steps) : koch_once(out, f, steps - 1);
}

void baseline_koch(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static Ladder f;
  ladder_start(&f, KOCH_F);
  for (uint8_t *next; f.levels <= steps && (next = ladder_next(&f, 8 * f.length[f.levels - 1] + 6)) != NULL;) {
    f.levels--;
    koch_once(next, &f, f.levels - 1);
    f.levels++;
  }
  f.warm = out->warm;
  uint8_t *at = out->sym;
  for (int i = 0; i < 4; i++) {
    at = koch_f(at, &f, steps);
    if (i < 3) *at++ = KOCH_MINUS;
  }
  out->nsym = (size_t)(at - out->sym);
  out->narg = 0;
}

// ---- L --> +RF-LFL-FR+, R --> -LF+RFR+FL- ----------------------------------

enum { HILBERT_L, HILBERT_PLUS, HILBERT_R, HILBERT_F, HILBERT_MINUS };

typedef struct Hilbert {
  Ladder letter[2];  // L, R
} Hilbert;

static uint8_t *hilbert(uint8_t *out, const Hilbert *h, int which, unsigned steps);

static uint8_t *hilbert_once(uint8_t *out, const Hilbert *h, int which, unsigned below) {
  uint8_t turn = which ? HILBERT_MINUS : HILBERT_PLUS, back = which ? HILBERT_PLUS : HILBERT_MINUS;
  *out++ = turn;
  out = hilbert(out, h, !which, below);
  *out++ = HILBERT_F;
  *out++ = back;
  out = hilbert(out, h, which, below);
  *out++ = HILBERT_F;
  out = hilbert(out, h, which, below);
  *out++ = back;
  *out++ = HILBERT_F;
  out = hilbert(out, h, !which, below);
  *out++ = turn;
  return out;
}

static uint8_t *hilbert(uint8_t *out, const Hilbert *h, int which, unsigned steps) {
  return steps < h->letter[which].levels ? put(out, &h->letter[which], steps) : hilbert_once(out, h, which, steps - 1);
}

void baseline_hilbert(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static Hilbert h;
  ladder_start(&h.letter[0], HILBERT_L);
  ladder_start(&h.letter[1], HILBERT_R);
  for (unsigned level = 1; level <= steps; level++) {
    uint8_t *next[2];
    for (int i = 0; i < 2; i++) next[i] = ladder_next(&h.letter[i], 4 * h.letter[i].length[level - 1] + 7);
    if (!next[0] || !next[1]) break;
    for (int i = 0; i < 2; i++) hilbert_once(next[i], &h, i, level - 1);
  }
  for (int i = 0; i < 2; i++) h.letter[i].warm = out->warm;
  out->nsym = (size_t)(hilbert(out->sym, &h, 0, steps) - out->sym);
  out->narg = 0;
}

// ---- X --> F[+X][-X]FX, F --> FF -------------------------------------------

enum { PLANT_X, PLANT_F, PLANT_OPEN, PLANT_PLUS, PLANT_CLOSE, PLANT_MINUS };

static uint8_t *plant_x(uint8_t *out, const Ladder *x, unsigned steps);

static uint8_t *plant_once(uint8_t *out, const Ladder *x, unsigned below) {
  size_t f = (size_t)1 << below;
  memset(out, PLANT_F, f);
  out += f;
  for (int i = 0; i < 2; i++) {
    *out++ = PLANT_OPEN;
    *out++ = i ? PLANT_MINUS : PLANT_PLUS;
    out = plant_x(out, x, below);
    *out++ = PLANT_CLOSE;
  }
  memset(out, PLANT_F, f);
  return plant_x(out + f, x, below);
}

static uint8_t *plant_x(uint8_t *out, const Ladder *x, unsigned steps) {
  return steps < x->levels ? put(out, x, steps) : plant_once(out, x, steps - 1);
}

void baseline_plant(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static Ladder x;
  ladder_start(&x, PLANT_X);
  while (x.levels <= steps) {
    unsigned below = x.levels - 1;
    uint8_t *next = ladder_next(&x, 3 * x.length[below] + ((size_t)2 << below) + 6);
    if (!next) break;
    x.levels--;
    plant_once(next, &x, below);
    x.levels++;
  }
  x.warm = out->warm;
  out->nsym = (size_t)(plant_x(out->sym, &x, steps) - out->sym);
  out->narg = 0;
}
