// check_environment.c -- what `environment:` names and queries ask: `environment: occupancy(cell=0.5)`.
#include "frontend/check.h"

#include <math.h>
#include <string.h>

// The environment of a name; LSYS_ENVIRONMENT_COUNT after an error.
static LsysEnvironmentId environment_named(Check *check, const AstExpr *value) {
  const char *names[LSYS_ENVIRONMENT_COUNT], *list = "";
  for (int id = 0; id < LSYS_ENVIRONMENT_COUNT; id++) {
    names[id] = lsys_environment_table[id].name;
    if (strcmp(names[id], value->name) == 0) return (LsysEnvironmentId)id;
    list = arena_printf(check->arena, "%s%s%s", list, *list ? ", " : "", names[id]);
  }
  const char *meant = diag_nearest(value->name, names, LSYS_ENVIRONMENT_COUNT);
  if (meant)
    diag_error(check->diag, value->name_span, "unknown environment `%s`; did you mean `%s`?", value->name, meant);
  else
    diag_error(check->diag, value->name_span, "unknown environment `%s`", value->name);
  diag_hint(check->diag, "there are %s, and shared objects by their names in quotes", list);
  return LSYS_ENVIRONMENT_COUNT;
}

// The place of a parameter; LSYS_ENVIRONMENT_VALUES after an error.
static size_t parameter_named(Check *check, const LsysEnvironmentInfo *info, const AstExpr *name) {
  const char *list = "";
  for (size_t i = 0; i < LSYS_ENVIRONMENT_VALUES && *info->parameter[i]; i++) {
    if (strcmp(info->parameter[i], name->name) == 0) return i;
    list = arena_printf(check->arena, "%s%s`%s`", list, i ? " and " : "", info->parameter[i]);
  }
  diag_error(check->diag, name->span, "`%s` has no parameter `%s`", info->name, name->name);
  diag_hint(check->diag, *list ? "its parameters are %s" : "it has %snone", list);
  return LSYS_ENVIRONMENT_VALUES;
}

static void read_parameter(Check *check, const LsysEnvironmentInfo *info, const AstExpr *given) {
  if (given->kind == AST_POISON) return;
  if (given->kind != AST_BINARY || given->op != OP_EQ || given->a->kind != AST_NAME) {
    diag_error(check->diag, given->span, "a parameter of an environment is written `name=value`");
    return;
  }
  size_t place = parameter_named(check, info, given->a);
  Expr *expr = check_expression(check, given->b);
  if (place < LSYS_ENVIRONMENT_VALUES && expr != check->poison) check->parameters[place] = expr;
}

static void finish_parameter(Check *check, size_t place) {
  const Expr *expr = check->parameters[place];
  double *value = &check->program->environment_value[place];
  if (expr && (!expr_constant(check->program, expr, value) || !isfinite(*value) || !(*value > 0)))
    diag_error(check->diag, expr->span, "`%s` is a number above 0 that is known when the grammar is compiled",
               lsys_environment_table[check->program->environment].parameter[place]);
}

void check_environment(Check *check, const AstStatement *statement) {
  Program *program = check->program;
  const AstExpr *value = statement->value;
  if (check->environment) {
    diag_warning(check->diag, WARN_REDEFINED, statement->span, "`environment:` is given twice; the last one counts");
    diag_note(check->diag, check->environment->span, "the other one is here");
  }
  check->environment = statement;
  program->environment_path = NULL;
  memset(check->parameters, 0, sizeof check->parameters);
  check_scope(check, SCOPE_CONSTANT);
  if (value->kind == AST_STRING) {
    program->environment = LSYS_ENVIRONMENT_FILE;
    program->environment_path = value->text;
  } else if (value->kind == AST_NAME || value->kind == AST_CALL) {
    LsysEnvironmentId id = environment_named(check, value);
    if (id == LSYS_ENVIRONMENT_COUNT) return;
    program->environment = id;
    const LsysEnvironmentInfo *info = &lsys_environment_table[program->environment];
    memcpy(program->environment_value, info->value, sizeof info->value);
    for (size_t i = 0; i < value->args.count; i++) read_parameter(check, info, value->args.at[i]);
  } else if (value->kind != AST_POISON) {
    diag_error(check->diag, value->span, "an environment is a name, with parameters in parentheses if it has any");
    diag_hint(check->diag, "such as `environment: occupancy(cell=0.5)`");
  }
}

void check_queries(Check *check) {
  Program *program = check->program;
  bool talks = false;
  for (size_t i = 0; i < LSYS_ENVIRONMENT_VALUES; i++) finish_parameter(check, i);
  for (size_t k = 0; k < check->kinds.count; k++) {
    const Kind *kind = &check->kinds.at[k];
    if (kind->symbol[0] != '?' || !kind->symbol[1]) continue;
    talks |= kind->turtle == LSYS_TURTLE_QUERY_ENVIRONMENT;
    if (kind->turtle != LSYS_TURTLE_NONE) continue;
    diag_error(check->diag, kind->span, "`%s` is no query: there are ?P, ?H, ?L, ?U, ?F, and ?E for the environment",
               kind->symbol);
  }
  if (talks && !check->environment && !check->ast->rules.no_environment) program->environment = LSYS_ENVIRONMENT_POINT;
}
