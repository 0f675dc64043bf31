// describe.c -- Program + Facts -> LsysGrammar without its function pointers.
// Requires: facts of this program. Ensures: every word of the descriptor is
// packed, every argument that is no constant holds 0 (the `axiom` function
// overwrites those), and nothing points outside the arena.
#include "analysis/facts.h"

#include <math.h>
#include <string.h>

static uint8_t kind_flags(const KindFacts *kind) {
  return (uint8_t)((kind->key ? LSYS_KIND_KEY : 0) | (kind->terminal ? LSYS_KIND_TERMINAL : 0)
                   | (kind->fixed ? LSYS_KIND_FIXED : 0));
}

static const LsysKind *describe_kinds(Arena *arena, const Program *program, const Facts *facts) {
  LsysKind *kinds = arena_array(arena, program->kind_count, sizeof *kinds);
  for (size_t k = 0; k < program->kind_count; k++) {
    const Kind *kind = &program->kinds[k];
    kinds[k] = (LsysKind){kind->symbol, (uint16_t)kind->arity, (uint8_t)kind->turtle, kind_flags(&facts->kinds[k])};
  }
  return kinds;
}

static const char *const *describe_texts(Arena *arena, const Program *program) {
  const char **texts = arena_array(arena, program->kind_count, sizeof *texts);
  bool any = false;
  for (size_t k = 0; k < program->kind_count; k++) any |= (texts[k] = program->kinds[k].text) != NULL;
  return any ? texts : NULL;
}

static double bound(const Program *program, const Expr *expr, double otherwise) {
  double value;
  return expr && expr_constant(program, expr, &value) ? value : otherwise;
}

static void describe_params(Arena *arena, const Program *program, LsysGrammar *grammar) {
  LsysParam *params = arena_array(arena, program->value_count, sizeof *params);
  for (size_t v = 0; v < program->value_count; v++) {
    const Value *value = &program->values[v];
    if (value->kind != VALUE_PARAM) continue;
    params[grammar->param_count++] = (LsysParam){.name = value->name,
                                                 .value = (uint32_t)(LSYS_SETTING_COUNT + v),
                                                 .low = bound(program, value->low, -INFINITY),
                                                 .high = bound(program, value->high, INFINITY),
                                                 .text = value->text};
  }
  grammar->params = params;
}

static LsysWord pack_word(Arena *arena, const Program *program, const Word *word) {
  bool wide = program->kind_count > 256;
  uint8_t *sym = arena_array(arena, word->count, wide ? 2 : 1);
  size_t arguments = word_arguments(program, word), n = 0;
  double *arg = arena_array(arena, arguments, sizeof *arg);
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    if (wide) {
      uint16_t symbol = (uint16_t)module->kind;
      memcpy(sym + 2 * i, &symbol, sizeof symbol);
    } else {
      sym[i] = (uint8_t)module->kind;
    }
    for (uint32_t a = 0; a < program->kinds[module->kind].arity; a++) {
      if (!expr_constant(program, module->args[a], &arg[n])) arg[n] = 0;
      n++;
    }
  }
  return (LsysWord){.sym = sym, .arg = arg, .nsym = word->count, .narg = arguments};
}

static void describe_axioms(Arena *arena, const Program *program, LsysGrammar *grammar) {
  LsysAxiom *axioms = arena_array(arena, program->axiom_count, sizeof *axioms);
  for (size_t i = 0; i < program->axiom_count; i++) axioms[i].word = pack_word(arena, program, &program->axioms[i]);
  grammar->axioms = axioms;
  grammar->axiom_count = (uint32_t)program->axiom_count;
}

static void describe_looks(Arena *arena, const Program *program, LsysGrammar *grammar) {
  LsysSurface *surfaces = arena_array(arena, program->surface_count, sizeof *surfaces);
  for (size_t i = 0; i < program->surface_count; i++) {
    surfaces[i] = program->surfaces[i].shape;
    surfaces[i].name = program->surfaces[i].name;
  }
  grammar->surfaces = surfaces;
  grammar->surface_count = (uint32_t)program->surface_count;
  grammar->contours = program->contours;
  grammar->contour_count = (uint32_t)program->contour_count;
  grammar->colours = program->colours;
  grammar->colour_count = (uint32_t)program->colour_count;
  grammar->page = program->page;
}

static size_t larger(size_t a, size_t b) {
  return a > b ? a : b;
}

static uint32_t homomorphism_flags(const Program *program) {
  uint32_t flags = 0;
  for (size_t i = 0; i < program->lsystem_count; i++) {
    const Productions *productions = &program->lsystems[i].homomorphism.productions;
    if (productions->count) flags |= LSYS_GRAMMAR_HOMOMORPHISM;
    for (size_t p = 0; p < productions->count; p++) {
      if (productions->at[p]->left.count || productions->at[p]->right.count) flags |= LSYS_GRAMMAR_WHOLE;
    }
  }
  // Which L-system a module belongs to depends on the delimiters before it.
  return flags && program->lsystem_count > 1 ? flags | LSYS_GRAMMAR_WHOLE : flags;
}

static uint32_t grammar_flags(const Program *program, const Facts *facts) {
  uint32_t flags = homomorphism_flags(program);
  if (!facts->deterministic) flags |= LSYS_GRAMMAR_RANDOM;
  if (facts->context_free) flags |= LSYS_GRAMMAR_EXPAND;
  if (facts->sequential) flags |= LSYS_GRAMMAR_SEQUENTIAL;
  if (facts->tables) flags |= LSYS_GRAMMAR_TABLES;
  if (facts->queries) flags |= LSYS_GRAMMAR_QUERIES;
  if (program->kind_count > 256) flags |= LSYS_GRAMMAR_WIDE;
  return flags;
}

static size_t context_modules(const Context *context) {
  size_t count = 0;
  for (size_t i = 0; i < context->count; i++) count += context->at[i].what == PATTERN_MODULE;
  return count;
}

// What a scan has to provide for the contexts of some productions.
static void describe_contexts_of(const Productions *productions, LsysGrammar *grammar) {
  for (size_t i = 0; i < productions->count; i++) {
    const Production *production = productions->at[i];
    grammar->left_window = (uint32_t)larger(grammar->left_window, context_modules(&production->left));
    if (production->right.count) grammar->flags |= LSYS_GRAMMAR_RIGHT;
    if (production->strict.count > 1) grammar->flags |= LSYS_GRAMMAR_ORDERED;
  }
}

static LsysContextView describe_view(Arena *arena, const Program *program, const LSystem *lsystem) {
  uint8_t *classes = arena_array(arena, program->kind_count, 1);
  for (KindId kind = 0; kind < program->kind_count; kind++) {
    classes[kind] = lsystem->ignored[kind] ? LSYS_CLASS_IGNORED : LSYS_CLASS_SEEN;
    if (kind == program->open) classes[kind] = LSYS_CLASS_OPEN;
    if (kind == program->close) classes[kind] = LSYS_CLASS_CLOSE;
  }
  return (LsysContextView){classes, lsystem->ring};
}

static void describe_contexts(Arena *arena, const Program *program, const Facts *facts, LsysGrammar *grammar) {
  LsysContextView *views = arena_array(arena, facts->view_count, sizeof *views);
  for (uint32_t i = 0; i < facts->view_count; i++) views[i] = describe_view(arena, program, facts->views[i]);
  grammar->views = views;
  grammar->view_count = facts->view_count;
  double *numbers = arena_array(arena, program->lsystem_count, sizeof *numbers);
  for (size_t i = 0; i < program->lsystem_count; i++) numbers[i] = program->lsystems[i].called;
  grammar->system_count = (uint32_t)program->lsystem_count;
  grammar->system_number = numbers;
  for (size_t i = 0; i < program->lsystem_count; i++) {
    describe_contexts_of(&program->lsystems[i].productions, grammar);
    describe_contexts_of(&program->lsystems[i].homomorphism.productions, grammar);
    if (program->lsystems[i].ring) grammar->flags |= LSYS_GRAMMAR_RING;
  }
  if (program->cut != KIND_NONE || program->lsystem_count > 1) grammar->flags |= LSYS_GRAMMAR_ORDERED;
}

static const char *describe_names(Arena *arena, const Program *program) {
  size_t size = 1;
  for (size_t i = 0; i < program->name_count; i++) size += strlen(program->names[i]) + 1;
  char *names = arena_array(arena, size, 1), *end = names;
  for (size_t i = 0; i < program->name_count; i++) {
    if (i) *end++ = ' ';
    end = stpcpy(end, program->names[i]);
  }
  return names;
}

LsysGrammar *describe(Arena *arena, const Program *program, const Facts *facts) {
  LsysGrammar *grammar = ARENA_NEW(arena, LsysGrammar);
  grammar->abi_version = LSYS_ABI_VERSION;
  grammar->flags = grammar_flags(program, facts);
  grammar->name = program->name;
  grammar->names = describe_names(arena, program);
  grammar->kind_count = (uint32_t)program->kind_count;
  grammar->kinds = describe_kinds(arena, program, facts);
  describe_params(arena, program, grammar);
  describe_axioms(arena, program, grammar);
  describe_looks(arena, program, grammar);
  grammar->value_count = (uint32_t)program->total_values;
  grammar->seed = program->seed;
  grammar->room_sym = 1;  // the interpreter writes module by module
  describe_contexts(arena, program, facts, grammar);
  grammar->environment = program->environment;
  grammar->environment_path = program->environment_path;
  grammar->environment_value = program->environment_value;
  grammar->growth = facts->growth;
  grammar->texts = describe_texts(arena, program);
  return grammar;
}
