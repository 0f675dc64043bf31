// check_actions.c -- statement blocks (cpfg): in a production's blocks a name
// that is assigned is a local variable, unless a global or a parameter has it;
// in Start, StartEach, EndEach and End it is a global, found by check_names.c.
#include "frontend/check.h"

#include <string.h>

enum { MOST_DIGITS = 4 };  // of a width or precision that is printed with

static Actions actions_of(Check *check, const AstActions *actions);

// ---- assignments ----------------------------------------------------------------

static void assign_name(Check *check, const AstExpr *target, Action *action) {
  Name *name = name_intern(check, target->name);
  const Slot *slot = check_bound(check, name);
  if (slot) {
    action->kind = ACTION_SET_LOCAL;
    action->slot = name->slot;
  } else if (name->global != NONE) {
    action->kind = ACTION_SET_VALUE;
    action->slot = LSYS_SETTING_COUNT + name->global;
  } else if (name_definition(check, name)) {
    diag_error(check->diag, target->span, "`%s` is a constant and cannot be assigned", name->text);
    diag_note(check->diag, name_definition(check, name)->span, "it is defined here");
  } else {
    action->kind = ACTION_SET_LOCAL;
    action->slot = check_bind(check, name->text, target->span);
    check->scope.slots.at[action->slot].used = true;
  }
}

static void assign_element(Check *check, const AstExpr *target, Action *action) {
  uint32_t array = check_element(check, target, &action->index);
  action->kind = ACTION_SET_ELEMENT;
  action->slot = array;
  action->index_count = (uint32_t)target->args.count;
}

static Expr *file_value(Check *check, const AstExpr *call, LsysFunction function);

// The value first: a variable does not see its own first assignment.
static void assign(Check *check, const AstAction *ast, Action *action) {
  LsysFunction function = ast->value->kind == AST_CALL ? function_named(ast->value->name) : LSYS_FN_COUNT;
  bool file = function != LSYS_FN_COUNT && lsys_functions[function].how == LSYS_FN_FILE;
  action->value = file ? file_value(check, ast->value, function) : check_expression(check, ast->value);
  if (ast->target->kind == AST_NAME)
    assign_name(check, ast->target, action);
  else if (ast->target->kind == AST_INDEX)
    assign_element(check, ast->target, action);
  else if (ast->target->kind != AST_POISON)
    diag_error(check->diag, ast->target->span, "only a variable or an element of an array can be assigned");
}

// ---- calls for their effect --------------------------------------------------------

static void use_table(Check *check, const AstExpr *call, Action *action) {
  if (check->scope.kind != SCOPE_BLOCK) {
    diag_error(check->diag, call->span, "a table is chosen before a step: `useTable` stands in Start or StartEach");
    return;
  }
  if (call->args.count != 1 || call->args.at[0]->kind != AST_STRING) {
    diag_error(check->diag, call->span, "`useTable` takes the name of a table in quotes");
    return;
  }
  const AstExpr *name = call->args.at[0];
  action->kind = ACTION_USE_TABLE;
  action->slot = table_named(check, check->systems.at[0], name->text, name->span);
  check->uses_tables = true;
}

// cpfg sets its stream of random numbers back with srand. Here there is no stream: before the derivation it
// chooses the seed, and behind that it has nothing to do.
static void seed_random(Check *check, const AstExpr *call, Action *action) {
  action->kind = ACTION_IF;
  action->value = expr_number(check->arena, 0, call->span);
  if (call->args.count != 1) {
    diag_error(check->diag, call->span, "`srand` takes one argument, not %zu", call->args.count);
    return;
  }
  Expr *seed = check_expression(check, call->args.at[0]);
  double value;
  if (seed == check->poison) return;
  if (check->scope.start && expr_constant(check->program, seed, &value))
    check->start_seed = seed;
  else
    diag_remark(check->diag, call->span,
                "`srand` does nothing here: what a module draws depends on its place and the seed alone");
}

// The number of values that a printf format asks for; -1 after an error.
static int conversions(Check *check, const char *name, const AstExpr *format) {
  int count = 0;
  for (const char *c = format->text; *c; c++) {
    if (*c != '%') continue;
    if (*++c == '%') continue;
    c += strspn(c, "-+ #0");
    size_t width = strspn(c, "0123456789"), precision = c[width] == '.' ? 1 + strspn(c + width + 1, "0123456789") : 0;
    if (width > MOST_DIGITS || precision > 1 + MOST_DIGITS) {
      diag_error(check->diag, format->span, "a width in the text is too big: it has %d digits at most", MOST_DIGITS);
      return -1;
    }
    c += width + precision;
    if (*c == 'l') c++;
    if (!*c || !strchr("difFeEgG", *c)) {
      diag_error(check->diag, format->span, "`%s` prints numbers: after `%%` it knows d, i, f, e and g", name);
      return -1;
    }
    count++;
  }
  return count;
}

void check_format(Check *check, const char *name, const AstExpr *format, size_t values, Span span) {
  int wanted = conversions(check, name, format), given = (int)values;
  if (wanted >= 0 && wanted != given)
    diag_error(check->diag, span, "the text asks for %d value%s, but %d %s given", wanted, wanted == 1 ? "" : "s",
               given, given == 1 ? "is" : "are");
}

static Expr *text_expr(Check *check, const AstExpr *ast) {
  Expr *text = ARENA_NEW(check->arena, Expr);
  *text = (Expr){EXPR_STRING, .text = ast->text, .span = ast->span};
  return text;
}

// printf(text, ...), fprintf(file, text, ...)
static void print_numbers(Check *check, const AstExpr *call, Expr *result) {
  size_t first = result->function == LSYS_FN_FPRINTF;
  const AstExpr *format = call->args.at[first];
  if (first) result->args[0] = check_expression(check, call->args.at[0]);
  if (format->kind != AST_STRING) {
    diag_error(check->diag, format->span, "`%s` prints by a text in quotes: `%s\"x = %%g\\n\", x)`", call->name,
               first ? "fprintf(f, " : "printf(");
    return;
  }
  check_format(check, "printf", format, call->args.count - first - 1, call->span);
  result->args[first] = text_expr(check, format);
  for (size_t i = first + 1; i < call->args.count; i++) result->args[i] = check_expression(check, call->args.at[i]);
}

static Expr *effect(Check *check, const AstExpr *call, LsysFunction function) {
  const LsysFunctionInfo *info = &lsys_functions[function];
  int count = (int)call->args.count;
  if (count < info->least || (info->most >= 0 && count > info->most)) {
    diag_error(check->diag, call->span, "`%s` takes %s, not %d", info->name, function_arguments(check, info), count);
    return check->poison;
  }
  Expr *result = ARENA_NEW(check->arena, Expr);
  *result = (Expr){EXPR_CALL, .function = function, .count = (uint32_t)count, .span = call->span};
  result->args = arena_array(check->arena, call->args.count, sizeof(Expr *));
  if (function == LSYS_FN_PRINTF || function == LSYS_FN_FPRINTF)
    print_numbers(check, call, result);
  else
    result->args = check_arguments(check, &call->args);
  return result;
}

// A value that nothing uses: nothing is done for it, but its names and calls are checked and numbered.
static void compute_idly(Check *check, const AstExpr *value, Action *action) {
  if (check->ast->rules.idle_values)
    diag_warning(check->diag, WARN_UNUSED_VALUE, value->span, "this statement computes a value that nothing uses");
  else
    diag_error(check->diag, value->span, "this statement computes a value that nothing uses");
  if (value->kind == AST_BINARY && value->op == OP_EQ && value->a->kind == AST_NAME)
    diag_hint(check->diag, "`%s = ...;` assigns", value->a->name);
  check_expression(check, value);
  action->kind = ACTION_IF;
  action->value = expr_number(check->arena, 0, value->span);
}

// fopen("name", "mode"), fscanf(file): what an assignment gets.
static Expr *file_value(Check *check, const AstExpr *call, LsysFunction function) {
  bool opens = function == LSYS_FN_FOPEN;
  const AstExprs *args = &call->args;
  Expr *result = ARENA_NEW(check->arena, Expr);
  *result = (Expr){EXPR_CALL, .function = function, .count = (uint32_t)args->count, .span = call->span};
  result->args = arena_array(check->arena, args->count, sizeof(Expr *));
  if (!opens && args->count == 1) {
    result->args[0] = check_expression(check, args->at[0]);
    return result;
  }
  bool texts = opens && args->count == 2 && args->at[0]->kind == AST_STRING && args->at[1]->kind == AST_STRING;
  if (texts
      && (!strcmp(args->at[1]->text, "r") || !strcmp(args->at[1]->text, "w") || !strcmp(args->at[1]->text, "a"))) {
    for (int i = 0; i < 2; i++) result->args[i] = text_expr(check, args->at[i]);
    return result;
  }
  diag_error(check->diag, call->span, "%s",
             opens ? "`fopen` takes a file's name and \"r\", \"w\" or \"a\", both in quotes"
                   : "as a value `fscanf(f)` is the next number of a file and takes the file alone");
  return check->poison;
}

// fscanf(file, text, x, y, ...) reads a number into each.
static void scan_numbers(Check *check, const AstExpr *call, Action *action) {
  size_t count = call->args.count < 3 ? 0 : call->args.count - 2;
  const AstExpr *format = call->args.count > 1 ? call->args.at[1] : call;
  size_t wanted = 0, letters = 0;
  bool plain = format->kind == AST_STRING;
  for (const char *c = plain ? format->text : ""; *c; c++) {
    wanted += *c == '%';
    letters += !strchr("%lfgde \t\n", *c);
  }
  if (!plain || letters || !count || wanted != count) {
    diag_error(check->diag, call->span,
               "`fscanf` reads numbers: `fscanf(f, \"%%f %%f\", x, y)` with as many conversions as variables");
    return;
  }
  *action = (Action){ACTION_IF, .value = expr_number(check->arena, 1, call->span), .span = call->span};
  action->then.count = count;
  action->then.at = arena_array(check->arena, count, sizeof(Action));
  for (size_t i = 0; i < count; i++) {
    AstExpr *read = ARENA_NEW(check->arena, AstExpr);
    *read = *call;
    read->args.count = 1;
    AstAction step = {AST_ASSIGN, call->args.at[i + 2]->span, .target = call->args.at[i + 2], .value = read};
    action->then.at[i].span = step.span;
    assign(check, &step, &action->then.at[i]);
  }
}

static void evaluate(Check *check, const AstExpr *value, Action *action) {
  LsysFunction function = value->kind == AST_CALL ? function_named(value->name) : LSYS_FN_COUNT;
  if (value->kind == AST_POISON) return;
  if (function == LSYS_FN_FOPEN)
    diag_error(check->diag, value->span, "`fopen` gives the file's number, which nothing uses here: `f = fopen(...);`");
  else if (function == LSYS_FN_FSCANF)
    scan_numbers(check, value, action);
  else if (function == LSYS_FN_USE_TABLE)
    use_table(check, value, action);
  else if (function == LSYS_FN_SRAND)
    seed_random(check, value, action);
  else if (function != LSYS_FN_COUNT && lsys_functions[function].how == LSYS_FN_EFFECT)
    action->value = effect(check, value, function);
  else if (value->kind == AST_CALL && function == LSYS_FN_COUNT)
    name_unknown(check, name_intern(check, value->name), value->name_span, true);
  else
    compute_idly(check, value, action);
}

// ---- statements ------------------------------------------------------------------------

static void action_of(Check *check, const AstAction *ast, Action *action) {
  static const ActionKind kinds[] = {[AST_IF] = ACTION_IF, [AST_WHILE] = ACTION_WHILE, [AST_DO] = ACTION_DO};
  action->span = ast->span;
  switch (ast->kind) {
  case AST_ASSIGN:
    assign(check, ast, action);
    break;
  case AST_EVALUATE:
    action->kind = ACTION_EVALUATE;
    evaluate(check, ast->value, action);
    break;
  case AST_IF:
  case AST_WHILE:
    action->kind = kinds[ast->kind];
    action->value = check_expression(check, ast->value);
    action->then = actions_of(check, &ast->then);
    action->otherwise = actions_of(check, &ast->otherwise);
    break;
  case AST_DO:
    action->kind = kinds[ast->kind];
    action->then = actions_of(check, &ast->then);
    action->value = check_expression(check, ast->value);
    break;
  }
}

static Actions actions_of(Check *check, const AstActions *actions) {
  Actions result = {0};
  if (actions->count == 0 || !check_deeper(check, actions->at[0]->span)) return result;
  result.count = actions->count;
  result.at = arena_array(check->arena, actions->count, sizeof(Action));
  for (size_t i = 0; i < actions->count; i++) action_of(check, actions->at[i], &result.at[i]);
  check->depth--;
  return result;
}

Actions check_actions(Check *check, const AstActions *actions) {
  return actions_of(check, actions);
}
