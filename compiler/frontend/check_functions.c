// check_functions.c -- functions and curves of files: each becomes an array of
// samples that nothing assigns and #defines that read it, so that no later pass
// knows of them.
//
//   NAME(x)      f(x) of a function, x kept within its range; nan of nan
//   func(n, x)   the same by number, from 1 in file order, or by name
//   curveGAL(n)  the length of a curve, n known when the grammar is compiled
//   curveX(n, s) curveY curveZ    a curve's place at s of 0 to 1, in parts of its length
//
// A contour N is a table for the turtle, which finds it in the descriptor by its number.
//
// The names of what only these statements make hold a dot, which no name of a grammar does.
#include "frontend/ast_build.h"
#include "frontend/check.h"
#include "frontend/spline.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
#define DRAWN(id, name, arguments, doc) DRAWN_##id,
#include "frontend/drawn.def"
  DRAWN_COUNT
};

static const char *const drawn[DRAWN_COUNT] = {
#define DRAWN(id, name, arguments, doc) [DRAWN_##id] = name,
#include "frontend/drawn.def"
};

// ---- collecting ------------------------------------------------------------------

static uint32_t new_function(Check *check, const char *text, uint32_t arity, Span span) {
  Name *name = name_intern(check, text);
  uint32_t index = (uint32_t)check->functions.count;
  *VEC_PUSH(check->arena, &check->functions) = (UserFunction){.name = name->text, .arity = arity, .span = span};
  *VEC_PUSH(check->arena, &name->definitions) =
    (Definition){.function = true, .made = true, .index = index, .at = check->statement, .until = NEVER, .span = span};
  return index;
}

static void new_array(Check *check, const char *text, double *values, uint32_t count, Span span) {
  AstArray *array = ARENA_NEW(check->arena, AstArray);
  AstExpr *none = ARENA_NEW(check->arena, AstExpr);
  *array = (AstArray){.name = text, .span = span};
  *VEC_PUSH(check->arena, &array->sizes) = none;
  for (uint32_t i = 0; i < count; i++) *VEC_PUSH(check->arena, &array->values) = none;
  Expr **sizes = arena_array(check->arena, 1, sizeof *sizes), **exprs = arena_array(check->arena, count, sizeof *exprs);
  sizes[0] = expr_number(check->arena, count, span);
  for (uint32_t i = 0; i < count; i++) exprs[i] = expr_number(check->arena, values[i], span);
  name_intern(check, text)->array = (uint32_t)check->arrays.count;
  *VEC_PUSH(check->arena, &check->arrays) = (ArrayEntry){array, sizes, exprs, span, .constant = true};
}

// One table and the three functions that read it.
static Samples *new_table(Check *check, const char *name, double *values, uint32_t pieces, Span span) {
  Samples *table = VEC_PUSH(check->arena, &check->samples);
  *table = (Samples){.name = name, .pieces = pieces, .statement = check->statement, .range = {0, 1}};
  new_array(check, arena_printf(check->arena, "%s.samples", name), values, pieces + 1, span);
  table->between = new_function(check, arena_printf(check->arena, "%s.between", name), 2, span);
  table->at = new_function(check, arena_printf(check->arena, "%s.at", name), 1, span);
  table->value = new_function(check, name, 1, span);
  return table;
}

// The file is looked for beside the one that names it.
static bool read_file(Check *check, const AstStatement *statement, Splines *splines) {
  const AstExpr *value = statement->value;
  if (value->kind == AST_POISON) return false;
  bool curve = statement->kind != AST_FUNCTION;
  const char *what = statement->kind == AST_CONTOUR ? "contour" : curve ? "curve" : "function";
  if (value->kind != AST_STRING) {
    diag_error(check->diag, value->span, "`%s` is followed by the name of a file",
               statement->kind == AST_CONTOUR ? "contour N:"
               : curve                        ? "curve NAME:"
               : statement->name              ? "function NAME:"
                                              : "functions:");
    return false;
  }
  char why[256];
  const char *path = check_beside(check, statement, value->text);
  if (splines_read(check->arena, path, curve, splines, why, sizeof why)) return true;
  diag_error(check->diag, value->span, "cannot read the %s \"%s\": %s", what, path, why);
  return false;
}

// Of a file with several splines the one with the statement's name.
static const Spline *choose(Check *check, const AstStatement *statement, const Splines *splines) {
  if (splines->count == 1) return &splines->at[0];
  const char **names = arena_array(check->arena, splines->count, sizeof *names);
  for (size_t i = 0; i < splines->count; i++) {
    names[i] = splines->at[i].name;
    if (strcmp(names[i], statement->name) == 0) return &splines->at[i];
  }
  const char *meant = diag_nearest(statement->name, names, splines->count);
  diag_error(check->diag, statement->name_span, "the file holds %zu of them, but none of the name `%s`", splines->count,
             statement->name);
  if (meant) diag_hint(check->diag, "there is `%s`", meant);
  return NULL;
}

static void collect_function(Check *check, const AstStatement *statement, const char *name, const Spline *spline) {
  double *values = arena_array(check->arena, spline->samples + 1u, sizeof *values), range[2];
  spline_function(spline, range, values);
  if (range[0] >= range[1] && spline->points.count > 1) {
    diag_error(check->diag, statement->value->span, "the function's points do not go from left to right");
    return;
  }
  Samples *table = new_table(check, name, values, spline->samples, statement->span);
  table->range[0] = range[0];
  table->range[1] = range[1];
  *VEC_PUSH(check->arena, &check->splines) = name;
}

// A name that stands for something else already; the function then has its number alone.
static const char *free_name(Check *check, const char *text) {
  const Name *name = name_intern(check, text);
  bool taken = !*text || strpbrk(text, "-+*/.,:;()[]{}") || name->definitions.count || name->array != NONE
            || name->global != NONE || function_named(text) != LSYS_FN_COUNT;
  return taken ? arena_printf(check->arena, "func.%zu", check->splines.count + 1) : text;
}

static bool is_free(Check *check, const AstStatement *statement) {
  const Name *name = name_intern(check, statement->name);
  if (function_named(statement->name) != LSYS_FN_COUNT) {
    diag_error(check->diag, statement->name_span, "`%s` is a function of the language", statement->name);
    return false;
  }
  if (!name->definitions.count) return true;
  diag_error(check->diag, statement->name_span, "`%s` is defined twice", statement->name);
  diag_note(check->diag, name->definitions.at[0].span, "the other definition is here");
  return false;
}

static void collect_curve(Check *check, const AstStatement *statement, const Spline *spline) {
  double *values[3];
  for (int c = 0; c < 3; c++) values[c] = arena_array(check->arena, spline->samples + 1u, sizeof(double));
  *VEC_PUSH(check->arena, &check->curve_lengths) = spline_curve(check->arena, spline, values);
  for (int c = 0; c < 3; c++)
    new_table(check, arena_printf(check->arena, "%s.%c", statement->name, "xyz"[c]), values[c], spline->samples,
              statement->span);
  *VEC_PUSH(check->arena, &check->curves) = statement->name;
}

// Twice the area that the points go around, from L to U.
static double area_around(double *const values[3], unsigned pieces) {
  double area = 0;
  for (unsigned i = 0; i < pieces; i++) area += values[0][i] * values[1][i + 1] - values[0][i + 1] * values[1][i];
  return area;
}

// cpfg lets x go along what it calls up, -U here, and y along -L. A closed one is turned round where it then has its
// inside on the right, so that normals show outwards.
static void collect_contour(Check *check, const AstStatement *statement, uint32_t number, const Spline *spline) {
  const unsigned pieces = spline->samples;
  double *values[3], *point = arena_array(check->arena, 2 * (pieces + (size_t)1), sizeof *point);
  for (int c = 0; c < 3; c++) values[c] = arena_array(check->arena, pieces + (size_t)1, sizeof(double));
  double length = spline_curve(check->arena, spline, values);
  if (!(length > 0 && isfinite(length))) {
    diag_error(check->diag, statement->value->span, "the contour's length is %s", length > 0 ? "infinite" : "0");
    return;
  }
  bool back = spline->closed && area_around(values, pieces) > 0;
  for (unsigned i = 0; i <= pieces; i++) {
    unsigned from = spline->closed && i == pieces ? 0 : i;
    if (back && from) from = pieces - from;
    for (int c = 0; c < 2; c++) point[2 * i + (unsigned)c] = 0 - values[1 - c][from];
  }
  *VEC_PUSH(check->arena, &check->contours) = (LsysContour){number, pieces, spline->closed, 0, point};
}

// A number that no other contour has.
static bool is_contour_number(Check *check, const AstStatement *statement, unsigned long number) {
  if (number < 1 || number > LSYS_MOST_CONTOUR) {
    diag_error(check->diag, statement->name_span, "a contour has a number, 1 to %d, for `@#(1)`", LSYS_MOST_CONTOUR);
    return false;
  }
  for (size_t i = 0; i < check->contours.count; i++) {
    if (check->contours.at[i].number != number) continue;
    diag_error(check->diag, statement->name_span, "contour %lu is given twice", number);
    return false;
  }
  return true;
}

// The name of a contour is its number; others of its file have those behind it.
static void collect_contours(Check *check, const AstStatement *statement, Splines *splines) {
  char *end;
  errno = 0;
  unsigned long number = strtoul(statement->name, &end, 10);
  if (*end || errno) number = 0;
  if (!is_contour_number(check, statement, number) || !read_file(check, statement, splines)) return;
  for (size_t i = 0; i < splines->count; i++)
    if (i == 0 || is_contour_number(check, statement, number + i))
      collect_contour(check, statement, (uint32_t)(number + i), &splines->at[i]);
}

static void collect(Check *check, const AstStatement *statement, Splines *splines) {
  if (statement->kind == AST_FUNCTION && statement->name && !is_free(check, statement)) return;
  if (statement->kind == AST_CONTOUR) {
    collect_contours(check, statement, splines);
    return;
  }
  if (!read_file(check, statement, splines)) return;
  if (!statement->name) {
    for (size_t i = 0; i < splines->count; i++)
      collect_function(check, statement, free_name(check, splines->at[i].name), &splines->at[i]);
    return;
  }
  const Spline *spline = choose(check, statement, splines);
  if (!spline) return;
  if (statement->kind == AST_CURVE)
    collect_curve(check, statement, spline);
  else
    collect_function(check, statement, statement->name, spline);
}

void functions_collect(Check *check, const AstStatement *statement) {
  Splines splines = {0};
  size_t errors = diag_errors(check->diag);
  collect(check, statement, &splines);
  if (diag_errors(check->diag) == errors || statement->kind == AST_CONTOUR) return;
  check->unread[statement->kind == AST_CURVE] = true;
  if (statement->kind == AST_FUNCTION && statement->name) name_intern(check, statement->name)->unread = true;
}

void functions_collected(Check *check) {
  Span nowhere = {0, 0};
  if (check->splines.count && !name_intern(check, drawn[DRAWN_FUNC])->definitions.count)
    check->chains[DRAWN_FUNC] = new_function(check, drawn[DRAWN_FUNC], 2, nowhere) + 1;
  for (int c = DRAWN_CURVE_X; c <= DRAWN_CURVE_Z && check->curves.count; c++)
    if (!name_intern(check, drawn[c])->definitions.count)
      check->chains[c] = new_function(check, drawn[c], 2, nowhere) + 1;
}

// ---- bodies --------------------------------------------------------------------------

typedef struct Body {
  Check *check;
  AstBuilder build;
} Body;

static AstExpr *number(Body *b, double value) {
  return ast_number(b->build, (Span){0, 0}, value);
}

static AstExpr *named(Body *b, const char *name) {
  return ast_name(b->build, (Span){0, 0}, name);
}

static AstExpr *call(Body *b, const char *name, AstExpr *first, AstExpr *second) {
  AstExprs args = {0};
  *VEC_PUSH(b->check->arena, &args) = first;
  if (second) *VEC_PUSH(b->check->arena, &args) = second;
  return ast_call(b->build, (Span){0, 0}, (Span){0, 0}, name, args);
}

static AstExpr *binary(Body *b, Operator op, AstExpr *left, AstExpr *right) {
  return ast_binary(b->build, op, left, right);
}

static AstExpr *sample(Body *b, const Samples *table, AstExpr *place) {
  AstExprs args = {0};
  *VEC_PUSH(b->check->arena, &args) = place;
  const char *name = arena_printf(b->check->arena, "%s.samples", table->name);
  return ast_index(b->build, (Span){0, 0}, (Span){0, 0}, name, args);
}

static void read_body(Body *b, uint32_t index, const char *const *parameters, const AstExpr *body) {
  Check *check = b->check;
  UserFunction *function = &check->functions.at[index];
  function->slot_names = arena_array(check->arena, function->arity, sizeof *function->slot_names);
  check_scope(check, SCOPE_FUNCTION);
  for (uint32_t i = 0; i < function->arity; i++) {
    function->slot_names[i] = parameters[i];
    check_bind(check, parameters[i], (Span){0, 0});
  }
  check->referring = &check->references[check->values.count + index];
  check->functions.at[index].body = check_expression(check, body);
  check->referring = NULL;
}

// between(i, t) is on the line from sample i to the next, at(t) finds i, and value(x) finds t.
static void read_table(Body *b, const Samples *table) {
  const char *it[] = {"i", "t"}, *x[] = {"x"};
  AstExpr *here = sample(b, table, named(b, "i"));
  AstExpr *next = sample(b, table, binary(b, OP_ADD, named(b, "i"), number(b, 1)));
  AstExpr *slope = binary(b, OP_SUB, next, here);
  AstExpr *rise = binary(b, OP_MUL, binary(b, OP_SUB, named(b, "t"), named(b, "i")), slope);
  read_body(b, table->between, it, binary(b, OP_ADD, here, rise));

  AstExpr *piece = call(b, "floor", call(b, "min", named(b, "t"), number(b, table->pieces - 1.0)), NULL);
  AstExpr *between = call(b, arena_printf(b->check->arena, "%s.between", table->name), piece, named(b, "t"));
  read_body(b, table->at, &it[1], between);

  AstExpr *share = named(b, "x");
  if (table->range[0] != 0) share = binary(b, OP_SUB, share, number(b, table->range[0]));
  double width = table->range[1] - table->range[0];
  if (width != 1) share = binary(b, OP_DIV, share, number(b, width > 0 ? width : 1));
  AstExpr *inside = call(b, "max", number(b, 0), call(b, "min", number(b, 1), share));
  AstExpr *at = call(b, arena_printf(b->check->arena, "%s.at", table->name),
                     binary(b, OP_MUL, inside, number(b, table->pieces)), NULL);
  AstExpr *sane = binary(b, OP_EQ, named(b, "x"), named(b, "x"));
  read_body(b, table->value, x, ast_choice(b->build, sane, at, named(b, "x")));
}

// n == 1 ? first(x) : n == 2 ? second(x) : nan
static void read_chain(Body *b, uint32_t index, const char *const *names, size_t count, const char *suffix) {
  const char *nx[] = {"n", "x"};
  AstExpr *body = number(b, NAN);
  for (size_t i = count; i-- > 0;) {
    const char *name = arena_printf(b->check->arena, "%s%s", names[i], suffix);
    AstExpr *here = binary(b, OP_EQ, named(b, "n"), number(b, (double)i + 1));
    body = ast_choice(b->build, here, call(b, name, named(b, "x"), NULL), body);
  }
  read_body(b, index, nx, body);
}

void functions_read(Check *check) {
  static const char *const suffixes[] = {"", ".x", ".y", ".z"};
  Body b = {check, {check->arena, check->diag}};
  for (size_t i = 0; i < check->samples.count; i++) read_table(&b, &check->samples.at[i]);
  for (int c = 0; c < 4; c++) {
    if (!check->chains[c]) continue;
    bool curve = c > 0;
    read_chain(&b, check->chains[c] - 1, curve ? check->curves.at : check->splines.at,
               curve ? check->curves.count : check->splines.count, suffixes[c]);
  }
}

// ---- calls ----------------------------------------------------------------------------

static int chain_named(const char *name) {
  for (int c = DRAWN_FUNC; c <= DRAWN_CURVE_Z; c++)
    if (strcmp(name, drawn[c]) == 0) return c;
  return -1;
}

bool functions_are_meant(const char *name) {
  return chain_named(name) >= 0 || strcmp(name, drawn[DRAWN_CURVE_LENGTH]) == 0;
}

// The number that a name or a constant as the first argument is; 0: it is neither.
static size_t number_of(Check *check, const AstExpr *id, const char *const *names, size_t count) {
  if (id->kind == AST_NUMBER && id->number >= 1 && id->number <= (double)count && id->number == trunc(id->number))
    return (size_t)id->number;
  for (size_t i = 0; id->kind == AST_NAME && i < count; i++)
    if (strcmp(names[i], id->name) == 0 && !check_bound(check, name_intern(check, id->name))) return i + 1;
  return 0;
}

// curveGAL(n) is a number.
static const AstExpr *curve_length(Check *check, const AstExpr *ast) {
  if (check->unread[true]) return NULL;  // was reported
  if (!check->curves.count || ast->args.count != 1) return ast;
  const AstExpr *id = ast->args.at[0];
  size_t which = number_of(check, id, check->curves.at, check->curves.count);
  AstBuilder build = {check->arena, check->diag};
  if (which) return ast_number(build, ast->span, check->curve_lengths.at[which - 1]);
  diag_error(check->diag, id->span, "`curveGAL` takes the name of a curve or its number, 1 to %zu",
             check->curves.count);
  return NULL;
}

static bool name_is_unread(Check *check, const char *text) {
  const Name *name = name_intern(check, text);
  return name->unread && !name->definitions.count;
}

const AstExpr *functions_call(Check *check, const AstExpr *ast) {
  if (strcmp(ast->name, drawn[DRAWN_CURVE_LENGTH]) == 0) return curve_length(check, ast);
  if (name_is_unread(check, ast->name)) return NULL;
  int chain = chain_named(ast->name);
  bool curve = chain > 0;
  if (chain >= 0 && check->unread[curve]) return NULL;  // was reported
  if (chain < 0 || !check->chains[chain] || ast->args.count != 2) return ast;
  const char *const *names = curve ? check->curves.at : check->splines.at;
  size_t count = curve ? check->curves.count : check->splines.count;
  const AstExpr *id = ast->args.at[0];
  size_t which = number_of(check, id, names, count);
  if (!which && id->kind == AST_NUMBER) {
    diag_error(check->diag, id->span, "there is no %s %g, only 1 to %zu", curve ? "curve" : "function", id->number,
               count);
    return NULL;
  }
  if (!which) return ast;
  AstExpr *direct = ARENA_NEW(check->arena, AstExpr);
  *direct = *ast;
  direct->args = (AstExprs){0};
  *VEC_PUSH(check->arena, &direct->args) = ast->args.at[1];
  direct->name = names[which - 1];
  if (curve) direct->name = arena_printf(check->arena, "%s.%c", names[which - 1], "xyz"[chain - 1]);
  return direct;
}
