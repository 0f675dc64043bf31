// check_systems.c -- which L-system and section a statement stands in, and what
// is known of an L-system only at the end of the file: ignored symbols, the
// schedule of tables, depths, seeds.
#include "frontend/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- collecting ------------------------------------------------------------------

static System *add_system(Check *check) {
  System *system = ARENA_NEW(check->arena, System);
  system->number = (uint32_t)check->systems.count;
  *VEC_PUSH(check->arena, &check->systems) = system;
  return system;
}

static bool is_content(const AstStatement *statement) {
  return statement->kind == AST_AXIOM || statement->kind == AST_PRODUCTION || statement->kind == AST_DECOMPOSITION
      || statement->kind == AST_HOMOMORPHISM || statement->kind == AST_TABLE;
}

// cpfg writes its main L-system as `Lsystem: 1` too: if nothing stands outside, the first one is the main one.
static bool first_is_main(const Ast *ast) {
  bool inside = false, any = false;
  for (size_t i = 0; i < ast->statements.count; i++) {
    const AstStatement *statement = &ast->statements.at[i];
    if (statement->kind == AST_LSYSTEM) inside = any = true;
    if (statement->kind == AST_ENDLSYSTEM) inside = false;
    if (!inside && is_content(statement)) return false;
  }
  return any;
}

static void collect_system(Check *check, const AstStatement *statement) {
  uint32_t *place = map_place(check->system_map, statement->name, 0);
  if (*place != MAP_NONE) {
    diag_error(check->diag, statement->name_span, "L-system `%s` is defined twice", statement->name);
    diag_note(check->diag, check->systems.at[*place]->span, "the other one is here");
    return;
  }
  System *first = check->systems.at[0];
  bool main = check->first_is_main && !first->name;
  check->system = main ? first : add_system(check);
  check->system->name = statement->name;
  check->system->span = statement->name_span;
  *place = check->system->number;
}

static void collect_table(Check *check, const AstStatement *statement) {
  System *system = check->system;
  uint32_t *place = map_place(check->table_map, statement->name, system->number);
  if (*place != MAP_NONE) {
    diag_error(check->diag, statement->name_span, "table `%s` is defined twice", statement->name);
    diag_note(check->diag, system->tables.at[*place].span, "the other one is here");
    return;
  }
  *place = (uint32_t)system->tables.count;
  *VEC_PUSH(check->arena, &system->tables) = (Table){statement->name, statement->name_span};
}

void systems_begin(Check *check) {
  check->first_is_main = first_is_main(check->ast);
  check->system = add_system(check);
}

void systems_collect(Check *check, const AstStatement *statement) {
  if (statement->kind == AST_LSYSTEM)
    collect_system(check, statement);
  else if (statement->kind == AST_ENDLSYSTEM)
    check->system = check->systems.at[0];
  else if (statement->kind == AST_TABLE)
    collect_table(check, statement);
}

// The number that a name is; false: it is none, or a large one.
static bool is_whole(const char *name, uint64_t *number) {
  size_t digits = strspn(name, "0123456789");
  if (digits == 0 || digits > 9 || name[digits]) return false;
  *number = strtoull(name, NULL, 10);
  return true;
}

// `?(n)` calls an L-system whose name is a number, as in cpfg, by that, the others by the numbers that are left.
void systems_number(Check *check) {
  for (size_t i = 0; i < check->systems.count; i++) {
    System *system = check->systems.at[i];
    if (system->name && is_whole(system->name, &system->called))
      *map_place(check->called_map, NULL, system->called) = (uint32_t)i;
  }
  uint64_t next = 0;
  for (size_t i = 0; i < check->systems.count; i++) {
    System *system = check->systems.at[i];
    if (system->name && is_whole(system->name, &system->called)) continue;
    while (map_find(check->called_map, NULL, next) != MAP_NONE) next++;
    system->called = next;
    *map_place(check->called_map, NULL, next) = (uint32_t)i;
  }
}

// ---- names ------------------------------------------------------------------------------

static void unknown(Check *check, const char *what, const char *name, Span span, const char *const *names,
                    size_t count) {
  const char *meant = diag_nearest(name, names, count);
  if (meant)
    diag_error(check->diag, span, "unknown %s `%s`; did you mean `%s`?", what, name, meant);
  else if (!check->partial)
    diag_error(check->diag, span, "unknown %s `%s`", what, name);
}

uint32_t system_named(Check *check, const char *name, Span span) {
  uint32_t index = map_find(check->system_map, name, 0);
  if (index != MAP_NONE) return index;
  size_t count = check->systems.count;
  const char **names = arena_array(check->arena, count, sizeof *names);
  for (size_t i = 0; i < count; i++) names[i] = check->systems.at[i]->name;
  unknown(check, "L-system", name, span, names, count);
  if (count == 1 && !check->partial) diag_hint(check->diag, "define it with `lsystem: %s` ... `endlsystem`", name);
  return NONE;
}

uint32_t table_named(Check *check, const System *system, const char *name, Span span) {
  uint32_t index = map_find(check->table_map, name, system->number);
  if (index != MAP_NONE) return index;
  size_t count = system->tables.count;
  const char **names = arena_array(check->arena, count, sizeof *names);
  for (size_t i = 0; i < count; i++) names[i] = system->tables.at[i].name;
  unknown(check, "table", name, span, names, count);
  if (count == 0 && !check->partial) diag_hint(check->diag, "begin it with `table %s:`", name);
  return NONE;
}

// ---- ignore and consider ----------------------------------------------------------------

static bool is_bracket(const char *symbol) {
  return strcmp(symbol, "[") == 0 || strcmp(symbol, "]") == 0;
}

enum { IGNORED = 1, CONSIDERED = 2 };

static void list_symbols(Check *check, Map *lists, const AstStatement *statement) {
  bool ignore = statement->kind == AST_IGNORE;
  for (size_t i = 0; i < statement->symbols.count; i++) {
    const AstSymbol *symbol = &statement->symbols.at[i];
    if (is_bracket(symbol->name) && ignore)
      diag_warning(check->diag, WARN_BRACKETS, symbol->span, "`%s` is never ignored: brackets say where branches are",
                   symbol->name);
    uint32_t *place = map_place(lists, symbol->name, 0);
    *place = (*place == MAP_NONE ? 0 : *place) | (ignore ? IGNORED : CONSIDERED);
  }
}

// Which kinds context matching does not see: what is ignored, and what is not considered if anything is.
static bool *ignored_kinds(Check *check, const System *system) {
  Map *lists = map_create(check->arena);
  bool consider = false, *ignored = arena_array(check->arena, check->kinds.count, sizeof(bool));
  size_t from = 0;
  if (check->ast->rules.last_ignore_counts && system->lists.count) from = system->lists.count - 1;
  for (size_t i = from; i < system->lists.count; i++) {
    list_symbols(check, lists, system->lists.at[i]);
    consider |= system->lists.at[i]->kind == AST_CONSIDER;
  }
  for (size_t i = 0; i < check->kinds.count; i++) {
    const char *symbol = check->kinds.at[i].symbol;
    uint32_t found = map_find(lists, symbol, 0), flags = found == MAP_NONE ? 0 : found;
    ignored[i] = !is_bracket(symbol) && ((flags & IGNORED) || (consider && !(flags & CONSIDERED)));
  }
  return ignored;
}

// ---- tables ---------------------------------------------------------------------------------

static void finish_tables(Check *check, const System *system, LSystem *result) {
  result->table_count = system->tables.count;
  result->tables = arena_array(check->arena, system->tables.count, sizeof *result->tables);
  for (size_t i = 0; i < system->tables.count; i++) result->tables[i] = system->tables.at[i].name;
  const AstStatement *schedule = system->schedule;
  if (!schedule) {
    if (system->tables.count && !(check->uses_tables && system->number == 0) && !check->partial) {
      diag_error(check->diag, system->tables.at[0].span, "no step uses table `%s`", system->tables.at[0].name);
      diag_hint(check->diag, "say which table each step uses with `tables: %s ...`", system->tables.at[0].name);
    }
    return;
  }
  result->schedule_count = schedule->symbols.count;
  result->schedule = arena_array(check->arena, schedule->symbols.count, sizeof *result->schedule);
  for (size_t i = 0; i < schedule->symbols.count; i++)
    result->schedule[i] = table_named(check, system, schedule->symbols.at[i].name, schedule->symbols.at[i].span);
}

// ---- constants ------------------------------------------------------------------------------

// A whole number from low to high, or low after an error.
static double whole(Check *check, const Expr *expr, const char *what, double low, double high) {
  double value;
  if (expr == check->poison) return low;
  if (!expr_constant(check->program, expr, &value)) {
    diag_error(check->diag, expr->span, "%s has to be known when the grammar is compiled", what);
    return low;
  }
  if (value == trunc(value) && value >= low && value <= high) return value;
  if (value > low && value == trunc(value))
    diag_error(check->diag, expr->span, "%s is at most %.0f", what, high);
  else
    diag_error(check->diag, expr->span, "%s is a whole number, %.0f or more", what, low);
  return low;
}

static void finish_rewriting(Check *check, const System *system, Section section, Rewriting *result) {
  Expr *depth = system->depth[section], *seed = system->seed[section];
  result->warnings = system->warnings[section];
  result->productions = (Productions){system->productions[section].at, system->productions[section].count};
  if (depth) {
    double value = whole(check, depth, "the maximum depth", 1, MOST_REWRITING);
    result->depth = expr_number(check->arena, value, depth->span);
  }
  if (seed) {
    result->has_seed = true;
    result->seed = (uint64_t)whole(check, seed, "a seed", 0, LARGEST_WHOLE);
  }
}

static bool is_pseudo(const ProductionList *productions) {
  for (size_t i = 0; i < productions->count; i++)
    if (productions->at[i]->strict.count > 1) return true;
  return false;
}

static void finish_system(Check *check, const System *system, LSystem *result) {
  const ProductionList *productions = &system->productions[SECTION_MAIN];
  result->name = system->name;
  result->called = (double)system->called;
  result->ring = system->ring;
  result->pseudo = is_pseudo(productions);
  result->productions = (Productions){productions->at, productions->count};
  result->ignored = ignored_kinds(check, system);
  finish_rewriting(check, system, SECTION_DECOMPOSITION, &result->decomposition);
  finish_rewriting(check, system, SECTION_HOMOMORPHISM, &result->homomorphism);
  finish_tables(check, system, result);
}

// cpfg: among productions of one predecessor of which some have a weight, one without counts 1. With `seed:` all that
// hold compete, weights or not.
static void weigh_all(Check *check, ProductionList *productions, bool seeded) {
  Map *weighted = map_create(check->arena), *found = map_create(check->arena);
  for (size_t i = 0; i < productions->count; i++) {
    const Production *p = productions->at[i];
    if (!p->strict.count) continue;
    uint32_t *earlier = map_place(found, NULL, p->strict.at[0].kind);
    if (p->weight || (seeded && *earlier != MAP_NONE)) *map_place(weighted, NULL, p->strict.at[0].kind) = 1;
    *earlier = 1;
  }
  for (size_t i = 0; i < productions->count; i++) {
    Production *p = productions->at[i];
    if (!p->weight && p->strict.count && map_find(weighted, NULL, p->strict.at[0].kind) != MAP_NONE)
      p->weight = expr_number(check->arena, 1, p->span);
  }
}

// ---- settings -------------------------------------------------------------------------------

static void finish_settings(Check *check) {
  Program *program = check->program;
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) program->settings[i] = check->settings[i];
  Expr *steps = program->settings[LSYS_SETTING_STEPS];
  double value;
  if (steps && steps != check->poison && expr_constant(program, steps, &value)) {
    whole(check, steps, "the number of steps", 0, LARGEST_WHOLE);
    if (value > 0 && value < 1) diag_hint(check->diag, "the length of F is given by `step:`");
  }
  const Expr *seed = check->seed ? check->seed : check->start_seed;
  if (seed) program->seed = (uint64_t)whole(check, seed, "a seed", 0, LARGEST_WHOLE);
}

void check_systems(Check *check) {
  Program *program = check->program;
  finish_settings(check);
  program->lsystem_count = check->systems.count;
  program->lsystems = arena_array(check->arena, check->systems.count, sizeof(LSystem));
  for (size_t i = 0; i < check->systems.count; i++) {
    System *system = check->systems.at[i];
    for (int section = 0; section < SECTION_COUNT && check->ast->rules.unweighted_counts_one; section++)
      weigh_all(check, &system->productions[section], check->seed && i == 0 && section == SECTION_MAIN);
    finish_system(check, system, &program->lsystems[i]);
  }
  for (size_t i = 0; i < check->kinds.count; i++) check->kinds.at[i].ignored = program->lsystems[0].ignored[i];
}
