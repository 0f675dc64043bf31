// facts.c -- Program -> Facts: runs the passes in order and sums them up over
// the whole grammar.
// Requires: a Program from check(). Ensures: every pointer of Facts but
// growth.row is set; lists are in file order.
#include "analysis/passes.h"

static void sum_production(Facts *facts, const Program *program, const Production *production) {
  size_t modules = production->successor.count, arguments = word_arguments(program, &production->successor);
  if (modules > facts->longest_successor) facts->longest_successor = modules;
  if (arguments > facts->most_arguments) facts->most_arguments = arguments;
}

// What all rewriting productions together use.
static unsigned sum_productions(Analysis *analysis) {
  unsigned used = 0;
  for (size_t k = 0; k < analysis->program->kind_count; k++) {
    const Productions *rewrites = &analysis->rewrites[k];
    for (size_t p = 0; p < rewrites->count; p++) {
      used |= uses_production(&analysis->uses, rewrites->at[p]);
      sum_production(analysis->facts, analysis->program, rewrites->at[p]);
    }
  }
  return used;
}

static bool has_query(const Program *program, const Facts *facts) {
  for (size_t k = 0; k < program->kind_count; k++) {
    const char *symbol = program->kinds[k].symbol;
    if (facts->kinds[k].reachable && symbol[0] == '?' && symbol[1]) return true;
  }
  return false;
}

static bool has_blocks(const Program *program) {
  return program->start.count || program->start_each.count || program->end_each.count || program->end.count;
}

static unsigned homomorphism_uses(const Analysis *analysis) {
  unsigned used = 0;
  for (size_t k = 0; k < analysis->program->kind_count; k++) {
    const Productions *images = &analysis->images[k];
    for (size_t p = 0; p < images->count; p++) used |= uses_production(&analysis->uses, images->at[p]);
  }
  return used;
}

static unsigned axiom_uses(const Analysis *analysis) {
  unsigned used = 0;
  for (size_t i = 0; i < analysis->program->axiom_count; i++) {
    used |= uses_word(&analysis->uses, &analysis->program->axioms[i]);
  }
  return used;
}

static void classify(Analysis *analysis, unsigned used) {
  const Program *program = analysis->program;
  const LSystem *main_system = &program->lsystems[0];
  Facts *facts = analysis->facts;
  for (size_t k = 0; k < program->kind_count; k++) {
    if (!facts->kinds[k].reachable) continue;
    if (program->kinds[k].arity) facts->parametric = true;
    for (size_t p = 0; p < analysis->rewrites[k].count; p++) {
      if (analysis->rewrites[k].at[p]->weight) facts->stochastic = true;
    }
  }
  facts->bracketed = program->open != KIND_NONE && facts->kinds[program->open].reachable;
  facts->tables = (used & USES_TABLE) || main_system->table_count;
  facts->sequential = used & (USES_WRITE | USES_EFFECT);
  unsigned all = used | uses_values(&analysis->uses) | uses_blocks(&analysis->uses) | axiom_uses(analysis);
  facts->deterministic = !((all | homomorphism_uses(analysis)) & USES_DRAW);
  facts->queries = has_query(program, facts);
  bool by_place = main_system->ring || main_system->pseudo || program->cut != KIND_NONE || program->lsystem_count > 1;
  facts->context_free = !(used & (USES_CONTEXT | USES_GLOBAL | USES_WRITE | USES_EFFECT)) && !by_place
                     && !has_blocks(program) && !facts->queries;
}

Facts *facts_find(Arena *arena, const Program *program) {
  Facts *facts = ARENA_NEW(arena, Facts);
  facts->kinds = arena_array(arena, program->kind_count, sizeof *facts->kinds);
  Analysis analysis = {.arena = arena, .program = program, .facts = facts, .uses = uses_find(arena, program)};
  find_productions(&analysis);
  find_reachable(&analysis);
  find_keys(&analysis);
  find_fixed(&analysis);
  classify(&analysis, sum_productions(&analysis));
  find_balance(&analysis);
  find_growth(&analysis);
  return facts;
}
