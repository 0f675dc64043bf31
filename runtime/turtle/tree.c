// tree.c -- reads a word as an axial tree from its base and orders it from its
// tips: each open axis keeps one byte for every node that has branches, and
// folds them when it ends.
#include "turtle/tree.h"

#include "core/memory.h"
#include "core/message.h"

#include <stdlib.h>
#include <string.h>

// The branches at one node, seen from the axis: the highest order among them, and whether several have it.
typedef struct Node {
  uint8_t highest : 7, several : 1;
} Node;

// An axis that is being read. A node is finished by the next segment of its axis.
typedef struct Axis {
  size_t first;   // of its nodes
  Node open;      // branches since the last segment; highest 0: none
  bool segments;  // it has one
} Axis;

struct LsysTree {
  const LsysGrammar *grammar;
  LsysMemory *memory;
  bool branches;  // the grammar has `[`
  uint8_t *what;  // of each kind: 1 draws, 2 `[`, 3 `]`
  Axis *axis;
  size_t axes, axis_room;
  Node *node;
  size_t nodes, node_room;
  LsysTreeOrders orders;
};

enum { DRAWS = 1, OPENS = 2, CLOSES = 3 };

static uint8_t what_of(uint8_t op) {
  switch ((LsysTurtleOp)op) {
  case LSYS_TURTLE_DRAW:
  case LSYS_TURTLE_DRAW_NO_VERTEX:
  case LSYS_TURTLE_SECOND_DRAW:
    return DRAWS;
  case LSYS_TURTLE_PUSH:
    return OPENS;
  case LSYS_TURTLE_POP:
    return CLOSES;
  default:
    return 0;
  }
}

LsysTree *lsys_tree_create(const LsysRun *run) {
  const LsysGrammar *grammar = run->grammar;
  LsysTree *t = calloc(1, sizeof *t);
  if (t) t->what = calloc((size_t)grammar->kind_count + 1, 1);
  if (!t || !t->what) {
    lsys_error("out of memory");
    free(t);
    return NULL;
  }
  t->grammar = grammar;
  t->memory = run->memory;
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    t->what[i] = what_of(grammar->kinds[i].turtle);
    t->branches |= t->what[i] == OPENS;
  }
  return t;
}

void lsys_tree_destroy(LsysTree *t) {
  if (!t) return;
  free(t->what);
  lsys_memory_free(t->memory, t->axis, t->axis_room, sizeof *t->axis);
  lsys_memory_free(t->memory, t->node, t->node_room, sizeof *t->node);
  free(t);
}

static void add_branch(Node *node, uint32_t order) {
  if (order > node->highest) {
    *node = (Node){.highest = (uint8_t)(order & 127), .several = 0};
  } else if (order == node->highest) {
    node->several = 1;
  }
}

// The order of the axis below a node, from `above`, its order beyond it.
static uint32_t below(LsysTree *t, Node node, uint32_t above) {
  add_branch(&node, above);
  uint32_t order = node.highest + (node.several ? 1u : 0u);
  if (order > LSYS_TREE_ORDERS) order = LSYS_TREE_ORDERS;
  if (node.several) t->orders.streams[order]++;
  return order;
}

// The Strahler order at the base of the innermost axis, which ends here. 0: it draws nothing.
static uint32_t fold(LsysTree *t) {
  Axis *a = &t->axis[t->axes - 1];
  uint32_t order = 0;
  if (a->open.highest) {
    order = below(t, a->open, 0);
  } else if (a->segments) {
    t->orders.streams[order = 1]++;
  }
  while (t->nodes > a->first) order = below(t, t->node[--t->nodes], order);
  return order;
}

static uint32_t gravelius(const LsysTree *t) {
  return t->axes < LSYS_TREE_ORDERS ? (uint32_t)t->axes : LSYS_TREE_ORDERS;
}

static bool open_axis(LsysTree *t) {
  if (t->axes == t->axis_room && !lsys_memory_fit(t->memory, &t->axis, &t->axis_room, t->axes + 1, sizeof *t->axis))
    return false;
  t->axis[t->axes++] = (Axis){.first = t->nodes};
  return true;
}

static void close_axis(LsysTree *t) {
  if (t->axes < 2) return;  // `]` without `[`
  uint32_t order = fold(t);
  t->axes--;
  if (order) add_branch(&t->axis[t->axes - 1].open, order);
}

static bool segment(LsysTree *t) {
  Axis *a = &t->axis[t->axes - 1];
  uint32_t order = gravelius(t);
  t->orders.segments[order]++;
  if (!a->segments) t->orders.axes[order]++;
  a->segments = true;
  if (!a->open.highest) return true;
  if (!lsys_memory_fit(t->memory, &t->node, &t->node_room, t->nodes + 1, sizeof *t->node)) return false;
  t->node[t->nodes++] = a->open;
  a->open = (Node){0};
  return true;
}

void lsys_tree_begin(LsysTree *t) {
  t->axes = t->nodes = 0;
  t->orders = (LsysTreeOrders){0};
}

bool lsys_tree_take(LsysTree *t, const LsysWord *part) {
  const bool wide = t->grammar->flags & LSYS_GRAMMAR_WIDE;
  if (!t->branches) return true;
  if (!t->axes && !open_axis(t)) return false;
  for (uint64_t i = 0; i < part->nsym; i++) {
    uint32_t kind = wide ? part->sym[2 * i] | (uint32_t)part->sym[2 * i + 1] << 8 : part->sym[i];
    uint8_t what = t->what[kind];
    if (!what) continue;
    if (what == CLOSES)
      close_axis(t);
    else if (!(what == DRAWS ? segment(t) : open_axis(t)))
      return false;
  }
  return true;
}

void lsys_tree_end(LsysTree *t) {
  while (t->axes > 1) close_axis(t);
  t->orders.strahler = t->axes ? fold(t) : 0;
}

const LsysTreeOrders *lsys_tree_orders(const LsysTree *t) {
  return &t->orders;
}
