// word.h -- the interpreter's own form of a word: boxed modules with their
// kinds, keys and arguments. Its memory is charged to the run.
#ifndef LSYSC_INTERP_WORD_H
#define LSYSC_INTERP_WORD_H

#include "frontend/program.h"
#include "lsys/abi.h"

typedef struct Box {
  KindId kind;
  uint32_t depth;  // decomposition and homomorphism: levels left
  uint64_t key;
  size_t args;    // index of its first argument among the word's
  size_t from;    // of rewriting and homomorphism: which module of the word before it came from
  uint64_t born;  // the step in which it was written, where the run wants births
} Box;

// Arguments stand back to back in module order, so that dropping the last
// modules drops the last arguments.
typedef struct Boxes {
  Box *at;
  size_t count, capacity;
  double *arg;
  size_t arg_count, arg_capacity;
  size_t from;  // of modules that are pushed
} Boxes;

// Room for one more element of size bytes behind count; charges the run for
// it. Does not return when there is none.
void *boxes_grow(LsysRun *run, void *at, size_t count, size_t *capacity, size_t size);

#define BOXES_RESERVE(run, at, count, capacity)                                                                        \
  ((count) < (capacity) ? (void)0 : (void)((at) = boxes_grow((run), (at), (count), &(capacity), sizeof *(at))))

void boxes_clear(Boxes *word);
void boxes_free(Boxes *word);

// Appends a module whose arguments are pushed next.
void boxes_push(LsysRun *run, Boxes *word, KindId kind, uint64_t key);
void boxes_push_arg(LsysRun *run, Boxes *word, double value);

// Appends a copy of from's module i, with another key.
void boxes_copy(LsysRun *run, Boxes *word, const Program *program, const Boxes *from, size_t i, uint64_t key);

void boxes_copy_all(LsysRun *run, Boxes *word, const Program *program, const Boxes *from);

// Between the boxed and the packed form (abi.h). Packing writes keys of kinds
// that have them where with_keys is set.
// In parts of one birth where the run wants them.
void boxes_pack(const Boxes *word, const LsysGrammar *grammar, bool with_keys, LsysStream *out);
void boxes_unpack(LsysRun *run, Boxes *word, const LsysWord *packed);

#endif
