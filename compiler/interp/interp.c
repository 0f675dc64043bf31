// interp.c -- Program -> a grammar whose derive walks the Program.
// The order of a derivation: globals reset, Start, axiom, then per step
// StartEach, rewriting, decomposition, EndEach, and End after the last.
// Repetitions of draws in blocks are counted over one derivation; stop() lets
// the step in which it was called be finished.
// Requires: run->grammar is what interp_grammar returned.
#include "interp/interp.h"

#include "interp/rewrite.h"
#include "lsys/number.h"

#include <stdlib.h>
#include <string.h>

// The word that a derivation writes may be shown by homomorphism while it is
// being written: each has an interpreter of its own.
typedef struct Pair {
  Interp derivation, homomorphism;
} Pair;

static Interp *begin(LsysRun *run, Interp *interp) {
  interp->scope.run = interp->blocks.run = run;
  return interp;
}

// ---- values --------------------------------------------------------------------

// Draws of #define, param and blocks.
static void begin_values(Scope *scope) {
  scope_start(scope, lsys_split(scope->run->root, LSYS_VALUES_CHILD));
}

static void reset_globals(const Program *program, double *value) {
  for (size_t i = 0; i < program->value_count; i++) {
    if (program->values[i].kind == VALUE_GLOBAL) value[LSYS_SETTING_COUNT + i] = 0;
  }
  for (size_t i = 0; i < program->array_count; i++) {
    const Array *array = &program->arrays[i];
    size_t count = 1;
    for (uint32_t d = 0; d < array->dimensions; d++) count *= array->sizes[d];
    memcpy(value + array->slot, array->values, count * sizeof(double));
  }
}

// given counts params alone, in the order of values; a given one keeps its value.
static void init_values(const Interp *interp, Scope *scope, const uint8_t *given) {
  const Program *program = interp->program;
  for (size_t n = 0; n < program->value_count; n++) {
    uint32_t i = program->value_order[n];
    const Value *value = &program->values[i];
    bool keep = value->kind == VALUE_PARAM && given && given[interp->param_number[i]];
    if (value->init && !keep) scope->run->value[LSYS_SETTING_COUNT + i] = evaluate(scope, value->init);
  }
}

static void init(LsysRun *run, const uint8_t *given) {
  Interp *interp = begin(run, &((Pair *)run->grammar->derive_data)->derivation);
  const Program *program = interp->program;
  for (size_t s = 0; s < LSYS_SETTING_COUNT; s++) run->value[s] = lsys_settings[s].value;
  reset_globals(program, run->value);
  begin_values(&interp->blocks);
  init_values(interp, &interp->blocks, given);
  for (size_t s = 0; s < LSYS_SETTING_COUNT; s++) {
    if (program->settings[s]) run->value[s] = evaluate(&interp->blocks, program->settings[s]);
  }
}

// ---- start words -----------------------------------------------------------------

// The place of an axiom's first module among all start words.
static uint64_t first_module(const Program *program, uint32_t which) {
  uint64_t first = 0;
  for (uint32_t i = 0; i < which; i++) first += program->axioms[i].count;
  return first;
}

static void build_axiom(Interp *interp, uint32_t which, Boxes *out) {
  Scope *scope = &interp->scope;
  const Word *word = &interp->program->axioms[which];
  uint64_t first = first_module(interp->program, which);
  boxes_clear(out);
  for (size_t i = 0; i < word->count; i++) {
    const Module *module = &word->at[i];
    scope_start(scope, lsys_split(scope->run->root, first + i));
    boxes_push(scope->run, out, module->kind, scope->key);
    for (uint32_t a = 0; a < interp->program->kinds[module->kind].arity; a++) {
      double value = evaluate(scope, module->args[a]);
      boxes_push_arg(scope->run, out, value);
    }
  }
}

static void axiom(LsysRun *run, uint32_t which, double *arg, const uint64_t *key) {
  (void)key;  // build_axiom makes the same ones
  Interp *interp = begin(run, &((Pair *)run->grammar->derive_data)->derivation);
  build_axiom(interp, which, &interp->word);
  if (interp->word.arg_count) memcpy(arg, interp->word.arg, interp->word.arg_count * sizeof *arg);
}

// ---- derivation ------------------------------------------------------------------

static bool decomposes(const Program *program) {
  for (size_t s = 0; s < program->lsystem_count; s++) {
    if (program->lsystems[s].decomposition.productions.count) return true;
  }
  return false;
}

static bool is_copy(const Boxes *a, size_t i, const Boxes *b, size_t k, uint32_t arity) {
  const Box *x = &a->at[i], *y = &b->at[k];
  return x->kind == y->kind && lsys_numbers_same(a->arg + x->args, b->arg + y->args, arity);
}

// What came of a module of the word before was born in this step, unless it is that module alone.
static void give_birth(Interp *interp, uint64_t step) {
  const Boxes *word = &interp->word;
  for (size_t i = 0, end; i < word->count; i = end) {
    size_t from = word->at[i].from;
    for (end = i + 1; end < word->count && word->at[end].from == from;) end++;
    uint32_t arity = interp->program->kinds[word->at[i].kind].arity;
    bool stays = end == i + 1 && is_copy(word, i, &interp->before, from, arity);
    for (size_t k = i; k < end; k++) word->at[k].born = stays ? interp->before.at[from].born : step + 1;
  }
}

static void derive_step(Interp *interp, LsysRun *run, uint64_t step) {
  if (run->births) boxes_copy_all(run, &interp->before, interp->program, &interp->word);
  rewrite_word(interp, step);
  if (decomposes(interp->program)) decompose_word(interp);
  if (run->births) give_birth(interp, step);
}

// Before a step the turtle reads the word, and queries in it learn what they ask.
static void look(Interp *interp, LsysRun *run) {
  const LsysGrammar *grammar = run->grammar;
  if (!(grammar->flags & LSYS_GRAMMAR_QUERIES)) return;
  Boxes *word = &interp->word;
  size_t width = grammar->flags & LSYS_GRAMMAR_WIDE ? 2 : 1, keys = 0;
  for (size_t i = 0; i < word->count; i++) {
    while (interp->symbol_room < (i + 1) * width)
      interp->symbols = boxes_grow(run, interp->symbols, interp->symbol_room, &interp->symbol_room, 1);
    memcpy(interp->symbols + i * width, &(uint16_t){(uint16_t)word->at[i].kind}, width);
    if (!(grammar->kinds[word->at[i].kind].flags & LSYS_KIND_KEY)) continue;
    BOXES_RESERVE(run, interp->keys, keys, interp->key_room);
    interp->keys[keys++] = word->at[i].key;
  }
  LsysWord packed = {interp->symbols, word->arg, interp->keys, word->count, word->arg_count, keys};
  lsys_look(run, &packed, word->arg);
}

static void derive(LsysRun *run, uint32_t which, uint64_t steps, LsysStream *out, void *data) {
  Interp *interp = begin(run, &((Pair *)data)->derivation);
  const Program *program = interp->program;
  Scope *blocks = &interp->blocks;
  reset_globals(program, run->value);
  begin_values(blocks);
  blocks->table = -1;
  blocks->stopped = interp->scope.stopped = false;
  execute(blocks, &program->start);
  build_axiom(interp, which, &interp->word);
  for (uint64_t left = steps; left > 0 && !blocks->stopped && !interp->scope.stopped; left--) {
    execute(blocks, &program->start_each);
    look(interp, run);
    derive_step(interp, run, run->steps - left);
    execute(blocks, &program->end_each);
  }
  execute(blocks, &program->end);
  run->born = 0;
  boxes_pack(&interp->word, run->grammar, true, out);
}

static void homomorphism(LsysRun *run, const LsysWord *in, LsysStream *out) {
  Interp *interp = begin(run, &((Pair *)run->grammar->derive_data)->homomorphism);
  boxes_unpack(run, &interp->word, in);
  homomorphism_word(interp);
  for (size_t i = 0; i < interp->word.count; i++) {
    Box *box = &interp->word.at[i];
    box->born = run->birth ? run->birth[box->from] : run->born;
  }
  boxes_pack(&interp->word, run->grammar, false, out);
}

// ---- the grammar -----------------------------------------------------------------

static Section section_create(Arena *arena, const Program *program, const LSystem *lsystem,
                              const Productions *productions, const Rewriting *rewriting) {
  Section section = {.lsystem = lsystem, .rewriting = rewriting};
  section.of = productions_by_kind(arena, program, productions);
  for (size_t i = 0; i < productions->count; i++) {
    section.contexts |= productions->at[i]->left.count || productions->at[i]->right.count;
  }
  return section;
}

static Interp interp_create(Arena *arena, const Program *program) {
  Interp interp = {.program = program,
                   .param_number = arena_array(arena, program->value_count, sizeof(uint32_t)),
                   .systems = arena_array(arena, program->lsystem_count, sizeof(System)),
                   .scope = scope_create(arena, program),
                   .blocks = scope_create(arena, program)};
  for (uint32_t i = 0, param = 0; i < program->value_count; i++) {
    interp.param_number[i] = param;
    if (program->values[i].kind == VALUE_PARAM) param++;
  }
  for (size_t i = 0; i < program->lsystem_count; i++) {
    const LSystem *lsystem = &program->lsystems[i];
    System *system = &interp.systems[i];
    system->derivation = section_create(arena, program, lsystem, &lsystem->productions, NULL);
    system->decomposition =
      section_create(arena, program, lsystem, &lsystem->decomposition.productions, &lsystem->decomposition);
    system->homomorphism =
      section_create(arena, program, lsystem, &lsystem->homomorphism.productions, &lsystem->homomorphism);
  }
  return interp;
}

LsysGrammar *interp_grammar(Arena *arena, const Program *program, const LsysGrammar *description) {
  Pair *pair = ARENA_NEW(arena, Pair);
  pair->derivation = interp_create(arena, program);
  pair->homomorphism = interp_create(arena, program);
  LsysGrammar *grammar = ARENA_NEW(arena, LsysGrammar);
  *grammar = *description;
  grammar->flags &= ~(uint32_t)LSYS_GRAMMAR_EXPAND;
  grammar->init = init;
  grammar->axiom = axiom;
  grammar->derive = derive;
  grammar->derive_data = pair;
  if (grammar->flags & LSYS_GRAMMAR_HOMOMORPHISM) grammar->homomorphism = homomorphism;
  return grammar;
}

static void release(Interp *interp) {
  for (size_t i = 0; i < interp->program->lsystem_count; i++) {
    links_free(&interp->systems[i].derivation.links);
    links_free(&interp->systems[i].homomorphism.links);
  }
  boxes_free(&interp->word);
  boxes_free(&interp->next);
  boxes_free(&interp->stack);
  boxes_free(&interp->successor);
  boxes_free(&interp->before);
  scope_free(&interp->scope);
  scope_free(&interp->blocks);
  free(interp->candidates);
  free(interp->nesting);
  free(interp->symbols);
  free(interp->keys);
  interp->candidates = NULL;
  interp->nesting = NULL;
  interp->symbols = NULL;
  interp->keys = NULL;
  interp->candidate_room = interp->nesting_room = interp->symbol_room = interp->key_room = 0;
}

void interp_release(const LsysGrammar *grammar) {
  Pair *pair = grammar->derive_data;
  release(&pair->derivation);
  release(&pair->homomorphism);
}
