// letters.c -- step for grammars where a module's kind and those of one
// neighbour on each side decide everything: not code for each production but a
// table of all cases, which lsys_step_letters goes through (lsys/scan.h).
#include "analysis/passes.h"
#include "codegen/ir.h"

#include <string.h>

enum {
  LONGEST = 64,          // successor
  MOST_BYTES = 1 << 18,  // of all texts: what stays in a cache
};

typedef struct Table {
  Ir *ir;
  size_t kinds, lefts, rights;  // rights, lefts: classes
  KindId *left, *right;         // the kind of each class from 1 on
  size_t width, longest;
  uint8_t *text, *length;
} Table;

// ---- whether there is one ------------------------------------------------------

static bool one_module(const Ir *ir, const Context *context) {
  return context->count == 0
      || (context->count == 1 && context->at[0].what == PATTERN_MODULE && context->at[0].kind != ir->program->close);
}

static bool by_letters(const Ir *ir, const Production *p) {
  double guard;
  return p->table < 0 && p->strict.count == 1 && one_module(ir, &p->left) && one_module(ir, &p->right) && !p->match
      && p->before.count == 0 && p->after.count == 0 && (!p->guard || expr_constant(ir->program, p->guard, &guard))
      && !p->weight && p->successor.count <= LONGEST;
}

static bool all_letters(const Ir *ir) {
  const LSystem *main = &ir->program->lsystems[0];
  uint32_t barred = LSYS_GRAMMAR_WIDE | LSYS_GRAMMAR_RING | LSYS_GRAMMAR_ORDERED | LSYS_GRAMMAR_SEQUENTIAL;
  bool traced = ir->options->debug || ir->options->optimise == 0;  // code that is close to the text is wanted
  if (ir->program->lsystem_count > 1) return false;
  if (traced || (ir->description->flags & barred) || ir->state || main->decomposition.productions.count) return false;
  for (KindId kind = 0; kind < ir->program->kind_count; kind++)
    if (ir->program->kinds[kind].arity || ir->facts->kinds[kind].key) return false;
  for (size_t i = 0; i < main->productions.count; i++)
    if (!by_letters(ir, main->productions.at[i])) return false;
  return true;
}

// ---- classes -------------------------------------------------------------------

static size_t class_of(const KindId *kinds, size_t count, KindId kind) {
  for (size_t class = 1; class < count; class ++)
    if (kinds[class] == kind) return class;
  return 0;
}

static void add_class(const Ir *ir, KindId *kinds, size_t *count, const Context *context) {
  if (context->count == 0) return;
  KindId kind = context->at[0].kind;
  bool seen = ir->description->views[0].context_class[kind] == LSYS_CLASS_SEEN;
  if (seen && !class_of(kinds, *count, kind)) kinds[(*count)++] = kind;
}

static void find_classes(Table *table) {
  Ir *ir = table->ir;
  const Productions *all = &ir->program->lsystems[0].productions;
  table->kinds = ir->program->kind_count;
  table->left = arena_array(ir->arena, table->kinds + 1, sizeof *table->left);
  table->right = arena_array(ir->arena, table->kinds + 1, sizeof *table->right);
  table->lefts = table->rights = 1;
  for (size_t i = 0; i < all->count; i++) {
    add_class(ir, table->left, &table->lefts, &all->at[i]->left);
    add_class(ir, table->right, &table->rights, &all->at[i]->right);
    if (table->longest < all->at[i]->successor.count) table->longest = all->at[i]->successor.count;
  }
  if (!table->longest) table->longest = 1;
  for (table->width = 8; table->width < table->longest;) table->width *= 2;
}

// ---- cases ---------------------------------------------------------------------

static bool fits(const KindId *kinds, size_t count, size_t class, const Context *context) {
  return context->count == 0 || (class && class_of(kinds, count, context->at[0].kind) == class);
}

static const Production *chosen(const Table *table, size_t left, size_t right, KindId kind) {
  const Productions *own = &table->ir->facts->kinds[kind].own;
  for (size_t i = 0; i < own->count; i++) {
    const Production *p = own->at[i];
    if (!production_never(table->ir->program, p) && fits(table->left, table->lefts, left, &p->left)
        && fits(table->right, table->rights, right, &p->right))
      return p;
  }
  return NULL;
}

static void fill_case(Table *table, size_t left, size_t right, KindId kind) {
  size_t entry = (left * table->rights + right) * table->kinds + kind;
  uint8_t *text = table->text + entry * table->width;
  const Production *p = chosen(table, left, right, kind);
  table->length[entry] = (uint8_t)(p ? p->successor.count : 1);
  text[0] = (uint8_t)kind;
  for (size_t i = 0; p && i < p->successor.count; i++) text[i] = (uint8_t)p->successor.at[i].kind;
}

static LLVMValueRef bytes(Ir *ir, const void *at, size_t size, const char *name) {
  LLVMValueRef data = ir_data(ir, LLVMConstStringInContext2(ir->context, at, size, true), name);
  LLVMSetAlignment(data, 64);
  return data;
}

// Behind a module of this kind: row `seen` if it can be a neighbour. `begins`: the class of the bracket that begins a
// branch in this direction; the row goes on inside of it if `enters`.
static void move(const Table *table, LsysMoves *moves, size_t code, size_t seen, uint8_t begins, bool enters) {
  uint8_t class = table->ir->description->views[0].context_class[code % table->kinds];
  bool bracket = class == LSYS_CLASS_OPEN || class == LSYS_CLASS_CLOSE, first = class == begins;
  if (class == LSYS_CLASS_SEEN) moves->set[code] = (uint32_t)seen;
  if (class == LSYS_CLASS_IGNORED || (first && enters)) moves->keep[code] = UINT32_MAX;
  if (bracket && !first) moves->pop[code] = UINT32_MAX;
  if (bracket) moves->depth[code] = first ? 1 : -1;
}

static LLVMValueRef row(LLVMTypeRef type, const void *at, size_t size) {
  LLVMValueRef values[LSYS_CODES];
  for (size_t i = 0; i < LSYS_CODES; i++) {
    uint64_t value = size == 4 ? ((const uint32_t *)at)[i] : ((const uint64_t *)at)[i];
    values[i] = LLVMConstInt(type, value, false);
  }
  return LLVMConstArray2(type, values, LSYS_CODES);
}

static LLVMValueRef freeze_moves(Ir *ir, const LsysMoves *moves, const char *name) {
  LLVMTypeRef i32 = ir->types.i32;
  LLVMValueRef rows[] = {row(i32, moves->keep, 4), row(i32, moves->pop, 4), row(i32, moves->set, 4),
                         row(ir->types.i64, moves->depth, 8)};
  return ir_data(ir, LLVMConstStructInContext(ir->context, rows, 4, false), name);
}

static LLVMValueRef left_moves(const Table *table) {
  LsysMoves moves = {0};
  size_t codes = table->rights * table->kinds;
  for (size_t code = 0; code < codes; code++) {
    size_t class = class_of(table->left, table->lefts, (KindId)(code % table->kinds));
    move(table, &moves, code, class * codes, LSYS_CLASS_OPEN, true);
  }
  return freeze_moves(table->ir, &moves, "left");
}

static LLVMValueRef right_moves(const Table *table) {
  LsysMoves moves = {0};
  for (KindId kind = 0; kind < table->kinds; kind++)
    move(table, &moves, kind, class_of(table->right, table->rights, kind) * table->kinds, LSYS_CLASS_CLOSE, false);
  return freeze_moves(table->ir, &moves, "right");
}

static LLVMValueRef freeze(const Table *table, size_t entries) {
  Ir *ir = table->ir;
  LLVMTypeRef i32 = ir->types.i32;
  LLVMValueRef fields[] = {bytes(ir, table->text, entries * table->width, "texts"),
                           bytes(ir, table->length, entries, "lengths"),
                           left_moves(table),
                           right_moves(table),
                           LLVMConstInt(i32, table->width, false),
                           LLVMConstInt(i32, table->longest, false),
                           LLVMConstInt(i32, table->rights > 1, false),
                           LLVMConstInt(i32, ir->program->open != KIND_NONE || ir->program->close != KIND_NONE, false)};
  return ir_data(ir, LLVMConstStructInContext(ir->context, fields, 8, false), "letters");
}

static void fill(Table *table) {
  size_t entries = table->lefts * table->rights * table->kinds;
  table->text = arena_array(table->ir->arena, entries, table->width);
  table->length = arena_array(table->ir->arena, entries, 1);
  for (size_t left = 0; left < table->lefts; left++)
    for (size_t right = 0; right < table->rights; right++)
      for (KindId kind = 0; kind < table->kinds; kind++) fill_case(table, left, right, kind);
}

LLVMValueRef letters_emit(Ir *ir) {
  if (!all_letters(ir)) return NULL;
  Table table = {.ir = ir};
  find_classes(&table);
  size_t codes = table.rights * table.kinds, entries = table.lefts * codes;
  if (codes > LSYS_CODES || entries * table.width > MOST_BYTES) return NULL;
  fill(&table);
  uint32_t room = LSYS_LETTERS_ROOM((uint32_t)table.longest);
  if (ir->room_sym < room) ir->room_sym = room;
  ir->letters = true;
  LLVMTypeRef types[] = {ir->types.ptr, ir->types.ptr, ir->types.ptr};
  LLVMValueRef function = LLVMAddFunction(ir->module, "step", LLVMFunctionType(ir->types.none, types, 2, false));
  LLVMSetLinkage(function, LLVMInternalLinkage);
  ir_at(ir, LLVMAppendBasicBlockInContext(ir->context, function, "entry"));
  LLVMValueRef args[] = {LLVMGetParam(function, 0), LLVMGetParam(function, 1), freeze(&table, entries)};
  ir_call(ir, ir_runtime(ir, "lsys_step_letters", ir->types.none, types, 3, IR_ANY), args, 3);
  LLVMBuildRetVoid(ir->builder);
  return function;
}
