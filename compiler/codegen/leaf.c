// leaf.c -- the last steps of kinds that are always replaced, by a row that
// nothing but constant weights decides: the draw is compared with constants,
// which gives the row's number, and the row is copied from a table. Where all
// modules of a successor end like this, or by cheap guards (pick.c), the last
// two steps are straight-line code without a branch that no processor could
// predict.
#include "analysis/passes.h"
#include "codegen/ir.h"

// Bounds on a kind's rows, and on what the code of one successor writes.
enum { MOST_ROWS = 8, ROW_BYTES = 16, MOST_LEAVES = 16, MOST_SYMBOLS = 192 };

typedef struct Leaf {
  const Word *row[MOST_ROWS];
  double bound[MOST_ROWS];  // the sum of weights up to this row
  unsigned rows;
  uint32_t longest;
} Leaf;

// True if the word is written as it is when one step is left: without arguments, and no longer than a row.
static bool is_row(const Ir *ir, const Word *word) {
  if (word->count * line_symbol_bytes(ir) > ROW_BYTES) return false;
  for (size_t i = 0; i < word->count; i++) {
    KindId kind = word->at[i].kind;
    if (ir->program->kinds[kind].arity || ir->facts->kinds[kind].decompositions.count) return false;
  }
  return true;
}

static bool add_row(const Ir *ir, Leaf *leaf, const Production *p) {
  double weight;
  if (!p->weight || p->before.count || p->after.count || !production_always(ir->program, p)) return false;
  if (!is_row(ir, &p->successor) || leaf->rows == MOST_ROWS) return false;
  if (!expr_constant(ir->program, p->weight, &weight)) return false;
  leaf->bound[leaf->rows] = weight + (leaf->rows ? leaf->bound[leaf->rows - 1] : 0);
  leaf->row[leaf->rows++] = &p->successor;
  if (leaf->longest < p->successor.count) leaf->longest = (uint32_t)p->successor.count;
  return true;
}

static bool find(const Ir *ir, KindId kind, Leaf *leaf) {
  const Productions *own = &ir->facts->kinds[kind].own;
  *leaf = (Leaf){0};
  if (ir->debug || ir->state || ir->stepping || ir->shown_keys) return false;
  for (size_t i = 0; i < own->count; i++)
    if (!production_never(ir->program, own->at[i]) && !add_row(ir, leaf, own->at[i])) return false;
  return leaf->rows && key_exceeds(leaf->bound[leaf->rows - 1]);
}

bool leaf_kind(const Ir *ir, KindId kind) {
  Leaf leaf;
  return find(ir, kind, &leaf) || pick_kind(ir, kind);
}

// ---- the table of a kind's rows -----------------------------------------------

static LLVMValueRef row_constant(Ir *ir, const Word *word) {
  LLVMValueRef symbols[ROW_BYTES];
  unsigned count = ROW_BYTES / line_symbol_bytes(ir);
  for (unsigned i = 0; i < count; i++)
    symbols[i] = LLVMConstInt(ir->types.symbol, i < word->count ? word->at[i].kind : 0, false);
  return LLVMConstArray2(ir->types.symbol, symbols, count);
}

// A constant of the module's own, made by the first that asks for it.
static LLVMValueRef shared_data(Ir *ir, const char *name, LLVMTypeRef type, LLVMValueRef *values, unsigned count) {
  LLVMValueRef data = LLVMGetNamedGlobal(ir->module, name);
  return data ? data : ir_data(ir, LLVMConstArray2(type, values, count), name);
}

static LLVMValueRef rows_data(Ir *ir, KindId kind, const Leaf *leaf) {
  LLVMValueRef rows[MOST_ROWS];
  for (unsigned i = 0; i < leaf->rows; i++) rows[i] = row_constant(ir, leaf->row[i]);
  return shared_data(ir, arena_printf(ir->arena, "rows.%u", kind), LLVMTypeOf(rows[0]), rows, leaf->rows);
}

static LLVMValueRef lengths_data(Ir *ir, KindId kind, const Leaf *leaf) {
  LLVMValueRef lengths[MOST_ROWS];
  for (unsigned i = 0; i < leaf->rows; i++) lengths[i] = LLVMConstInt(ir->types.i8, leaf->row[i]->count, false);
  return shared_data(ir, arena_printf(ir->arena, "lengths.%u", kind), ir->types.i8, lengths, leaf->rows);
}

// How many bounds the draw does not stay below: the number of the first row whose bound exceeds it.
static LLVMValueRef draw_row(Ir *ir, const Leaf *leaf, LLVMValueRef key) {
  LLVMValueRef bits = key_bits(ir, key, ir_int(ir, 0)), row = ir_int(ir, 0);
  double sum = leaf->bound[leaf->rows - 1];
  for (unsigned i = 0; i + 1 < leaf->rows; i++) {
    LLVMValueRef above = LLVMBuildNot(ir->builder, key_below(ir, bits, sum, leaf->bound[i]), "");
    row = LLVMBuildAdd(ir->builder, row, LLVMBuildZExt(ir->builder, above, ir->types.i64, ""), "row");
  }
  return row;
}

void leaf_write(Rewrite *rewrite, const Derived *module) {
  Ir *ir = rewrite->scope.ir;
  KindId kind = module->kind;
  Leaf leaf;
  if (!find(ir, kind, &leaf)) {
    pick_write(rewrite, kind, module->args);
    return;
  }
  LLVMValueRef row = draw_row(ir, &leaf, derived_key(ir, module)), lengths = lengths_data(ir, kind, &leaf);
  LLVMTypeRef type = LLVMArrayType2(ir->types.symbol, ROW_BYTES / line_symbol_bytes(ir));
  LLVMValueRef symbols = ir_advance(ir, type, rows_data(ir, kind, &leaf), row);
  LLVMValueRef length = LLVMBuildLoad2(ir->builder, ir->types.i8, ir_advance(ir, ir->types.i8, lengths, row), "");
  length = LLVMBuildZExt(ir->builder, length, ir->types.i64, "length");
  line_copy_row(rewrite, symbols, ROW_BYTES, length, leaf.longest);
}

// ---- two steps before the end -------------------------------------------------------

// Modules that the last step makes of one, and what its code costs; 0: it is no leaf.
static uint32_t longest(const Ir *ir, KindId kind, uint32_t *leaves) {
  enum { COST_OF_PICK = 4 };
  Leaf leaf;
  bool drawn = find(ir, kind, &leaf);
  *leaves += drawn ? 1 : COST_OF_PICK;
  return drawn ? leaf.longest : pick_longest(ir, kind);
}

uint32_t leaf_room(const Ir *ir, const Word *word) {
  uint32_t leaves = 0, symbols = 0;
  for (size_t i = 0; i < word->count; i++) {
    const KindFacts *facts = &ir->facts->kinds[word->at[i].kind];
    uint32_t most = facts->terminal ? 1 : longest(ir, word->at[i].kind, &leaves);
    if (facts->decompositions.count || !most || leaves > MOST_LEAVES) return 0;
    if ((symbols += most) > MOST_SYMBOLS) return 0;
  }
  return leaves ? symbols + ROW_BYTES : 0;
}

void leaf_write_word(Rewrite *rewrite, const Derived *modules, size_t count, uint32_t room) {
  Ir *ir = rewrite->scope.ir;
  line_reserve(rewrite, room);
  for (size_t i = 0; i < count; i++)
    if (ir->facts->kinds[modules[i].kind].terminal)
      line_add(rewrite, modules[i].kind, modules[i].args, NULL);
    else
      leaf_write(rewrite, &modules[i]);
}
