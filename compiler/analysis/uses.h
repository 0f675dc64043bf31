// uses.h -- what evaluating a piece of a Program can touch: the question
// behind most facts (does it draw? does it depend on state?).
#ifndef LSYSC_ANALYSIS_USES_H
#define LSYSC_ANALYSIS_USES_H

#include "frontend/program.h"

enum {
  USES_DRAW = 1,     // a random function or a choice by weight
  USES_GLOBAL = 2,   // reads a global variable or an array
  USES_WRITE = 4,    // writes one
  USES_EFFECT = 8,   // printf, files, stop
  USES_TABLE = 16,   // useTable, or a production of one table
  USES_CONTEXT = 32  // a context, or a strict predecessor of several modules
};
#define USES_STATE (USES_GLOBAL | USES_WRITE | USES_EFFECT | USES_TABLE)

typedef struct Uses {
  const Program *program;
  unsigned *functions;  // what each user function's body uses, callees included
} Uses;

// Works out the user functions once; calls of them are then one look-up.
Uses uses_find(Arena *arena, const Program *program);

// Sets of USES_* flags.
unsigned uses_expr(const Uses *uses, const Expr *expr);  // NULL uses nothing
unsigned uses_word(const Uses *uses, const Word *word);  // its arguments
unsigned uses_actions(const Uses *uses, const Actions *actions);
unsigned uses_production(const Uses *uses, const Production *production);
unsigned uses_values(const Uses *uses);  // #define, param and settings
unsigned uses_blocks(const Uses *uses);  // Start, StartEach, EndEach, End

#endif
