// check_names.c -- what names stand for: #define, param, globals and arrays are
// collected before anything is read, because they are seen before their place
// too; formal parameters and local variables are bound scope by scope.
#include "frontend/check.h"

#include <string.h>

// ---- names ---------------------------------------------------------------------

Name *name_intern(Check *check, const char *text) {
  uint32_t *index = map_place(check->name_map, text, 0);
  if (*index == MAP_NONE) {
    *index = (uint32_t)check->names.count;
    Name *name = ARENA_NEW(check->arena, Name);
    *name = (Name){.text = text, .global = NONE, .array = NONE};
    *VEC_PUSH(check->arena, &check->names) = name;
  }
  return check->names.at[*index];
}

// The definition that the current statement sees: the latest before it unless
// that was undefined, else the first one behind it. A #define does not see itself
// while there is an earlier one.
Definition *name_definition(const Check *check, const Name *name) {
  size_t low = 0, high = name->definitions.count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (name->definitions.at[middle].at < check->statement)
      low = middle + 1;
    else
      high = middle;
  }
  if (low > 0 && name->definitions.at[low - 1].until > check->statement) return &name->definitions.at[low - 1];
  return low < name->definitions.count ? &name->definitions.at[low] : NULL;
}

// ---- scopes --------------------------------------------------------------------------

void check_scope(Check *check, ScopeKind kind) {
  check->scope.kind = kind;
  check->scope.start = false;
  check->scope.number = ++check->scopes;
  check->scope.slots.count = 0;
  check->scope.visible = 0;
}

uint32_t check_bind(Check *check, const char *name, Span span) {
  Scope *scope = &check->scope;
  uint32_t slot = (uint32_t)scope->slots.count;
  *VEC_PUSH(check->arena, &scope->slots) = (Slot){name, span, false};
  scope->visible = slot + 1;
  if (name) {
    Name *bound = name_intern(check, name);
    bound->slot = slot;
    bound->scope = scope->number;
  }
  return slot;
}

Slot *check_bound(const Check *check, const Name *name) {
  const Scope *scope = &check->scope;
  return name->scope == scope->number && name->slot < scope->visible ? &scope->slots.at[name->slot] : NULL;
}

// ---- unknown names ---------------------------------------------------------------------

static const char *const constants[] = {"pi", "nan", "inf"};

bool name_is_bound(const Check *check, const Name *name) {
  return check_bound(check, name) || name->global != NONE || name->array != NONE || name_definition(check, name);
}

// What could have been meant by a name that is not bound: calls may mean functions too.
static const char *nearest(Check *check, const char *text, bool call) {
  enum { CONSTANTS = sizeof constants / sizeof *constants, ENOUGH_ERRORS = 100 };
  if (diag_errors(check->diag) > ENOUGH_ERRORS) return NULL;  // no longer shown
  const char **candidates =
    arena_array(check->arena, check->names.count + CONSTANTS + LSYS_FN_COUNT, sizeof *candidates);
  size_t count = 0;
  for (size_t i = 0; i < check->names.count; i++)
    if (name_is_bound(check, check->names.at[i]) && !strchr(check->names.at[i]->text, '.'))
      candidates[count++] = check->names.at[i]->text;
  for (size_t i = 0; i < CONSTANTS && !call; i++) candidates[count++] = constants[i];
  for (size_t i = 0; i < LSYS_FN_COUNT && call; i++) candidates[count++] = lsys_functions[i].name;
  return diag_nearest(text, candidates, count);
}

void name_unknown(Check *check, Name *name, Span span, bool call) {
  if (name->told == check->scope.number) return;
  name->told = check->scope.number;
  const char *what = call ? "function" : "name", *meant = nearest(check, name->text, call);
  if (check->partial && !meant) return;
  if (meant)
    diag_error(check->diag, span, "unknown %s `%s`; did you mean `%s`?", what, name->text, meant);
  else
    diag_error(check->diag, span, "unknown %s `%s`", what, name->text);
  if (name->definitions.count) {
    const Definition *last = &name->definitions.at[name->definitions.count - 1];
    diag_note(check->diag, last->undefined, "`%s` was undefined here", name->text);
  } else if (meant) {
    return;
  } else if (call && functions_are_meant(name->text)) {
    diag_hint(check->diag, "it needs a function or curve of a file, such as `%s`",
              *name->text == 'f' ? "function growth: growth.func" : "curve stem: stem.con");
  } else if (call) {
    diag_hint(check->diag, "define it with `#define %s(x) ...`", name->text);
  } else if (check->scope.kind == SCOPE_PRODUCTION) {
    diag_hint(check->diag, "a name is a formal parameter of the predecessor or comes from `#define %s ...`",
              name->text);
  } else {
    diag_hint(check->diag, "define it with `#define %s ...`", name->text);
  }
}

// ---- collecting ----------------------------------------------------------------------------

static const char *definition_word(const Definition *definition) {
  return definition->param ? "param" : "#define";
}

// False after an error, when the new definition does not count.
static bool may_define(Check *check, const Name *name, const AstStatement *statement) {
  bool param = statement->kind == AST_PARAM;
  if (function_named(name->text) != LSYS_FN_COUNT) {
    diag_error(check->diag, statement->name_span, "`%s` is a function of the language and cannot be defined anew",
               name->text);
    return false;
  }
  if (name->array != NONE) {
    diag_error(check->diag, statement->name_span, "`%s` is an array already", name->text);
    diag_note(check->diag, check->arrays.at[name->array].span, "the array is here");
    return false;
  }
  if (name->definitions.count == 0) return true;
  const Definition *last = &name->definitions.at[name->definitions.count - 1];
  if (last->until != NEVER && !param && !last->param) return true;
  if (param || last->param) {
    diag_error(check->diag, statement->name_span, "`%s` is defined twice", name->text);
    diag_note(check->diag, last->span, "the other %s is here", definition_word(last));
    return false;
  }
  diag_warning(check->diag, WARN_REDEFINED, statement->name_span, "`%s` is defined twice", name->text);
  diag_note(check->diag, last->span, "this first definition counts up to the second one");
  diag_hint(check->diag, "`#undef %s` between them says that this is meant", name->text);
  return true;
}

static void collect_definition(Check *check, const AstStatement *statement) {
  Name *name = name_intern(check, statement->name);
  if (!may_define(check, name, statement)) return;
  Definition definition = {.at = check->statement, .until = NEVER, .span = statement->name_span};
  definition.function = statement->kind == AST_DEFINE && statement->has_params;
  definition.param = statement->kind == AST_PARAM;
  if (definition.function) {
    definition.index = (uint32_t)check->functions.count;
    UserFunction *function = VEC_PUSH(check->arena, &check->functions);
    *function = (UserFunction){.name = name->text, .span = statement->name_span};
    function->arity = (uint32_t)statement->symbols.count;
  } else {
    definition.index = (uint32_t)check->values.count;
    Value *value = VEC_PUSH(check->arena, &check->values);
    *value = (Value){.kind = definition.param ? VALUE_PARAM : VALUE_DEFINE, .name = name->text};
    value->span = statement->name_span;
  }
  *VEC_PUSH(check->arena, &name->definitions) = definition;
}

static void collect_undef(Check *check, const AstStatement *statement) {
  Name *name = name_intern(check, statement->name);
  if (name->definitions.count == 0) return;
  Definition *last = &name->definitions.at[name->definitions.count - 1];
  if (last->param) {
    diag_error(check->diag, statement->name_span, "`%s` is a param and cannot be undefined", name->text);
    diag_note(check->diag, last->span, "the param is here");
  } else if (last->until == NEVER) {
    last->until = check->statement;
    last->undefined = statement->name_span;
  }
}

static void collect_array(Check *check, const AstArray *array) {
  Name *name = name_intern(check, array->name);
  if (name->array != NONE || name->definitions.count) {
    Span other = name->array != NONE ? check->arrays.at[name->array].span : name->definitions.at[0].span;
    diag_error(check->diag, array->span, "`%s` is defined twice", name->text);
    diag_note(check->diag, other, "the other definition is here");
    return;
  }
  name->array = (uint32_t)check->arrays.count;
  *VEC_PUSH(check->arena, &check->arrays) = (ArrayEntry){.array = array, .span = array->span};
}

static void collect_global(Check *check, const AstExpr *target) {
  if (target->kind != AST_NAME) return;
  Name *name = name_intern(check, target->name);
  if (name->global != NONE) return;
  name->global = (uint32_t)check->globals.count;
  *VEC_PUSH(check->arena, &check->globals) = (Value){VALUE_GLOBAL, .name = name->text, .span = target->span};
}

static void collect_globals(Check *check, const AstActions *actions) {
  if (!check_deeper(check, actions->count ? actions->at[0]->span : (Span){0, 0})) return;
  for (size_t i = 0; i < actions->count; i++) {
    const AstAction *action = actions->at[i];
    if (action->kind == AST_ASSIGN) collect_global(check, action->target);
    bool reads = action->kind == AST_EVALUATE && action->value->kind == AST_CALL
              && function_named(action->value->name) == LSYS_FN_FSCANF;
    for (size_t k = 2; reads && k < action->value->args.count; k++) collect_global(check, action->value->args.at[k]);
    collect_globals(check, &action->then);
    collect_globals(check, &action->otherwise);
  }
  check->depth--;
}

// Globals stand behind all other values; a name cannot be both.
static void place_globals(Check *check) {
  uint32_t first = (uint32_t)check->values.count;
  for (size_t i = 0; i < check->globals.count; i++) *VEC_PUSH(check->arena, &check->values) = check->globals.at[i];
  for (size_t i = 0; i < check->names.count; i++) {
    Name *name = check->names.at[i];
    if (name->global == NONE) continue;
    name->global += first;
    Span other = {0, 0};
    if (name->definitions.count) other = name->definitions.at[0].span;
    if (name->array != NONE) other = check->arrays.at[name->array].span;
    if (other.end == 0) continue;
    diag_error(check->diag, check->values.at[name->global].span, "`%s` is a constant and cannot be assigned",
               name->text);
    diag_note(check->diag, other, "it is defined here; give the variable another name");
  }
}

void check_collect(Check *check) {
  const Ast *ast = check->ast;
  check_scope(check, SCOPE_CONSTANT);
  systems_begin(check);
  for (check->statement = 0; check->statement < ast->statements.count; check->statement++) {
    const AstStatement *statement = &ast->statements.at[check->statement];
    switch (statement->kind) {
    case AST_DEFINE:
    case AST_PARAM:
      collect_definition(check, statement);
      break;
    case AST_UNDEF:
      collect_undef(check, statement);
      break;
    case AST_ARRAYS:
      for (size_t i = 0; i < statement->arrays.count; i++) collect_array(check, &statement->arrays.at[i]);
      break;
    case AST_BLOCK:
      collect_globals(check, &statement->actions);
      break;
    case AST_FUNCTION:
    case AST_CURVE:
    case AST_CONTOUR:
      functions_collect(check, statement);
      break;
    case AST_MODULES:
    case AST_SURFACE:
      kinds_declare(check, statement);
      break;
    default:
      systems_collect(check, statement);
      break;
    }
  }
  functions_collected(check);
  systems_number(check);
  place_globals(check);
}
