// productions.c -- Program -> the productions of each kind, in file order.
// A pseudo-production belongs to the kind of its first module.
#include "analysis/passes.h"

#include <string.h>

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

static bool has_contexts(const Productions *productions) {
  for (size_t i = 0; i < productions->count; i++)
    if (productions->at[i]->left.count || productions->at[i]->right.count) return true;
  return false;
}

// The number of the view of the word that an L-system has; one without contexts takes any.
static uint32_t find_view(const Program *program, Facts *facts, const LSystem *lsystem) {
  bool looks = has_contexts(&lsystem->productions) || has_contexts(&lsystem->homomorphism.productions);
  uint32_t view = 0;
  for (; looks && view < facts->view_count; view++) {
    const LSystem *other = facts->views[view];
    if (other->ring == lsystem->ring && memcmp(other->ignored, lsystem->ignored, program->kind_count) == 0) break;
  }
  if (view == facts->view_count) facts->views[facts->view_count++] = lsystem;
  return view;
}

static void find_systems(Analysis *analysis) {
  Arena *arena = analysis->arena;
  const Program *program = analysis->program;
  Facts *facts = analysis->facts;
  facts->systems = arena_array(arena, program->lsystem_count, sizeof *facts->systems);
  facts->views = arena_array(arena, program->lsystem_count, sizeof *facts->views);
  for (size_t i = 0; i < program->lsystem_count; i++) {
    const LSystem *lsystem = &program->lsystems[i];
    SystemFacts *system = &facts->systems[i];
    system->own = productions_by_kind(arena, program, &lsystem->productions);
    system->decompositions = productions_by_kind(arena, program, &lsystem->decomposition.productions);
    system->homomorphisms = productions_by_kind(arena, program, &lsystem->homomorphism.productions);
    system->view = find_view(program, facts, lsystem);
  }
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
  find_systems(analysis);
  const SystemFacts *main_system = &analysis->facts->systems[0];
  for (size_t k = 0; k < program->kind_count; k++) {
    KindFacts *kind = &analysis->facts->kinds[k];
    kind->own = main_system->own[k];
    kind->decompositions = main_system->decompositions[k];
    kind->homomorphisms = main_system->homomorphisms[k];
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
