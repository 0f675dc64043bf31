// reach.c -- productions of each kind -> which kinds can occur, which change,
// which carry keys, which are words known in advance. Each is the least (or
// greatest) set closed under "occurs in a successor of".
#include "analysis/passes.h"

// ---- reachable -------------------------------------------------------------

typedef struct Work {
  KindId *at;  // kinds marked but not yet followed
  size_t count;
} Work;

static void reach_word(Analysis *analysis, Work *work, const Word *word) {
  for (size_t i = 0; i < word->count; i++) {
    KindId kind = word->at[i].kind;
    if (analysis->facts->kinds[kind].reachable) continue;
    analysis->facts->kinds[kind].reachable = true;
    work->at[work->count++] = kind;
  }
}

void find_reachable(Analysis *analysis) {
  const Program *program = analysis->program;
  Work work = {arena_array(analysis->arena, program->kind_count, sizeof(KindId)), 0};
  for (size_t i = 0; i < program->axiom_count; i++) reach_word(analysis, &work, &program->axioms[i]);
  while (work.count) {
    const Productions *rewrites = &analysis->rewrites[work.at[--work.count]];
    for (size_t i = 0; i < rewrites->count; i++) {
      if (!production_never(program, rewrites->at[i])) reach_word(analysis, &work, &rewrites->at[i]->successor);
    }
  }
}

// ---- keys ------------------------------------------------------------------

// Spreads flag from kinds to the kinds whose successors they occur in, until
// nothing changes. Alternate directions: a chain of kinds takes two sweeps.
static void spread(const Analysis *analysis, const Productions *lists, bool *flag) {
  size_t count = analysis->program->kind_count;
  bool changed = true;
  for (bool forward = true; changed; forward = !forward) {
    changed = false;
    for (size_t i = 0; i < count; i++) {
      size_t k = forward ? i : count - 1 - i;
      for (size_t p = 0; !flag[k] && p < lists[k].count; p++) {
        const Word *successor = &lists[k].at[p]->successor;
        for (size_t m = 0; !flag[k] && m < successor->count; m++) flag[k] = flag[successor->at[m].kind];
        changed |= flag[k];
      }
    }
  }
}

static void mark_using(const Analysis *analysis, const Productions *lists, unsigned wanted, bool *flag) {
  for (size_t k = 0; k < analysis->program->kind_count; k++) {
    for (size_t p = 0; p < lists[k].count; p++) {
      if (uses_production(&analysis->uses, lists[k].at[p]) & wanted) flag[k] = true;
    }
  }
}

// A kind has a key if a draw can be reached from it: through its homomorphism,
// which starts from it, or through what the derivation makes of it.
void find_keys(Analysis *analysis) {
  size_t count = analysis->program->kind_count;
  bool *draws = arena_array(analysis->arena, count, sizeof *draws);
  mark_using(analysis, analysis->images, USES_DRAW, draws);
  spread(analysis, analysis->images, draws);
  mark_using(analysis, analysis->rewrites, USES_DRAW, draws);
  spread(analysis, analysis->rewrites, draws);
  for (size_t k = 0; k < count; k++) analysis->facts->kinds[k].key = draws[k];
}

// ---- terminal and fixed ----------------------------------------------------

static bool is_query(const Kind *kind) {
  return kind->symbol[0] == '?' && kind->symbol[1];
}

// A fixed kind is one without arguments from which neither a draw nor state
// nor a neighbour is reached, nor a kind whose homomorphism draws: its modules
// need keys. Where the place in the word decides what
// happens to a module (cut, sub-L-systems), none is.
void find_fixed(Analysis *analysis) {
  const Program *program = analysis->program;
  size_t count = program->kind_count;
  bool by_place = program->cut != KIND_NONE || program->lsystems[0].pseudo || program->lsystem_count > 1;
  bool *varies = arena_array(analysis->arena, count, sizeof *varies);
  mark_using(analysis, analysis->rewrites, USES_DRAW | USES_STATE | USES_CONTEXT, varies);
  for (size_t k = 0; k < count; k++) varies[k] |= by_place || is_query(&program->kinds[k]);
  spread(analysis, analysis->rewrites, varies);
  for (size_t k = 0; k < count; k++) {
    KindFacts *kind = &analysis->facts->kinds[k];
    kind->fixed = program->kinds[k].arity == 0 && !varies[k] && !kind->key;
    kind->terminal = analysis->rewrites[k].count == 0 && !is_query(&program->kinds[k]) && k != program->cut;
  }
  // The second and later modules of a pseudo-production's predecessor are replaced too.
  for (size_t s = 0; s < program->lsystem_count; s++) {
    const Productions *productions = &program->lsystems[s].productions;
    for (size_t p = 0; p < productions->count; p++) {
      const Context *strict = &productions->at[p]->strict;
      for (size_t m = 1; m < strict->count; m++) analysis->facts->kinds[strict->at[m].kind].terminal = false;
    }
  }
}
