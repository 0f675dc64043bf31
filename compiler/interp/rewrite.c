// rewrite.c -- one derivation step: every module of the word at once.
// Everything reads the word before the step only; what it becomes is written
// to next, and then the two change places.
// Source: LANGUAGE.md 5.1-5.6.
#include "interp/choose.h"

#include <math.h>
#include <string.h>

void swap_words(Interp *interp) {
  Boxes word = interp->word;
  interp->word = interp->next;
  interp->next = word;
}

const Links *section_link(Interp *interp, Section *section) {
  if (!section->contexts) return NULL;
  links_find(interp->scope.run, &section->links, interp->program, section->lsystem, &interp->word);
  return &section->links;
}

// ---- sub-L-systems -----------------------------------------------------------

static bool is_symbol(const Interp *interp, KindId kind, const char *symbol) {
  return strcmp(interp->program->kinds[kind].symbol, symbol) == 0;
}

size_t system_at(Interp *interp, size_t *depth, size_t i) {
  const Box *box = &interp->word.at[i];
  if (interp->program->lsystem_count == 1) return 0;
  if (*depth && is_symbol(interp, box->kind, "$")) --*depth;
  size_t system = *depth ? interp->nesting[*depth - 1] : 0;
  if (is_symbol(interp, box->kind, "?") && interp->program->kinds[box->kind].arity) {
    double number = interp->word.arg[box->args];
    size_t called = 0, count = interp->program->lsystem_count;
    while (called < count && interp->program->lsystems[called].called != floor(number)) called++;
    if (called == count) lsys_fail(interp->scope.run, "?(%.17g): there is no L-system of that number", number);
    BOXES_RESERVE(interp->scope.run, interp->nesting, *depth, interp->nesting_room);
    interp->nesting[(*depth)++] = (uint32_t)called;
  }
  return system;
}

// ---- one step ----------------------------------------------------------------

static int64_t table_of(const Interp *interp, size_t system, uint64_t step) {
  const LSystem *lsystem = &interp->program->lsystems[system];
  if (lsystem->schedule_count) return lsystem->schedule[step % lsystem->schedule_count];
  return system == 0 ? interp->blocks.table : -1;
}

// The ] that ends the branch of module i, or the word's end.
static size_t branch_end(const Interp *interp, size_t i) {
  size_t depth = 0;
  for (; i < interp->word.count; i++) {
    KindId kind = interp->word.at[i].kind;
    if (kind == interp->program->open) depth++;
    if (kind == interp->program->close && depth-- == 0) break;
  }
  return i;
}

// Rewrites what stands at module i and returns where to go on.
static size_t rewrite_at(Interp *interp, size_t system, int64_t table, size_t i) {
  Section *section = &interp->systems[system].derivation;
  const Box box = interp->word.at[i];
  Subject subject = {&interp->word, i, section->contexts ? &section->links : NULL, i};
  const Production *production = choose(interp, section, table, &subject);
  if (production) {
    replace(interp, production, box.key, &interp->next);
    return i + production->strict.count;
  }
  if (box.kind == interp->program->cut) return branch_end(interp, i);
  boxes_copy(interp->scope.run, &interp->next, interp->program, &interp->word, i, lsys_split(box.key, 0));
  return i + 1;
}

void rewrite_word(Interp *interp, uint64_t step) {
  for (size_t s = 0; s < interp->program->lsystem_count; s++) section_link(interp, &interp->systems[s].derivation);
  boxes_clear(&interp->next);
  for (size_t i = 0, depth = 0; i < interp->word.count;) {
    interp->next.from = i;
    size_t system = system_at(interp, &depth, i);
    i = rewrite_at(interp, system, table_of(interp, system, step), i);
  }
  swap_words(interp);
}
