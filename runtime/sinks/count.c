// count.c -- how many modules of each symbol, all numbers of arguments
// together, in the order in which symbols first stand in the grammar.
#include "sinks/count.h"

#include "core/stream.h"
#include "lsys/number.h"

#include <stdlib.h>
#include <string.h>

enum { LANES = 4 };  // neighbouring modules count in different tables, so that equal ones need not wait for each other

typedef struct CountSink {
  LsysSink sink;
  const LsysGrammar *grammar;
  LsysMemory *memory;
  LsysOut *out;
  uint32_t axiom;
  bool several;  // start words: each block gets a heading
  bool sizes;    // --stats: how many bytes the packed word takes, too
  uint32_t *first;
  uint64_t counts[];  // LANES tables of kind_count each
} CountSink;

bool lsys_count_heading(LsysOut *out, bool several, uint32_t axiom) {
  return !several || lsys_out_print(out, "axiom %u\n", axiom + 1);
}

static int compare(const void *left, const void *right, void *data) {
  const uint32_t *a = left, *b = right;
  const LsysKind *kinds = ((const LsysGrammar *)data)->kinds;
  int order = strcmp(kinds[*a].symbol, kinds[*b].symbol);
  return order ? order : (*a > *b) - (*a < *b);
}

uint32_t *lsys_count_firsts(const LsysGrammar *grammar, LsysMemory *memory) {
  uint32_t count = grammar->kind_count;
  uint32_t *first = lsys_memory_alloc(memory, count, sizeof *first);
  uint32_t *sorted = lsys_memory_alloc(memory, count, sizeof *sorted);
  for (uint32_t k = 0; sorted && k < count; k++) sorted[k] = k;
  if (first && sorted) {
    qsort_r(sorted, count, sizeof *sorted, compare, (void *)grammar);
    for (uint32_t i = 0; i < count; i++) {
      const char *symbol = grammar->kinds[sorted[i]].symbol;
      bool same = i && strcmp(grammar->kinds[sorted[i - 1]].symbol, symbol) == 0;
      first[sorted[i]] = same ? first[sorted[i - 1]] : sorted[i];
    }
  }
  lsys_memory_free(memory, sorted, count, sizeof *sorted);
  if (sorted) return first;
  lsys_memory_free(memory, first, count, sizeof *first);
  return NULL;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)pass;
  CountSink *count = (CountSink *)sink;
  count->axiom = axiom;
  memset(count->counts, 0, (size_t)LANES * count->grammar->kind_count * sizeof *count->counts);
  return true;
}

// counts has LANES tables.
static void add(const LsysGrammar *grammar, const LsysWord *part, uint64_t *counts) {
  size_t kinds = grammar->kind_count;
  uint64_t *lane[LANES], i = 0;
  for (int l = 0; l < LANES; l++) lane[l] = counts + (size_t)l * kinds;
  if (lsys_symbol_width(grammar) == 2) {
    for (; i < part->nsym; i++) lane[0][part->sym[2 * i] | part->sym[2 * i + 1] << 8]++;
    return;
  }
  for (; i + LANES <= part->nsym; i += LANES)
    for (int l = 0; l < LANES; l++) lane[l][part->sym[i + l]]++;
  for (; i < part->nsym; i++) lane[0][part->sym[i]]++;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  CountSink *count = (CountSink *)sink;
  add(count->grammar, part, count->counts);
  return true;
}

static bool prepare(const LsysSink *sink, const LsysWord *part, LsysPrepared *prepared) {
  const LsysGrammar *grammar = ((const CountSink *)sink)->grammar;
  size_t size = (size_t)LANES * grammar->kind_count * sizeof(uint64_t);
  char *counts = lsys_prepared_room(prepared, size);
  if (!counts) return false;
  memset(counts, 0, size);
  add(grammar, part, (uint64_t *)counts);
  prepared->used += size;
  return true;
}

static bool accept(LsysSink *sink, const LsysPrepared *prepared) {
  CountSink *count = (CountSink *)sink;
  const uint64_t *counts = (const uint64_t *)prepared->data;
  for (size_t i = 0; i < prepared->used / sizeof *counts; i++) count->counts[i] += counts[i];
  return true;
}

static bool end(LsysSink *sink) {
  CountSink *count = (CountSink *)sink;
  const LsysGrammar *grammar = count->grammar;
  uint32_t kinds = grammar->kind_count;
  uint64_t *sum = count->counts, total = 0, bytes = 0;
  for (uint32_t k = 0; k < kinds; k++) {
    for (uint32_t l = 1; l < LANES; l++) sum[k] += count->counts[l * kinds + k];
    total += sum[k];
    bytes += sum[k] * (lsys_symbol_width(grammar) + grammar->kinds[k].arity * sizeof(double));
    if (count->first[k] != k) sum[count->first[k]] += sum[k];
  }
  bool well = lsys_count_heading(count->out, count->several, count->axiom);
  for (uint32_t k = 0; k < kinds; k++)
    if (count->first[k] == k)
      well = lsys_out_print(count->out, "%s\t%llu\n", grammar->kinds[k].symbol, (unsigned long long)sum[k]);
  well = well && lsys_out_print(count->out, "total\t%llu\n", (unsigned long long)total);
  return well && (!count->sizes || lsys_out_print(count->out, "bytes\t%llu\n", (unsigned long long)bytes));
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  CountSink *count = (CountSink *)sink;
  lsys_memory_free(count->memory, count->first, count->grammar->kind_count, sizeof *count->first);
  lsys_memory_free(count->memory, count, 1,
                   sizeof *count + (size_t)LANES * count->grammar->kind_count * sizeof *count->counts);
}

LsysSink *lsys_sink_count(const LsysSinkContext *context) {
  size_t kinds = context->grammar->kind_count;
  CountSink *count = lsys_memory_alloc(context->memory, 1, sizeof *count + LANES * kinds * sizeof *count->counts);
  if (!count) return NULL;
  count->sink = (LsysSink){.passes = 1,
                           .begin = begin,
                           .take = take,
                           .end = end,
                           .finish = finish,
                           .destroy = destroy,
                           .prepare = prepare,
                           .accept = accept};
  count->grammar = context->grammar;
  count->memory = context->memory;
  count->out = context->out;
  count->sizes = context->options->at[LSYS_OPTION_STATS].given;
  count->several = context->grammar->axiom_count > 1 && !context->options->at[LSYS_OPTION_AXIOM].given;
  count->first = lsys_count_firsts(context->grammar, context->memory);
  if (count->first) return &count->sink;
  destroy(&count->sink);
  return NULL;
}
