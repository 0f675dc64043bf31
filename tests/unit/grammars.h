// grammars.h -- small grammars written by hand, as the code generator would
// compile them: what the run time expects of a grammar, in C.
#ifndef LSYS_TESTS_GRAMMARS_H
#define LSYS_TESTS_GRAMMARS_H

#include "lsys/abi.h"

#include <stdbool.h>
#include <stddef.h>

static inline bool grammar_has_room(const LsysStream *out, const LsysGrammar *grammar) {
  return out->sym_limit - out->sym >= (ptrdiff_t)grammar->room_sym;
}

static inline void grammar_settings(LsysRun *run) {
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) run->value[i] = lsys_settings[i].value;
}

// ---- Lindenmayer's algae, ABOP p. 4:  axiom: A   A --> AB   B --> A ------------

enum { ALGAE_A, ALGAE_B };

static const LsysGrammar algae;

static void algae_expand_kind(LsysStream *out, uint8_t kind, uint64_t steps) {
  if ((uintptr_t)__builtin_frame_address(0) < out->stack_limit) lsys_too_deep(out);
  const LsysRun *run = out->run;
  while (steps && steps >= run->block_levels[kind]) {
    steps--;
    if (kind == ALGAE_A) {
      algae_expand_kind(out, ALGAE_A, steps);
      kind = ALGAE_B;  // the last module of a successor is derived by the loop
    } else {
      kind = ALGAE_A;
    }
  }
  if (steps < run->block_levels[kind]) {
    const LsysBlock *block = &run->block[kind][steps];
    lsys_append(out, block->sym, block->nsym, block->arg, block->narg);
    return;
  }
  if (!grammar_has_room(out, &algae)) lsys_flush(out);
  *out->sym++ = kind;
}

static void algae_expand(LsysStream *out, const LsysWord *in, uint64_t steps) {
  for (uint64_t i = 0; i < in->nsym; i++) algae_expand_kind(out, in->sym[i], steps - out->stop);
}

static void algae_init(LsysRun *run, const uint8_t *given) {
  (void)given;
  grammar_settings(run);
}

static const uint8_t algae_axiom[] = {ALGAE_A};
static const LsysKind algae_kinds[] = {{"A", 0, 0, LSYS_KIND_FIXED}, {"B", 0, 0, LSYS_KIND_FIXED}};
static const LsysAxiom algae_axioms[] = {{.word = {.sym = algae_axiom, .nsym = 1}}};
static const uint32_t algae_rows[] = {0, 2, 3}, algae_columns[] = {0, 1, 0}, algae_counts[] = {1, 1, 1};

static const LsysGrammar algae = {
  .abi_version = LSYS_ABI_VERSION,
  .flags = LSYS_GRAMMAR_EXPAND,
  .name = "algae",
  .kind_count = 2,
  .kinds = algae_kinds,
  .axiom_count = 1,
  .axioms = algae_axioms,
  .value_count = LSYS_SETTING_COUNT,
  .room_sym = 1,
  .frame_bytes = 128,
  .growth = {algae_rows, algae_columns, algae_counts},
  .init = algae_init,
  .expand = algae_expand,
};

// ---- a bush with a param, a guard, weights and keys -----------------------------
//   param r = 0.5 in 0..1
//   axiom: A(1) A(2)
//   A(x) : x > 0.2 --> F(x)[A(x*r)]A(x)    : 0.75
//   A(x)           --> F(x)                : 0.25

enum { BUSH_A, BUSH_F, BUSH_OPEN, BUSH_CLOSE, BUSH_R = LSYS_SETTING_COUNT };

static const LsysGrammar bush;

static void bush_put(LsysStream *out, uint8_t kind) {
  *out->sym++ = kind;
}

static void bush_put_arg(LsysStream *out, uint8_t kind, double x) {
  *out->sym++ = kind;
  *out->arg++ = x;
}

static void bush_expand_a(LsysStream *out, uint64_t steps, double x, uint64_t key) {
  if ((uintptr_t)__builtin_frame_address(0) < out->stack_limit) lsys_too_deep(out);
  if (!grammar_has_room(out, &bush)) lsys_flush(out);
  if (steps == 0) {
    bush_put_arg(out, BUSH_A, x);
    *out->key++ = key;
    return;
  }
  double weight = (x > 0.2 ? 0.75 : 0), sum = weight + 0.25;
  bool branches = lsys_draw(key, 0) * sum < weight;
  bush_put_arg(out, BUSH_F, x);
  if (!branches) return;
  bush_put(out, BUSH_OPEN);
  bush_expand_a(out, steps - 1, x * out->run->value[BUSH_R], lsys_split(key, 2));
  if (!grammar_has_room(out, &bush)) lsys_flush(out);
  bush_put(out, BUSH_CLOSE);
  bush_expand_a(out, steps - 1, x, lsys_split(key, 4));
}

static void bush_expand(LsysStream *out, const LsysWord *in, uint64_t steps) {
  const double *arg = in->arg;
  const uint64_t *key = in->key;
  for (uint64_t i = 0; i < in->nsym; i++) {
    if (in->sym[i] == BUSH_A) {
      bush_expand_a(out, steps - out->stop, *arg++, *key++);
      continue;
    }
    if (!grammar_has_room(out, &bush)) lsys_flush(out);
    if (in->sym[i] == BUSH_F)
      bush_put_arg(out, BUSH_F, *arg++);
    else
      bush_put(out, in->sym[i]);
  }
}

static void bush_init(LsysRun *run, const uint8_t *given) {
  grammar_settings(run);
  run->value[LSYS_SETTING_STEPS] = 3;
  if (!given[0]) run->value[BUSH_R] = 0.5;
}

static const uint8_t bush_axiom[] = {BUSH_A, BUSH_A};
static const double bush_arguments[] = {1, 2};
static const LsysKind bush_kinds[] = {
  {"A", 1, 0, LSYS_KIND_KEY},
  {"F", 1, LSYS_TURTLE_DRAW, LSYS_KIND_TERMINAL},
  {"[", 0, LSYS_TURTLE_PUSH, LSYS_KIND_TERMINAL},
  {"]", 0, LSYS_TURTLE_POP, LSYS_KIND_TERMINAL},
};
static const LsysAxiom bush_axioms[] = {{.word = {.sym = bush_axiom, .arg = bush_arguments, .nsym = 2, .narg = 2}}};
static const LsysParam bush_params[] = {{"r", BUSH_R, 0, 1, "0.5"}};

static const LsysGrammar bush = {
  .abi_version = LSYS_ABI_VERSION,
  .flags = LSYS_GRAMMAR_EXPAND | LSYS_GRAMMAR_RANDOM,
  .name = "bush",
  .kind_count = 4,
  .kinds = bush_kinds,
  .param_count = 1,
  .params = bush_params,
  .axiom_count = 1,
  .axioms = bush_axioms,
  .value_count = LSYS_SETTING_COUNT + 1,
  .seed = 1,
  .room_sym = 2,
  .frame_bytes = 160,
  .init = bush_init,
  .expand = bush_expand,
};

#endif
