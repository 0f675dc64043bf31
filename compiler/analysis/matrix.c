// matrix.c -- productions of each kind -> the growth matrix as sparse rows.
//
// The matrix exists if everything that can happen to a module of a kind gives
// the same number of modules of each kind: then counts depend on kinds alone,
// whatever guards, contexts and draws decide. Reachable kinds only; the rows
// of others are empty.
// Source: growth functions of D0L systems, ABOP p. 36; Rozenberg and Salomaa,
// "The mathematical theory of L systems", 1980.
#include "analysis/passes.h"

#include <stdlib.h>

// Deeper decompositions that still change are counted by deriving.
#define DEEPEST_DECOMPOSITION 10000

typedef struct Entry {
  KindId kind;
  uint32_t count;
} Entry;

typedef struct Row {
  Entry *at;  // by rising kind, no zeros
  size_t count;
} Row;

typedef struct Matrix {
  Analysis *analysis;
  uint64_t *sum;    // scratch, per kind: the row being added up
  KindId *touched;  // kinds with sum != 0
  size_t touched_count;
  bool overflow;
} Matrix;

static bool row_equal(const Row *a, const Row *b) {
  if (a->count != b->count) return false;
  for (size_t i = 0; i < a->count; i++) {
    if (a->at[i].kind != b->at[i].kind || a->at[i].count != b->at[i].count) return false;
  }
  return true;
}

static void add(Matrix *matrix, KindId kind, uint64_t count) {
  if (!count) return;
  if (!matrix->sum[kind]) matrix->touched[matrix->touched_count++] = kind;
  matrix->sum[kind] += count;  // both at most 2^32: cannot wrap before the test
  if (matrix->sum[kind] > UINT32_MAX) {
    matrix->sum[kind] = UINT32_MAX;
    matrix->overflow = true;
  }
}

// Adds what module becomes according to rows; a module of its own where rows is NULL.
static void add_image(Matrix *matrix, const Row *rows, KindId module) {
  if (!rows) {
    add(matrix, module, 1);
    return;
  }
  for (size_t i = 0; i < rows[module].count; i++) add(matrix, rows[module].at[i].kind, rows[module].at[i].count);
}

static int by_kind(const void *a, const void *b) {
  KindId x = *(const KindId *)a, y = *(const KindId *)b;
  return (x > y) - (x < y);
}

// Takes the sum as a row and clears it.
static Row take(Matrix *matrix) {
  qsort(matrix->touched, matrix->touched_count, sizeof(KindId), by_kind);
  Row row = {arena_array(matrix->analysis->arena, matrix->touched_count, sizeof(Entry)), matrix->touched_count};
  for (size_t i = 0; i < row.count; i++) {
    KindId kind = matrix->touched[i];
    row.at[i] = (Entry){kind, (uint32_t)matrix->sum[kind]};
    matrix->sum[kind] = 0;
  }
  matrix->touched_count = 0;
  return row;
}

static Row word_row(Matrix *matrix, const Row *rows, const Word *word) {
  for (size_t i = 0; i < word->count; i++) add_image(matrix, rows, word->at[i].kind);
  return take(matrix);
}

static Row module_row(Matrix *matrix, const Row *rows, KindId kind) {
  add_image(matrix, rows, kind);
  return take(matrix);
}

// The row of kind if each of its productions, and staying as it is where none
// need apply, has the same one; then rows maps each module further.
// False where they differ.
static bool agreed_row(Matrix *matrix, const Productions *productions, const Row *rows, const Row *stay, KindId kind,
                       Row *result) {
  const Program *program = matrix->analysis->program;
  bool closed = false, any = false;
  for (size_t i = 0; i < productions->count && !closed; i++) {
    const Production *production = productions->at[i];
    if (production_never(program, production)) continue;
    Row row = word_row(matrix, rows, &production->successor);
    if (any && !row_equal(&row, result)) return false;
    *result = row;
    any = true;
    closed = production_always(program, production) && !production->weight;
  }
  for (size_t i = 0; i < productions->count; i++) closed |= production_always(program, productions->at[i]);
  if (closed) return true;
  Row row = module_row(matrix, stay, kind);
  if (any && !row_equal(&row, result)) return false;
  *result = row;
  return true;
}

// What one module of each reachable kind becomes by decomposition down to
// depth levels; NULL in *rows where the grammar has no decomposition.
static bool decomposition_rows(Matrix *matrix, Row **rows) {
  Analysis *analysis = matrix->analysis;
  const Program *program = analysis->program;
  const Rewriting *section = &program->lsystems[0].decomposition;
  *rows = NULL;
  if (!section->productions.count) return true;
  double depth = 1;
  if (section->depth && !expr_constant(program, section->depth, &depth)) return false;
  for (unsigned level = 0; level < depth; level++) {
    if (level >= DEEPEST_DECOMPOSITION) return false;
    Row *next = arena_array(analysis->arena, program->kind_count, sizeof *next);
    bool changed = false;
    for (KindId k = 0; k < program->kind_count; k++) {
      const KindFacts *kind = &analysis->facts->kinds[k];
      if (!kind->reachable) continue;
      if (!agreed_row(matrix, &kind->decompositions, *rows, NULL, k, &next[k]) || matrix->overflow) return false;
      changed |= !*rows || !row_equal(&next[k], &(*rows)[k]);
    }
    *rows = next;
    if (!changed) break;
  }
  return true;
}

static bool growth_rows(Matrix *matrix, Row *rows) {
  Analysis *analysis = matrix->analysis;
  Row *decomposed;
  if (!decomposition_rows(matrix, &decomposed)) return false;
  for (KindId k = 0; k < analysis->program->kind_count; k++) {
    const KindFacts *kind = &analysis->facts->kinds[k];
    if (!kind->reachable) continue;
    if (!agreed_row(matrix, &kind->own, decomposed, decomposed, k, &rows[k]) || matrix->overflow) return false;
  }
  return true;
}

static LsysGrowth pack(Arena *arena, const Row *rows, size_t kinds) {
  size_t entries = 0;
  for (size_t k = 0; k < kinds; k++) entries += rows[k].count;
  uint32_t *row = arena_array(arena, kinds + 1, sizeof *row);
  uint32_t *kind = arena_array(arena, entries, sizeof *kind);
  uint32_t *count = arena_array(arena, entries, sizeof *count);
  uint32_t n = 0;
  for (size_t k = 0; k < kinds; k++) {
    row[k] = n;
    for (size_t i = 0; i < rows[k].count; i++, n++) {
      kind[n] = rows[k].at[i].kind;
      count[n] = rows[k].at[i].count;
    }
  }
  row[kinds] = n;
  return (LsysGrowth){row, kind, count};
}

void find_growth(Analysis *analysis) {
  const Program *program = analysis->program;
  const LSystem *main_system = &program->lsystems[0];
  // Here more than the module's kind decides: its place, or an effect that may end the derivation.
  if (main_system->pseudo || program->cut != KIND_NONE || program->lsystem_count > 1 || analysis->facts->sequential)
    return;
  Matrix matrix = {.analysis = analysis,
                   .sum = arena_array(analysis->arena, program->kind_count, sizeof(uint64_t)),
                   .touched = arena_array(analysis->arena, program->kind_count, sizeof(KindId))};
  Row *rows = arena_array(analysis->arena, program->kind_count, sizeof *rows);
  if (!growth_rows(&matrix, rows)) return;
  analysis->facts->counts_by_kind = true;
  analysis->facts->growth = pack(analysis->arena, rows, program->kind_count);
}
