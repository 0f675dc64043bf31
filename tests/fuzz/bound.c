// bound.c -- how long a random grammar's words can become at most: guards and
// contexts are taken to hold whenever that makes a word longer.
#include "grammar.h"

enum { MOST_KINDS = 64, MOST_DEPTH = 8 };

typedef struct Bound {
  const FuzzGrammar *grammar;
  const FuzzModule *kinds[MOST_KINDS];
  int kind_count;
  double longest[MOST_KINDS][MOST_DEPTH + 1];  // after the steps so far, if decomposed to that depth first
} Bound;

static int kind_of(Bound *bound, const FuzzModule *module) {
  for (int i = 0; i < bound->kind_count; i++)
    if (bound->kinds[i]->symbol == module->symbol && bound->kinds[i]->arity == module->arity) return i;
  bound->kinds[bound->kind_count] = module;
  return bound->kind_count++;
}

static void find_kinds(Bound *bound, const FuzzWord *word) {
  for (size_t i = 0; i < word->count; i++) kind_of(bound, &word->at[i]);
}

static double length_of(Bound *bound, const FuzzWord *word, int depth) {
  double sum = 0;
  for (size_t i = 0; i < word->count; i++) sum += bound->longest[kind_of(bound, &word->at[i])][depth];
  return sum;
}

// The longest that the successors of a kind's productions give; at least `least`.
static double longest_successor(Bound *bound, int kind, RuleSection section, int depth, double least) {
  for (size_t i = 0; i < bound->grammar->rules.count; i++) {
    const FuzzRule *rule = &bound->grammar->rules.at[i];
    if (rule->section != section || kind_of(bound, &rule->strict.at[0]) != kind) continue;
    double length = length_of(bound, &rule->successor, depth);
    if (length > least) least = length;
  }
  return least;
}

// From the lengths without decomposition (or homomorphism) to those with it, depth by depth.
static void decompose(Bound *bound, RuleSection section) {
  for (int depth = 1; depth <= bound->grammar->depth; depth++)
    for (int kind = 0; kind < bound->kind_count; kind++)
      bound->longest[kind][depth] = longest_successor(bound, kind, section, depth - 1, bound->longest[kind][0]);
}

static void step(Bound *bound) {
  double next[MOST_KINDS];
  decompose(bound, RULE_DECOMPOSITION);
  int depth = bound->grammar->depth;
  for (int kind = 0; kind < bound->kind_count; kind++)
    next[kind] = longest_successor(bound, kind, RULE_DERIVATION, depth, bound->longest[kind][depth]);
  for (int kind = 0; kind < bound->kind_count; kind++) bound->longest[kind][0] = next[kind];
}

bool fuzz_too_long(const FuzzGrammar *grammar, double longest) {
  Bound bound = {.grammar = grammar};
  find_kinds(&bound, &grammar->axiom);
  for (size_t i = 0; i < grammar->rules.count; i++) {
    find_kinds(&bound, &grammar->rules.at[i].strict);
    find_kinds(&bound, &grammar->rules.at[i].successor);
  }
  // Steps are counted from the word's end: what the homomorphism makes of a module, of its successor, and so on.
  for (int kind = 0; kind < bound.kind_count; kind++) bound.longest[kind][0] = 1;
  decompose(&bound, RULE_HOMOMORPHISM);
  for (int kind = 0; kind < bound.kind_count; kind++) bound.longest[kind][0] = bound.longest[kind][grammar->depth];
  for (int i = 0; i < grammar->steps; i++) {
    step(&bound);
    if (length_of(&bound, &grammar->axiom, 0) > longest) return true;
  }
  return false;
}

uint64_t fuzz_most_steps(const FuzzGrammar *grammar, double longest) {
  enum { ENOUGH = 60 };
  FuzzGrammar longer = *grammar;
  while (longer.steps < ENOUGH) {
    longer.steps++;
    if (fuzz_too_long(&longer, longest)) return (uint64_t)longer.steps - 1;
  }
  return ENOUGH;
}
