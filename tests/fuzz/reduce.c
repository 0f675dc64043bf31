// reduce.c -- a failing grammar -> a small one that still fails.
//
// Greedy: every way of making the grammar smaller by one piece is tried in
// turn, the first that still fails is kept, until none does. A try works on a
// deep copy, so that a grammar that does not fail is simply dropped.
#include "grammar.h"

// ---- copies ------------------------------------------------------------------

static Node *copy_node(Arena *arena, const Node *node) {
  if (!node) return NULL;
  Node *copy = ARENA_NEW(arena, Node);
  *copy = *node;
  for (int i = 0; i < node->count; i++) copy->kid[i] = copy_node(arena, node->kid[i]);
  return copy;
}

static FuzzWord copy_word(Arena *arena, const FuzzWord *word) {
  FuzzWord copy = {0};
  for (size_t i = 0; i < word->count; i++) {
    FuzzModule module = word->at[i];
    for (int k = 0; k < module.arity; k++) module.arg[k] = copy_node(arena, module.arg[k]);
    *VEC_PUSH(arena, &copy) = module;
  }
  return copy;
}

static FuzzGrammar *copy_grammar(Arena *arena, const FuzzGrammar *grammar) {
  FuzzGrammar *copy = ARENA_NEW(arena, FuzzGrammar);
  *copy = *grammar;
  copy->axiom = copy_word(arena, &grammar->axiom);
  copy->defines.at = NULL;
  copy->defines.count = copy->defines.capacity = 0;
  copy->functions.at = NULL;
  copy->functions.count = copy->functions.capacity = 0;
  copy->rules.at = NULL;
  copy->rules.count = copy->rules.capacity = 0;
  for (size_t i = 0; i < grammar->defines.count; i++)
    *VEC_PUSH(arena, &copy->defines) = copy_node(arena, grammar->defines.at[i]);
  for (size_t i = 0; i < grammar->functions.count; i++)
    *VEC_PUSH(arena, &copy->functions) = copy_node(arena, grammar->functions.at[i]);
  for (size_t i = 0; i < grammar->rules.count; i++) {
    FuzzRule rule = grammar->rules.at[i];
    rule.left = copy_word(arena, &rule.left);
    rule.strict = copy_word(arena, &rule.strict);
    rule.right = copy_word(arena, &rule.right);
    rule.before = copy_node(arena, rule.before);
    rule.guard = copy_node(arena, rule.guard);
    rule.weight = copy_node(arena, rule.weight);
    rule.successor = copy_word(arena, &rule.successor);
    *VEC_PUSH(arena, &copy->rules) = rule;
  }
  return copy;
}

// ---- ways of making a grammar smaller ------------------------------------------

// A pass over all places where something can be left out: number `wanted` is done.
typedef struct Cut {
  int at, wanted;
} Cut;

static bool is_it(Cut *cut) {
  return cut->at++ == cut->wanted;
}

// A node becomes one of its operands, or 1.
static void cut_node(Cut *cut, Node **place) {
  Node *node = *place;
  if (!node) return;
  if (node->kind == NODE_NUMBER) return;
  if (is_it(cut)) {
    node->kind = NODE_NUMBER;
    node->number = 1;
    node->count = 0;
    return;
  }
  for (int i = 0; i < node->count; i++) {
    if (is_it(cut)) {
      *place = node->kid[i];
      return;
    }
  }
  for (int i = 0; i < node->count; i++) cut_node(cut, &node->kid[i]);
}

static void remove_modules(FuzzWord *word, size_t at, size_t count) {
  for (size_t i = at + count; i < word->count; i++) word->at[i - count] = word->at[i];
  word->count -= count;
}

// The modules up to the matching bracket.
static size_t branch_length(const FuzzWord *word, size_t at) {
  int depth = 0;
  for (size_t i = at; i < word->count; i++) {
    depth += word->at[i].symbol == '[' ? 1 : word->at[i].symbol == ']' ? -1 : 0;
    if (depth <= 0) return i - at + 1;
  }
  return word->count - at;
}

// Drops a module or a whole branch, opens a branch, simplifies an argument.
static void cut_word(Cut *cut, FuzzWord *word, size_t least, bool arguments) {
  for (size_t i = 0; i < word->count; i++) {
    size_t length = branch_length(word, i);
    if (word->count - length >= least && is_it(cut)) {
      remove_modules(word, i, length);
      return;
    }
    if (length > 1 && is_it(cut)) {
      remove_modules(word, i + length - 1, 1);
      remove_modules(word, i, 1);
      return;
    }
    for (int k = 0; arguments && k < word->at[i].arity; k++) cut_node(cut, &word->at[i].arg[k]);
  }
}

static void cut_rule(Cut *cut, FuzzRule *rule) {
  if (rule->left.count && is_it(cut)) rule->left.count = 0;
  if (rule->right.count && is_it(cut)) rule->right.count = 0;
  if (rule->before && is_it(cut)) rule->before = NULL;
  if (rule->guard && is_it(cut)) rule->guard = NULL;
  if (rule->weight && is_it(cut)) rule->weight = NULL;
  cut_word(cut, &rule->left, 1, false);
  cut_word(cut, &rule->right, 1, false);
  cut_word(cut, &rule->strict, 1, false);
  cut_node(cut, &rule->before);
  cut_node(cut, &rule->guard);
  cut_node(cut, &rule->weight);
  cut_word(cut, &rule->successor, 0, true);
}

// The productions of all tables apply in every step.
static void drop_tables(FuzzGrammar *grammar) {
  grammar->schedule = NULL;
  for (size_t i = 0; i < grammar->rules.count; i++) grammar->rules.at[i].table = -1;
}

// False when there is no place with that number any more.
static bool cut_grammar(FuzzGrammar *grammar, int wanted) {
  Cut cut = {0, wanted};
  for (size_t i = grammar->rules.count; i-- > 0;)
    if (is_it(&cut)) {
      for (size_t k = i + 1; k < grammar->rules.count; k++) grammar->rules.at[k - 1] = grammar->rules.at[k];
      grammar->rules.count--;
      return true;
    }
  if (grammar->steps > 1 && is_it(&cut)) grammar->steps /= 2;
  if (grammar->steps > 0 && is_it(&cut)) grammar->steps--;
  if (grammar->depth > 1 && is_it(&cut)) grammar->depth--;
  if (grammar->ignore && is_it(&cut)) grammar->ignore = NULL;
  if (grammar->ring && is_it(&cut)) grammar->ring = false;
  if (grammar->defines.count && is_it(&cut)) grammar->defines.count--;
  if (grammar->functions.count && is_it(&cut)) grammar->functions.count--;
  if (grammar->schedule && is_it(&cut)) drop_tables(grammar);
  if (grammar->seed && is_it(&cut)) grammar->seed = 0;
  cut_word(&cut, &grammar->axiom, 1, true);
  for (size_t i = 0; i < grammar->defines.count; i++) cut_node(&cut, &grammar->defines.at[i]);
  for (size_t i = 0; i < grammar->functions.count; i++) cut_node(&cut, &grammar->functions.at[i]);
  for (size_t i = 0; i < grammar->rules.count; i++) cut_rule(&cut, &grammar->rules.at[i]);
  return cut.at > cut.wanted;
}

FuzzGrammar *fuzz_reduce(Arena *arena, const FuzzGrammar *grammar, FuzzFails *fails, void *data) {
  FuzzGrammar *best = copy_grammar(arena, grammar);
  // After a success the places before it were tried on a larger grammar: the pass goes on there and
  // starts again at the end.
  bool smaller = true;
  while (smaller) {
    smaller = false;
    for (int place = 0;;) {
      FuzzGrammar *next = copy_grammar(arena, best);
      if (!cut_grammar(next, place)) break;
      if (fails(next, data)) {
        best = next;
        smaller = true;
      } else {
        place++;
      }
    }
  }
  return best;
}
