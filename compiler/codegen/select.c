// select.c -- which production rewrites a module (LANGUAGE.md 5.2): the one
// emission of the choice, for derivation, decomposition and homomorphism.
//
// Productions are tried in file order. The first that holds is taken if it has
// no weight. Otherwise it opens a lottery that all later productions which
// hold and have a weight join; the running sum of weights after production j
// is the bound under which j is drawn. Where productions do not hold the sum
// stands still, so that their bound is never the first to exceed the draw.
#include "analysis/passes.h"
#include "codegen/ir.h"

typedef struct Ticket {  // a production in the lottery
  const Production *production;
  Slot *slots;
  LLVMValueRef bound;
} Ticket;

typedef struct Lottery {
  LLVMValueRef open;  // i1: some production joined; NULL: certainly none
  LLVMValueRef sum;   // of their weights
  VEC(Ticket) tickets;
  bool certain;  // one always joins
} Lottery;

// True if some statement assigns the slot.
static bool assigns(const Actions *actions, uint32_t slot) {
  for (size_t i = 0; i < actions->count; i++) {
    const Action *action = &actions->at[i];
    if (action->kind == ACTION_SET_LOCAL && action->slot == slot) return true;
    if (assigns(&action->then, slot) || assigns(&action->otherwise, slot)) return true;
  }
  return false;
}

// Variables live in memory: local ones, parameters that a statement assigns, and parameters of the neighbours of a
// production with a weight, which is taken only after others were tried, where values of its path are out of reach.
static bool is_variable(const Production *production, uint32_t slot, uint32_t first, uint32_t arity) {
  bool neighbour = slot < first || slot >= first + arity;
  return slot >= production->parameters || (production->weight && neighbour) || assigns(&production->before, slot)
      || assigns(&production->after, slot);
}

void slot_bind(Ir *ir, Slot *slot, LLVMValueRef value) {
  if (slot->address)
    LLVMBuildStore(ir->builder, value, slot->address);
  else
    slot->value = value;
}

static Slot *make_slots(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  Slot *slots = arena_array(ir->arena, production->parameters + (size_t)production->locals, sizeof *slots);
  uint32_t first = production->strict.at[0].slot, arity = ir->program->kinds[rewrite->kind].arity;
  for (uint32_t i = 0; i < production->parameters + production->locals; i++) {
    if (!is_variable(production, i, first, arity)) continue;
    const char *name = production->slot_names[i];
    slots[i].address = ir_local(ir, ir->types.f64, 1, name ? name : "");
    LLVMBuildStore(ir->builder, ir_double(ir, 0), slots[i].address);
  }
  for (uint32_t i = 0; i < arity; i++) slot_bind(ir, &slots[first + i], rewrite->args[i]);
  return slots;
}

// Goes on only where the test holds; elsewhere at fail.
static void require(Ir *ir, LLVMValueRef test, LLVMBasicBlockRef fail) {
  LLVMBasicBlockRef next = ir_block(ir, "holds");
  ir_branch(ir, test, next, fail);
  ir_at(ir, next);
}

static void require_expr(Rewrite *rewrite, const Expr *expr, LLVMBasicBlockRef fail) {
  double value;
  if (!expr) return;
  if (expr_constant(rewrite->scope.ir->program, expr, &value) && lsys_holds(value)) return;
  require(rewrite->scope.ir, expr_test(&rewrite->scope, expr), fail);
}

// Branches to fail unless the production holds. Returns false if it always does.
static bool test(Rewrite *rewrite, const Production *production, LLVMBasicBlockRef fail) {
  Ir *ir = rewrite->scope.ir;
  if (production->table >= 0) {
    LLVMValueRef table = LLVMConstInt(ir->types.i32, (unsigned long long)production->table, false);
    LLVMValueRef applies = LLVMBuildICmp(ir->builder, LLVMIntEQ, rewrite->table, table, "");
    LLVMValueRef none = LLVMBuildICmp(ir->builder, LLVMIntSLT, rewrite->table, LLVMConstNull(ir->types.i32), "");
    require(ir, LLVMBuildOr(ir->builder, applies, none, ""), fail);
  }
  rewrite->scope.slots = make_slots(rewrite, production);
  neighbours_require(rewrite, production, rewrite->scope.slots, fail);
  require_expr(rewrite, production->match, fail);
  actions_run(&rewrite->scope, &production->before);
  require_expr(rewrite, production->guard, fail);
  return LLVMGetFirstUse(LLVMBasicBlockAsValue(fail)) != NULL;
}

static void take_now(Rewrite *rewrite, const Production *production, Slot *slots, Take take) {
  rewrite->scope.slots = slots;
  debug_enter(rewrite, production);
  actions_run(&rewrite->scope, &production->after);
  take(rewrite, production);
  debug_leave(rewrite);
}

// The production's weight as it counts: 0 unless it is greater.
static LLVMValueRef share(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef weight = expr_value(&rewrite->scope, production->weight);
  LLVMValueRef positive = LLVMBuildFCmp(ir->builder, LLVMRealOGT, weight, ir_double(ir, 0), "");
  return LLVMBuildSelect(ir->builder, positive, weight, ir_double(ir, 0), "");
}

static LLVMValueRef merged(Ir *ir, LLVMTypeRef type, LLVMValueRef failed, LLVMBasicBlockRef fail, LLVMValueRef held,
                           LLVMBasicBlockRef hold) {
  LLVMValueRef phi = LLVMBuildPhi(ir->builder, type, "");
  LLVMAddIncoming(phi, (LLVMValueRef[]){failed, held}, (LLVMBasicBlockRef[]){fail, hold}, 2);
  return phi;
}

// Lets a production that held join; may_fail: it need not hold, and fail is where it did not.
static void join(Rewrite *rewrite, Lottery *lottery, const Production *production, LLVMBasicBlockRef fail,
                 bool may_fail) {
  Ir *ir = rewrite->scope.ir;
  LLVMValueRef yes = LLVMConstInt(ir->types.i1, 1, false), no = LLVMConstInt(ir->types.i1, 0, false);
  LLVMValueRef sum = LLVMBuildFAdd(ir->builder, lottery->sum, share(rewrite, production), "sum"), open = yes;
  if (may_fail) {
    LLVMBasicBlockRef held = LLVMGetInsertBlock(ir->builder), next = ir_block(ir, "next");
    LLVMBuildBr(ir->builder, next);
    ir_at(ir, fail);
    LLVMBuildBr(ir->builder, next);
    ir_at(ir, next);
    sum = merged(ir, ir->types.f64, lottery->sum, fail, sum, held);
    open = merged(ir, ir->types.i1, lottery->open ? lottery->open : no, fail, yes, held);
  }
  lottery->sum = sum;
  lottery->open = open;
  lottery->certain |= !may_fail;
  *VEC_PUSH(ir->arena, &lottery->tickets) = (Ticket){production, rewrite->scope.slots, sum};
}

static bool surely_exceeds(const Lottery *lottery) {
  double sum;
  return lottery->certain && ir_is_double(lottery->sum, &sum) && key_exceeds(sum);
}

// What is drawn, once for all tickets.
typedef struct Ball {
  LLVMValueRef bits, value;
} Ball;

static Ball draw_ball(Rewrite *rewrite, const Lottery *lottery) {
  Ir *ir = rewrite->scope.ir;
  Ball ball = {0};
  if (surely_exceeds(lottery))
    ball.bits = key_bits(ir, rewrite->scope.key, ir_int(ir, 0));
  else
    ball.value = LLVMBuildFMul(ir->builder, key_draw(ir, rewrite->scope.key, ir_int(ir, 0)), lottery->sum, "ball");
  return ball;
}

static LLVMValueRef wins(Ir *ir, const Lottery *lottery, const Ticket *ticket, const Ball *ball) {
  double sum, bound;
  if (ball->bits && ir_is_double(lottery->sum, &sum) && ir_is_double(ticket->bound, &bound))
    return key_below(ir, ball->bits, sum, bound);
  return LLVMBuildFCmp(ir->builder, LLVMRealOLT, ball->value, ticket->bound, "");
}

// Ends at the place where nothing is drawn, because no weight counted. False if there is no such place.
static bool draw(Rewrite *rewrite, const Lottery *lottery, Take take) {
  Ir *ir = rewrite->scope.ir;
  LLVMBasicBlockRef stay = NULL;
  bool sure = surely_exceeds(lottery);
  if (!sure) {
    LLVMBasicBlockRef drawing = ir_block(ir, "draw");
    stay = ir_block(ir, "stay");
    ir_branch(ir, LLVMBuildFCmp(ir->builder, LLVMRealOGT, lottery->sum, ir_double(ir, 0), ""), drawing, stay);
    ir_at(ir, drawing);
  }
  Ball ball = draw_ball(rewrite, lottery);
  for (size_t i = 0; i < lottery->tickets.count; i++) {
    const Ticket *ticket = &lottery->tickets.at[i];
    bool last = i + 1 == lottery->tickets.count;
    LLVMBasicBlockRef next = last ? stay : ir_block(ir, "next");
    if (next) {
      LLVMBasicBlockRef chosen = ir_block(ir, "chosen");
      ir_branch(ir, wins(ir, lottery, ticket, &ball), chosen, next);
      ir_at(ir, chosen);
    }
    take_now(rewrite, ticket->production, ticket->slots, take);
    if (next) ir_at(ir, next);
  }
  return !sure;
}

// One production in its turn. False if no later one can have a turn.
static bool try(Rewrite *rewrite, Lottery *lottery, const Production *production, Take take) {
  Ir *ir = rewrite->scope.ir;
  if (!production->weight && lottery->certain) return true;
  LLVMBasicBlockRef fail = ir_block(ir, "next");
  if (!production->weight && lottery->open) require(ir, LLVMBuildNot(ir->builder, lottery->open, ""), fail);
  bool may_fail = test(rewrite, production, fail);
  if (production->weight) {
    join(rewrite, lottery, production, fail, may_fail);
  } else {
    take_now(rewrite, production, rewrite->scope.slots, take);
    if (may_fail) ir_at(ir, fail);
  }
  if (!may_fail) LLVMDeleteBasicBlock(fail);
  return production->weight || may_fail;
}

// Branches to fail unless the production applies, as far as can be told without changing anything: blocks are not run,
// nothing is drawn, and what depends on either counts as holding.
static void suspect(Rewrite *rewrite, const Production *production, LLVMBasicBlockRef fail) {
  rewrite->scope.slots = make_slots(rewrite, production);
  neighbours_require(rewrite, production, rewrite->scope.slots, fail);
  require_expr(rewrite, production->match, fail);
  bool known =
    production->guard && !production->before.count && !expr_draws(rewrite->scope.ir->program, production->guard);
  if (known) require_expr(rewrite, production->guard, fail);
}

void select_any(Rewrite *rewrite, const Productions *productions, void (*then)(Rewrite *rewrite)) {
  Ir *ir = rewrite->scope.ir;
  for (size_t i = 0; i < productions->count; i++) {
    if (production_never(ir->program, productions->at[i])) continue;
    LLVMBasicBlockRef fail = ir_block(ir, "next");
    suspect(rewrite, productions->at[i], fail);
    then(rewrite);
    ir_at(ir, fail);
  }
}

bool select_production(Rewrite *rewrite, const Productions *productions, Take take) {
  Ir *ir = rewrite->scope.ir;
  Lottery lottery = {.sum = ir_double(ir, 0)};
  for (size_t i = 0; i < productions->count; i++) {
    const Production *production = productions->at[i];
    if (production_never(ir->program, production)) continue;
    if (!try(rewrite, &lottery, production, take)) return false;
  }
  return lottery.tickets.count == 0 || draw(rewrite, &lottery, take);
}
