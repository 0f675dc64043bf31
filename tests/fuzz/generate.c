// generate.c -- a number -> a random grammar, the same on every machine.
//
// Each grammar first draws which features it has, so that simple classes turn
// up as often as the full language, then its kinds, then productions that use
// them. The number of steps is the largest that keeps every word short.
#include "grammar.h"

#include "lsys/keys.h"

typedef struct Kind {
  char symbol;
  int arity;
} Kind;

enum { MOST_KINDS = 16, MOST_STEPS = 14, MOST_FORMALS = 20 };

typedef struct Generator {
  Arena *arena;
  FuzzGrammar *grammar;
  uint64_t state;
  Kind kinds[MOST_KINDS];
  int kind_count;
  int system;   // whose productions are made
  int formals;  // of the production that is being made
  bool local;   // ... and it has a local variable
  bool parametric, guarded, stochastic, bracketed, cuts, left, right, decomposes, interprets, defines, drawn, blocks,
    pseudo, asks;
} Generator;

// ---- chance ------------------------------------------------------------------

static uint64_t draw(Generator *g) {
  return lsys_mix64(g->state += LSYS_GOLDEN);
}

static int below(Generator *g, int n) {
  return (int)(draw(g) % (uint64_t)n);
}

static bool chance(Generator *g, int percent) {
  return below(g, 100) < percent;
}

// ---- expressions ---------------------------------------------------------------

static Node *node(Generator *g, NodeKind kind, const char *text, int count) {
  Node *made = ARENA_NEW(g->arena, Node);
  *made = (Node){.kind = kind, .text = text, .count = count};
  return made;
}

static Node *number(Generator *g) {
  static const double numbers[] = {0, 1, 2, 3, 0.5, 0.25, 10, 1.1, 0.1, 7, 100, 1e-3};
  Node *made = node(g, NODE_NUMBER, NULL, 0);
  made->number = numbers[below(g, sizeof numbers / sizeof *numbers)];
  return made;
}

static Node *leaf(Generator *g) {
  int defines = (int)g->grammar->defines.count;
  if (g->local && chance(g, 30)) return node(g, NODE_LOCAL, NULL, 0);
  if (g->formals && chance(g, 65)) {
    Node *made = node(g, NODE_FORMAL, NULL, 0);
    made->slot = below(g, g->formals);
    return made;
  }
  if (defines && chance(g, 25)) {
    Node *made = node(g, NODE_DEFINE, NULL, 0);
    made->slot = below(g, defines);
    return made;
  }
  return number(g);
}

static Node *expression(Generator *g, int depth);

static Node *call(Generator *g, int depth) {
  static const struct {
    const char *name;
    int count;
  } pure[] = {{"sin", 1},   {"cos", 1}, {"sqrt", 1}, {"floor", 1}, {"ceil", 1}, {"round", 1},
              {"trunc", 1}, {"abs", 1}, {"sign", 1}, {"exp", 1},   {"log", 1},  {"atan", 2},
              {"min", 2},   {"max", 3}, {"pow", 2},  {"tan", 1},   {"asin", 1}},
    random[] = {{"ran", 1}, {"nran", 2}, {"bran", 2}, {"biran", 2}};
  bool draws = g->stochastic && chance(g, 30);
  int which = below(g, draws ? sizeof random / sizeof *random : sizeof pure / sizeof *pure);
  int count = draws ? random[which].count : pure[which].count;
  Node *made = node(g, NODE_CALL, draws ? random[which].name : pure[which].name, count);
  for (int i = 0; i < count; i++) made->kid[i] = draws && i ? number(g) : expression(g, depth - 1);
  return made;
}

static Node *application(Generator *g, int depth) {
  Node *made = node(g, NODE_APPLY, NULL, 2);
  made->slot = below(g, (int)g->grammar->functions.count);
  for (int i = 0; i < 2; i++) made->kid[i] = expression(g, depth - 1);
  return made;
}

static Node *expression(Generator *g, int depth) {
  static const char *const operators[] = {"+", "-",  "*", "/",  "%",  "^",  "+",  "-", "*",
                                          "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
  if (depth <= 0 || chance(g, 35)) return leaf(g);
  if (g->grammar->functions.count && chance(g, 12)) return application(g, depth);
  if (chance(g, 12)) return call(g, depth);
  if (chance(g, 10)) {
    Node *made = node(g, NODE_UNARY, chance(g, 70) ? "-" : "!", 1);
    made->kid[0] = expression(g, depth - 1);
    return made;
  }
  bool choice = chance(g, 8);
  Node *made = choice ? node(g, NODE_CHOICE, NULL, 3)
                      : node(g, NODE_BINARY, operators[below(g, sizeof operators / sizeof *operators)], 2);
  for (int i = 0; i < made->count; i++) made->kid[i] = expression(g, depth - 1);
  return made;
}

// Something that holds about as often as not.
static Node *condition(Generator *g) {
  static const char *const comparisons[] = {"<", "<=", ">", ">=", "==", "!="};
  if (chance(g, 20)) return expression(g, 3);
  Node *made = node(g, NODE_BINARY, comparisons[below(g, 6)], 2);
  made->kid[0] = expression(g, 2);
  made->kid[1] = chance(g, 70) ? number(g) : expression(g, 1);
  return made;
}

// ---- words ---------------------------------------------------------------------

static FuzzModule module_of(Generator *g, const Kind *kind) {
  FuzzModule made = {.symbol = kind->symbol, .arity = kind->arity};
  for (int i = 0; i < kind->arity; i++) made.arg[i] = expression(g, 3);
  return made;
}

static FuzzModule terminal(Generator *g) {
  static const char symbols[] = "F+-fX";
  FuzzModule made = {.symbol = symbols[below(g, g->drawn ? 5 : 1)]};
  if (g->parametric && chance(g, 30)) {
    made.arity = 1;
    made.arg[0] = expression(g, 2);
  }
  return made;
}

static void add_modules(Generator *g, FuzzWord *word, int count, int depth);

// ?(n) ... $, now and then without its end.
static void add_nested(Generator *g, FuzzWord *word, int depth) {
  FuzzModule begin = {.symbol = '?', .arity = 1, .arg = {node(g, NODE_NUMBER, NULL, 0)}};
  begin.arg[0]->number = chance(g, 80);
  *VEC_PUSH(g->arena, word) = begin;
  add_modules(g, word, 1 + below(g, 2), depth);
  if (chance(g, 90)) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '$'};
}

static void add_modules(Generator *g, FuzzWord *word, int count, int depth) {
  for (int i = 0; i < count; i++) {
    if (g->bracketed && depth > 0 && chance(g, 20)) {
      *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '['};
      add_modules(g, word, 1 + below(g, 2), depth - 1);
      *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = ']'};
    } else if (g->grammar->nested && depth > 0 && chance(g, 15)) {
      add_nested(g, word, depth - 1);
    } else if (g->cuts && chance(g, 4)) {
      *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '%'};
    } else if (chance(g, 35)) {
      FuzzModule made = terminal(g);
      *VEC_PUSH(g->arena, word) = made;
    } else {
      FuzzModule made = module_of(g, &g->kinds[below(g, g->kind_count)]);
      *VEC_PUSH(g->arena, word) = made;
    }
  }
}

// A word in which something goes on growing.
static void add_growth(Generator *g, FuzzWord *word) {
  int count = 1 + chance(g, 50);
  for (int i = 0; i < count; i++) {
    FuzzModule made = module_of(g, &g->kinds[below(g, g->kind_count)]);
    *VEC_PUSH(g->arena, word) = made;
  }
}

static FuzzModule pattern(Generator *g, const Kind *kind, bool literal) {
  FuzzModule made = {.symbol = kind->symbol, .arity = kind->arity};
  for (int i = 0; i < kind->arity; i++) {
    if (literal && chance(g, 10)) {
      made.arg[i] = number(g);
    } else {
      made.arg[i] = node(g, NODE_FORMAL, NULL, 0);
      made.arg[i]->slot = g->formals++;
    }
  }
  return made;
}

static void add_context(Generator *g, FuzzWord *word, bool right) {
  int count = chance(g, 75) ? 1 : 2;
  for (int i = 0; i < count; i++) {
    const Kind *kind = &g->kinds[below(g, g->kind_count)];
    bool branch = right && g->bracketed && chance(g, 15);
    if (branch) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '['};
    *VEC_PUSH(g->arena, word) = pattern(g, kind, false);
    if (branch) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = ']'};
  }
  if (!right && g->bracketed && chance(g, 10)) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '['};
}

// A module or a branch behind a strict predecessor's first module.
static void add_beside(Generator *g, FuzzWord *word) {
  bool branch = g->bracketed && chance(g, 40);
  if (branch) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = '['};
  *VEC_PUSH(g->arena, word) = pattern(g, &g->kinds[below(g, g->kind_count)], true);
  if (branch) *VEC_PUSH(g->arena, word) = (FuzzModule){.symbol = ']'};
}

// ---- productions ---------------------------------------------------------------

static void add_rule(Generator *g, const Kind *kind, RuleSection section, bool weighted, bool last) {
  FuzzRule rule = {.section = section, .system = g->system, .table = -1};
  bool contexts = section != RULE_DECOMPOSITION;
  g->formals = 0;
  g->local = false;
  if (g->grammar->schedule && section == RULE_DERIVATION && !g->system) rule.table = below(g, FUZZ_TABLES + 1) - 1;
  int often = last ? 15 : 50;  // the last one is what mostly happens
  if (contexts && g->left && chance(g, often)) add_context(g, &rule.left, false);
  *VEC_PUSH(g->arena, &rule.strict) = pattern(g, kind, true);
  if (g->pseudo && section == RULE_DERIVATION && !last && chance(g, 40)) add_beside(g, &rule.strict);
  if (contexts && g->right && chance(g, often)) add_context(g, &rule.right, true);
  if (g->blocks && chance(g, 30)) {
    rule.before = expression(g, 2);
    g->local = true;
  }
  bool needs_guard = !last && !weighted && !rule.left.count && !rule.right.count;  // else what follows is never reached
  if (g->formals && g->guarded && (needs_guard || chance(g, last ? 20 : 60))) rule.guard = condition(g);
  if (chance(g, last ? 80 : 50)) add_growth(g, &rule.successor);
  if (chance(g, 85)) add_modules(g, &rule.successor, 1 + below(g, section == RULE_DERIVATION ? 4 : 2), 2);
  if (weighted) rule.weight = chance(g, 80) ? number(g) : expression(g, 2);
  *VEC_PUSH(g->arena, &g->grammar->rules) = rule;
  g->local = false;
}

static void add_family(Generator *g, const Kind *kind, RuleSection section) {
  bool weighted = g->stochastic && chance(g, 60);
  int count = weighted ? 2 + below(g, 3) : 1 + below(g, 3);
  for (int i = 0; i < count; i++) add_rule(g, kind, section, weighted && chance(g, 90), i + 1 == count);
}

// All productions of an L-system; often: how many of 100 kinds are derived.
static void add_families(Generator *g, int often) {
  for (int i = 0; i < g->kind_count; i++)
    if (chance(g, often)) add_family(g, &g->kinds[i], RULE_DERIVATION);
  for (int i = 0; g->decomposes && i < g->kind_count; i++)
    if (chance(g, 40)) add_family(g, &g->kinds[i], RULE_DECOMPOSITION);
  for (int i = 0; g->interprets && i < g->kind_count; i++)
    if (chance(g, 40)) add_family(g, &g->kinds[i], RULE_HOMOMORPHISM);
}

static void choose_kinds(Generator *g) {
  static const char letters[] = "ABCDEGH";
  int count = 1 + below(g, 5);
  for (int i = 0; i < count; i++) {
    int arity = g->parametric ? below(g, MOST_ARGS) : 0;
    g->kinds[g->kind_count++] = (Kind){letters[i], arity};
    if (g->parametric && chance(g, 10)) g->kinds[g->kind_count++] = (Kind){letters[i], (arity + 1) % MOST_ARGS};
  }
  if (chance(g, 30)) g->kinds[g->kind_count++] = (Kind){'F', 0};
  static const char queries[] = "ephlu";
  for (int i = 0; g->asks && i < 2; i++)
    g->kinds[g->kind_count++] = (Kind){queries[below(g, i ? 5 : 1)], below(g, MOST_ARGS)};
}

static void choose_features(Generator *g) {
  static const char *const environments[] = {"point", "occupancy(cell=2)", "light(shade=0.75)", "terrain(height=3)"};
  g->parametric = chance(g, 65);
  g->guarded = g->parametric && chance(g, 70);
  g->stochastic = chance(g, 40);
  g->bracketed = chance(g, 55);
  g->left = chance(g, 35);
  g->right = chance(g, 30);
  g->decomposes = chance(g, 25);
  g->interprets = chance(g, 20);
  g->defines = g->parametric && chance(g, 40);
  g->drawn = chance(g, 80);
  g->blocks = g->parametric && chance(g, 25);
  g->pseudo = chance(g, 8);
  if (chance(g, 12)) g->grammar->schedule = chance(g, 50) ? "t0 t1" : "t0 t1 t1";
  g->cuts = g->bracketed && chance(g, 15);
  g->grammar->nested = chance(g, 12);
  g->asks = g->parametric && !g->grammar->nested && !(g->interprets && (g->left || g->right)) && chance(g, 15);
  if (g->asks && chance(g, 60)) g->grammar->environment = environments[below(g, 4)];
  g->grammar->ring = (g->left || g->right) && !g->bracketed && chance(g, 15);
}

static void choose_ignore(Generator *g) {
  static const char *const symbols[] = {"+ - F", "F", "+ -", "A", "B F", "X f + -"};
  if (g->grammar->nested && chance(g, 50)) g->grammar->ignore_nested = chance(g, 50) ? "+ - $ ?" : "A F";
  if (!(g->left || g->right) || !chance(g, 40)) return;
  g->grammar->ignore = symbols[below(g, sizeof symbols / sizeof *symbols)];
  g->grammar->consider = chance(g, 20);
}

FuzzGrammar *fuzz_generate(Arena *arena, uint64_t number_, double longest) {
  FuzzGrammar *grammar = ARENA_NEW(arena, FuzzGrammar);
  Generator *g = ARENA_NEW(arena, Generator);
  *g = (Generator){.arena = arena, .grammar = grammar, .state = lsys_root(number_)};
  grammar->number = number_;
  choose_features(g);
  choose_kinds(g);
  g->formals = 2;
  for (int i = 0; g->defines && i < below(g, 3); i++) {
    Node *body = expression(g, 2);
    *VEC_PUSH(arena, &grammar->functions) = body;
  }
  g->formals = 0;
  for (int i = 0; g->defines && i < 3; i++) {
    Node *value = expression(g, 2);
    *VEC_PUSH(arena, &grammar->defines) = value;
  }
  grammar->seed = draw(g) % 1000;
  grammar->depth = 1 + below(g, 3);
  add_growth(g, &grammar->axiom);
  add_modules(g, &grammar->axiom, below(g, 4), 1);
  for (g->system = 0; g->system <= grammar->nested; g->system++) add_families(g, g->system ? 60 : 95);
  choose_ignore(g);
  for (grammar->steps = MOST_STEPS; grammar->steps > 0 && fuzz_too_long(grammar, longest);) grammar->steps--;
  return grammar;
}
