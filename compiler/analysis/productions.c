// productions.c -- Program -> the productions of each kind, in file order.
// A pseudo-production belongs to the kind of its first module.
#include "analysis/passes.h"

// Sums of weights up to this one stay finite; of infinite sums no share is ever drawn.
#define LARGEST_WEIGHT 1e300

static KindId head_kind(const Production *production) {
  return production->strict.at[0].kind;
}

// Appends each production of from to its kind's list.
static void group(Analysis *analysis, Productions *lists, size_t *room, const Productions *from) {
  for (size_t i = 0; i < from->count; i++) {
    KindId kind = head_kind(from->at[i]);
    Productions *list = &lists[kind];
    if (list->count == room[kind]) {
      list->at = vec_grow(analysis->arena, list->at, list->count, &room[kind], sizeof *list->at);
    }
    list->at[list->count++] = from->at[i];
  }
}

typedef const Productions *(*Section)(const LSystem *lsystem);

static const Productions *derivation(const LSystem *lsystem) {
  return &lsystem->productions;
}

static const Productions *decomposition(const LSystem *lsystem) {
  return &lsystem->decomposition.productions;
}

static const Productions *homomorphism(const LSystem *lsystem) {
  return &lsystem->homomorphism.productions;
}

// The first systems L-systems' productions of one or two sections, per kind.
static Productions *gather(Analysis *analysis, size_t systems, Section first, Section second) {
  const Program *program = analysis->program;
  Productions *lists = arena_array(analysis->arena, program->kind_count, sizeof *lists);
  size_t *room = arena_array(analysis->arena, program->kind_count, sizeof *room);
  for (size_t i = 0; i < systems; i++) {
    group(analysis, lists, room, first(&program->lsystems[i]));
    if (second) group(analysis, lists, room, second(&program->lsystems[i]));
  }
  return lists;
}

void find_productions(Analysis *analysis) {
  size_t every = analysis->program->lsystem_count;
  analysis->rewrites = gather(analysis, every, derivation, decomposition);
  analysis->images = gather(analysis, every, homomorphism, NULL);
  Productions *own = gather(analysis, 1, derivation, NULL);
  Productions *decompositions = gather(analysis, 1, decomposition, NULL);
  Productions *homomorphisms = gather(analysis, 1, homomorphism, NULL);
  for (size_t k = 0; k < analysis->program->kind_count; k++) {
    KindFacts *kind = &analysis->facts->kinds[k];
    kind->own = own[k];
    kind->decompositions = decompositions[k];
    kind->homomorphisms = homomorphisms[k];
  }
}

bool production_always(const Program *program, const Production *p) {
  if (p->left.count || p->right.count || p->strict.count != 1 || p->match || p->table >= 0) return false;
  double value;
  if (p->guard && !(expr_constant(program, p->guard, &value) && lsys_holds(value))) return false;
  return !p->weight || (expr_constant(program, p->weight, &value) && value > 0 && value <= LARGEST_WEIGHT);
}

bool production_never(const Program *program, const Production *p) {
  double value;
  return p->guard && expr_constant(program, p->guard, &value) && !lsys_holds(value);
}
