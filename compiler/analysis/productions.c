// productions.c -- Program -> the productions of each kind, in file order.
// A pseudo-production belongs to the kind of its first module.
#include "analysis/passes.h"

// Sums of weights up to this one stay finite; of infinite sums no share is ever drawn.
#define LARGEST_WEIGHT 1e300

typedef struct Lists {
  Productions *of;  // per kind
  size_t *room;     // capacity of each
} Lists;

static Lists lists_create(Arena *arena, const Program *program) {
  return (Lists){arena_array(arena, program->kind_count, sizeof(Productions)),
                 arena_array(arena, program->kind_count, sizeof(size_t))};
}

static void append(Arena *arena, Lists *lists, const Productions *from) {
  for (size_t i = 0; i < from->count; i++) {
    KindId kind = from->at[i]->strict.at[0].kind;
    Productions *list = &lists->of[kind];
    if (list->count == lists->room[kind]) {
      list->at = vec_grow(arena, list->at, list->count, &lists->room[kind], sizeof(Production *));
    }
    list->at[list->count++] = from->at[i];
  }
}

Productions *productions_by_kind(Arena *arena, const Program *program, const Productions *productions) {
  Lists lists = lists_create(arena, program);
  append(arena, &lists, productions);
  return lists.of;
}

void find_productions(Analysis *analysis) {
  Arena *arena = analysis->arena;
  const Program *program = analysis->program;
  Lists rewrites = lists_create(arena, program), images = lists_create(arena, program);
  for (size_t i = 0; i < program->lsystem_count; i++) {
    append(arena, &rewrites, &program->lsystems[i].productions);
    append(arena, &rewrites, &program->lsystems[i].decomposition.productions);
    append(arena, &images, &program->lsystems[i].homomorphism.productions);
  }
  analysis->rewrites = rewrites.of;
  analysis->images = images.of;
  const LSystem *main_system = &program->lsystems[0];
  Productions *own = productions_by_kind(arena, program, &main_system->productions);
  Productions *decompositions = productions_by_kind(arena, program, &main_system->decomposition.productions);
  Productions *homomorphisms = productions_by_kind(arena, program, &main_system->homomorphism.productions);
  for (size_t k = 0; k < program->kind_count; k++) {
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
