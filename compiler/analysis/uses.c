// uses.c -- Program -> sets of USES_* flags for its expressions, blocks and
// productions. Invariant: a set never lacks a flag; it may hold one that only
// an unreachable part of the expression needs.
#include "analysis/uses.h"

static unsigned value_uses(const Program *program, uint32_t slot) {
  if (slot < LSYS_SETTING_COUNT) return 0;
  size_t value = slot - LSYS_SETTING_COUNT;
  if (value >= program->value_count) return USES_GLOBAL;  // an element of an array
  return program->values[value].kind == VALUE_GLOBAL ? USES_GLOBAL : 0;
}

unsigned uses_expr(const Uses *uses, const Expr *expr) {
  if (!expr) return 0;
  unsigned found = 0;
  switch (expr->kind) {
  case EXPR_VALUE:
    found = value_uses(uses->program, expr->slot);
    break;
  case EXPR_ELEMENT:
    found = uses->program->arrays[expr->slot].constant ? 0 : USES_GLOBAL;
    break;
  case EXPR_APPLY:
    found = uses->functions[expr->slot];
    break;
  case EXPR_CALL:
    if (lsys_functions[expr->function].how == LSYS_FN_RANDOM) found = USES_DRAW;
    if (lsys_functions[expr->function].how == LSYS_FN_EFFECT || lsys_functions[expr->function].how == LSYS_FN_FILE)
      found = USES_EFFECT;
    break;
  default:
    break;
  }
  for (uint32_t i = 0; i < expr->count; i++) found |= uses_expr(uses, expr->args[i]);
  return found;
}

// Functions never recurse, so sweeping over them until nothing changes ends;
// sweeping in alternate directions makes a chain in file order, or against
// it, take two sweeps.
Uses uses_find(Arena *arena, const Program *program) {
  Uses uses = {program, arena_array(arena, program->function_count, sizeof(unsigned))};
  bool changed = true;
  for (bool forward = true; changed; forward = !forward) {
    changed = false;
    for (size_t i = 0; i < program->function_count; i++) {
      size_t f = forward ? i : program->function_count - 1 - i;
      unsigned found = uses_expr(&uses, program->functions[f].body);
      if (found != uses.functions[f]) changed = true;
      uses.functions[f] = found;
    }
  }
  return uses;
}

static unsigned uses_exprs(const Uses *uses, Expr *const *exprs, size_t count) {
  unsigned found = 0;
  for (size_t i = 0; i < count; i++) found |= uses_expr(uses, exprs[i]);
  return found;
}

unsigned uses_word(const Uses *uses, const Word *word) {
  unsigned found = 0;
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    found |= uses_exprs(uses, module->args, uses->program->kinds[module->kind].arity);
  }
  return found;
}

unsigned uses_actions(const Uses *uses, const Actions *actions) {
  unsigned found = 0;
  for (size_t i = 0; i < actions->count; i++) {
    const Action *action = &actions->at[i];
    if (action->kind == ACTION_SET_VALUE || action->kind == ACTION_SET_ELEMENT) found |= USES_WRITE;
    if (action->kind == ACTION_USE_TABLE) found |= USES_TABLE;
    found |= uses_expr(uses, action->value) | uses_exprs(uses, action->index, action->index_count);
    found |= uses_actions(uses, &action->then) | uses_actions(uses, &action->otherwise);
  }
  return found;
}

unsigned uses_production(const Uses *uses, const Production *p) {
  unsigned found = uses_expr(uses, p->match) | uses_expr(uses, p->guard) | uses_expr(uses, p->weight);
  found |= uses_actions(uses, &p->before) | uses_actions(uses, &p->after) | uses_word(uses, &p->successor);
  if (p->weight) found |= USES_DRAW;
  if (p->table >= 0) found |= USES_TABLE;
  if (p->left.count || p->right.count || p->strict.count != 1) found |= USES_CONTEXT;
  return found;
}

unsigned uses_values(const Uses *uses) {
  unsigned found = uses_exprs(uses, uses->program->settings, LSYS_SETTING_COUNT);
  for (size_t i = 0; i < uses->program->value_count; i++) found |= uses_expr(uses, uses->program->values[i].init);
  return found;
}

unsigned uses_blocks(const Uses *uses) {
  const Program *program = uses->program;
  return uses_actions(uses, &program->start) | uses_actions(uses, &program->start_each)
       | uses_actions(uses, &program->end_each) | uses_actions(uses, &program->end);
}
