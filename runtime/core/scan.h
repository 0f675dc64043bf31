// scan.h -- preparing a step's scan over a word: segments, the index of
// branches, and the state at the word's beginning.
#ifndef LSYS_CORE_SCAN_H
#define LSYS_CORE_SCAN_H

#include "core/memory.h"
#include "lsys/abi.h"
#include "lsys/scan.h"

// What matching needs to know of a grammar's kinds, once per run.
typedef struct ScanTables {
  const LsysGrammar *grammar;
  LsysMemory *memory;
  uint16_t *arity;  // by kind
  uint8_t wide;     // 1: symbols take two bytes
  bool parametric;  // some kind has arguments
  int8_t *turn;     // by kind: 1 for `[`, -1 for `]`, else 0
  uint32_t open;    // kind of `[`, LSYS_NO_MODULE if there is none
  uint32_t close;
} ScanTables;

// False after printing that there is no memory. Free them in either case.
bool scan_tables(ScanTables *tables, const LsysGrammar *grammar, LsysMemory *memory);
void scan_tables_free(ScanTables *tables);

// How often a kind stands in a segment.
size_t scan_count(const LsysSegment *segment, uint32_t kind, bool wide);

// A bracket and what stands behind it.
typedef struct ScanBracket {
  const uint8_t *sym;
  const double *arg;
  uint32_t open;  // ordinal of the next `[` from there on; of a `[`: its own
} ScanBracket;

typedef struct ScanBrackets {
  ScanBracket *at;
  size_t count, room;
} ScanBrackets;

// Fills the skips of branches that end in segment `number`, where they begin. Brackets without a partner in it are left
// in `opens`, which is empty before, and added to `closes` unless that is NULL.
void scan_branches(ScanBrackets *opens, ScanBrackets *closes, const ScanTables *tables, LsysRun *run,
                   const LsysSegment *segment, uint32_t number);

// Gives a whole word its skips: each `[` learns where its branch continues. The arrays are grown as needed and reused
// from step to step; the run ends when memory does.
typedef struct ScanIndex {
  LsysSkip *skips;
  size_t room;
  ScanBrackets opens;
} ScanIndex;
void scan_index(ScanIndex *index, const ScanTables *tables, LsysRun *run, LsysSegment *word);
void scan_index_free(ScanIndex *index, LsysRun *run);

// A scan at the beginning of the word, which is all zeros or was used before. left has room for the grammar's window.
void scan_start(LsysScan *scan, const ScanTables *tables, const LsysContextView *view, LsysRun *run,
                const LsysSegment *segments, uint32_t count, LsysNeighbour *left);
void scan_free(LsysScan *scan, LsysRun *run);

// With what a scan enters a segment in the middle of a word.
typedef struct ScanBorder {
  const LsysNeighbour *left;   // the window
  const LsysNeighbour *saved;  // windows to which `]` of this segment return, outermost first, depth of them,
  const uint8_t *saved_fresh;  //   and LsysScan.fresh of each
  size_t depth;
  uint32_t fresh;
  uint32_t behind_kind;    // words of letters: the next seen module behind the segment,
  const uint32_t *behind;  //   and those behind the branches that it leaves open, innermost last,
  size_t behind_depth;     //   so many
} ScanBorder;

// Lets a scan that was started go on at the beginning of a segment.
void scan_enter(LsysScan *scan, uint32_t segment, const ScanBorder *border);

// An array of at least count elements, grown to twice of that if need be; what it held is kept. The run ends where
// there is no memory.
void *scan_array(LsysRun *run, void *at, size_t *room, size_t count, size_t size);
void scan_array_free(LsysRun *run, void *at, size_t room, size_t size);

static inline void scan_add(LsysRun *run, ScanBrackets *to, ScanBracket bracket) {
  if (to->count == to->room) to->at = scan_array(run, to->at, &to->room, to->count + 1, sizeof *to->at);
  to->at[to->count++] = bracket;
}

#endif
