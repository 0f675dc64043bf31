// evaluate.h -- the value of an expression and the effect of a block.
#ifndef LSYSC_INTERP_EVALUATE_H
#define LSYSC_INTERP_EVALUATE_H

#include "frontend/program.h"
#include "lsys/abi.h"

// How often a site was evaluated in the rewriting numbered `rewriting`; in
// another one it counts as 0, so that a new rewriting resets all at once.
typedef struct SiteCount {
  uint64_t rewriting;
  uint64_t evaluations;
} SiteCount;

// Where names of an expression get their values from.
typedef struct Scope {
  const Program *program;
  LsysRun *run;     // run->value: settings, constants, params, globals, array elements
  int64_t table;    // as useTable last set it; -1: never
  bool stopped;     // stop() asked for the derivation's end
  uint64_t key;     // of the rewriting: draws are functions of it
  SiteCount *site;  // program->sites + 1 of them
  uint64_t rewriting;
  double *slot;  // stack of frames: parameters and locals of productions, parameters of functions
  size_t slots, slot_capacity;
  size_t base;      // the frame that EXPR_PARAMETER reads
  unsigned nested;  // evaluations under way
} Scope;

// Memory lives in the arena, but for the frames: scope_free.
Scope scope_create(Arena *arena, const Program *program);
void scope_free(Scope *scope);

// A new rewriting by key: no frames, every site evaluated 0 times so far.
void scope_start(Scope *scope, uint64_t key);

// Pushes a frame of count zeros and makes it the current one.
void scope_push(Scope *scope, size_t count);

// Drops the current frame, which is the last.
void scope_pop(Scope *scope);

double evaluate(Scope *scope, const Expr *expr);
bool evaluate_holds(Scope *scope, const Expr *expr);
void execute(Scope *scope, const Actions *actions);

#endif
