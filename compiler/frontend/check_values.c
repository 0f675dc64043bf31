// check_values.c -- #define, param and arrays once all are read: the order in
// which values are made, cycles, which values are known before any run.
#include "frontend/check.h"

#include <math.h>
#include <stdlib.h>

// ---- definitions ------------------------------------------------------------------

static const Definition *definition_here(Check *check, const AstStatement *statement) {
  const Name *name = name_intern(check, statement->name);
  for (size_t i = name->definitions.count; i-- > 0;)
    if (name->definitions.at[i].at == check->statement) return &name->definitions.at[i];
  return NULL;  // it was refused
}

static void read_function(Check *check, const AstStatement *statement, const Definition *definition) {
  UserFunction *function = &check->functions.at[definition->index];
  function->slot_names = arena_array(check->arena, function->arity, sizeof *function->slot_names);
  check_scope(check, SCOPE_FUNCTION);
  for (size_t i = 0; i < statement->symbols.count; i++) {
    check_formal(check, statement->symbols.at[i].name, statement->symbols.at[i].span);
    function->slot_names[i] = statement->symbols.at[i].name;
  }
  check->referring = &check->references[check->values.count + definition->index];
  function->body = check_expression(check, statement->value);
  check->referring = NULL;
  check_unused(check, function->arity);
}

static void read_value(Check *check, const AstStatement *statement, const Definition *definition) {
  Value *value = &check->values.at[definition->index];
  check_scope(check, SCOPE_CONSTANT);
  check->referring = &check->references[definition->index];
  value->init = check_expression(check, statement->value);
  check->referring = NULL;
  if (statement->low) value->low = check_expression(check, statement->low);
  if (statement->high) value->high = check_expression(check, statement->high);
}

void values_begin(Check *check) {
  size_t nodes = check->values.count + check->functions.count;
  check->references = arena_array(check->arena, nodes, sizeof *check->references);
}

void check_definition(Check *check, const AstStatement *statement) {
  const Definition *definition = definition_here(check, statement);
  if (!definition) return;
  if (definition->function)
    read_function(check, statement, definition);
  else
    read_value(check, statement, definition);
}

// ---- dependency order -----------------------------------------------------------------

typedef struct Visit {
  uint32_t node;
  size_t next;  // reference to follow
} Visit;

typedef VEC(Visit) Visits;

typedef enum Mark { MARK_NEW, MARK_OPEN, MARK_DONE } Mark;

static const char *node_name(const Check *check, uint32_t node) {
  size_t values = check->values.count;
  return node < values ? check->values.at[node].name : check->functions.at[node - values].name;
}

static uint32_t reference_node(const Check *check, const Reference *reference) {
  return reference->index + (reference->function ? (uint32_t)check->values.count : 0);
}

// path: the open nodes; the last one refers to a node that is open too.
static void report_cycle(Check *check, const Visits *path, uint32_t back) {
  enum { MOST_NOTES = 8 };
  size_t first = path->count;
  while (path->at[first - 1].node != back) first--;
  for (size_t i = first - 1; i < path->count; i++) {
    uint32_t node = path->at[i].node;
    const Reference *reference = &check->references[node].list.at[path->at[i].next - 1];
    const char *name = node_name(check, node), *other = node_name(check, reference_node(check, reference));
    if (i == first - 1 && i + 1 == path->count && node >= check->values.count)
      diag_error(check->diag, reference->span, "`%s` calls itself, which a #define cannot", name);
    else if (i == first - 1 && i + 1 == path->count)
      diag_error(check->diag, reference->span, "`%s` is defined by itself", name);
    else if (i == first - 1)
      diag_error(check->diag, reference->span, "`%s` is defined by itself: it needs `%s`", name, other);
    else if (i - first < MOST_NOTES)
      diag_note(check->diag, reference->span, "`%s` needs `%s`", name, other);
  }
}

// Visits what the node refers to before the node itself; order gets every node.
static void visit(Check *check, uint32_t root, Mark *marks, uint32_t *order, size_t *done) {
  Visits path = {0};
  *VEC_PUSH(check->arena, &path) = (Visit){root, 0};
  marks[root] = MARK_OPEN;
  while (path.count) {
    Visit *at = &path.at[path.count - 1];
    const References *references = &check->references[at->node];
    if (at->next == references->list.count) {
      marks[at->node] = MARK_DONE;
      order[(*done)++] = at->node;
      path.count--;
      continue;
    }
    uint32_t node = reference_node(check, &references->list.at[at->next++]);
    if (marks[node] == MARK_OPEN) report_cycle(check, &path, node);
    if (marks[node] != MARK_NEW) continue;
    marks[node] = MARK_OPEN;
    *VEC_PUSH(check->arena, &path) = (Visit){node, 0};
  }
}

static uint32_t *dependency_order(Check *check) {
  size_t count = check->values.count + check->functions.count, done = 0;
  uint32_t *order = arena_array(check->arena, count, sizeof *order);
  Mark *marks = arena_array(check->arena, count, sizeof *marks);
  for (uint32_t node = 0; node < count; node++)
    if (marks[node] == MARK_NEW) visit(check, node, marks, order, &done);
  return order;
}

// ---- what follows from the order -----------------------------------------------------------

// Nesting with the bodies of the functions that are applied.
static size_t nesting(const size_t *functions, const Expr *expr) {
  size_t deepest = expr->kind == EXPR_APPLY ? functions[expr->slot] : 0;
  for (uint32_t i = 0; i < expr->count; i++) {
    size_t depth = nesting(functions, expr->args[i]);
    if (depth > deepest) deepest = depth;
  }
  return deepest + 1;
}

static void finish_function(Check *check, uint32_t index, size_t *nestings) {
  UserFunction *function = &check->functions.at[index];
  function->draws = expr_draws(check->program, function->body);
  nestings[index] = nesting(nestings, function->body);
  if (nestings[index] <= MOST_DEPTH) return;
  diag_error(check->diag, function->span, "`%s` is nested too deep: more than %d levels with the functions it calls",
             function->name, MOST_DEPTH);
  nestings[index] = 0;
}

static void finish_values(Check *check, const uint32_t *order) {
  Program *program = check->program;
  size_t values = check->values.count, count = values + check->functions.count, done = 0;
  size_t *nestings = arena_array(check->arena, check->functions.count, sizeof *nestings);
  program->value_order = arena_array(check->arena, values, sizeof *program->value_order);
  for (size_t i = 0; i < count; i++) {
    if (order[i] >= values) {
      finish_function(check, order[i] - (uint32_t)values, nestings);
      continue;
    }
    Value *value = &check->values.at[order[i]];
    program->value_order[done++] = order[i];
    bool constant = value->kind == VALUE_DEFINE && value->init != check->poison;
    value->known = constant && expr_constant(program, value->init, &value->number);
  }
}

// ---- params ---------------------------------------------------------------------------------

// Replaces a bound by its number; false after an error.
static bool finish_bound(Check *check, Expr **bound, double *number, double unbounded) {
  *number = unbounded;
  if (!*bound) return true;
  if (*bound == check->poison) return false;
  if (!expr_constant(check->program, *bound, number) || isnan(*number)) {
    diag_error(check->diag, (*bound)->span, "the range of a param is made of numbers");
    return false;
  }
  *bound = expr_number(check->arena, *number, (*bound)->span);
  return true;
}

static const char *expression_text(Check *check, const Expr *expr) {
  char *text = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&text, &length);
  if (!out) return "";
  expr_print(check->program, expr, NULL, out);
  fclose(out);
  const char *copy = arena_copy(check->arena, text, length);
  free(text);
  return copy;
}

static void finish_param(Check *check, Value *param) {
  double low, high, value;
  if (param->init == check->poison) return;
  param->text = expression_text(check, param->init);
  if (!finish_bound(check, &param->low, &low, -INFINITY) || !finish_bound(check, &param->high, &high, INFINITY)) return;
  if (low > high) {
    diag_error(check->diag, span_join(param->low->span, param->high->span),
               "the range of `%s` is empty: %g is above %g", param->name, low, high);
    return;
  }
  if (!expr_constant(check->program, param->init, &value) || (value >= low && value <= high)) return;
  diag_error(check->diag, param->init->span, "the default of `%s` is %g, which is not in its range", param->name,
             value);
  diag_note(
    check->diag,
    span_join(param->low ? param->low->span : param->high->span, param->high ? param->high->span : param->low->span),
    "the range is here");
}

// ---- arrays ---------------------------------------------------------------------------------

void check_arrays(Check *check, const AstStatement *statement) {
  check_scope(check, SCOPE_CONSTANT);
  for (size_t i = 0; i < statement->arrays.count; i++) {
    const AstArray *array = &statement->arrays.at[i];
    const Name *name = name_intern(check, array->name);
    if (name->array == NONE || check->arrays.at[name->array].array != array) continue;  // it was refused
    ArrayEntry *entry = &check->arrays.at[name->array];
    entry->sizes = check_arguments(check, &array->sizes);
    entry->values = check_arguments(check, &array->values);
  }
}

static bool finish_sizes(Check *check, const ArrayEntry *entry, Array *array, size_t *count) {
  enum { MOST_DIMENSIONS = sizeof array->sizes / sizeof *array->sizes };
  size_t dimensions = entry->array->sizes.count;
  if (dimensions == 0 || dimensions > MOST_DIMENSIONS) {
    diag_error(check->diag, entry->span, "an array has 1 to %d indices, not %zu", MOST_DIMENSIONS, dimensions);
    return false;
  }
  *count = 1;
  for (size_t i = 0; i < dimensions; i++) {
    double size;
    if (entry->sizes[i] == check->poison) return false;
    bool whole = expr_constant(check->program, entry->sizes[i], &size) && size == trunc(size);
    if (!whole || size < 1 || size > MOST_ELEMENTS) {
      diag_error(check->diag, entry->sizes[i]->span, "the size of an array is a whole number from 1 to %d",
                 MOST_ELEMENTS);
      return false;
    }
    array->sizes[array->dimensions++] = (uint32_t)size;
    *count *= (size_t)size;
    if (*count <= MOST_ELEMENTS) continue;
    diag_error(check->diag, entry->span, "`%s` has more than %d elements", array->name, MOST_ELEMENTS);
    return false;
  }
  return true;
}

static void finish_array(Check *check, const ArrayEntry *entry, Array *array) {
  size_t count, given = entry->array->values.count;
  array->name = entry->array->name;
  array->constant = entry->constant;
  array->slot = (uint32_t)check->program->total_values;
  if (!finish_sizes(check, entry, array, &count)) return;
  if (check->program->total_values + count > MOST_ELEMENTS) {
    diag_error(check->diag, entry->span, "all arrays together have more than %d elements", MOST_ELEMENTS);
    return;
  }
  check->program->total_values += count;
  array->values = arena_array(check->arena, count, sizeof(double));
  if (given > count) {
    diag_error(check->diag, entry->array->values.at[count]->span, "`%s` has %zu element%s, but %zu values are given",
               array->name, count, count == 1 ? "" : "s", given);
    return;
  }
  for (size_t i = 0; i < given; i++)
    if (entry->values[i] != check->poison && !expr_constant(check->program, entry->values[i], &array->values[i]))
      diag_error(check->diag, entry->values[i]->span, "the values of an array are constants");
}

// ---- all ------------------------------------------------------------------------------------

void check_values(Check *check) {
  Program *program = check->program;
  program->values = check->values.at;
  program->value_count = check->values.count;
  program->functions = check->functions.at;
  program->function_count = check->functions.count;
  program->total_values = LSYS_SETTING_COUNT + check->values.count;
  finish_values(check, dependency_order(check));
  for (size_t i = 0; i < check->values.count; i++)
    if (check->values.at[i].kind == VALUE_PARAM) finish_param(check, &check->values.at[i]);
  program->array_count = check->arrays.count;
  program->arrays = arena_array(check->arena, check->arrays.count, sizeof(Array));
  for (size_t i = 0; i < check->arrays.count; i++) finish_array(check, &check->arrays.at[i], &program->arrays[i]);
}
