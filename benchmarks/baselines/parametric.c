// parametric.c -- row of trees, ternary tree, guarded rewriting: the last
// levels are written straight-line, with several levels fused by hand.
#include "baselines/baseline.h"

#include <string.h>

// ---- A(s) --> F(s)[+A(s/R)][-A(s/R)] ---------------------------------------

enum { TREE_A, TREE_F, TREE_OPEN, TREE_PLUS, TREE_CLOSE, TREE_MINUS };
#define R 1.456

// The symbols of A after three steps, and after the last one of each A inside.
static const uint8_t tree1[9] = {TREE_F,    TREE_OPEN,  TREE_PLUS, TREE_A,    TREE_CLOSE,
                                 TREE_OPEN, TREE_MINUS, TREE_A,    TREE_CLOSE};

typedef struct Cursor {
  uint8_t *sym;
  double *arg;
  const uint8_t *three;  // symbols of A after three steps: 57
} Cursor;

enum { THREE = 57 };

static inline void tree_three(Cursor *c, double s) {
  memcpy(c->sym, c->three, THREE);
  c->sym += THREE;
  double s1 = s / R, s2 = s1 / R, s3 = s2 / R, *a = c->arg;
  a[0] = s;
  for (int i = 0; i < 2; i++) {
    double *b = a + 1 + 7 * i;
    b[0] = s1;
    for (int j = 0; j < 2; j++) {
      b[1 + 3 * j] = s2;
      b[2 + 3 * j] = s3;
      b[3 + 3 * j] = s3;
    }
  }
  c->arg += 15;
}

static void tree(Cursor *c, double s, unsigned steps) {
  if (steps == 3) {
    tree_three(c, s);
    return;
  }
  if (steps == 0) {
    *c->sym++ = TREE_A;
    *c->arg++ = s;
    return;
  }
  *c->sym++ = TREE_F;
  *c->arg++ = s;
  for (int i = 0; i < 2; i++) {
    *c->sym++ = TREE_OPEN;
    *c->sym++ = i ? TREE_MINUS : TREE_PLUS;
    tree(c, s / R, steps - 1);
    *c->sym++ = TREE_CLOSE;
  }
}

static size_t tree_symbols(uint8_t *out, unsigned steps) {
  if (steps == 0) {
    *out = TREE_A;
    return 1;
  }
  size_t n = 0;
  for (int i = 0; i < 9; i++) {
    if (tree1[i] == TREE_A)
      n += tree_symbols(out + n, steps - 1);
    else
      out[n++] = tree1[i];
  }
  return n;
}

void baseline_row_of_trees(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  uint8_t three[THREE];
  tree_symbols(three, 3);
  Cursor c = {out->sym, out->arg, three};
  tree(&c, 1, steps);
  out->nsym = (size_t)(c.sym - out->sym);
  out->narg = (size_t)(c.arg - out->arg);
}

// ---- the ternary tree: A has no argument, so its word after k steps is one block ----

enum { TERN_WIDTH, TERN_F, TERN_ROLL, TERN_A, TERN_OPEN, TERN_PITCH, TERN_CLOSE };
enum { TERN_LEVELS = 9 };

typedef struct Ternary {
  double length[64], width[64];  // F(50), !(vr) after k steps
  uint8_t *sym[TERN_LEVELS];
  double *arg[TERN_LEVELS];
  size_t nsym[TERN_LEVELS], narg[TERN_LEVELS];
  unsigned levels;
  bool warm;
  uint8_t sym_bytes[1 << 18];
  double args[1 << 17];
} Ternary;

static void ternary(Cursor *c, const Ternary *t, unsigned steps);

static void ternary_once(Cursor *c, const Ternary *t, unsigned below) {
  *c->sym++ = TERN_WIDTH;
  *c->arg++ = t->width[below];
  *c->sym++ = TERN_F;
  *c->arg++ = t->length[below];
  static const double rolls[] = {94.74, 132.63};
  for (int i = 0; i < 3; i++) {
    *c->sym++ = TERN_OPEN;
    *c->sym++ = TERN_PITCH;
    *c->arg++ = 18.95;
    *c->sym++ = TERN_F;
    *c->arg++ = t->length[below];
    ternary(c, t, below);
    *c->sym++ = TERN_CLOSE;
    if (i == 2) break;
    *c->sym++ = TERN_ROLL;
    *c->arg++ = rolls[i];
  }
}

static void ternary(Cursor *c, const Ternary *t, unsigned steps) {
  if (steps >= t->levels) {
    ternary_once(c, t, steps - 1);
    return;
  }
  put_block(c->sym, t->sym[steps], t->nsym[steps], t->warm);
  put_block(c->arg, t->arg[steps], t->narg[steps] * sizeof(double), t->warm);
  c->sym += t->nsym[steps];
  c->arg += t->narg[steps];
}

static double grown(double x, double factor, unsigned steps) {
  for (unsigned i = 0; i < steps; i++) x *= factor;
  return x;
}

void baseline_ternary_tree(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static Ternary t;
  for (unsigned k = 0; k < 64; k++) {
    t.length[k] = grown(50, 1.109, k);
    t.width[k] = grown(1.732, 1.732, k);
  }
  t.sym_bytes[0] = TERN_A;
  t.sym[0] = t.sym_bytes;
  t.arg[0] = t.args;
  t.nsym[0] = 1;
  t.narg[0] = 0;
  t.levels = 1;
  t.warm = false;
  while (t.levels < TERN_LEVELS && t.levels <= steps) {
    unsigned k = t.levels;
    t.sym[k] = t.sym[k - 1] + t.nsym[k - 1];
    t.arg[k] = t.arg[k - 1] + t.narg[k - 1];
    Cursor c = {t.sym[k], t.arg[k], NULL};
    ternary_once(&c, &t, k - 1);
    t.nsym[k] = (size_t)(c.sym - t.sym[k]);
    t.narg[k] = (size_t)(c.arg - t.arg[k]);
    t.levels++;
  }
  t.warm = out->warm;
  Cursor c = {out->sym, out->arg, NULL};
  *c.sym++ = TERN_WIDTH;
  *c.arg++ = grown(1, 1.732, steps);
  *c.sym++ = TERN_F;
  *c.arg++ = grown(200, 1.109, steps);
  *c.sym++ = TERN_ROLL;
  *c.arg++ = 45;
  ternary(&c, &t, steps);
  out->nsym = (size_t)(c.sym - out->sym);
  out->narg = (size_t)(c.arg - out->arg);
}

// ---- guards: A(x,y), B(x) ----------------------------------------------------

enum { GUARD_A, GUARD_B };

// The last step without a branch: what each production writes is computed, and what holds is selected.
static inline void guard_a_last(Cursor *c, double x, double y) {
  bool low = y <= 3, high = y > 3, some = low | high;
  double quotient = x / y;
  uint16_t symbols = low ? GUARD_A | GUARD_B << 8 : high ? GUARD_B | GUARD_A << 8 : GUARD_A;
  memcpy(c->sym, &symbols, 2);
  c->sym += 1 + some;
  c->arg[0] = low ? x * 1.5 : x;
  c->arg[1] = low ? x + y : high ? quotient : y;
  c->arg[2] = low ? y : 0;
  c->arg += 2 + some;
}

static inline void guard_b_last(Cursor *c, double x) {
  bool low = x < 1, high = x >= 1;
  *c->sym++ = low ? GUARD_A : GUARD_B;
  c->arg[0] = low ? x + 0.5 : high ? x - 1 : x;
  c->arg[1] = x;
  c->arg += 1 + low;
}

static void guard_b(Cursor *c, double x, unsigned steps);

static void guard_a(Cursor *c, double x, double y, unsigned steps) {
  for (; steps > 2; steps--) {
    if (y <= 3) {
      guard_a(c, x * 1.5, x + y, steps - 1);
      guard_b(c, y, steps - 1);
      return;
    }
    if (!(y > 3)) break;
    guard_b(c, x, steps - 1);
    x = x / y;
    y = 0;
  }
  if (steps == 2 && y <= 3) {
    guard_a_last(c, x * 1.5, x + y);
    guard_b_last(c, y);
  } else if (steps == 2 && y > 3) {
    guard_b_last(c, x);
    guard_a_last(c, x / y, 0);
  } else if (steps == 1) {
    guard_a_last(c, x, y);
  } else {
    *c->sym++ = GUARD_A;
    c->arg[0] = x;
    c->arg[1] = y;
    c->arg += 2;
  }
}

static void guard_b(Cursor *c, double x, unsigned steps) {
  for (; steps > 1; steps--) {
    if (x < 1) {
      if (steps == 2)
        guard_a_last(c, x + 0.5, x);
      else
        guard_a(c, x + 0.5, x, steps - 1);
      return;
    }
    if (!(x >= 1)) break;
    x -= 1;
  }
  if (steps == 1) {
    guard_b_last(c, x);
  } else {
    *c->sym++ = GUARD_B;
    *c->arg++ = x;
  }
}

void baseline_guards(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  Cursor c = {out->sym, out->arg, NULL};
  guard_a(&c, 1, 1, steps);
  out->nsym = (size_t)(c.sym - out->sym);
  out->narg = (size_t)(c.arg - out->arg);
}
