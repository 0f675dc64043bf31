// rewrite.h -- which production a module is rewritten by, and one rewriting
// of a whole word.
#ifndef LSYSC_INTERP_REWRITE_H
#define LSYSC_INTERP_REWRITE_H

#include "interp/context.h"

// One set of productions: an L-system's own, its decomposition or its homomorphism.
typedef struct Section {
  const LSystem *lsystem;
  const Rewriting *rewriting;  // NULL: the L-system's own productions
  Productions *of;             // per kind of the (first) strict predecessor
  bool contexts;               // some production has one
  Links links;                 // of the word being rewritten, if contexts
} Section;

typedef struct System {
  Section derivation, decomposition, homomorphism;
} System;

// A production that was found to apply, its frame and the sum of weights up to it.
typedef struct Candidate {
  const Production *production;
  size_t frame;
  double sum;
} Candidate;

typedef struct Interp {
  const Program *program;
  uint32_t *param_number;  // per value: which param it is
  System *systems;         // one per L-system
  Scope scope;             // of the rewriting under way
  Scope blocks;            // of Start, StartEach, EndEach, End; counts on over a derivation
  Candidate *candidates;
  size_t candidate_room;
  Boxes word, next;  // before and after what is under way
  Boxes stack;       // decomposition and homomorphism: what is left to do, the next on top
  Boxes successor;   // scratch of the same
  Boxes before;      // with births: the word before the step
  uint8_t *symbols;  // of the word, packed for the turtle to look at,
  uint64_t *keys;    //   and its keys
  size_t symbol_room, key_room;
  uint32_t *nesting;  // L-systems around the module at hand
  size_t nesting_room;
} Interp;

// One derivation step but for its blocks and its decomposition. step is its number, from 0.
void rewrite_word(Interp *interp, uint64_t step);

// Decomposition of the word at the end of a step. (unfold.c)
void decompose_word(Interp *interp);

// Replaces the word by what homomorphism makes of it. (unfold.c)
void homomorphism_word(Interp *interp);

// ---- shared by both -----------------------------------------------------------

void swap_words(Interp *interp);

// Finds the neighbours in the word if productions of the section have contexts; else NULL.
const Links *section_link(Interp *interp, Section *section);

// The number of the L-system that rewrites module i of the word: of the innermost ?(n) ... $ around it. The
// delimiters belong to the L-system outside. *depth: how many are open; 0 before module 0, then kept by the caller.
size_t system_at(Interp *interp, size_t *depth, size_t i);

#endif
