// facts.h -- what can be known of a Program without deriving: one table that
// the code generator, describe() and `lsysc analyze` read.
#ifndef LSYSC_ANALYSIS_FACTS_H
#define LSYSC_ANALYSIS_FACTS_H

#include "frontend/program.h"
#include "lsys/abi.h"

typedef struct KindFacts {
  bool reachable;   // from an axiom, through productions and decomposition
  bool terminal;    // LSYS_KIND_TERMINAL
  bool fixed;       // LSYS_KIND_FIXED
  bool key;         // LSYS_KIND_KEY
  Productions own;  // the main system's productions whose strict predecessor it is (context-free or not), file order
  Productions decompositions, homomorphisms;  // likewise
} KindFacts;

// An L-system's productions by the kind of their (first) strict predecessor, each list in file order.
typedef struct SystemFacts {
  Productions *own, *decompositions, *homomorphisms;
  uint32_t view;  // what its contexts see
} SystemFacts;

typedef struct Facts {
  KindFacts *kinds;      // program->kind_count of them
  SystemFacts *systems;  // program->lsystem_count of them
  // L-systems that ignore the same symbols see the same word: for each such view, one that has it.
  const LSystem **views;
  uint32_t view_count;
  bool context_free;   // no contexts, pseudo-productions, cut, ring, queries, globals: the expand engine applies
  bool queries;        // a word can hold modules that ask the turtle or the environment
  bool deterministic;  // nothing draws
  bool parametric, bracketed, stochastic, sequential, tables;
  bool balanced;                             // brackets nest in every word
  bool counts_by_kind;                       // the growth matrix exists: counts depend on kinds alone
  LsysGrowth growth;                         // see abi.h; row == NULL unless counts_by_kind
  size_t longest_successor, most_arguments;  // over productions and decompositions, in modules and doubles
} Facts;

Facts *facts_find(Arena *arena, const Program *program);

// Productions by the kind of their (first) strict predecessor: one list per kind, each in file order.
Productions *productions_by_kind(Arena *arena, const Program *program, const Productions *productions);

// A bound on the modules of all words of a derivation of so many steps, images under the homomorphism included. Above
// limit it may be any number that is.
double work_bound(Arena *arena, const Program *program, const Facts *facts, uint64_t steps, double limit);

// The descriptor of a grammar with everything but its function pointers, in
// the arena. Code generation freezes it into constants, the interpreter and
// the JIT use it as it is.
LsysGrammar *describe(Arena *arena, const Program *program, const Facts *facts);

#endif
