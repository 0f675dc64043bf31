// analyze.c -- Program + Facts -> text for people: what kind of grammar this
// is, what happens to each kind of module, how fast words grow.
#include "analysis/analyze.h"

#include "analysis/growth.h"
#include "support/map.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  DEFAULT_STEPS = 10,   // shown where the grammar has no number of steps
  FIRST_SHOWN = 12,     // steps shown one by one; then the last
  LAST_EXACT = 100000,  // beyond it exponential growth is only estimated
  LONGEST_NUMBER = 40,  // digits of a number before it is shortened
};

// ---- class ---------------------------------------------------------------------

static size_t context_length(const Context *context) {
  size_t length = 0;
  for (size_t i = 0; i < context->count; i++) length += context->at[i].what == PATTERN_MODULE;
  return length;
}

// The most modules in a left and in a right context of the derivation's productions.
static void context_reach(const Program *program, size_t *left, size_t *right) {
  *left = *right = 0;
  for (size_t s = 0; s < program->lsystem_count; s++) {
    const Productions *productions = &program->lsystems[s].productions;
    for (size_t i = 0; i < productions->count; i++) {
      size_t l = context_length(&productions->at[i]->left), r = context_length(&productions->at[i]->right);
      if (l > *left) *left = l;
      if (r > *right) *right = r;
    }
  }
}

static void print_family(const Program *program, const Facts *facts, FILE *out) {
  size_t left, right;
  context_reach(program, &left, &right);
  if (program->lsystems[0].pseudo)
    fputs("pseudo-L", out);
  else if (left > 1 || right > 1)
    fprintf(out, "IL, a (%zu,%zu)L", left, right);
  else if (left || right)
    fputs(left && right ? "2L" : "1L", out);
  else
    fprintf(out, "%s%s0L", facts->deterministic ? "D" : "", facts->tables ? "T" : "");
  if ((left || right) && facts->tables) fputs(" with tables", out);
}

static void print_class(const Program *program, const Facts *facts, FILE *out) {
  const struct {
    bool holds;
    const char *word;
  } words[] = {
    {facts->bracketed, "bracketed"},
    {facts->parametric, "parametric"},
    {!facts->deterministic, "stochastic"},
    {facts->sequential, "sequential"},
    {facts->queries, "open"},
    {program->lsystems[0].ring, "ring"},
    {program->lsystems[0].decomposition.productions.count, "decomposition"},
    {program->lsystems[0].homomorphism.productions.count, "homomorphism"},
    {program->lsystem_count > 1, "sub-L-systems"},
  };
  fputs("class        ", out);
  print_family(program, facts, out);
  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    if (words[i].holds) fprintf(out, ", %s", words[i].word);
  }
  fputc('\n', out);
}

// ---- engine --------------------------------------------------------------------

// Why the expand engine does not apply.
static const char *step_reason(const Program *program, const Facts *facts) {
  size_t left, right;
  context_reach(program, &left, &right);
  if (program->lsystems[0].pseudo) return "predecessors of several modules are read from the left";
  if (left || right) return "productions look at neighbours";
  if (program->cut != KIND_NONE) return "% removes what stands behind it";
  if (program->lsystem_count > 1) return "which L-system applies depends on the place in the word";
  if (program->lsystems[0].ring) return "first and last module are neighbours";
  if (facts->sequential) return "productions write global variables, print or stop";
  return "productions read what blocks, queries or the environment set";
}

// Whether something in a step depends on all that came before it (the run time's lsys_spread_applies).
static bool in_order(const Program *program, const Facts *facts) {
  return facts->sequential || program->lsystems[0].pseudo || program->cut != KIND_NONE || program->lsystem_count > 1
      || (!facts->context_free && (program->lsystems[0].ring || facts->queries));
}

static void print_engine(const Program *program, const Facts *facts, FILE *out) {
  if (facts->context_free) {
    fputs("engine       expand: what a module becomes depends on itself alone, so no intermediate word is stored\n",
          out);
  } else {
    fprintf(out, "engine       step, word by word: %s\n", step_reason(program, facts));
  }
  if (in_order(program, facts)) fputs("             in order, on one thread\n", out);
}

// ---- kinds -----------------------------------------------------------------------

// Code points of a UTF-8 text.
static int text_width(const char *text) {
  int width = 0;
  for (; *text; text++) width += (*text & 0xc0) != 0x80;
  return width;
}

static int symbol_width(const Program *program) {
  int widest = text_width("symbol");
  for (size_t k = 0; k < program->kind_count; k++) {
    int width = text_width(program->kinds[k].symbol);
    if (width > widest) widest = width;
  }
  return widest;
}

static void print_kind(const Program *program, const Facts *facts, size_t k, int width, FILE *out) {
  const Kind *kind = &program->kinds[k];
  const KindFacts *fact = &facts->kinds[k];
  const struct {
    bool holds;
    const char *word;
  } words[] = {
    {!fact->reachable, "unreachable"},
    {fact->terminal, "terminal"},
    {fact->fixed && !fact->terminal, "fixed"},
    {fact->key, "key"},
    {kind->ignored, "ignored"},
    {fact->decompositions.count, "decomposed"},
    {fact->homomorphisms.count, "shown-as"},
  };
  fprintf(out, "  %4zu  %s%*s  %5" PRIu32 "  %-6s  %5zu ", k, kind->symbol, width - text_width(kind->symbol), "",
          kind->arity, kind->turtle == LSYS_TURTLE_NONE ? "-" : lsys_turtle[kind->turtle].symbol, fact->own.count);
  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    if (words[i].holds) fprintf(out, " %s", words[i].word);
  }
  fputc('\n', out);
}

static void print_kinds(const Program *program, const Facts *facts, FILE *out) {
  int width = symbol_width(program);
  fprintf(out, "\nkinds        %zu\n", program->kind_count);
  fprintf(out, "  %4s  %-*s  %5s  %-6s  %5s  %s\n", "byte", width, "symbol", "arity", "turtle", "rules", "facts");
  for (size_t k = 0; k < program->kind_count; k++) print_kind(program, facts, k, width, out);
  fprintf(out, "longest successor: %zu module%s, %zu argument%s\n", facts->longest_successor,
          facts->longest_successor == 1 ? "" : "s", facts->most_arguments, facts->most_arguments == 1 ? "" : "s");
}

// ---- growth ----------------------------------------------------------------------

// How many kinds have each symbol.
static Map *count_symbols(Arena *arena, const Program *program) {
  Map *map = map_create(arena);
  for (size_t k = 0; k < program->kind_count; k++) {
    uint32_t *count = map_place(map, program->kinds[k].symbol, 0);
    *count = *count == MAP_NONE ? 1 : *count + 1;
  }
  return map;
}

// Symbol and, where another kind has the same symbol, number of arguments.
static void print_name(const Kind *kind, const Map *symbols, FILE *out) {
  fputs(kind->symbol, out);
  if (map_find(symbols, kind->symbol, 0) > 1) {
    fprintf(out, "(%" PRIu32 " argument%s)", kind->arity, kind->arity == 1 ? "" : "s");
  }
}

static bool is_unit_row(const LsysGrowth *growth, size_t k) {
  uint32_t first = growth->row[k];
  return growth->row[k + 1] == first + 1 && growth->kind[first] == k && growth->count[first] == 1;
}

static void print_matrix(const Program *program, const Facts *facts, FILE *out) {
  const LsysGrowth *growth = &facts->growth;
  Arena *arena = arena_create();
  const Map *symbols = count_symbols(arena, program);
  fputs("\ngrowth matrix (one module becomes; kinds that stay are left out)\n", out);
  for (size_t k = 0; k < program->kind_count; k++) {
    if (!facts->kinds[k].reachable || is_unit_row(growth, k)) continue;
    fputs("  ", out);
    print_name(&program->kinds[k], symbols, out);
    fputs(" ->", out);
    for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++) {
      fprintf(out, "  %" PRIu32 " ", growth->count[e]);
      print_name(&program->kinds[growth->kind[e]], symbols, out);
    }
    fputs(growth->row[k] == growth->row[k + 1] ? "  nothing\n" : "\n", out);
  }
  arena_destroy(arena);
}

static void print_rate(GrowthRate growth, FILE *out) {
  fputs("growth       ", out);
  if (growth.kind == GROWTH_DIES)
    fputs("words die out\n", out);
  else if (growth.kind == GROWTH_POLYNOMIAL && growth.degree == 0)
    fputs("bounded\n", out);
  else if (growth.kind == GROWTH_POLYNOMIAL)
    fprintf(out, "polynomial, of degree %u\n", growth.degree);
  else {
    fprintf(out, "exponential: %.12g modules for each one in a step", growth.rate);
    if (growth.degree) fprintf(out, ", times a polynomial of degree %u", growth.degree);
    fputc('\n', out);
  }
}

// A number in full, or its first digits and the power of ten.
static void print_number(const mpz_t number, int width, FILE *out) {
  char *digits = mpz_get_str(NULL, 10, number);
  size_t length = strlen(digits);
  if (length <= LONGEST_NUMBER)
    fprintf(out, " %*s", width, digits);
  else
    fprintf(out, "  %c.%.11se%zu", digits[0], digits + 1, length - 1);
  void (*release)(void *, size_t);
  mp_get_memory_functions(NULL, NULL, &release);
  release(digits, length + 1);
}

static void print_step(const Program *program, const Facts *facts, const Word *axiom, uint64_t step, mpz_t *counts,
                       FILE *out) {
  growth_counts(program, facts, axiom, step, counts);
  mpz_t modules, bytes;
  mpz_inits(modules, bytes, NULL);
  unsigned width = program->kind_count > 256 ? 2 : 1;
  for (size_t k = 0; k < program->kind_count; k++) {
    mpz_add(modules, modules, counts[k]);
    mpz_addmul_ui(bytes, counts[k], width + 8ul * program->kinds[k].arity + (facts->kinds[k].key ? 8 : 0));
  }
  fprintf(out, "  %8" PRIu64, step);
  print_number(modules, 24, out);
  print_number(bytes, 24, out);
  fputc('\n', out);
  mpz_clears(modules, bytes, NULL);
}

static uint64_t shown_steps(const Program *program) {
  double steps;
  const Expr *setting = program->settings[LSYS_SETTING_STEPS];
  if (!setting || !expr_constant(program, setting, &steps) || !(steps >= 0)) return DEFAULT_STEPS;
  return steps < 1e18 ? (uint64_t)steps : (uint64_t)1e18;
}

static void print_last_step(const Program *program, const Facts *facts, const Word *axiom, uint64_t step,
                            GrowthRate growth, mpz_t *counts, FILE *out) {
  if (growth.kind != GROWTH_EXPONENTIAL || step <= LAST_EXACT)
    print_step(program, facts, axiom, step, counts, out);
  else
    fprintf(out, "  %8" PRIu64 "  about 10^%.0f\n", step, (double)step * log10(growth.rate));
}

static void print_axiom(const Program *program, const Facts *facts, size_t which, GrowthRate growth, FILE *out) {
  const Word *axiom = &program->axioms[which];
  mpz_t *counts = malloc((program->kind_count + 1) * sizeof *counts);
  if (!counts) return;
  for (size_t k = 0; k < program->kind_count; k++) mpz_init(counts[k]);
  if (program->axiom_count > 1) fprintf(out, "axiom %zu\n", which + 1);
  fprintf(out, "  %8s %24s %24s\n", "step", "modules", "bytes");
  uint64_t steps = shown_steps(program), shown = steps < FIRST_SHOWN ? steps : FIRST_SHOWN;
  for (uint64_t step = 0; step <= shown; step++) print_step(program, facts, axiom, step, counts, out);
  if (shown + 1 < steps) fprintf(out, "  %8s\n", "...");
  if (steps > shown) print_last_step(program, facts, axiom, steps, growth, counts, out);
  for (size_t k = 0; k < program->kind_count; k++) mpz_clear(counts[k]);
  free(counts);
}

void analyze_print(const Program *program, const Facts *facts, FILE *out) {
  fprintf(out, "grammar      %s\n", program->name);
  print_class(program, facts, out);
  print_engine(program, facts, out);
  if (facts->bracketed && !facts->balanced) fputs("brackets     need not nest: some word opens or closes more\n", out);
  if (!facts->counts_by_kind) {
    fputs("growth       depends on arguments, neighbours, draws or tables: only deriving tells\n", out);
    print_kinds(program, facts, out);
    return;
  }
  GrowthRate growth = growth_rate(program, facts);
  print_rate(growth, out);
  print_kinds(program, facts, out);
  print_matrix(program, facts, out);
  fputs("\npredicted size\n", out);
  for (size_t i = 0; i < program->axiom_count; i++) print_axiom(program, facts, i, growth, out);
}
