// contexts.c -- Anabaena with heterocysts, Hogeweg and Hesper 1.31 a, and an
// acropetal signal, each rewritten by a loop made for that grammar alone. A
// step goes from one buffer into the other; the last one is copied to out.
#include "baselines/baseline.h"

#include <stdlib.h>
#include <string.h>

typedef struct Buffer {
  uint8_t *sym;
  double *arg;
  size_t nsym, narg, sym_room, arg_room;
} Buffer;

static void reserve(Buffer *b, size_t nsym, size_t narg) {
  if (b->sym_room < nsym) {
    free(b->sym);
    b->sym = malloc(b->sym_room = 2 * nsym);
  }
  if (b->arg_room < narg) {
    free(b->arg);
    b->arg = malloc((b->arg_room = 2 * narg) * sizeof(double));
  }
}

static void hand_over(Packed *out, Buffer *from, Buffer *other) {
  memcpy(out->sym, from->sym, from->nsym);
  if (from->narg) memcpy(out->arg, from->arg, from->narg * sizeof(double));
  out->nsym = from->nsym;
  out->narg = from->narg;
  free(from->sym);
  free(from->arg);
  free(other->sym);
  free(other->arg);
}

// ---- Anabaena with heterocysts -----------------------------------------------

enum { CELL_TURN, CELL_F, CELL_GAP, CELL_SURFACE, CELL_H };

// The concentration of the next cell behind the module at i, whose arguments begin at a; NULL: none.
static inline const double *next_cell(const Buffer *in, size_t i, const double *a) {
  static const uint8_t arity[] = {1, 3, 1, 0, 1};
  for (; i < in->nsym; a += arity[in->sym[i++]])
    if (in->sym[i] <= CELL_F) return in->sym[i] == CELL_F ? a + 2 : NULL;
  return NULL;
}

static void heterocysts_step(const Buffer *in, Buffer *out) {
  reserve(out, 3 * in->nsym, 3 * in->narg);
  const double *a = in->arg, *left = NULL;
  uint8_t *sym = out->sym;
  double *arg = out->arg;
  for (size_t i = 0; i < in->nsym; i++) {
    uint8_t letter = in->sym[i];
    if (letter != CELL_F) {
      *sym++ = letter;
      if (letter == CELL_SURFACE) continue;
      *arg++ = letter == CELL_H && *a < 3 ? *a * 1.1 : *a;
      if (letter == CELL_TURN) left = NULL;
      a++;
      continue;
    }
    double s = a[0], t = a[1], c = a[2];
    const double *k = left, *r;
    left = a + 2;
    a += 3;
    if (s >= 6 && (t == 1 || t == 2)) {
      double third = s / 3, rest = s / 3 * 2;
      memcpy(sym, (const uint8_t[]){CELL_F, CELL_GAP, CELL_F}, 3);
      sym += 3;
      memcpy(arg, (const double[]){t == 1 ? rest : third, 2, c, 1, t == 1 ? third : rest, 1, c}, 7 * sizeof(double));
      arg += 7;
    } else if (!k || !(r = next_cell(in, i + 1, a))) {
      *sym++ = CELL_F;
      memcpy(arg, a - 3, 3 * sizeof(double));
      arg += 3;
    } else if (s > 3.9 || c > 0.4) {
      *sym++ = CELL_F;
      arg[0] = s + .1;
      arg[1] = t;
      arg[2] = c + 0.25 * (*k + *r - 3 * c);
      arg += 3;
    } else {
      memcpy(sym, (const uint8_t[]){CELL_F, CELL_SURFACE, CELL_H}, 3);
      sym += 3;
      memcpy(arg, (const double[]){0, 0, 900, 1}, 4 * sizeof(double));
      arg += 4;
    }
  }
  out->nsym = (size_t)(sym - out->sym);
  out->narg = (size_t)(arg - out->arg);
}

void baseline_heterocysts(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  Buffer a = {0}, b = {0};
  reserve(&a, 64, 64);
  memcpy(a.sym, (const uint8_t[]){CELL_TURN, CELL_F, CELL_F, CELL_F}, 4);
  memcpy(a.arg, (const double[]){90, 0, 0, 900, 4, 1, 900, 0, 0, 900}, 10 * sizeof(double));
  a.nsym = 4;
  a.narg = 10;
  Buffer *from = &a, *to = &b;
  for (; steps; steps--) {
    heterocysts_step(from, to);
    Buffer *swap = from;
    from = to;
    to = swap;
  }
  hand_over(out, from, to);
}

// ---- neighbours through brackets ----------------------------------------------

// right[i]: the class of the next module on the axis behind i, 0 at the end of the branch. class_of 0: not seen.
static void neighbours(const Buffer *in, const uint8_t *class_of, uint8_t open, uint8_t close, uint8_t *right,
                       uint8_t *stack) {
  uint8_t now = 0;
  for (size_t i = in->nsym; i-- > 0;) {
    uint8_t letter = in->sym[i];
    if (letter == close) {
      *stack++ = now;
      now = 0;
    } else if (letter == open) {
      now = *--stack;
    } else {
      right[i] = now;
      now = class_of[letter] ? class_of[letter] : now;
    }
  }
}

// ---- Hogeweg and Hesper ---------------------------------------------------------

enum { HH_F, HH_1, HH_0, HH_OPEN, HH_PLUS, HH_CLOSE, HH_MINUS };

static void hogeweg_step(const Buffer *in, Buffer *out, uint8_t *right, uint8_t *stack) {
  static const uint8_t class_of[7] = {[HH_0] = 1, [HH_1] = 2};
  // [left][self][right]: 0 becomes 0, 1 becomes 1, 2: 1[+F1F1], 3: 1F1, 4 stays
  static const uint8_t rule[3][3][3] = {
    {{0}, {4, 4, 4}, {4, 4, 4}}, {{0}, {4, 0, 2}, {4, 1, 1}}, {{0}, {4, 0, 3}, {4, 0, 0}}};
  static const uint8_t texts[5][8] = {
    {HH_0}, {HH_1}, {HH_1, HH_OPEN, HH_PLUS, HH_F, HH_1, HH_F, HH_1, HH_CLOSE}, {HH_1, HH_F, HH_1}};
  static const uint8_t lengths[5] = {1, 1, 8, 3};
  static const uint8_t other[7] = {HH_F, 0, 0, HH_OPEN, HH_MINUS, HH_CLOSE, HH_PLUS};
  reserve(out, 8 * in->nsym, 0);
  neighbours(in, class_of, HH_OPEN, HH_CLOSE, right, stack);
  uint8_t left = 0, *sym = out->sym;
  for (size_t i = 0; i < in->nsym; i++) {
    uint8_t letter = in->sym[i], self = class_of[letter];
    if (!self) {
      if (letter == HH_OPEN) *stack++ = left;
      if (letter == HH_CLOSE) left = *--stack;
      *sym++ = other[letter];
      continue;
    }
    uint8_t what = rule[left][self][right[i]];
    left = self;
    if (what == 4) {
      *sym++ = letter;
    } else {
      memcpy(sym, texts[what], 8);
      sym += lengths[what];
    }
  }
  out->nsym = (size_t)(sym - out->sym);
}

// Repeats a step that needs a byte of neighbour and of stack per module.
static void repeat(Packed *out, const uint8_t *axiom, size_t length, unsigned steps,
                   void (*step)(const Buffer *, Buffer *, uint8_t *, uint8_t *)) {
  Buffer a = {0}, b = {0}, *from = &a, *to = &b;
  uint8_t *right = NULL, *stack = NULL;
  size_t room = 0;
  reserve(&a, 64, 0);
  memcpy(a.sym, axiom, length);
  a.nsym = length;
  for (; steps; steps--) {
    if (room < from->nsym) {
      room = 2 * from->nsym;
      free(right);
      free(stack);
      right = malloc(room);
      stack = malloc(room);
    }
    step(from, to, right, stack);
    Buffer *swap = from;
    from = to;
    to = swap;
  }
  free(right);
  free(stack);
  hand_over(out, from, to);
}

void baseline_hogeweg(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static const uint8_t axiom[] = {HH_F, HH_1, HH_F, HH_1, HH_F, HH_1};
  repeat(out, axiom, sizeof axiom, steps, hogeweg_step);
}

// ---- S < I --> S on a growing tree ------------------------------------------------

enum { SIGNAL_S, SIGNAL_A, SIGNAL_I, SIGNAL_OPEN, SIGNAL_PLUS, SIGNAL_CLOSE, SIGNAL_MINUS };

static void signal_step(const Buffer *in, Buffer *out, uint8_t *right, uint8_t *stack) {
  (void)right;
  static const uint8_t apex[16] = {SIGNAL_I,    SIGNAL_OPEN,  SIGNAL_PLUS, SIGNAL_A,     SIGNAL_CLOSE, SIGNAL_I,
                                   SIGNAL_OPEN, SIGNAL_MINUS, SIGNAL_A,    SIGNAL_CLOSE, SIGNAL_A};
  reserve(out, 11 * in->nsym + 16, 0);
  uint8_t left = SIGNAL_I, *sym = out->sym;
  for (size_t i = 0; i < in->nsym; i++) {
    uint8_t letter = in->sym[i];
    switch (letter) {
    case SIGNAL_A:
      memcpy(sym, apex, 16);
      sym += 11;
      left = letter;
      continue;
    case SIGNAL_I:
      *sym++ = left == SIGNAL_S ? SIGNAL_S : SIGNAL_I;
      left = letter;
      continue;
    case SIGNAL_S:
      left = letter;
      break;
    case SIGNAL_OPEN:
      *stack++ = left;
      break;
    case SIGNAL_CLOSE:
      left = *--stack;
      break;
    }
    *sym++ = letter;
  }
  out->nsym = (size_t)(sym - out->sym);
}

void baseline_signal(Packed *out, unsigned steps, uint64_t seed) {
  (void)seed;
  static const uint8_t axiom[] = {SIGNAL_S, SIGNAL_A};
  repeat(out, axiom, sizeof axiom, steps, signal_step);
}
