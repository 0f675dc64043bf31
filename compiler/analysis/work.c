// work.c -- how many modules a derivation goes through at most, before it runs.
//
// size(k, s), the most modules that one module of kind k can be after s steps,
// is the greatest over k's productions (or k itself, if none applies) of the
// sums over their successors of size(m, s - 1). Guards, weights, contexts and
// tables are taken to allow whatever is largest, so that this is a bound and
// no estimate. The work is the sum of the words' sizes over all steps.
#include "analysis/facts.h"

#include <math.h>
#include <string.h>

enum { MOST_STEPS = 10000, MOST_DEPTH = 64 };  // what is looked at

typedef enum Sort { OWN, DECOMPOSITION, HOMOMORPHISM } Sort;

typedef struct Bound {
  const Program *program;
  const Facts *facts;
  double *before, *after, *scratch;  // sizes by kind
} Bound;

// A kind's productions of one sort in one L-system.
static const Productions *productions_of(const SystemFacts *system, Sort sort, size_t kind) {
  const Productions *lists[] = {system->own, system->decompositions, system->homomorphisms};
  return &lists[sort][kind];
}

static double size_of(const Word *word, const double *sizes) {
  double size = 0;
  for (size_t i = 0; i < word->count; i++) size += sizes[word->at[i].kind];
  return size;
}

// to[k]: the most that a module of kind k is, or what it becomes, by the sizes in `from`.
static void rewrite(const Bound *bound, Sort sort, const double *from, double *to) {
  const Program *program = bound->program;
  memcpy(to, from, program->kind_count * sizeof *to);
  for (size_t s = 0; s < program->lsystem_count; s++)
    for (size_t k = 0; k < program->kind_count; k++) {
      const Productions *some = productions_of(&bound->facts->systems[s], sort, k);
      for (size_t i = 0; i < some->count; i++) to[k] = fmax(to[k], size_of(&some->at[i]->successor, from));
    }
}

// How deep sections of this sort go at most.
static unsigned depth_of(const Program *program, Sort sort) {
  double deepest = 0;
  for (size_t s = 0; s < program->lsystem_count; s++) {
    const LSystem *lsystem = &program->lsystems[s];
    const Rewriting *section = sort == DECOMPOSITION ? &lsystem->decomposition : &lsystem->homomorphism;
    double depth = 1;
    if (section->depth) expr_constant(program, section->depth, &depth);
    if (section->productions.count) deepest = fmax(deepest, depth);
  }
  return deepest < MOST_DEPTH ? (unsigned)deepest : MOST_DEPTH;
}

// The same in place, as often as a section may be applied to a module.
static void rewrite_deep(const Bound *bound, Sort sort, double *sizes) {
  size_t bytes = bound->program->kind_count * sizeof *sizes;
  for (unsigned d = depth_of(bound->program, sort); d > 0; d--) {
    rewrite(bound, sort, sizes, bound->scratch);
    if (memcmp(sizes, bound->scratch, bytes) == 0) return;
    memcpy(sizes, bound->scratch, bytes);
  }
}

static double size_of_axioms(const Bound *bound) {
  double size = 0;
  for (size_t a = 0; a < bound->program->axiom_count; a++) size += size_of(&bound->program->axioms[a], bound->before);
  return size;
}

double work_bound(Arena *arena, const Program *program, const Facts *facts, uint64_t steps, double limit) {
  if (steps > MOST_STEPS) return INFINITY;
  Bound bound = {.program = program, .facts = facts};
  bound.before = arena_array(arena, program->kind_count, sizeof(double));
  bound.after = arena_array(arena, program->kind_count, sizeof(double));
  bound.scratch = arena_array(arena, program->kind_count, sizeof(double));
  for (size_t k = 0; k < program->kind_count; k++) bound.before[k] = 1;
  rewrite_deep(&bound, HOMOMORPHISM, bound.before);
  double work = size_of_axioms(&bound);
  for (uint64_t s = 0; s < steps && work <= limit; s++) {
    rewrite_deep(&bound, DECOMPOSITION, bound.before);
    rewrite(&bound, OWN, bound.before, bound.after);
    double *swap = bound.before;
    bound.before = bound.after;
    bound.after = swap;
    work += size_of_axioms(&bound);
  }
  return work;
}
