// choose.c -- the production for one module: the first in the file that
// holds; if that has a weight, one drawn among all that hold and have one.
// Guards and weights are evaluated in file order and only if reached, which
// is what the repetitions of draws inside them count.
#include "interp/choose.h"

static void bind_strict(Scope *scope, const Program *program, const Pattern *pattern, const Boxes *word, size_t at) {
  const Box *box = &word->at[at];
  for (uint32_t a = 0; a < program->kinds[box->kind].arity; a++) {
    scope->slot[scope->base + pattern->slot + a] = word->arg[box->args + a];
  }
}

static bool match_strict(Interp *interp, const Production *production, const Subject *subject) {
  for (size_t i = 0; i < production->strict.count; i++) {
    const Pattern *pattern = &production->strict.at[i];
    if (subject->at + i >= subject->word->count) return false;
    if (subject->word->at[subject->at + i].kind != pattern->kind) return false;
    bind_strict(&interp->scope, interp->program, pattern, subject->word, subject->at + i);
  }
  return true;
}

static bool match_contexts(Interp *interp, const Production *production, const Subject *subject) {
  if (!production->left.count && !production->right.count) return true;
  if (!subject->links) return false;
  size_t first = subject->place, last = first + production->strict.count - 1;
  return match_left(subject->links, &production->left, first, last, &interp->scope)
      && match_right(subject->links, &production->right, first, last, &interp->scope);
}

// Binds the production's parameters in the current frame and tells whether it applies.
static bool holds(Interp *interp, const Production *production, const Subject *subject) {
  if (!match_strict(interp, production, subject) || !match_contexts(interp, production, subject)) return false;
  if (production->match && !evaluate_holds(&interp->scope, production->match)) return false;
  execute(&interp->scope, &production->before);
  return !production->guard || evaluate_holds(&interp->scope, production->guard);
}

static double weight(Interp *interp, const Production *production) {
  double value = evaluate(&interp->scope, production->weight);
  return value > 0 ? value : 0;  // nan counts 0 too
}

// Candidate j is the first with u W < w1 + ... + wj.
static const Production *draw(Interp *interp, size_t count) {
  if (!count) return NULL;
  double u = lsys_draw(interp->scope.key, 0), all = interp->candidates[count - 1].sum;
  for (size_t j = 0; j < count; j++) {
    const Candidate *candidate = &interp->candidates[j];
    if (u * all < candidate->sum) {
      interp->scope.base = candidate->frame;
      return candidate->production;
    }
  }
  return NULL;
}

const Production *choose(Interp *interp, const Section *section, int64_t table, const Subject *subject) {
  Scope *scope = &interp->scope;
  const Box *box = &subject->word->at[subject->at];
  const Productions *list = &section->of[box->kind];
  size_t count = 0;
  double sum = 0;
  scope_start(scope, box->key);
  for (size_t i = 0; i < list->count; i++) {
    const Production *production = list->at[i];
    if (production->table >= 0 && table >= 0 && production->table != table) continue;
    if (count && !production->weight) continue;
    scope_push(scope, (size_t)production->parameters + production->locals);
    if (!holds(interp, production, subject)) {
      scope_pop(scope);
      continue;
    }
    if (!production->weight) return production;
    sum += weight(interp, production);
    BOXES_RESERVE(scope->run, interp->candidates, count, interp->candidate_room);
    interp->candidates[count++] = (Candidate){production, scope->base, sum};
  }
  return draw(interp, count);
}

// As choose, but changes nothing: blocks are not run, nothing is drawn, and what depends on either counts as holding.
bool suspects(Interp *interp, const Section *section, const Subject *subject) {
  Scope *scope = &interp->scope;
  const Box *box = &subject->word->at[subject->at];
  const Productions *list = &section->of[box->kind];
  for (size_t i = 0; i < list->count; i++) {
    const Production *p = list->at[i];
    scope_start(scope, box->key);
    scope_push(scope, (size_t)p->parameters + p->locals);
    if (!match_strict(interp, p, subject) || !match_contexts(interp, p, subject)) continue;
    if (p->match && !evaluate_holds(scope, p->match)) continue;
    if (!p->guard || p->before.count || expr_draws(interp->program, p->guard)) return true;
    if (evaluate_holds(scope, p->guard)) return true;
  }
  return false;
}

void replace(Interp *interp, const Production *production, uint64_t key, Boxes *out) {
  Scope *scope = &interp->scope;
  execute(scope, &production->after);
  for (size_t j = 0; j < production->successor.count; j++) {
    const Module *module = &production->successor.at[j];
    boxes_push(scope->run, out, module->kind, lsys_split(key, j));
    for (uint32_t a = 0; a < interp->program->kinds[module->kind].arity; a++) {
      double value = evaluate(scope, module->args[a]);
      boxes_push_arg(scope->run, out, value);
    }
  }
}
