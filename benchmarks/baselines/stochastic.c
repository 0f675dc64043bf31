// stochastic.c -- random shrubs and a tree with random angles, with the keys
// of LANGUAGE.md 5.8; the last step is written without a call.
#include "baselines/baseline.h"

#include "lsys/keys.h"

#include <string.h>

// ---- F --> F[+F]F[-F]F : 0.33, F[+F]F : 0.33, F[-F]F : 0.34 -----------------

enum { SHRUB_F, SHRUB_OPEN, SHRUB_PLUS, SHRUB_CLOSE, SHRUB_MINUS };

typedef struct Choice {
  uint8_t sym[16];
  uint8_t length, letters, place[5];  // places of the F
} Choice;

static const Choice choices[3] = {
  {{0, 1, 2, 0, 3, 0, 1, 4, 0, 3, 0}, 11, 5, {0, 3, 5, 8, 10}},
  {{0, 1, 2, 0, 3, 0}, 6, 3, {0, 3, 5}},
  {{0, 1, 4, 0, 3, 0}, 6, 3, {0, 3, 5}},
};

static inline const Choice *choose(uint64_t key) {
  double u = lsys_draw(key, 0);
  return &choices[(u >= 0.33) + (u >= 0.33 + 0.33)];
}

static uint8_t *shrub(uint8_t *out, uint64_t key, unsigned steps) {
  const Choice *c = choose(key);
  if (steps == 1) {
    memcpy(out, c->sym, 16);
    return out + c->length;
  }
  unsigned from = 0;
  for (unsigned i = 0; i < c->letters; i++) {
    unsigned place = c->place[i];
    memcpy(out, c->sym + from, 4);
    out = shrub(out + (place - from), lsys_split(key, place), steps - 1);
    from = place + 1;
  }
  return out;
}

void baseline_shrub(Packed *out, unsigned steps, uint64_t seed) {
  uint64_t key = lsys_split(lsys_root(seed), 0);
  out->narg = 0;
  out->nsym = steps ? (size_t)(shrub(out->sym, key, steps) - out->sym) : 1;
  if (!steps) *out->sym = SHRUB_F;
}

// ---- A(s) --> F(s)[+(20+ran(10))A(s*0.9)][-(20+ran(10))A(s*0.8)] -------------

enum { RANDOM_A, RANDOM_F, RANDOM_OPEN, RANDOM_PLUS, RANDOM_CLOSE, RANDOM_MINUS };
static const uint8_t random_tree_once[9] = {RANDOM_F,    RANDOM_OPEN,  RANDOM_PLUS, RANDOM_A,    RANDOM_CLOSE,
                                            RANDOM_OPEN, RANDOM_MINUS, RANDOM_A,    RANDOM_CLOSE};

typedef struct Cursor {
  uint8_t *sym;
  double *arg;
} Cursor;

static void random_tree(Cursor *c, double s, uint64_t key, unsigned steps) {
  double left = 20 + lsys_draw(key, 1) * 10, right = 20 + lsys_draw(key, 2) * 10;
  if (steps == 1) {
    memcpy(c->sym, random_tree_once, 9);
    c->sym += 9;
    c->arg[0] = s;
    c->arg[1] = left;
    c->arg[2] = s * 0.9;
    c->arg[3] = right;
    c->arg[4] = s * 0.8;
    c->arg += 5;
    return;
  }
  memcpy(c->sym, random_tree_once, 3);
  c->sym += 3;
  c->arg[0] = s;
  c->arg[1] = left;
  c->arg += 2;
  random_tree(c, s * 0.9, lsys_split(key, 3), steps - 1);
  memcpy(c->sym, random_tree_once + 4, 3);
  c->sym += 3;
  *c->arg++ = right;
  random_tree(c, s * 0.8, lsys_split(key, 7), steps - 1);
  *c->sym++ = RANDOM_CLOSE;
}

void baseline_random_tree(Packed *out, unsigned steps, uint64_t seed) {
  Cursor c = {out->sym, out->arg};
  if (steps) {
    random_tree(&c, 1, lsys_split(lsys_root(seed), 0), steps);
  } else {
    *c.sym++ = RANDOM_A;
    *c.arg++ = 1;
  }
  out->nsym = (size_t)(c.sym - out->sym);
  out->narg = (size_t)(c.arg - out->arg);
}
