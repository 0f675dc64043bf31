// pick.c -- the last step of kinds with cheap guards: what every production
// would write is computed, and the row of the first that holds is selected,
// without a branch that no processor could predict. A module to which none
// applies is a row of its own.
#include "analysis/passes.h"
#include "codegen/ir.h"

// Bounds on a kind's rows: their symbols fit a register, and computing all of them costs less than a wrong guess.
enum { MOST_ROWS = 4, ROW_BYTES = 8, MOST_ARGUMENTS = 6, MOST_COST = 40 };

typedef struct Pick {
  const Production *row[MOST_ROWS];
  unsigned rows;
  bool certain;  // the last row always holds
  uint32_t longest, arguments;
  unsigned budget;
} Pick;

// What a row writes.
typedef struct Choice {
  LLVMValueRef symbols, count, arg_count;
  LLVMValueRef args[MOST_ARGUMENTS];
} Choice;

static bool affords(Pick *pick, const Expr *expr) {
  return !expr || expr_cheap(expr, &pick->budget);
}

static bool add_word(const Ir *ir, Pick *pick, const Word *word) {
  uint32_t arguments = 0;
  for (size_t i = 0; i < word->count; i++) {
    uint32_t arity = ir->program->kinds[word->at[i].kind].arity;
    if (ir->facts->kinds[word->at[i].kind].decompositions.count) return false;
    if ((arguments += arity) > MOST_ARGUMENTS) return false;
    for (uint32_t a = 0; a < arity; a++)
      if (!affords(pick, word->at[i].args[a])) return false;
  }
  if (word->count * line_symbol_bytes(ir) > ROW_BYTES) return false;
  if (pick->longest < word->count) pick->longest = (uint32_t)word->count;
  if (pick->arguments < arguments) pick->arguments = arguments;
  return true;
}

static bool add_row(const Ir *ir, Pick *pick, const Production *p) {
  if (p->weight || p->table >= 0 || p->before.count || p->after.count || counters_needed(ir, p)) return false;
  if (pick->rows == MOST_ROWS || !affords(pick, p->match) || !affords(pick, p->guard)) return false;
  pick->row[pick->rows++] = p;
  return add_word(ir, pick, &p->successor);
}

static bool find(const Ir *ir, KindId kind, Pick *pick) {
  const KindFacts *facts = &ir->facts->kinds[kind];
  uint32_t arity = ir->program->kinds[kind].arity;
  *pick = (Pick){.longest = 1, .arguments = arity, .budget = MOST_COST};
  if (ir->options->optimise < 2) return false;  // selected quickly, they are branches
  if (ir->debug || ir->state || ir->stepping || ir->shown_keys) return false;
  if (facts->decompositions.count || arity > MOST_ARGUMENTS) return false;
  for (size_t i = 0; i < facts->own.count && !pick->certain; i++) {
    const Production *p = facts->own.at[i];
    if (production_never(ir->program, p)) continue;
    if (!add_row(ir, pick, p)) return false;
    pick->certain = production_always(ir->program, p);
  }
  return pick->rows;
}

uint32_t pick_longest(const Ir *ir, KindId kind) {
  Pick pick;
  return find(ir, kind, &pick) ? pick.longest : 0;
}

bool pick_kind(const Ir *ir, KindId kind) {
  Pick pick;
  return find(ir, kind, &pick) && pick.rows + !pick.certain > 1;
}

// ---- rows --------------------------------------------------------------------

static Choice choice_of(Ir *ir, const Pick *pick, const KindId *kinds, size_t count, LLVMValueRef *args, uint32_t n) {
  Choice choice = {
    .symbols = line_symbols(ir, kinds, count, pick->longest), .count = ir_int(ir, count), .arg_count = ir_int(ir, n)};
  for (uint32_t i = 0; i < pick->arguments; i++) choice.args[i] = i < n ? args[i] : LLVMGetUndef(ir->types.f64);
  return choice;
}

// What the production makes of a module with these arguments; *holds becomes an i1, or NULL if it always does.
static Choice row(Rewrite *rewrite, const Pick *pick, const Production *p, LLVMValueRef *args, LLVMValueRef *holds) {
  Ir *ir = rewrite->scope.ir;
  Scope *scope = &rewrite->scope;
  scope->slots = arena_array(ir->arena, p->parameters, sizeof(Slot));
  uint32_t first = p->strict.at[0].slot, arity = ir->program->kinds[p->strict.at[0].kind].arity;
  for (uint32_t i = 0; i < arity; i++) scope->slots[first + i].value = args[i];
  *holds = NULL;
  if (!production_always(ir->program, p)) {
    if (p->match) *holds = expr_test(scope, p->match);
    LLVMValueRef guard = p->guard ? expr_test(scope, p->guard) : NULL;
    *holds = *holds && guard ? LLVMBuildAnd(ir->builder, *holds, guard, "") : guard ? guard : *holds;
  }
  const Derived *modules = successor_derive(rewrite, p);
  KindId kinds[ROW_BYTES];
  LLVMValueRef values[MOST_ARGUMENTS];
  uint32_t n = 0;
  for (size_t i = 0; i < p->successor.count; i++) {
    kinds[i] = modules[i].kind;
    for (uint32_t a = 0; a < ir->program->kinds[kinds[i]].arity; a++) values[n++] = modules[i].args[a];
  }
  return choice_of(ir, pick, kinds, p->successor.count, values, n);
}

// Without the mark, the selection of instructions turns it back into a branch.
static LLVMValueRef either(Ir *ir, LLVMValueRef holds, LLVMValueRef yes, LLVMValueRef no) {
  if (yes == no) return yes;
  LLVMValueRef select = LLVMBuildSelect(ir->builder, holds, yes, no, "");
  if (LLVMIsASelectInst(select)) ir_mark(ir, select, "unpredictable");
  return select;
}

static Choice choose(Ir *ir, const Pick *pick, LLVMValueRef holds, const Choice *yes, const Choice *no) {
  Choice choice = {.symbols = either(ir, holds, yes->symbols, no->symbols),
                   .count = either(ir, holds, yes->count, no->count),
                   .arg_count = either(ir, holds, yes->arg_count, no->arg_count)};
  for (uint32_t i = 0; i < pick->arguments; i++) choice.args[i] = either(ir, holds, yes->args[i], no->args[i]);
  return choice;
}

void pick_write(Rewrite *rewrite, KindId kind, LLVMValueRef *args) {
  Ir *ir = rewrite->scope.ir;
  Pick pick;
  find(ir, kind, &pick);
  Scope scope = rewrite->scope;
  Choice chosen = choice_of(ir, &pick, &kind, 1, args, ir->program->kinds[kind].arity);
  for (unsigned i = pick.rows; i-- > 0;) {
    LLVMValueRef holds;
    Choice written = row(rewrite, &pick, pick.row[i], args, &holds);
    chosen = holds ? choose(ir, &pick, holds, &written, &chosen) : written;
  }
  rewrite->scope = scope;
  line_pick(rewrite, chosen.symbols, chosen.count, pick.longest, chosen.args, pick.arguments, chosen.arg_count);
}
