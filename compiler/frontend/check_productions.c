// check_productions.c -- one production: its parameters are bound left to
// right, then blocks, guard, successor and weight are read in file order.
#include "frontend/check.h"

#include <string.h>

static bool given(const AstWord *word) {
  return word->span.end != 0;
}

static void check_predecessor(Check *check, const AstProduction *ast, const Production *production) {
  if (production->strict.count == 0)
    diag_error(check->diag, ast->arrow_span, "nothing stands before the arrow: a production needs a predecessor");
  if (check->section == SECTION_MAIN) return;
  const char *section = check->section == SECTION_DECOMPOSITION ? "decomposition" : "homomorphism";
  if (production->strict.count > 1)
    diag_error(check->diag, ast->strict.span, "a %s replaces one module at a time", section);
  if (check->section == SECTION_DECOMPOSITION && (given(&ast->left) || given(&ast->right)))
    diag_error(check->diag, given(&ast->left) ? ast->left.span : ast->right.span, "a decomposition has no contexts");
}

// `p : A --> B` reads `p` as a label, which may have been meant as a predecessor with the guard A.
static void check_label(Check *check, const AstProduction *ast) {
  if (!ast->label || ast->strict.modules.count == 0 || ast->strict.modules.at[0].args.count) return;
  const Name *name = name_intern(check, ast->label);
  const Definition *definition = name_definition(check, name);
  if (!definition) return;
  diag_warning(check->diag, WARN_LABEL, ast->label_span, "`%s` is read as a label here, but it is also a %s",
               ast->label, definition->param ? "param" : "#define");
  diag_note(check->diag, definition->span, "it is defined here");
  diag_hint(check->diag, "if `%s` is the module to replace write `%s()`; else give the label another name", ast->label,
            ast->label);
}

void check_unused(Check *check, size_t parameters) {
  for (size_t i = 0; i < parameters; i++) {
    const Slot *slot = &check->scope.slots.at[i];
    if (slot->name && !slot->used)
      diag_warning(check->diag, WARN_UNUSED_PARAMETER, slot->span, "parameter `%s` is never used", slot->name);
  }
}

// A weight is asked for right after the guard held: it does not see what `after` assigns.
static Expr *check_weight(Check *check, const AstExpr *weight, uint32_t visible) {
  uint32_t all = check->scope.visible;
  check->scope.visible = visible;
  Expr *result = weight ? check_expression(check, weight) : NULL;
  check->scope.visible = all;
  return result;
}

static const char **slot_names(const Check *check) {
  size_t count = check->scope.slots.count;
  const char **names = arena_array(check->arena, count, sizeof *names);
  for (size_t i = 0; i < count; i++) names[i] = check->scope.slots.at[i].name;
  return names;
}

static void note_predecessor(Check *check, const Production *production) {
  for (size_t i = 0; i < production->strict.count; i++) {
    const Pattern *pattern = &production->strict.at[i];
    check->predecessor.at[pattern->kind] = true;
  }
}

void check_production(Check *check, const AstStatement *statement) {
  const AstProduction *ast = statement->production;
  Production *production = ARENA_NEW(check->arena, Production);
  check_scope(check, SCOPE_PRODUCTION);
  check->literals.count = 0;
  production->label = ast->label;
  production->number = check->productions++;
  production->span = statement->span;
  production->head = span_join(span_join(ast->left.span, ast->strict.span), ast->right.span);
  production->table = check->section == SECTION_MAIN ? check->table : -1;
  production->left = check_context(check, &ast->left, SIDE_LEFT);
  production->strict = check_context(check, &ast->strict, SIDE_STRICT);
  production->right = check_context(check, &ast->right, SIDE_RIGHT);
  production->match = check_match(check);
  production->parameters = (uint32_t)check->scope.slots.count;
  check_predecessor(check, ast, production);
  check_label(check, ast);

  production->before = check_actions(check, &ast->before);
  uint32_t visible = check->scope.visible;
  if (ast->guard) production->guard = check_expression(check, ast->guard);
  production->after = check_actions(check, &ast->after);
  production->successor = check_word(check, &ast->successor, "successor");
  production->weight = check_weight(check, ast->weight, visible);

  production->locals = (uint32_t)check->scope.slots.count - production->parameters;
  production->slot_names = slot_names(check);
  check_unused(check, production->parameters);
  note_predecessor(check, production);
  *VEC_PUSH(check->arena, &check->system->productions[check->section]) = production;
}
