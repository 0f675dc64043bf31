// check_kinds.c -- symbols with a number of arguments become kinds, numbered in
// the order in which they are asked for: the rule is at Kind in program.h.
#include "frontend/check.h"

#include <string.h>

// ---- declarations --------------------------------------------------------------

static Declaration *declared(Check *check, const char *symbol) {
  uint32_t index = map_find(check->declaration_map, symbol, 0);
  return index == MAP_NONE ? NULL : &check->declarations.at[index];
}

static Declaration *declaration_with(Check *check, const char *symbol, uint32_t arity) {
  Declaration *declaration = declared(check, symbol);
  while (declaration && !(declaration->has_arity && declaration->arity == arity))
    declaration = declaration->next == NONE ? NULL : &check->declarations.at[declaration->next];
  return declaration;
}

static Declaration *declare(Check *check, const char *name, Span span) {
  uint32_t *first = map_place(check->declaration_map, name, 0);
  Declaration new = {.name = name, .span = span, .next = *first};
  *first = (uint32_t)check->declarations.count;
  Declaration *declaration = VEC_PUSH(check->arena, &check->declarations);
  *declaration = new;
  return declaration;
}

static void declare_module(Check *check, const AstStatement *statement) {
  uint32_t arity = (uint32_t)statement->symbols.count;
  const Declaration *other = declaration_with(check, statement->name, arity);
  if (other) {
    diag_warning(check->diag, WARN_REDEFINED, statement->name_span, "`%s` with %u argument%s is declared twice",
                 statement->name, arity, arity == 1 ? "" : "s");
    diag_note(check->diag, other->span, "the other declaration is here");
    return;
  }
  Declaration *declaration = declare(check, statement->name, statement->name_span);
  declaration->has_arity = true;
  declaration->arity = arity;
  declaration->arg_names = arena_array(check->arena, arity, sizeof *declaration->arg_names);
  check_scope(check, SCOPE_CONSTANT);
  for (uint32_t i = 0; i < arity; i++) {
    const AstSymbol *argument = &statement->symbols.at[i];
    declaration->arg_names[i] = argument->name;
    const Slot *slot = check_bound(check, name_intern(check, argument->name));
    if (slot) {
      diag_error(check->diag, argument->span, "two arguments of `%s` are called `%s`", statement->name, argument->name);
      diag_note(check->diag, slot->span, "the other one is here");
    }
    check_bind(check, argument->name, argument->span);
  }
}

static void declare_surface(Check *check, const AstStatement *statement) {
  for (const Declaration *d = declared(check, statement->name); d;
       d = d->next == NONE ? NULL : &check->declarations.at[d->next])
    if (d->surface) {
      diag_error(check->diag, statement->name_span, "surface `%s` is declared twice", statement->name);
      diag_note(check->diag, d->span, "the other declaration is here");
      return;
    }
  declare(check, statement->name, statement->name_span)->surface = true;
}

void kinds_declare(Check *check, const AstStatement *statement) {
  if (statement->kind == AST_SURFACE)
    declare_surface(check, statement);
  else if (statement->name)
    declare_module(check, statement);
  // `#modules a b` says how a word is cut into symbols, which the scanner knows already.
  if (statement->name) *VEC_PUSH(check->arena, &check->symbols) = statement->name;
  for (size_t i = 0; !statement->name && i < statement->symbols.count; i++)
    *VEC_PUSH(check->arena, &check->symbols) = statement->symbols.at[i].name;
}

// ---- kinds ------------------------------------------------------------------------

// "2 arguments (age, vigor)"
static const char *arguments_text(Check *check, const Declaration *declaration) {
  const char *text =
    arena_printf(check->arena, "%u argument%s", declaration->arity, declaration->arity == 1 ? "" : "s");
  for (uint32_t i = 0; i < declaration->arity; i++)
    text = arena_printf(check->arena, "%s%s%s", text, i ? ", " : " (", declaration->arg_names[i]);
  return declaration->arity ? arena_printf(check->arena, "%s)", text) : text;
}

static void check_declared(Check *check, Kind *kind) {
  const Declaration *declaration = declaration_with(check, kind->symbol, kind->arity);
  if (declaration) kind->arg_names = declaration->arg_names;
  const Declaration *wanted = NULL;
  for (const Declaration *d = declared(check, kind->symbol); d;
       d = d->next == NONE ? NULL : &check->declarations.at[d->next]) {
    kind->draws_subfigure |= d->surface;
    if (d->has_arity) wanted = d;
  }
  if (declaration || !wanted) return;
  diag_error(check->diag, kind->span, "`%s` takes %s, not %u", kind->symbol, arguments_text(check, wanted),
             kind->arity);
  diag_note(check->diag, wanted->span, "it is declared here");
}

static void check_limits(Check *check, const Kind *kind) {
  if (kind->arity > 0 && (!strcmp(kind->symbol, "[") || !strcmp(kind->symbol, "]") || !strcmp(kind->symbol, "%")))
    diag_error(check->diag, kind->span, "`%s` takes no arguments", kind->symbol);
  if (kind->arity > MOST_ARGUMENTS)
    diag_error(check->diag, kind->span, "`%s` has %u arguments; a module may have %d", kind->symbol, kind->arity,
               MOST_ARGUMENTS);
  if (check->kinds.count == MOST_KINDS + 1)
    diag_error(check->diag, kind->span, "more than %d different kinds of modules", MOST_KINDS);
}

KindId kind_of(Check *check, const char *symbol, const char *text, size_t arity, Span span) {
  const char *name = text ? arena_printf(check->arena, "%s\"%s", symbol, text) : symbol;
  uint32_t *place = map_place(check->kind_map, name, arity);
  if (*place != MAP_NONE) return *place;
  KindId id = *place = (uint32_t)check->kinds.count;
  Kind *kind = VEC_PUSH(check->arena, &check->kinds);
  *kind =
    (Kind){.symbol = symbol, .text = text, .arity = (uint32_t)arity, .turtle = lsys_turtle_op(symbol), .span = span};
  *VEC_PUSH(check->arena, &check->predecessor) = false;
  check_declared(check, kind);
  check_limits(check, kind);
  return id;
}
