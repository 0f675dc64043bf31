// growth.c -- the counts at step n: the axiom's vector of counts times the
// n-th power of the growth matrix, in exact integers.
//
// Numbers grow by a fixed number of bits a step, so n vector steps cost in the
// order of n^2 and repeated squaring of the k x k matrix in the order of
// k^3 n: vector steps first, squaring for the far ones.
#include "analysis/growth.h"

#include <stdlib.h>

typedef struct Counts {
  size_t kinds;
  const LsysGrowth *growth;
  mpz_t *scratch;  // kinds of them
} Counts;

static void *allocate(size_t count, size_t size) {
  void *result = calloc(count + 1, size);
  if (!result) {
    fputs("lsysc: error: out of memory\n", stderr);
    exit(EXIT_FAILURE);
  }
  return result;
}

static mpz_t *vector_create(size_t count) {
  mpz_t *vector = allocate(count, sizeof *vector);
  for (size_t i = 0; i < count; i++) mpz_init(vector[i]);
  return vector;
}

static void vector_free(mpz_t *vector, size_t count) {
  for (size_t i = 0; i < count; i++) mpz_clear(vector[i]);
  free(vector);
}

static void vector_swap(mpz_t *a, mpz_t *b, size_t count) {
  for (size_t i = 0; i < count; i++) mpz_swap(a[i], b[i]);
}

// vector := vector M, M the sparse growth matrix.
static void step_sparse(Counts *counts, mpz_t *vector) {
  const LsysGrowth *growth = counts->growth;
  for (size_t k = 0; k < counts->kinds; k++) mpz_set_ui(counts->scratch[k], 0);
  for (size_t k = 0; k < counts->kinds; k++) {
    if (mpz_sgn(vector[k]) == 0) continue;
    for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++) {
      mpz_addmul_ui(counts->scratch[growth->kind[e]], vector[k], growth->count[e]);
    }
  }
  vector_swap(vector, counts->scratch, counts->kinds);
}

// ---- repeated squaring, over the kinds that the matrix mentions ----------------

typedef struct Dense {
  size_t size;
  size_t *kind;  // of each row and column
  mpz_t *at;     // size x size, row by row
} Dense;

static Dense dense_create(const Counts *counts) {
  const LsysGrowth *growth = counts->growth;
  Dense dense = {0, allocate(counts->kinds, sizeof(size_t)), NULL};
  size_t *place = allocate(counts->kinds, sizeof *place);
  for (size_t k = 0; k < counts->kinds; k++) {
    if (growth->row[k] == growth->row[k + 1]) continue;
    place[k] = dense.size + 1;
    dense.kind[dense.size++] = k;
  }
  dense.at = vector_create(dense.size * dense.size);
  for (size_t i = 0; i < dense.size; i++) {
    size_t k = dense.kind[i];
    for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++) {
      size_t column = place[growth->kind[e]];
      // A kind that becomes nothing has no row: it counts at the last step only, which is made sparse.
      if (column) mpz_set_ui(dense.at[i * dense.size + column - 1], growth->count[e]);
    }
  }
  free(place);
  return dense;
}

static void dense_free(Dense *dense) {
  vector_free(dense->at, dense->size * dense->size);
  free(dense->kind);
}

static void dense_square(Dense *dense, mpz_t *product) {
  size_t n = dense->size;
  for (size_t i = 0; i < n; i++) {
    for (size_t j = 0; j < n; j++) {
      mpz_set_ui(product[i * n + j], 0);
      for (size_t k = 0; k < n; k++) mpz_addmul(product[i * n + j], dense->at[i * n + k], dense->at[k * n + j]);
    }
  }
  vector_swap(dense->at, product, n * n);
}

static void dense_apply(const Dense *dense, mpz_t *vector, mpz_t *scratch) {
  size_t n = dense->size;
  for (size_t j = 0; j < n; j++) {
    mpz_set_ui(scratch[j], 0);
    for (size_t i = 0; i < n; i++) mpz_addmul(scratch[j], vector[dense->kind[i]], dense->at[i * n + j]);
  }
  for (size_t j = 0; j < n; j++) mpz_swap(vector[dense->kind[j]], scratch[j]);
}

static void step_squaring(Counts *counts, mpz_t *vector, uint64_t steps) {
  Dense dense = dense_create(counts);
  mpz_t *product = vector_create(dense.size * dense.size);
  for (; steps; steps >>= 1) {
    if (steps & 1) dense_apply(&dense, vector, product);
    if (steps > 1) dense_square(&dense, product);
  }
  vector_free(product, dense.size * dense.size);
  dense_free(&dense);
}

// ---- choice ------------------------------------------------------------------

// Work in multiplications of 64-bit words, for numbers of about one bit a step.
static bool squaring_is_cheaper(const Counts *counts, uint64_t steps) {
  double n = (double)steps, k = 0, entries = counts->growth->row[counts->kinds];
  for (size_t i = 0; i < counts->kinds; i++) k += counts->growth->row[i] != counts->growth->row[i + 1];
  return entries * n * (1 + n / 128) > k * k * k * (64 + n / 8);
}

void growth_counts(const Program *program, const Facts *facts, const Word *axiom, uint64_t step, mpz_t *counts) {
  size_t kinds = program->kind_count;
  Counts state = {kinds, &facts->growth, vector_create(kinds)};
  for (size_t k = 0; k < kinds; k++) mpz_set_ui(counts[k], 0);
  for (size_t i = 0; i < axiom->count; i++) mpz_add_ui(counts[axiom->at[i].kind], counts[axiom->at[i].kind], 1);
  if (step && squaring_is_cheaper(&state, step - 1)) {
    step_squaring(&state, counts, step - 1);
    step = 1;
  }
  for (; step; step--) step_sparse(&state, counts);
  vector_free(state.scratch, kinds);
}
