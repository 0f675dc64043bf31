// function.c -- user functions (#define NAME(a,b) expr), statement blocks, and
// the counters of repeated calls of random functions (LANGUAGE.md 5.8).
//
// A user function is an internal function (run, [key, counters,] arguments...).
// A site can repeat within one rewriting only if it stands in a function or a
// loop; those sites share one array of counters in the frame of the rewriting.
#include "codegen/ir.h"

// ---- counters ----------------------------------------------------------------

static void mark(Ir *ir, const Expr *expr) {
  if (!expr) return;
  bool random = expr->kind == EXPR_CALL && lsys_functions[expr->function].how == LSYS_FN_RANDOM;
  if (random && ir->counter[expr->site] == NO_COUNTER) ir->counter[expr->site] = ir->counters++;
  for (uint32_t i = 0; i < expr->count; i++) mark(ir, expr->args[i]);
}

// Marks the sites in loops; in_loop: everything here already is.
static void mark_loops(Ir *ir, const Actions *actions, bool in_loop) {
  for (size_t i = 0; i < actions->count; i++) {
    const Action *action = &actions->at[i];
    bool loop = in_loop || action->kind == ACTION_WHILE || action->kind == ACTION_DO;
    if (loop) mark(ir, action->value);
    for (uint32_t j = 0; loop && j < action->index_count; j++) mark(ir, action->index[j]);
    mark_loops(ir, &action->then, loop);
    mark_loops(ir, &action->otherwise, loop);
  }
}

static void mark_productions(Ir *ir, const Productions *productions) {
  for (size_t i = 0; i < productions->count; i++) {
    mark_loops(ir, &productions->at[i]->before, false);
    mark_loops(ir, &productions->at[i]->after, false);
  }
}

void counters_assign(Ir *ir) {
  const Program *program = ir->program;
  ir->counter = arena_array(ir->arena, program->sites + (size_t)1, sizeof *ir->counter);
  for (size_t site = 0; site <= program->sites; site++) ir->counter[site] = NO_COUNTER;
  for (size_t i = 0; i < program->function_count; i++) mark(ir, program->functions[i].body);
  for (size_t i = 0; i < program->lsystem_count; i++) {
    mark_productions(ir, &program->lsystems[i].productions);
    mark_productions(ir, &program->lsystems[i].decomposition.productions);
    mark_productions(ir, &program->lsystems[i].homomorphism.productions);
  }
  const Actions *blocks[] = {&program->start, &program->start_each, &program->end_each, &program->end};
  for (int i = 0; i < 4; i++) mark_loops(ir, blocks[i], true);
}

static bool counts(const Ir *ir, const Expr *expr) {
  if (!expr) return false;
  if (expr->kind == EXPR_APPLY && ir->program->functions[expr->slot].draws) return true;
  if (expr->kind == EXPR_CALL && lsys_functions[expr->function].how == LSYS_FN_RANDOM
      && ir->counter[expr->site] != NO_COUNTER)
    return true;
  for (uint32_t i = 0; i < expr->count; i++)
    if (counts(ir, expr->args[i])) return true;
  return false;
}

static bool actions_count(const Ir *ir, const Actions *actions) {
  for (size_t i = 0; i < actions->count; i++) {
    const Action *action = &actions->at[i];
    if (counts(ir, action->value)) return true;
    for (uint32_t j = 0; j < action->index_count; j++)
      if (counts(ir, action->index[j])) return true;
    if (actions_count(ir, &action->then) || actions_count(ir, &action->otherwise)) return true;
  }
  return false;
}

bool counters_needed(const Ir *ir, const Production *production) {
  if (!ir->counters) return false;
  const Production *p = production;
  if (counts(ir, p->match) || counts(ir, p->guard) || counts(ir, p->weight)) return true;
  if (actions_count(ir, &p->before) || actions_count(ir, &p->after)) return true;
  return counters_needed_word(ir, &p->successor);
}

bool counters_needed_word(const Ir *ir, const Word *word) {
  for (size_t i = 0; i < word->count; i++)
    for (uint32_t a = 0; a < ir->program->kinds[word->at[i].kind].arity; a++)
      if (counts(ir, word->at[i].args[a])) return true;
  return false;
}

LLVMValueRef counters_create(Ir *ir) {
  return ir_local(ir, ir->types.i64, ir->counters, "counters");
}

void counters_clear(Ir *ir, LLVMValueRef counters) {
  LLVMValueRef zero = LLVMConstInt(ir->types.i8, 0, false);
  LLVMBuildMemSet(ir->builder, counters, zero, ir_int(ir, 8 * (uint64_t)ir->counters), 8);
}

// ---- user functions ------------------------------------------------------------

void functions_declare(Ir *ir) {
  const Program *program = ir->program;
  ir->functions = arena_array(ir->arena, program->function_count, sizeof *ir->functions);
  for (size_t i = 0; i < program->function_count; i++) {
    const UserFunction *function = &program->functions[i];
    LLVMTypeRef *types = arena_array(ir->arena, function->arity + (size_t)3, sizeof *types);
    unsigned n = 0;
    types[n++] = ir->types.ptr;
    if (function->draws) {
      types[n++] = ir->types.i64;
      types[n++] = ir->types.ptr;
    }
    for (uint32_t a = 0; a < function->arity; a++) types[n++] = ir->types.f64;
    const char *name = arena_printf(ir->arena, "function.%s", function->name);
    ir->functions[i] = LLVMAddFunction(ir->module, name, LLVMFunctionType(ir->types.f64, types, n, false));
    LLVMSetLinkage(ir->functions[i], LLVMInternalLinkage);
    ir_attribute(ir, ir->functions[i], LLVMAttributeFunctionIndex, "nounwind");
  }
}

void functions_define(Ir *ir) {
  for (size_t i = 0; i < ir->program->function_count; i++) {
    const UserFunction *function = &ir->program->functions[i];
    LLVMValueRef emitted = ir->functions[i];
    ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, emitted, "entry"));
    unsigned first = function->draws ? 3 : 1;
    Slot *slots = arena_array(ir->arena, function->arity, sizeof *slots);
    for (uint32_t a = 0; a < function->arity; a++) slots[a].value = LLVMGetParam(emitted, first + a);
    Scope scope = {.ir = ir, .run = LLVMGetParam(emitted, 0), .slots = slots};
    if (function->draws) {
      scope.key = LLVMGetParam(emitted, 1);
      scope.counters = LLVMGetParam(emitted, 2);
    }
    LLVMBuildRet(ir->builder, expr_value(&scope, function->body));
  }
}

// ---- statement blocks ------------------------------------------------------------

static void run_if(Scope *scope, const Action *action) {
  Ir *ir = scope->ir;
  LLVMValueRef test = expr_test(scope, action->value);
  LLVMBasicBlockRef then = ir_block(ir, "then"), otherwise = ir_block(ir, "else"), join = ir_block(ir, "joined");
  ir_branch(ir, test, then, otherwise);
  ir_at(ir, then);
  actions_run(scope, &action->then);
  LLVMBuildBr(ir->builder, join);
  ir_at(ir, otherwise);
  actions_run(scope, &action->otherwise);
  LLVMBuildBr(ir->builder, join);
  ir_at(ir, join);
}

static void run_loop(Scope *scope, const Action *action) {
  Ir *ir = scope->ir;
  LLVMBasicBlockRef test = ir_block(ir, "test"), body = ir_block(ir, "body"), done = ir_block(ir, "done");
  LLVMBuildBr(ir->builder, action->kind == ACTION_WHILE ? test : body);
  ir_at(ir, body);
  actions_run(scope, &action->then);
  LLVMBuildBr(ir->builder, test);
  ir_at(ir, test);
  LLVMValueRef more = expr_test(scope, action->value);
  ir_branch(ir, more, body, done);
  ir_at(ir, done);
}

static void run_action(Scope *scope, const Action *action) {
  Ir *ir = scope->ir;
  switch (action->kind) {
  case ACTION_SET_LOCAL:
    LLVMBuildStore(ir->builder, expr_value(scope, action->value), scope->slots[action->slot].address);
    return;
  case ACTION_SET_VALUE: {
    LLVMValueRef value = expr_value(scope, action->value);
    LLVMBuildStore(ir->builder, value, expr_value_address(scope, action->slot));
    return;
  }
  case ACTION_SET_ELEMENT: {
    LLVMValueRef at = expr_element_address(scope, action->slot, action->index, action->index_count);
    LLVMBuildStore(ir->builder, expr_value(scope, action->value), at);
    return;
  }
  case ACTION_IF:
    run_if(scope, action);
    return;
  case ACTION_WHILE:
  case ACTION_DO:
    run_loop(scope, action);
    return;
  case ACTION_EVALUATE:
    expr_value(scope, action->value);
    return;
  case ACTION_USE_TABLE:
    ir_store(ir, ir_int(ir, action->slot), scope->run, ir->types.run, RUN_TABLE);
    return;
  }
}

void actions_run(Scope *scope, const Actions *actions) {
  for (size_t i = 0; i < actions->count; i++) run_action(scope, &actions->at[i]);
}
