// check.c -- Ast -> Program. Never edits the Ast.
//
// After errors of the parser it looks for further ones in what could be read,
// and takes nothing for missing. Ensures: every name is a slot, every symbol a
// kind, calls of random functions are numbered in file order from 1, and
// nothing in the Program nests deeper than a pass may recurse.
#include "frontend/check.h"

#include <math.h>
#include <string.h>

static void prepare(Check *check) {
  check->program = ARENA_NEW(check->arena, Program);
  check->name_map = map_create(check->arena);
  check->kind_map = map_create(check->arena);
  check->declaration_map = map_create(check->arena);
  check->system_map = map_create(check->arena);
  check->called_map = map_create(check->arena);
  check->table_map = map_create(check->arena);
  check->poison = expr_number(check->arena, NAN, (Span){0, 0});
}

// The file name without folder and suffix.
static const char *name_of(Arena *arena, const SourceFile *file) {
  const char *slash = strrchr(file->path, '/'), *name = slash ? slash + 1 : file->path;
  const char *dot = strrchr(name, '.');
  return arena_copy(arena, name, dot && dot > name ? (size_t)(dot - name) : strlen(name));
}

static KindId kind_named(const Check *check, const char *symbol) {
  return map_find(check->kind_map, symbol, 0);
}

// Hands over what was gathered in lists.
static void fill(Check *check) {
  Program *program = check->program;
  const Ast *ast = check->ast;
  program->name = name_of(check->arena, ast->file);
  program->file = ast->file;
  program->rules = ast->rules;
  program->kinds = check->kinds.at;
  program->kind_count = check->kinds.count;
  program->open = kind_named(check, "[");
  program->close = kind_named(check, "]");
  program->cut = kind_named(check, "%");
  program->axioms = check->axioms.at;
  program->axiom_count = check->axioms.count;
  program->surfaces = check->surfaces.at;
  program->surface_count = check->surfaces.count;
  program->contours = check->contours.at;
  program->contour_count = check->contours.count;
  program->colours = check->colours.at;
  program->colour_count = check->colours.count;
  for (int i = 0; i < LSYS_PAGE_COUNT; i++) program->page[i] = check->page[i] ? check->page[i]->name : NULL;
  program->names = check->symbols.at;
  program->name_count = check->symbols.count;
  program->sites = check->sites;
  Actions *blocks[] = {&program->start, &program->start_each, &program->end_each, &program->end};
  for (int i = 0; i < 4; i++) *blocks[i] = (Actions){check->blocks[i].at, check->blocks[i].count};
  if (program->axiom_count || check->partial) return;
  diag_error(check->diag, (Span){ast->file->base, ast->file->base}, "the grammar has no start word");
  diag_hint(check->diag, "write one, such as `axiom: A`");
}

Program *check(Arena *arena, const Ast *ast, Diag *diag) {
  Check state = {.arena = arena, .diag = diag, .ast = ast, .partial = diag_errors(diag) > 0};
  prepare(&state);
  check_collect(&state);
  check_statements(&state);
  if (state.failed) return NULL;
  check_values(&state);
  fill(&state);
  check_queries(&state);
  check_systems(&state);
  if (diag_errors(diag)) return NULL;
  check_warnings(&state);
  check_families(&state);
  return diag_errors(diag) ? NULL : state.program;
}
