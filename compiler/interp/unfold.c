// unfold.c -- decomposition and homomorphism: each module of the word is
// replaced over and over, depth first, down to the section's maximum depth.
// Invariant: the stack holds what is left of one module of the word, the next
// on top; each of its modules knows how many levels it has left.
// Source: LANGUAGE.md 5.7.
#include "interp/choose.h"

static uint32_t maximum_depth(Interp *interp, const Section *section) {
  if (!section->rewriting->depth) return 1;
  scope_start(&interp->scope, 0);
  double depth = evaluate(&interp->scope, section->rewriting->depth);
  return depth >= UINT32_MAX ? UINT32_MAX : depth >= 1 ? (uint32_t)depth : 0;
}

static void push(Interp *interp, const Boxes *from, size_t i, uint64_t key, uint32_t depth) {
  boxes_copy(interp->scope.run, &interp->stack, interp->program, from, i, key);
  interp->stack.at[interp->stack.count - 1].depth = depth;
}

static void pop(Interp *interp) {
  interp->stack.arg_count = interp->stack.at[--interp->stack.count].args;
}

// Replaces the stack's top by a production's successor, its first module on top.
static void replace_top(Interp *interp, const Production *production) {
  Box top = interp->stack.at[interp->stack.count - 1];
  Boxes *successor = &interp->successor;
  boxes_clear(successor);
  replace(interp, production, top.key, successor);
  pop(interp);
  for (size_t j = successor->count; j-- > 0;) push(interp, successor, j, successor->at[j].key, top.depth - 1);
}

static void tell_cut(Interp *interp, const Section *section) {
  lsys_cut_short(interp->scope.run, section->rewriting == &section->lsystem->homomorphism);
}

// Unfolds the module on the stack into next; its contexts are those of module place of the word.
static void unfold(Interp *interp, const Section *section, const Links *links, size_t place) {
  while (interp->stack.count) {
    size_t top = interp->stack.count - 1;
    Subject subject = {&interp->stack, top, links, place};
    const Box box = interp->stack.at[top];
    const Production *production = box.depth ? choose(interp, section, -1, &subject) : NULL;
    if (production) {
      replace_top(interp, production);
      continue;
    }
    if (!box.depth && section->rewriting->warnings && suspects(interp, section, &subject)) tell_cut(interp, section);
    boxes_copy(interp->scope.run, &interp->next, interp->program, &interp->stack, top, box.key);
    pop(interp);
  }
}

void decompose_word(Interp *interp) {
  boxes_clear(&interp->next);
  boxes_clear(&interp->stack);
  for (size_t i = 0, depth = 0; i < interp->word.count; i++) {
    const Section *section = &interp->systems[system_at(interp, &depth, i)].decomposition;
    interp->next.from = interp->word.at[i].from;
    push(interp, &interp->word, i, interp->word.at[i].key, maximum_depth(interp, section));
    unfold(interp, section, NULL, i);
  }
  swap_words(interp);
}

// Looking at a module does not change it: homomorphism draws from a child of
// its key that the derivation never uses.
static uint64_t homomorphism_key(const Section *section, uint64_t key) {
  uint64_t start = lsys_split(key, LSYS_VALUES_CHILD);
  return section->rewriting->has_seed ? start ^ lsys_mix64(section->rewriting->seed) : start;
}

void homomorphism_word(Interp *interp) {
  for (size_t s = 0; s < interp->program->lsystem_count; s++) section_link(interp, &interp->systems[s].homomorphism);
  boxes_clear(&interp->next);
  boxes_clear(&interp->stack);
  for (size_t i = 0, depth = 0; i < interp->word.count; i++) {
    const Section *section = &interp->systems[system_at(interp, &depth, i)].homomorphism;
    const Links *links = section->contexts ? &section->links : NULL;
    interp->next.from = i;
    push(interp, &interp->word, i, homomorphism_key(section, interp->word.at[i].key), maximum_depth(interp, section));
    unfold(interp, section, links, i);
  }
  swap_words(interp);
}
