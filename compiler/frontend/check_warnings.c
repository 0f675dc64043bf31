// check_warnings.c -- what is allowed but hardly meant, one warning at a time.
// Which productions stand in each other's way is check_families.c's.
#include "frontend/check.h"

#include <math.h>
#include <string.h>

// ---- productions one by one -----------------------------------------------------

static void warn_guard(Check *check, const Production *production) {
  double value;
  if (!production->guard || !expr_literal(production->guard, &value)) return;
  diag_warning(check->diag, WARN_CONSTANT_GUARD, production->guard->span,
               lsys_holds(value) ? "this condition always holds" : "this condition never holds");
  diag_hint(check->diag,
            lsys_holds(value) ? "without it the production does the same" : "the production never applies");
}

static void warn_weight(Check *check, const Production *production) {
  double value;
  if (!production->weight || !expr_constant(check->program, production->weight, &value) || value > 0) return;
  diag_warning(check->diag, WARN_WEIGHT_ZERO, production->weight->span,
               "a production of weight %g is never chosen: a weight is greater than 0", value);
}

static void note_list(Check *check, const System *system, const char *symbol) {
  for (size_t i = system->lists.count; i-- > 0;) {
    const AstStatement *list = system->lists.at[i];
    if (list->kind == AST_CONSIDER) diag_note(check->diag, list->span, "contexts see the symbols of this list only");
    if (list->kind == AST_CONSIDER) return;
    for (size_t j = 0; j < list->symbols.count; j++) {
      if (strcmp(list->symbols.at[j].name, symbol) != 0) continue;
      diag_note(check->diag, list->symbols.at[j].span, "it is ignored here");
      return;
    }
  }
}

static void warn_context(Check *check, const System *system, const bool *ignored, const Context *context) {
  for (size_t i = 0; i < context->count; i++) {
    const Pattern *pattern = &context->at[i];
    if (pattern->what != PATTERN_MODULE || !ignored[pattern->kind]) continue;
    const char *symbol = check->program->kinds[pattern->kind].symbol;
    diag_warning(check->diag, WARN_IMPOSSIBLE_CONTEXT, pattern->span,
                 "this context is never found: contexts do not see `%s`", symbol);
    note_list(check, system, symbol);
    return;
  }
}

static void warn_productions(Check *check, const System *system, const Productions *productions) {
  const bool *ignored = check->program->lsystems[system->number].ignored;
  for (size_t i = 0; i < productions->count; i++) {
    const Production *production = productions->at[i];
    warn_guard(check, production);
    warn_weight(check, production);
    warn_context(check, system, ignored, &production->left);
    warn_context(check, system, ignored, &production->right);
  }
}

// ---- expressions ------------------------------------------------------------------------

static void warn_divisions(Check *check) {
  for (size_t i = 0; i < check->divisions.count; i++) {
    const Expr *division = check->divisions.at[i], *divisor = division->args[1];
    double value;
    if (expr_constant(check->program, divisor, &value) && value == 0)
      diag_warning(check->diag, WARN_DIVISION, divisor->span, "division by 0: the result is infinite or nan");
  }
}

static void warn_unused_definitions(Check *check) {
  for (size_t i = 0; i < check->names.count; i++) {
    const Name *name = check->names.at[i];
    for (size_t j = 0; j < name->definitions.count; j++)
      if (!name->definitions.at[j].used && !name->definitions.at[j].made)
        diag_warning(check->diag, WARN_UNUSED_DEFINE, name->definitions.at[j].span, "`%s` is never used", name->text);
  }
}

// ---- kinds ---------------------------------------------------------------------------------

static const char *with_arguments(Check *check, uint32_t arity) {
  if (arity == 0) return "without arguments";
  return arena_printf(check->arena, "with %u argument%s", arity, arity == 1 ? "" : "s");
}

// `A(x) --> ...` where all words have `A` alone: the production waits for a module that never comes.
static void warn_arity(Check *check) {
  const Program *program = check->program;
  const bool *reached = check_reachable(check);
  Map *staying = map_create(check->arena);  // symbol -> a kind in the words that nothing replaces
  for (uint32_t i = 0; i < program->kind_count; i++)
    if (reached[i] && !check->predecessor.at[i]) *map_place(staying, program->kinds[i].symbol, 0) = i;
  for (uint32_t i = 0; i < program->kind_count; i++) {
    const Kind *kind = &program->kinds[i];
    uint32_t other = map_find(staying, kind->symbol, 0);
    if (reached[i] || !check->predecessor.at[i] || other == MAP_NONE) continue;
    diag_warning(check->diag, WARN_ARITY, kind->span, "`%s` %s never stands in a word, only `%s` %s", kind->symbol,
                 with_arguments(check, kind->arity), kind->symbol, with_arguments(check, program->kinds[other].arity));
    diag_note(check->diag, program->kinds[other].span, "such a one is here, and no production replaces it");
  }
}

// A production that waits for a symbol that no word holds, whatever its arguments.
static void warn_never(Check *check, const Productions *productions, const Map *standing) {
  for (size_t i = 0; i < productions->count; i++) {
    const Context *strict = &productions->at[i]->strict;
    for (size_t j = 0; j < strict->count; j++) {
      const char *symbol = check->program->kinds[strict->at[j].kind].symbol;
      if (strict->at[j].what != PATTERN_MODULE || map_find(standing, symbol, 0) != MAP_NONE) continue;
      diag_warning(check->diag, WARN_UNREACHABLE, strict->at[j].span,
                   "this production never applies: `%s` never stands in a word", symbol);
      if (strict->count > 1)
        diag_hint(check->diag,
                  "it asks for %zu modules in a row; a condition stands behind a `:`, as in `A(x) : x > 1`",
                  strict->count);
      break;
    }
  }
}

static void warn_symbols(Check *check) {
  const Program *program = check->program;
  const bool *reached = check_reachable(check);
  Map *standing = map_create(check->arena);
  for (uint32_t i = 0; i < program->kind_count; i++)
    if (reached[i]) *map_place(standing, program->kinds[i].symbol, 0) = i;
  for (size_t i = 0; i < program->lsystem_count; i++) {
    warn_never(check, &program->lsystems[i].productions, standing);
    warn_never(check, &program->lsystems[i].decomposition.productions, standing);
    warn_never(check, &program->lsystems[i].homomorphism.productions, standing);
  }
}

// ---- decompositions and homomorphisms that do not end -----------------------------------------

typedef struct Step {
  const Production *production;
  size_t next;  // module of its successor
} Step;

typedef VEC(Step) Steps;

typedef struct Endless {
  Check *check;
  const Production **always;  // per kind: the production that replaces it whatever its arguments are, NULL
  bool *open, *done;          // per kind
  double depth;
} Endless;

static bool is_unconditional(const Production *p) {
  return !p->left.count && !p->right.count && !p->match && !p->guard && !p->weight && p->strict.count == 1;
}

static void begin(const Endless *endless, Steps *path, KindId kind) {
  endless->open[kind] = true;
  *VEC_PUSH(endless->check->arena, path) = (Step){endless->always[kind], 0};
}

static void follow(const Endless *endless, KindId root) {
  Steps path = {0};
  begin(endless, &path, root);
  while (path.count) {
    Step *step = &path.at[path.count - 1];
    const Production *production = step->production;
    if (step->next == production->successor.count) {
      KindId kind = production->strict.at[0].kind;
      endless->open[kind] = false;
      endless->done[kind] = true;
      path.count--;
      continue;
    }
    const Module *module = &production->successor.at[step->next++];
    if (endless->open[module->kind]) {
      diag_warning(endless->check->diag, WARN_HOMOMORPHISM_DEPTH, module->span,
                   "this comes back to a module that is being replaced: only the maximum depth of %g ends it",
                   endless->depth);
      step->next = production->successor.count;  // one warning for a production
    } else if (endless->always[module->kind] && !endless->done[module->kind]) {
      begin(endless, &path, module->kind);
    }
  }
}

static void warn_endless(Check *check, const Rewriting *section) {
  const Program *program = check->program;
  Endless endless = {.check = check};
  if (!section->depth || !expr_constant(program, section->depth, &endless.depth) || endless.depth <= 1) return;
  endless.always = arena_array(check->arena, program->kind_count, sizeof *endless.always);
  endless.open = arena_array(check->arena, program->kind_count, sizeof(bool));
  endless.done = arena_array(check->arena, program->kind_count, sizeof(bool));
  const Productions *productions = &section->productions;
  for (size_t i = productions->count; i-- > 0;)
    if (is_unconditional(productions->at[i]))
      endless.always[productions->at[i]->strict.at[0].kind] = productions->at[i];
  for (uint32_t kind = 0; kind < program->kind_count; kind++)
    if (endless.always[kind] && !endless.done[kind]) follow(&endless, kind);
}

// ---- settings -------------------------------------------------------------------------------

static bool setting(const Check *check, LsysSetting which, double *value) {
  const Expr *expr = check->program->settings[which];
  return expr && expr->span.end && expr_constant(check->program, expr, value);
}

static void warn_step(Check *check) {
  double step, steps;
  if (!setting(check, LSYS_SETTING_STEP, &step) || !setting(check, LSYS_SETTING_STEPS, &steps)) return;
  if (step < 2 || step != trunc(step) || steps > 1) return;
  diag_warning(check->diag, WARN_STEP_STEPS, check->program->settings[LSYS_SETTING_STEP]->span,
               "`step:` is the length of F; was this meant as `steps:`, the number of derivation steps?");
  diag_note(check->diag, check->program->settings[LSYS_SETTING_STEPS]->span, "the number of steps is given here");
}

// pi times a fraction with a small denominator, written with at least 3 digits.
static void warn_radians(Check *check) {
  enum { MOST_PARTS = 12 };
  double angle;
  if (!setting(check, LSYS_SETTING_ANGLE, &angle)) return;
  for (int parts = 1; parts <= MOST_PARTS; parts++) {
    double turns = fabs(angle) * parts / M_PI, whole = round(turns);
    if (whole < 1 || fabs(angle) > 2 * M_PI + 0.001 || fabs(turns - whole) > 0.0005 * whole) continue;
    diag_warning(check->diag, WARN_TURNS, check->program->settings[LSYS_SETTING_ANGLE]->span,
                 "angles are in degrees; %g radians are %g", angle, 180 * whole / parts);
    return;
  }
}

void check_warnings(Check *check) {
  warn_divisions(check);
  for (size_t i = 0; i < check->systems.count; i++) {
    const LSystem *lsystem = &check->program->lsystems[i];
    const System *system = check->systems.at[i];
    warn_productions(check, system, &lsystem->productions);
    warn_productions(check, system, &lsystem->decomposition.productions);
    warn_productions(check, system, &lsystem->homomorphism.productions);
    warn_endless(check, &lsystem->decomposition);
    warn_endless(check, &lsystem->homomorphism);
  }
  warn_arity(check);
  warn_symbols(check);
  warn_unused_definitions(check);
  warn_step(check);
  warn_radians(check);
}
