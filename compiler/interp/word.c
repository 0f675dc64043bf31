// word.c -- boxed words: growing, copying, packing.
// Invariant: at[i].args + arity(at[i]) == at[i+1].args, and the last ends at
// arg_count.
#include "interp/word.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_CAPACITY = 64 };

void *boxes_grow(LsysRun *run, void *at, size_t count, size_t *capacity, size_t size) {
  size_t next = count < FIRST_CAPACITY ? FIRST_CAPACITY : count + count / 2;
  if (next < count || next > (size_t)INT64_MAX / size) lsys_fail(run, "the word is too long for this machine");
  lsys_charge(run, (int64_t)((next - *capacity) * size));
  void *grown = realloc(at, next * size);
  if (!grown) lsys_fail(run, "out of memory: the word does not fit");
  *capacity = next;
  return grown;
}

void boxes_clear(Boxes *word) {
  word->count = word->arg_count = 0;
}

void boxes_free(Boxes *word) {
  free(word->at);
  free(word->arg);
  *word = (Boxes){0};
}

void boxes_push(LsysRun *run, Boxes *word, KindId kind, uint64_t key) {
  BOXES_RESERVE(run, word->at, word->count, word->capacity);
  word->at[word->count++] = (Box){.kind = kind, .key = key, .args = word->arg_count, .from = word->from};
}

void boxes_push_arg(LsysRun *run, Boxes *word, double value) {
  BOXES_RESERVE(run, word->arg, word->arg_count, word->arg_capacity);
  word->arg[word->arg_count++] = value;
}

void boxes_copy(LsysRun *run, Boxes *word, const Program *program, const Boxes *from, size_t i, uint64_t key) {
  const Box *box = &from->at[i];
  boxes_push(run, word, box->kind, key);
  for (uint32_t a = 0; a < program->kinds[box->kind].arity; a++) boxes_push_arg(run, word, from->arg[box->args + a]);
}

void boxes_copy_all(LsysRun *run, Boxes *word, const Program *program, const Boxes *from) {
  boxes_clear(word);
  for (size_t i = 0; i < from->count; i++) {
    boxes_copy(run, word, program, from, i, from->at[i].key);
    word->at[i].born = from->at[i].born;
  }
}

static uint8_t *write_symbol(uint8_t *sym, KindId kind, bool wide) {
  if (!wide) {
    *sym = (uint8_t)kind;
    return sym + 1;
  }
  uint16_t symbol = (uint16_t)kind;
  memcpy(sym, &symbol, sizeof symbol);
  return sym + sizeof symbol;
}

void boxes_pack(const Boxes *word, const LsysGrammar *grammar, bool with_keys, LsysStream *out) {
  bool wide = grammar->flags & LSYS_GRAMMAR_WIDE;
  for (size_t i = 0; i < word->count; i++) {
    const Box *box = &word->at[i];
    const LsysKind *kind = &grammar->kinds[box->kind];
    bool key = with_keys && kind->flags & LSYS_KIND_KEY;
    if (out->run->births && box->born != out->run->born) {
      lsys_flush(out);
      out->run->born = box->born;
    }
    if (out->sym_limit - out->sym < 1 + wide) lsys_flush(out);
    out->sym = write_symbol(out->sym, box->kind, wide);
    for (uint32_t a = 0; a < kind->arity; a++) *out->arg++ = word->arg[box->args + a];
    if (key) *out->key++ = box->key;
  }
}

static KindId read_symbol(const uint8_t *sym, uint64_t i, bool wide) {
  if (!wide) return sym[i];
  uint16_t symbol;
  memcpy(&symbol, sym + 2 * i, sizeof symbol);
  return symbol;
}

void boxes_unpack(LsysRun *run, Boxes *word, const LsysWord *packed) {
  const LsysGrammar *grammar = run->grammar;
  bool wide = grammar->flags & LSYS_GRAMMAR_WIDE;
  const double *arg = packed->arg;
  const uint64_t *key = packed->key;
  boxes_clear(word);
  for (uint64_t i = 0; i < packed->nsym; i++) {
    KindId kind = read_symbol(packed->sym, i, wide);
    boxes_push(run, word, kind, grammar->kinds[kind].flags & LSYS_KIND_KEY ? *key++ : 0);
    for (uint32_t a = 0; a < grammar->kinds[kind].arity; a++) boxes_push_arg(run, word, *arg++);
  }
}
