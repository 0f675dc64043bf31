// check_reach.c -- which kinds can come to stand in a word: those of the axioms,
// and those of the successors of whatever can. Contexts, guards and weights are
// taken to hold, so a kind that is not reached never comes.
#include "frontend/check.h"

typedef struct Link {  // a production of a kind, and the next one
  const Production *production;
  uint32_t next;
} Link;

typedef struct Reach {
  Check *check;
  uint32_t *first;  // per kind: its first link, NONE
  VEC(Link) links;
  bool *reached;
  VEC(KindId) found;  // kinds whose productions are still to be followed
} Reach;

static void link_productions(Reach *reach, const Productions *productions) {
  for (size_t i = 0; i < productions->count; i++) {
    const Production *production = productions->at[i];
    uint32_t *first = &reach->first[production->strict.at[0].kind];
    Link link = {production, *first};
    *first = (uint32_t)reach->links.count;
    *VEC_PUSH(reach->check->arena, &reach->links) = link;
  }
}

static void find(Reach *reach, const Word *word) {
  for (size_t i = 0; i < word->count; i++) {
    KindId kind = word->at[i].kind;
    if (reach->reached[kind]) continue;
    reach->reached[kind] = true;
    *VEC_PUSH(reach->check->arena, &reach->found) = kind;
  }
}

const bool *check_reachable(Check *check) {
  const Program *program = check->program;
  Reach reach = {.check = check};
  reach.first = arena_array(check->arena, program->kind_count, sizeof *reach.first);
  reach.reached = arena_array(check->arena, program->kind_count, sizeof *reach.reached);
  for (size_t i = 0; i < program->kind_count; i++) reach.first[i] = NONE;
  for (size_t i = 0; i < program->lsystem_count; i++) {
    link_productions(&reach, &program->lsystems[i].productions);
    link_productions(&reach, &program->lsystems[i].decomposition.productions);
    link_productions(&reach, &program->lsystems[i].homomorphism.productions);
  }
  for (size_t i = 0; i < program->axiom_count; i++) find(&reach, &program->axioms[i]);
  while (reach.found.count)
    for (uint32_t at = reach.first[reach.found.at[--reach.found.count]]; at != NONE; at = reach.links.at[at].next)
      find(&reach, &reach.links.at[at].production->successor);
  return reach.reached;
}
