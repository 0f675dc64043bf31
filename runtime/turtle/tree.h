// tree.h -- the branching of a drawn word, as botanists and hydrologists count it:
// Gravelius orders (the trunk 1, its branches 2, ...) and Horton-Strahler orders
// (twigs 1; where two of the highest order meet, one more).
// Sources: Strahler 1957; Barker, Cumming, Horsfield 1973; ABOP p. 21 (axial trees).
#ifndef LSYS_TURTLE_TREE_H
#define LSYS_TURTLE_TREE_H

#include "lsys/abi.h"

#include <stdbool.h>

enum { LSYS_TREE_ORDERS = 64 };  // higher Gravelius orders count as this one; no word has a higher Strahler order

typedef struct LsysTree LsysTree;

// A tree of words of this grammar. NULL after printing that memory ran out.
LsysTree *lsys_tree_create(const LsysRun *run);
void lsys_tree_destroy(LsysTree *tree);

void lsys_tree_begin(LsysTree *tree);
// False after printing that memory ran out.
bool lsys_tree_take(LsysTree *tree, const LsysWord *part);
void lsys_tree_end(LsysTree *tree);

// After the end; nothing is counted where the grammar has no brackets. Orders count from 1; order[0] is not used.
typedef struct LsysTreeOrders {
  uint64_t segments[LSYS_TREE_ORDERS + 1];  // of each Gravelius order
  uint64_t axes[LSYS_TREE_ORDERS + 1];      // axes of each Gravelius order that have a segment
  uint64_t streams[LSYS_TREE_ORDERS + 1];   // maximal paths of each Strahler order
  uint32_t strahler;                        // of the whole tree; 0 if nothing is drawn
} LsysTreeOrders;
const LsysTreeOrders *lsys_tree_orders(const LsysTree *tree);

#endif
