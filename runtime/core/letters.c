// letters.c -- a step over words of letters: all that a module becomes stands
// in a table by its kind and the kinds of its neighbours (LsysLetters).
//
// From the end of the word to its beginning each module gets its code, which
// says what stands on its right; from the beginning to the end the text of that
// code is copied from the row that says what stands on its left. Neither loop
// has a branch that depends on the word: letters would be guessed wrongly.
#include "core/scan.h"

#include <string.h>

#define INLINE static inline __attribute__((always_inline))

enum { BLOCK = 1024 };  // modules between two looks at what there is room for

// aside[depth-1] was put aside last; below what the word put aside there are zeros, for brackets that have no other.
typedef struct Place {
  uint32_t row;
  size_t depth;
  uint32_t *aside;
} Place;

INLINE void pass(Place *place, const LsysMoves *moves, uint8_t code, bool nested) {
  uint32_t row = (place->row & moves->keep[code]) | moves->set[code];
  if (nested) {
    row |= place->aside[place->depth - 1] & moves->pop[code];
    place->aside[place->depth] = place->row;
    place->depth += (size_t)moves->depth[code];
  }
  place->row = row;
}

// Makes room for n modules to put aside, or to take from there.
static void make_room(LsysScan *scan, Place *place, size_t n) {
  size_t used = place->depth, room = scan->aside_room, below = used < n + 1 ? used + n + 1 : 0;
  if (room < below + used + n + 1) {
    scan->aside = scan_array(scan->run, scan->aside, &scan->aside_room, below + used + n + 1, sizeof *scan->aside);
  }
  place->aside = scan->aside;
  if (!below) return;
  memmove(place->aside + below, place->aside, used * sizeof *place->aside);
  memset(place->aside, 0, below * sizeof *place->aside);
  place->depth += below;
}

// Where a segment begins or ends, modules beyond it have set rows: the one at hand, and those put aside.
static uint32_t row_of(const LsysMoves *moves, uint32_t kind) {
  return kind == LSYS_NO_MODULE ? 0 : moves->set[kind];
}

static Place begin(LsysScan *scan, size_t depth) {
  scan->aside = scan_array(scan->run, scan->aside, &scan->aside_room, depth, sizeof *scan->aside);
  return (Place){.depth = depth, .aside = scan->aside};
}

static Place begin_left(LsysScan *scan, const LsysMoves *moves) {
  if (!scan->window) return (Place){0};
  Place place = begin(scan, scan->depth);
  for (size_t i = 0; i < scan->depth; i++) place.aside[i] = row_of(moves, scan->saved[i * scan->window].kind);
  place.row = row_of(moves, scan->left->kind);
  return place;
}

static Place begin_right(LsysScan *scan, const LsysMoves *moves) {
  Place place = begin(scan, scan->behind_depth);
  for (size_t i = 0; i < scan->behind_depth; i++) place.aside[i] = row_of(moves, scan->behind[i]);
  place.row = row_of(moves, scan->behind_kind);
  return place;
}

// ---- codes -------------------------------------------------------------------

INLINE void encode(const uint8_t *sym, uint8_t *code, size_t n, Place *place, const LsysMoves *right, bool nested) {
  Place at = *place;
  while (n-- > 0) {
    uint8_t kind = sym[n];
    code[n] = (uint8_t)(at.row + kind);
    pass(&at, right, kind, nested);
  }
  *place = at;
}

static const uint8_t *codes(LsysScan *scan, const LsysLetters *letters) {
  if (!letters->looks_right) return scan->sym;
  size_t left = (size_t)(scan->end - scan->sym);
  scan->code = scan_array(scan->run, scan->code, &scan->code_room, left, 1);
  Place place = begin_right(scan, letters->right);
  while (left) {
    size_t n = left < BLOCK ? left : BLOCK;
    if (letters->nested) make_room(scan, &place, n);
    left -= n;
    if (letters->nested)
      encode(scan->sym + left, scan->code + left, n, &place, letters->right, true);
    else
      encode(scan->sym + left, scan->code + left, n, &place, letters->right, false);
  }
  return scan->code;
}

// ---- texts -------------------------------------------------------------------

INLINE uint8_t *write(uint8_t *out, const uint8_t *code, size_t n, Place *place, const LsysLetters *letters,
                      size_t width, bool nested) {
  const uint8_t *text = letters->text, *length = letters->length;
  const LsysMoves *left = letters->left;
  Place at = *place;
  for (size_t i = 0; i < n; i++) {
    size_t entry = at.row + code[i];
    pass(&at, left, code[i], nested);
    memcpy(out, text + entry * width, width);
    out += length[entry];
  }
  *place = at;
  return out;
}

static uint8_t *write_some(uint8_t *out, const uint8_t *code, size_t n, Place *place, const LsysLetters *letters) {
  bool nested = letters->nested;
  switch (letters->width) {
  case 8:
    return nested ? write(out, code, n, place, letters, 8, true) : write(out, code, n, place, letters, 8, false);
  case 16:
    return nested ? write(out, code, n, place, letters, 16, true) : write(out, code, n, place, letters, 16, false);
  case 32:
    return nested ? write(out, code, n, place, letters, 32, true) : write(out, code, n, place, letters, 32, false);
  default:
    return nested ? write(out, code, n, place, letters, 64, true) : write(out, code, n, place, letters, 64, false);
  }
}

void lsys_step_letters(LsysScan *scan, LsysStream *out, const LsysLetters *letters) {
  const uint8_t *code = codes(scan, letters), *end = code + (scan->end - scan->sym);
  size_t most = scan->lengths ? 1 : BLOCK;
  Place place = begin_left(scan, letters->left);
  while (code < end) {
    if (out->sym_limit - out->sym < LSYS_LETTERS_ROOM((ptrdiff_t)letters->longest)) lsys_flush(out);
    size_t n = (size_t)(end - code), room = ((size_t)(out->sym_limit - out->sym) - letters->width) / letters->longest;
    n = n < room ? n : room;
    n = n < most ? n : most;
    if (letters->nested) make_room(scan, &place, n);
    uint8_t *behind = write_some(out->sym, code, n, &place, letters);
    if (scan->lengths) *scan->lengths++ = (uint64_t)(behind - out->sym);
    out->sym = behind;
    code += n;
  }
  scan->sym = scan->end;
}
