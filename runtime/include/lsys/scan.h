// scan.h -- how compiled productions see the neighbours of a module: the step
// engine's contract with the run time (LANGUAGE.md 5.4, ABOP p. 30-32).
//
// One step reads a word that does not change and writes the next one. The word
// is a row of segments, each contiguous in memory; a scan walks over a part of
// it. What it keeps costs the same for every module, whatever the length of the
// word or of its branches:
//
//   left   the last `window` seen modules on the path to the root, nearest first;
//          saved at `[`, restored behind the matching `]`
//   right  the first seen module ahead on the same axis, found once and kept
//          until it is passed; whole branches are jumped over by an index
#ifndef LSYS_SCAN_H
#define LSYS_SCAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct LsysRun;

#define LSYS_NO_MODULE UINT32_MAX  // there is no such neighbour

// What a kind is to context matching: LsysContextView.context_class.
enum { LSYS_CLASS_SEEN, LSYS_CLASS_IGNORED, LSYS_CLASS_OPEN, LSYS_CLASS_CLOSE };

// How contexts see a word. L-systems that ignore the same symbols share a view.
typedef struct LsysContextView {
  const uint8_t *context_class;  // LSYS_CLASS_* of each kind
  uint64_t ring;                 // 1: first and last module are neighbours
} LsysContextView;

typedef struct LsysNeighbour {
  uint32_t kind;  // LSYS_NO_MODULE: the path ends before it
  uint32_t wrap;  // ring: one more than its number among the seen modules of the root's axis, if it is a neighbour
                  //   around the end of the word; else 0
  const double *arg;
} LsysNeighbour;

// Where a branch continues behind its `]`: one for each `[` of a segment, in order.
typedef struct LsysSkip {
  const uint8_t *sym;
  const double *arg;
  uint32_t segment, open;  // open: ordinal of the next `[` from there on
} LsysSkip;

typedef struct LsysSegment {
  const uint8_t *sym, *end;
  const double *arg;
  const uint64_t *key;
  LsysSkip *skip;  // NULL where the grammar has no right contexts or no brackets
  uint64_t skip_count;
} LsysSegment;

// A place between two modules, looking ahead.
typedef struct LsysCursor {
  const uint8_t *sym, *end;  // end: of its segment
  const double *arg;
  const double *found;  // arguments of the module that lsys_ahead found
  uint32_t segment, open;
} LsysCursor;

typedef struct LsysScan LsysScan;

struct LsysScan {
  // What compiled code reads and keeps. sym, arg, key: the module that is rewritten next.
  const uint8_t *sym, *end;
  const double *arg;
  const uint64_t *key;
  LsysNeighbour *left;  // window of them, left[0] the nearest
  struct LsysRun *run;
  uint64_t step;         // index of this step, from 0
  uint64_t depth;        // open brackets
  uint32_t fresh;        // 1: no seen module yet since the `[` that began this branch
  uint32_t ahead_known;  // 1: `ahead` holds
  uint32_t passed;       // ring: seen modules of the root's axis up to this one; left[j] counts if its wrap is 0 or
                         //   beyond passed
  uint32_t system;       // the L-system around the module (LANGUAGE.md, sub-L-systems)
  LsysScan *other;       // the same word as the next view sees it; NULL: none
  const uint8_t *whole;  // the end of the segment, up to which predecessors and cuts may reach beyond `end`

  // The run time's own.
  uint32_t window;
  uint32_t segment, open;
  const LsysSegment *segments;
  uint32_t segment_count;
  const uint8_t *context_class;  // by kind
  const uint16_t *arity;         // by kind
  uint32_t wide;                 // 1: symbols take two bytes
  uint32_t ring;                 // 1: the word is a ring; a neighbour is looked for up to the module itself
  LsysCursor ahead;              // behind the first seen module ahead, by lsys_right
  uint32_t ahead_kind;
  struct LsysLevel *levels;  // what `[` saved, one per open bracket
  size_t level_room;
  LsysNeighbour *saved;  // window of them per level
  uint32_t *around;      // the L-systems around `system`, nested of them
  uint64_t nested;
  size_t around_room;
  uint8_t *code;    // lsys_step_letters: of each module
  uint32_t *aside;  //   and rows put aside
  size_t code_room, aside_room;
  uint32_t behind_kind;    //   the next seen module behind the segment,
  const uint32_t *behind;  //   and behind branches that it leaves open, innermost last
  size_t behind_depth;
  uint64_t *lengths;  //   and where to tell what length each module of the segment became; NULL: nowhere
};

// At the beginning of a seen module's rewriting, compiled code sets ahead_known = 0 and, in a ring, counts the module
// in passed; behind it, it moves the window on and sets fresh = 0.
//
// Call for `[` and `]` after writing what they become, with scan->sym at the bracket; they save and restore
// the context, and do not move scan->sym. A `]` without `[` ends the axis: nothing is to its left.
void lsys_scan_open(LsysScan *scan);
void lsys_scan_close(LsysScan *scan);

// Call for `?(number)` before it is rewritten, but behind reading scan->system, and for `$` before both: what stands
// between them belongs to the L-system of that number.
void lsys_scan_enter(LsysScan *scan, double number);
void lsys_scan_leave(LsysScan *scan);

// A cursor directly behind the modules that start at scan->sym: 1, or more in a pseudo-production.
void lsys_behind(const LsysScan *scan, LsysCursor *cursor, uint32_t modules);

// The kind of the next seen module on the axis, whose arguments are cursor->found; the cursor moves behind it.
// LSYS_NO_MODULE at the end of the branch, of the axis or of the word; the cursor then stands there.
uint32_t lsys_ahead(const LsysScan *scan, LsysCursor *cursor);

// lsys_behind and lsys_ahead in one for a single strict predecessor, at a cost that does not depend on what lies
// between.
uint32_t lsys_right(LsysScan *scan, LsysCursor *cursor);

// Is there a branch at this place, before the next seen module? If so, `inside` stands behind its `[` and
// cursor behind its `]`.
bool lsys_branch(const LsysScan *scan, LsysCursor *cursor, LsysCursor *inside);

// Does a `]` follow on the axis, behind nothing but ignored modules and branches?
bool lsys_closes(const LsysScan *scan, const LsysCursor *cursor);

// Moves scan->sym, arg, key to the `]` that ends the branch (or scan->whole, the end of the word): the cut `%`.
void lsys_cut(LsysScan *scan);

// ---- words of letters --------------------------------------------------------

enum { LSYS_CODES = 256 };

// What passing a module makes of the row, by its code: (row & keep) | (what was put aside last & pop) | set. Behind a
// bracket more or fewer rows are put aside.
typedef struct LsysMoves {
  uint32_t keep[LSYS_CODES], pop[LSYS_CODES], set[LSYS_CODES];
  int64_t depth[LSYS_CODES];
} LsysMoves;

// What becomes of modules without arguments where that depends on their kind and on the kind of one neighbour on each
// side. Kinds are in classes as neighbours; 0: none that makes a difference, or none at all. A module's code is
// (class of the right one) * kinds + its kind, less than LSYS_CODES; its row is (class of the left one) * codes.
typedef struct LsysLetters {
  const uint8_t *text;     // [row + code]: what it becomes, in `width` bytes each
  const uint8_t *length;   // [row + code]: how much of that
  const LsysMoves *left;   // by code: for the row of what follows
  const LsysMoves *right;  // by kind: for what adds up to the code of what stands before
  uint32_t width;          // 8, 16, 32 or 64
  uint32_t longest;        // length
  uint32_t looks_right;    // 0: right is not there, and codes are kinds
  uint32_t nested;         // 0: no move puts anything aside
} LsysLetters;

// The room for symbols that a grammar with this table promises (LsysGrammar.room_sym).
#define LSYS_LETTERS_ROOM(longest) (64 + 64 * (longest))

struct LsysStream;

// Rewrites a whole segment, from scan->sym to scan->end.
void lsys_step_letters(LsysScan *scan, struct LsysStream *out, const LsysLetters *letters);

#endif
