// test_draws.c -- compiled code compares a draw as an integer, and looks rows
// up in a table: at the very borders between weights, where one draw is the
// last that takes a production and the next takes another one, it has to choose
// as the interpreter does, and as LANGUAGE.md 5.2 says.
//
// Any draw can be had: the functions that make keys are bijections, so the
// root is found from which the module at a certain place draws what is wanted.
#include "grammar.h"

#include "codegen/backend.h"
#include "core/derive.h"

#include <dlfcn.h>
#include <inttypes.h>

enum { MOST_WEIGHTS = 10, AROUND = 3 };
static const uint64_t DRAWS = UINT64_C(1) << 53;

// ---- from a draw back to the root --------------------------------------------

static uint64_t unshift(uint64_t z, unsigned bits) {
  uint64_t x = z;
  for (unsigned known = bits; known < 64; known += bits) x = z ^ (x >> bits);
  return x;
}

// The inverse of lsys_mix64: its factors' inverses modulo 2^64.
static uint64_t unmix(uint64_t z) {
  z = unshift(z, 31) * UINT64_C(0x319642B2D24D8EC3);
  z = unshift(z, 27) * UINT64_C(0x96DE1B173F119089);
  return unshift(z, 30);
}

static uint64_t parent(uint64_t key, uint64_t child) {
  return unmix(key) - (child + 1) * LSYS_GOLDEN;
}

// The key whose draw 0 is made of these 64 bits.
static uint64_t drawing(uint64_t bits) {
  return unmix(bits) ^ lsys_mix64(LSYS_DRAW_SALT);
}

static void inverses(void **state) {
  (void)state;
  for (uint64_t i = 0; i < 1000; i++) {
    uint64_t bits = i * LSYS_GOLDEN, key = drawing(bits);
    assert_true(lsys_mix64(unmix(bits)) == bits);
    assert_true(lsys_split(parent(bits, i), i) == bits);
    assert_true(lsys_draw(key, 0) == (double)(bits >> 11) * 0x1p-53);
  }
}

// ---- one module's choice -----------------------------------------------------

typedef struct Sink {
  LsysSink sink;
  uint8_t sym[64];
  size_t count;
} Sink;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)axiom, (void)pass;
  ((Sink *)sink)->count = 0;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  Sink *to = (Sink *)sink;
  if (to->count + part->nsym > sizeof to->sym) return false;
  memcpy(to->sym + to->count, part->sym, part->nsym);
  to->count += part->nsym;
  return true;
}

static bool end(LsysSink *sink) {
  (void)sink;
  return true;
}

static Sink derive(const LsysGrammar *grammar, uint64_t root, uint64_t steps) {
  LsysMemory memory = {.limit = lsys_memory_default()};
  LsysOptions options = {0};
  options.at[LSYS_OPTION_STEPS] = (LsysOptionValue){.given = true, .whole = steps};
  options.at[LSYS_OPTION_THREADS] = (LsysOptionValue){.given = true, .whole = 1};
  Sink sink = {.sink = {.passes = 1, .begin = begin, .take = take, .end = end}};
  LsysDerivation derivation;
  assert_true(lsys_derivation_open(&derivation, grammar, &options, &memory));
  derivation.worker.run.root = root;
  assert_true(lsys_derivation_run(&derivation, 0, &sink.sink, 0));
  lsys_derivation_close(&derivation);
  return sink;
}

// ---- grammars ----------------------------------------------------------------

typedef struct Weights {
  const char *text[MOST_WEIGHTS];
} Weights;

static const Weights families[] = {
  {{"0.33", "0.33", "0.34"}},
  {{"33", "33", "34"}},
  {{"1", "1", "1"}},
  {{"0.1", "0.2", "0.3", "0.4"}},
  {{"0.7", "0.1"}},
  {{"1e-17", "1"}},
  {{"1", "1e-17"}},
  {{"3", "1e-3", "5", "1e-9"}},
  {{"1e-200", "3e-200"}},
  {{"1e300", "1e300"}},
  {{"1e-310", "2e-310", "1e-310"}},
  {{"1.7", "1.7", "1.7", "1.7", "1.7", "1.7", "1.7", "1.7"}},
  {{"0.3", "0.1", "0.1", "0.1", "0.1", "0.1", "0.1", "0.1", "0.1"}},
};

// B becomes `ZA`, and A becomes `x_j` and j + 1 times Z by the j-th weight; with an argument it is no row of a table.
static void write_grammar(const Weights *weights, bool rows, char *text, size_t size) {
  size_t n = (size_t)snprintf(text, size, "axiom: B\nB --> ZA\n");
  for (int j = 0; j < MOST_WEIGHTS && weights->text[j]; j++)
    n += (size_t)snprintf(text + n, size - n, "A --> x_%d%s%.*s : %s\n", j, rows ? "" : "(1)", j + 1, "ZZZZZZZZZZ",
                          weights->text[j]);
  assert_true(n < size);
}

// LANGUAGE.md 5.2: the first j with u W < w1 + ... + wj. -1: there is none, because u W was rounded to W.
static int chosen(const double *bound, int count, uint64_t n) {
  for (int j = 0; j < count; j++)
    if ((double)n * 0x1p-53 * bound[count - 1] < bound[j]) return j;
  return -1;
}

typedef struct Engines {
  const LsysGrammar *compiled;
  LsysGrammar *interpreted;
} Engines;

// Both engines, with the draw of A made of n and of such low bits. The word's length tells what was chosen.
static void check_draw(const Engines *engines, uint64_t n, uint64_t low, int wanted) {
  uint64_t key = drawing(n << 11 | low);
  uint64_t root = parent(parent(key, 1), 0);
  Sink ours = derive(engines->compiled, root, 2), theirs = derive(engines->interpreted, root, 2);
  int by_code = (int)ours.count - 3, by_interpreter = (int)theirs.count - 3;
  if (by_code != wanted || by_interpreter != wanted || memcmp(ours.sym, theirs.sym, ours.count) != 0)
    fail_msg("draw %" PRIu64 ": compiled code chooses %d, the interpreter %d, the definition %d", n, by_code,
             by_interpreter, wanted);
}

static void check_borders(const Engines *engines, const Weights *weights) {
  double bound[MOST_WEIGHTS], sum = 0;
  int count = 0;
  for (; count < MOST_WEIGHTS && weights->text[count]; count++)
    bound[count] = sum += strtod(weights->text[count], NULL);
  for (int j = 0; j <= count; j++) {
    uint64_t border = j == 0 ? 0 : (uint64_t)(bound[j - 1] / sum * 0x1p53);
    for (uint64_t n = border < AROUND ? 0 : border - AROUND; n <= border + AROUND && n < DRAWS; n++)
      for (uint64_t low = 0; low <= 0x7ff; low += 0x7ff) check_draw(engines, n, low, chosen(bound, count, n));
  }
}

static const Backend *backend(void) {
  void *module = dlopen(LSYSC_BACKEND, RTLD_NOW | RTLD_LOCAL);
  const Backend *loaded = module ? dlsym(module, "lsysc_backend") : NULL;
  if (!loaded) fail_msg("cannot load the code generator: %s", dlerror());
  return loaded;
}

static void borders(void **state) {
  (void)state;
  const Backend *code = backend();
  char text[1024];
  for (size_t f = 0; f < sizeof families / sizeof *families; f++)
    for (unsigned variant = 0; variant < 4; variant++) {
      write_grammar(&families[f], variant & 1, text, sizeof text);
      Grammar grammar = grammar_read(text);
      BackendOptions how = {.optimise = variant & 2, .symbol = "lsys_grammar"};
      DiagOptions options;
      diag_options_default(&options);
      Diag *diag = diag_create(grammar.arena, sources_create(grammar.arena), &options);
      Jit *jit =
        code->jit(grammar.program, grammar.facts, grammar.description, &how, lsys_symbols, lsys_symbol_count, diag);
      assert_non_null(jit);
      Engines engines = {code->jit_grammar(jit), interp_grammar(grammar.arena, grammar.program, grammar.description)};
      check_borders(&engines, &families[f]);
      interp_release(engines.interpreted);
      code->jit_free(jit);
      arena_destroy(grammar.arena);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(inverses), cmocka_unit_test(borders)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
