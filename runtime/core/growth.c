// growth.c -- the vector of counts is multiplied by the growth matrix once a
// step, in exact integers: O(steps * entries * digits).
#include "core/growth.h"

#include "core/stream.h"
#include "sinks/count.h"

#include <string.h>

static bool add_one(LsysMemory *memory, LsysBig *to) {
  uint64_t limb = 1;
  return lsys_big_add_product(memory, to, &(LsysBig){&limb, 1, 1}, 1);
}

static bool count_axiom(const LsysGrammar *grammar, uint32_t axiom, LsysMemory *memory, LsysBig *counts) {
  const LsysWord *word = &grammar->axioms[axiom].word;
  unsigned width = lsys_symbol_width(grammar);
  bool well = true;
  for (uint64_t i = 0; well && i < word->nsym; i++) {
    const uint8_t *sym = word->sym + i * width;
    well = add_one(memory, &counts[width == 1 ? sym[0] : sym[0] | sym[1] << 8]);
  }
  return well;
}

static bool multiply(const LsysGrammar *grammar, LsysMemory *memory, const LsysBig *from, LsysBig *to) {
  const LsysGrowth *growth = &grammar->growth;
  for (uint32_t k = 0; k < grammar->kind_count; k++) lsys_big_clear(&to[k]);
  for (uint32_t k = 0; k < grammar->kind_count; k++) {
    if (!from[k].count) continue;
    for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++)
      if (!lsys_big_add_product(memory, &to[growth->kind[e]], &from[k], growth->count[e])) return false;
  }
  return true;
}

bool lsys_growth_counts(const LsysGrammar *grammar, uint32_t axiom, uint64_t steps, LsysMemory *memory,
                        LsysBig *counts) {
  uint32_t kinds = grammar->kind_count;
  LsysBig *other = lsys_memory_alloc(memory, kinds, sizeof *other);
  bool well = other && count_axiom(grammar, axiom, memory, counts);
  for (uint64_t step = 0; well && step < steps; step++) {
    well = multiply(grammar, memory, counts, other);
    for (uint32_t k = 0; k < kinds; k++) {
      LsysBig old = counts[k];
      counts[k] = other[k];
      other[k] = old;
    }
  }
  for (uint32_t k = 0; other && k < kinds; k++) lsys_big_free(memory, &other[k]);
  lsys_memory_free(memory, other, kinds, sizeof *other);
  return well;
}

bool lsys_growth_sizes(const LsysGrammar *grammar, uint64_t steps, LsysMemory *memory, uint64_t *size) {
  const LsysGrowth *growth = &grammar->growth;
  uint32_t kinds = grammar->kind_count;
  uint64_t *before = lsys_memory_alloc(memory, kinds, sizeof *before);
  if (!before) return false;
  for (uint32_t k = 0; k < kinds; k++) size[k] = 1;
  for (uint64_t step = 0; step < steps; step++) {
    memcpy(before, size, kinds * sizeof *size);
    memset(size, 0, kinds * sizeof *size);
    for (uint32_t k = 0; k < kinds; k++)
      for (uint32_t e = growth->row[k]; e < growth->row[k + 1]; e++)
        size[k] += before[growth->kind[e]] * growth->count[e];
  }
  lsys_memory_free(memory, before, kinds, sizeof *before);
  return true;
}

static bool print_row(LsysMemory *memory, LsysOut *out, const char *name, LsysBig *count) {
  size_t size;
  char *digits = lsys_big_decimal(memory, count, &size);
  bool well = digits && lsys_out_print(out, "%s\t%s\n", name, digits);
  lsys_memory_free(memory, digits, digits ? size : 0, 1);
  return well;
}

// Adds up kinds with one symbol and the total, then prints. Destroys the counts.
static bool print_counts(const LsysGrammar *grammar, LsysMemory *memory, LsysBig *counts, LsysOut *out) {
  LsysBig total = {0};
  uint32_t *first = lsys_count_firsts(grammar, memory);
  bool well = first;
  for (uint32_t k = 0; well && k < grammar->kind_count; k++) {
    well = lsys_big_add_product(memory, &total, &counts[k], 1);
    if (well && first[k] != k) well = lsys_big_add_product(memory, &counts[first[k]], &counts[k], 1);
  }
  for (uint32_t k = 0; well && k < grammar->kind_count; k++)
    if (first[k] == k) well = print_row(memory, out, grammar->kinds[k].symbol, &counts[k]);
  well = well && print_row(memory, out, "total", &total);
  lsys_memory_free(memory, first, grammar->kind_count, sizeof *first);
  lsys_big_free(memory, &total);
  return well;
}

bool lsys_growth_print(const LsysDerivation *derivation, uint32_t axiom, LsysOut *out) {
  const LsysGrammar *grammar = derivation->worker.run.grammar;
  LsysMemory *memory = derivation->worker.memory;
  bool several = derivation->axiom_end - derivation->first_axiom > 1;
  LsysBig *counts = lsys_memory_alloc(memory, grammar->kind_count, sizeof *counts);
  bool well = counts && lsys_growth_counts(grammar, axiom, derivation->worker.run.steps, memory, counts)
           && lsys_count_heading(out, several, axiom) && print_counts(grammar, memory, counts, out);
  for (uint32_t k = 0; counts && k < grammar->kind_count; k++) lsys_big_free(memory, &counts[k]);
  lsys_memory_free(memory, counts, grammar->kind_count, sizeof *counts);
  return well;
}
