// balance.c -- do brackets nest in every word? They do if they nest in every
// start word and in every successor that can be reached: rewriting then
// replaces a module by a nested word, and a cut removes one.
#include "analysis/passes.h"

static bool nests(const Program *program, const Word *word) {
  size_t depth = 0;
  for (size_t i = 0; i < word->count; i++) {
    KindId kind = word->at[i].kind;
    if (kind == program->open) depth++;
    if (kind == program->close && depth-- == 0) return false;
  }
  return depth == 0;
}

void find_balance(Analysis *analysis) {
  const Program *program = analysis->program;
  bool balanced = true;
  for (size_t i = 0; i < program->axiom_count; i++) balanced &= nests(program, &program->axioms[i]);
  for (size_t k = 0; k < program->kind_count; k++) {
    if (!analysis->facts->kinds[k].reachable) continue;
    const Productions *rewrites = &analysis->rewrites[k];
    for (size_t p = 0; p < rewrites->count; p++) balanced &= nests(program, &rewrites->at[p]->successor);
  }
  analysis->facts->balanced = balanced;
}
