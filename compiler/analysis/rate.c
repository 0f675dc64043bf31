// rate.c -- growth matrix -> class of growth and rate.
//
// In the graph "kind a becomes kind b", a strongly connected component whose
// kinds each become exactly one of its own is a cycle: it only moves modules.
// Any other component with a cycle multiplies them. So words grow
// exponentially if a multiplying component is reachable, else polynomially;
// the degree counts components of the greatest rate along one path, less one.
// Source: Salomaa, "On exponential growth in Lindenmayer systems", 1973;
// Tarjan's components, 1972; Collatz-Wielandt bounds of the spectral radius.
#include "analysis/growth.h"

#include <math.h>
#include <stdlib.h>

#define UNSEEN UINT32_MAX
#define SAME_RATE 1e-9

typedef struct Graph {
  Arena *arena;
  const LsysGrowth *growth;
  uint32_t kinds;
  uint32_t *component;  // of each kind; numbered so that edges go to equal or lower numbers
  uint32_t components;
  uint32_t *members;  // kinds sorted by component
  uint32_t *first;    // where each component's members begin; one more at the end
} Graph;

// ---- components ----------------------------------------------------------------

typedef struct Tarjan {
  uint32_t *index, *low;   // order of discovery; least reachable
  uint32_t *stack, depth;  // kinds whose component is not known yet
  uint32_t *path, *edge;   // the walk: kind and next edge of each level
  uint32_t next;
} Tarjan;

static void enter(Tarjan *t, uint32_t level, uint32_t kind, const LsysGrowth *growth) {
  t->path[level] = kind;
  t->edge[level] = growth->row[kind];
  t->index[kind] = t->low[kind] = t->next++;
  t->stack[t->depth++] = kind;
}

static void leave(Graph *graph, Tarjan *t, uint32_t kind) {
  if (t->low[kind] != t->index[kind]) return;
  uint32_t member;
  do {
    member = t->stack[--t->depth];
    graph->component[member] = graph->components;
    graph->members[graph->first[graph->components + 1]++] = member;
  } while (member != kind);
  graph->components++;
  graph->first[graph->components + 1] = graph->first[graph->components];
}

static uint32_t least(uint32_t a, uint32_t b) {
  return a < b ? a : b;
}

static void walk(Graph *graph, Tarjan *t, uint32_t root) {
  const LsysGrowth *growth = graph->growth;
  uint32_t level = 0;
  enter(t, level, root, growth);
  while (true) {
    uint32_t kind = t->path[level];
    if (t->edge[level] < growth->row[kind + 1]) {
      uint32_t to = growth->kind[t->edge[level]++];
      if (t->index[to] == UNSEEN)
        enter(t, ++level, to, growth);
      else if (graph->component[to] == UNSEEN)
        t->low[kind] = least(t->low[kind], t->index[to]);
      continue;
    }
    leave(graph, t, kind);
    if (level == 0) return;
    uint32_t from = t->path[--level];
    t->low[from] = least(t->low[from], t->low[kind]);
  }
}

static void find_components(Graph *graph) {
  size_t n = graph->kinds;
  uint32_t *memory = arena_array(graph->arena, 8 * n + 2, sizeof *memory);
  graph->component = memory;
  graph->members = memory + n;
  graph->first = memory + 2 * n;  // n + 2
  Tarjan t = {.index = memory + 3 * n + 2, .low = memory + 4 * n + 2, .stack = memory + 5 * n + 2};
  t.path = memory + 6 * n + 2;
  t.edge = memory + 7 * n + 2;
  for (size_t k = 0; k < n; k++) graph->component[k] = t.index[k] = UNSEEN;
  for (uint32_t k = 0; k < n; k++) {
    if (t.index[k] == UNSEEN) walk(graph, &t, k);
  }
}

// ---- spectral radius of one component ------------------------------------------

// y := x (M + I) within component c. Adding the identity makes the iteration
// converge on cyclic components too; it adds 1 to the radius.
static void apply(const Graph *graph, uint32_t c, const double *x, double *y) {
  const LsysGrowth *growth = graph->growth;
  for (uint32_t m = graph->first[c]; m < graph->first[c + 1]; m++) {
    uint32_t kind = graph->members[m];
    y[kind] = x[kind];
    for (uint32_t e = growth->row[kind]; e < growth->row[kind + 1]; e++) {
      if (graph->component[growth->kind[e]] == c) y[kind] += growth->count[e] * x[growth->kind[e]];
    }
  }
}

// The radius lies between the least and the greatest quotient y/x.
static double radius(const Graph *graph, uint32_t c, double *x, double *y) {
  enum { MOST_ITERATIONS = 20000 };
  uint32_t from = graph->first[c], to = graph->first[c + 1];
  double low = 0, high = 1;
  for (uint32_t m = from; m < to; m++) x[graph->members[m]] = 1;
  for (int i = 0; i < MOST_ITERATIONS && high - low > 1e-13 * high; i++) {
    apply(graph, c, x, y);
    low = INFINITY;
    high = 0;
    for (uint32_t m = from; m < to; m++) {
      uint32_t kind = graph->members[m];
      double quotient = y[kind] / x[kind];
      low = fmin(low, quotient);
      high = fmax(high, quotient);
    }
    for (uint32_t m = from; m < to; m++) x[graph->members[m]] = y[graph->members[m]] / high;
  }
  return (low + high) / 2 - 1;
}

// Kinds of the component that a kind of it becomes, counted with multiplicity; the greatest over its kinds.
static uint64_t greatest_row(const Graph *graph, uint32_t c) {
  const LsysGrowth *growth = graph->growth;
  uint64_t greatest = 0;
  for (uint32_t m = graph->first[c]; m < graph->first[c + 1]; m++) {
    uint32_t kind = graph->members[m];
    uint64_t sum = 0;
    for (uint32_t e = growth->row[kind]; e < growth->row[kind + 1]; e++) {
      if (graph->component[growth->kind[e]] == c) sum += growth->count[e];
    }
    if (sum > greatest) greatest = sum;
  }
  return greatest;
}

static double component_rate(const Graph *graph, uint32_t c, double *x, double *y) {
  uint64_t row = greatest_row(graph, c);
  return row <= 1 ? (double)row : radius(graph, c, x, y);
}

// ---- class -----------------------------------------------------------------------

// The most components of rate `rate` on a path: successors of a component
// have lower numbers, so theirs are known.
static unsigned longest_chain(const Graph *graph, const double *rates, double rate, unsigned *chain) {
  const LsysGrowth *growth = graph->growth;
  unsigned longest = 0;
  for (uint32_t c = 0; c < graph->components; c++) {
    for (uint32_t m = graph->first[c]; m < graph->first[c + 1]; m++) {
      uint32_t kind = graph->members[m];
      for (uint32_t e = growth->row[kind]; e < growth->row[kind + 1]; e++) {
        uint32_t to = graph->component[growth->kind[e]];
        if (to != c && chain[to] > chain[c]) chain[c] = chain[to];
      }
    }
    if (fabs(rates[c] - rate) <= SAME_RATE * rate) chain[c]++;
    if (chain[c] > longest) longest = chain[c];
  }
  return longest;
}

GrowthRate growth_rate(const Program *program, const Facts *facts) {
  Graph graph = {arena_create(), .growth = &facts->growth, .kinds = (uint32_t)program->kind_count};
  find_components(&graph);
  double *rates = arena_array(graph.arena, graph.components, sizeof *rates);
  double *x = arena_array(graph.arena, graph.kinds, sizeof *x);
  double *y = arena_array(graph.arena, graph.kinds, sizeof *y);
  GrowthRate result = {GROWTH_DIES, 0, 0};
  for (uint32_t c = 0; c < graph.components; c++) {
    rates[c] = component_rate(&graph, c, x, y);
    result.rate = fmax(result.rate, rates[c]);
  }
  if (result.rate > 0) {
    unsigned *chain = arena_array(graph.arena, graph.components, sizeof *chain);
    result.kind = result.rate > 1 ? GROWTH_EXPONENTIAL : GROWTH_POLYNOMIAL;
    result.degree = longest_chain(&graph, rates, result.rate, chain) - 1;
  }
  arena_destroy(graph.arena);
  return result;
}
