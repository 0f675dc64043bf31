// scan.c -- looking left and right along the axes of a bracketed word
// (ABOP p. 30-32). Left contexts come from a window kept along the scan, right
// ones from a cursor that jumps over whole branches.
#include "core/scan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SUMMED = 128 };

// What `[` saves until its `]`; the window of the level stands in scan->saved.
struct LsysLevel {
  LsysCursor ahead;
  uint32_t ahead_kind, ahead_known, fresh;
};

static inline uint32_t symbol(const uint8_t *at, bool wide) {
  uint16_t pair;
  if (!wide) return *at;
  memcpy(&pair, at, sizeof pair);
  return pair;
}

// ---- ahead -------------------------------------------------------------------

// The cursor stands at the end of its segment: on to the next one that has modules. In a ring the first
// follows the last, up to the strict predecessor. False at the end of the word.
static bool next_segment(const LsysScan *scan, LsysCursor *cursor) {
  while (cursor->sym == cursor->end) {
    bool wrapped = scan->ring && cursor->end == scan->sym;
    if (wrapped) return false;
    uint32_t next = cursor->segment + 1;
    if (next == scan->segment_count) {
      if (!scan->ring) return false;
      next = 0;
    }
    const LsysSegment *segment = &scan->segments[next];
    *cursor = (LsysCursor){segment->sym, segment->end, segment->arg, cursor->found, next, 0};
    if (scan->ring && next <= scan->segment && segment->sym <= scan->sym && scan->sym < segment->end)
      cursor->end = scan->sym;
  }
  return true;
}

static inline void jump(const LsysScan *scan, LsysCursor *cursor) {
  const LsysSkip *skip = &scan->segments[cursor->segment].skip[cursor->open];
  if (skip->segment != cursor->segment) cursor->end = scan->segments[skip->segment].end;
  cursor->sym = skip->sym;
  cursor->arg = skip->arg;
  cursor->segment = skip->segment;
  cursor->open = skip->open;
}

static inline void pass(const LsysScan *scan, LsysCursor *cursor, uint32_t kind) {
  cursor->sym += 1 + scan->wide;
  cursor->arg += scan->arity[kind];
}

// Passes ignored modules, and branches too if `over`; the class of what stands there then.
// LSYS_CLASS_CLOSE also at the end of the word, with kind LSYS_NO_MODULE.
static inline uint32_t approach(const LsysScan *scan, LsysCursor *cursor, bool over, uint32_t *kind) {
  for (;;) {
    if (cursor->sym == cursor->end && !next_segment(scan, cursor)) {
      *kind = LSYS_NO_MODULE;
      return LSYS_CLASS_CLOSE;
    }
    *kind = symbol(cursor->sym, scan->wide);
    uint32_t class = scan->context_class[*kind];
    if (class == LSYS_CLASS_IGNORED)
      pass(scan, cursor, *kind);
    else if (class == LSYS_CLASS_OPEN && over)
      jump(scan, cursor);
    else
      return class;
  }
}

uint32_t lsys_ahead(const LsysScan *scan, LsysCursor *cursor) {
  uint32_t kind;
  if (approach(scan, cursor, true, &kind) != LSYS_CLASS_SEEN) return LSYS_NO_MODULE;
  cursor->found = cursor->arg;
  pass(scan, cursor, kind);
  return kind;
}

bool lsys_branch(const LsysScan *scan, LsysCursor *cursor, LsysCursor *inside) {
  uint32_t kind;
  if (approach(scan, cursor, false, &kind) != LSYS_CLASS_OPEN) return false;
  *inside = *cursor;
  pass(scan, inside, kind);
  inside->open++;
  jump(scan, cursor);
  return true;
}

bool lsys_closes(const LsysScan *scan, const LsysCursor *cursor) {
  LsysCursor at = *cursor;
  uint32_t kind;
  return approach(scan, &at, true, &kind) == LSYS_CLASS_CLOSE && kind != LSYS_NO_MODULE;
}

void lsys_behind(const LsysScan *scan, LsysCursor *cursor, uint32_t modules) {
  const uint8_t *end = scan->segments[scan->segment].end;
  *cursor = (LsysCursor){scan->sym, end, scan->arg, NULL, scan->segment, scan->open};
  for (; modules; modules--) {
    uint32_t kind = symbol(cursor->sym, scan->wide);
    cursor->open += scan->context_class[kind] == LSYS_CLASS_OPEN;
    pass(scan, cursor, kind);
  }
}

uint32_t lsys_right(LsysScan *scan, LsysCursor *cursor) {
  if (!scan->ahead_known) {
    lsys_behind(scan, &scan->ahead, 1);
    scan->ahead_kind = lsys_ahead(scan, &scan->ahead);
    scan->ahead_known = 1;
  }
  *cursor = scan->ahead;
  return scan->ahead_kind;
}

// ---- brackets ------------------------------------------------------------------

static size_t level_bytes(const LsysScan *scan, size_t room) {
  return room * (sizeof *scan->levels + scan->window * sizeof *scan->saved);
}

static void grow_levels(LsysScan *scan, size_t wanted) {
  size_t room = scan->level_room ? 2 * scan->level_room : 64;
  while (room < wanted) room *= 2;
  lsys_charge(scan->run, (int64_t)(level_bytes(scan, room) - level_bytes(scan, scan->level_room)));
  struct LsysLevel *levels = realloc(scan->levels, room * sizeof *levels);
  if (levels) scan->levels = levels;
  LsysNeighbour *saved = levels ? realloc(scan->saved, room * (scan->window + 1) * sizeof *saved) : NULL;
  if (!saved) lsys_fail(scan->run, "out of memory for %zu open brackets", room);
  scan->saved = saved;
  scan->level_room = room;
}

void lsys_scan_open(LsysScan *scan) {
  if (scan->depth == scan->level_room) grow_levels(scan, scan->depth);
  scan->levels[scan->depth] = (struct LsysLevel){scan->ahead, scan->ahead_kind, scan->ahead_known, scan->fresh};
  for (uint32_t i = 0; i < scan->window; i++) scan->saved[scan->depth * scan->window + i] = scan->left[i];
  scan->depth++;
  scan->open++;
  scan->fresh = 1;
  scan->ahead_known = 0;
}

static void forget_left(LsysScan *scan) {
  for (uint32_t i = 0; i < scan->window; i++) scan->left[i] = (LsysNeighbour){.kind = LSYS_NO_MODULE};
}

void lsys_scan_close(LsysScan *scan) {
  if (!scan->depth) {
    forget_left(scan);
    scan->fresh = 0;
    scan->ahead_known = 0;
    return;
  }
  scan->depth--;
  const struct LsysLevel *level = &scan->levels[scan->depth];
  for (uint32_t i = 0; i < scan->window; i++) scan->left[i] = scan->saved[scan->depth * scan->window + i];
  scan->ahead = level->ahead;
  scan->ahead_kind = level->ahead_kind;
  scan->ahead_known = level->ahead_known;
  scan->fresh = level->fresh;
}

// ---- sub-L-systems ---------------------------------------------------------------

void lsys_scan_enter(LsysScan *scan, double number) {
  const LsysGrammar *grammar = scan->run->grammar;
  uint32_t called = 0;
  while (called < grammar->system_count && grammar->system_number[called] != floor(number)) called++;
  if (called == grammar->system_count) lsys_fail(scan->run, "?(%.17g): there is no L-system of that number", number);
  if (scan->nested == scan->around_room) {
    size_t room = scan->around_room ? 2 * scan->around_room : 64;
    lsys_charge(scan->run, (int64_t)((room - scan->around_room) * sizeof *scan->around));
    uint32_t *around = realloc(scan->around, room * sizeof *around);
    if (!around) lsys_fail(scan->run, "out of memory for %zu nested L-systems", room);
    scan->around = around;
    scan->around_room = room;
  }
  scan->around[scan->nested++] = scan->system;
  scan->system = called;
}

void lsys_scan_leave(LsysScan *scan) {
  if (scan->nested) scan->system = scan->around[--scan->nested];
}

// ---- the cut ---------------------------------------------------------------------

void lsys_cut(LsysScan *scan) {
  const LsysKind *kinds = scan->run->grammar->kinds;
  size_t depth = 0;
  for (; scan->sym < scan->whole; scan->sym += 1 + scan->wide) {
    uint32_t kind = symbol(scan->sym, scan->wide), class = scan->context_class[kind];
    if (class == LSYS_CLASS_CLOSE && depth-- == 0) return;
    if (class == LSYS_CLASS_OPEN) {
      depth++;
      scan->open++;
    }
    scan->arg += scan->arity[kind];
    scan->key += (kinds[kind].flags & LSYS_KIND_KEY) != 0;
  }
}

// ---- preparing -------------------------------------------------------------------

bool scan_tables(ScanTables *tables, const LsysGrammar *grammar, LsysMemory *memory) {
  *tables = (ScanTables){.grammar = grammar, .memory = memory, .open = LSYS_NO_MODULE, .close = LSYS_NO_MODULE};
  tables->wide = (grammar->flags & LSYS_GRAMMAR_WIDE) != 0;
  tables->arity = lsys_memory_alloc(memory, grammar->kind_count, sizeof *tables->arity);
  tables->turn = lsys_memory_alloc(memory, grammar->kind_count, sizeof *tables->turn);
  if (!tables->arity || !tables->turn) return false;
  for (uint32_t kind = 0; kind < grammar->kind_count; kind++) {
    tables->arity[kind] = grammar->kinds[kind].arity;
    tables->parametric |= tables->arity[kind] > 0;
    if (grammar->views->context_class[kind] == LSYS_CLASS_OPEN) tables->open = kind;
    if (grammar->views->context_class[kind] == LSYS_CLASS_CLOSE) tables->close = kind;
  }
  if (tables->open != LSYS_NO_MODULE) tables->turn[tables->open] = 1;
  if (tables->close != LSYS_NO_MODULE) tables->turn[tables->close] = -1;
  return true;
}

void scan_tables_free(ScanTables *tables) {
  if (!tables->grammar) return;
  lsys_memory_free(tables->memory, tables->arity, tables->grammar->kind_count, sizeof *tables->arity);
  lsys_memory_free(tables->memory, tables->turn, tables->grammar->kind_count, sizeof *tables->turn);
}

void *scan_array(LsysRun *run, void *at, size_t *room, size_t count, size_t size) {
  if (count <= *room) return at;
  size_t wanted = 2 * count;
  lsys_charge(run, (int64_t)((wanted - *room) * size));
  void *grown = realloc(at, wanted * size);
  if (!grown) lsys_fail(run, "out of memory for the index of a word of %zu modules", count);
  *room = wanted;
  return grown;
}

void scan_array_free(LsysRun *run, void *at, size_t room, size_t size) {
  lsys_charge(run, -(int64_t)(room * size));
  free(at);
}

// Sums of so many letters fit their own size, which makes them sums of vectors.
static size_t count_letters(const uint8_t *at, const uint8_t *end, uint8_t kind) {
  size_t count = 0;
  for (; end - at >= SUMMED; at += SUMMED) {
    uint8_t sum = 0;
    for (int i = 0; i < SUMMED; i++) sum = (uint8_t)(sum + (at[i] == kind));
    count += sum;
  }
  for (; at < end; at++) count += *at == kind;
  return count;
}

size_t scan_count(const LsysSegment *segment, uint32_t kind, bool wide) {
  if (!wide) return count_letters(segment->sym, segment->end, (uint8_t)kind);
  size_t count = 0;
  for (const uint8_t *at = segment->sym; at < segment->end; at += 2) count += symbol(at, true) == kind;
  return count;
}

static inline __attribute__((always_inline)) void find_branches(ScanBrackets *opens, ScanBrackets *closes,
                                                                const ScanTables *tables, LsysRun *run,
                                                                const LsysSegment *segment, uint32_t number,
                                                                bool wide) {
  const double *arg = segment->arg;
  uint32_t open = 0;
  for (const uint8_t *at = segment->sym; at < segment->end; at += 1 + wide) {
    uint32_t kind = symbol(at, wide);
    arg += tables->arity[kind];
    if (kind == tables->open)
      scan_add(run, opens, (ScanBracket){at, arg, open++});
    else if (kind == tables->close && opens->count)
      segment->skip[opens->at[--opens->count].open] = (LsysSkip){at + 1 + wide, arg, number, open};
    else if (kind == tables->close && closes)
      scan_add(run, closes, (ScanBracket){at, arg, open});
  }
}

void scan_branches(ScanBrackets *opens, ScanBrackets *closes, const ScanTables *tables, LsysRun *run,
                   const LsysSegment *segment, uint32_t number) {
  if (tables->wide)
    find_branches(opens, closes, tables, run, segment, number, true);
  else
    find_branches(opens, closes, tables, run, segment, number, false);
}

void scan_index(ScanIndex *index, const ScanTables *tables, LsysRun *run, LsysSegment *word) {
  if (tables->open == LSYS_NO_MODULE || !(tables->grammar->flags & LSYS_GRAMMAR_RIGHT)) return;
  word->skip_count = scan_count(word, tables->open, tables->wide);
  word->skip = index->skips = scan_array(run, index->skips, &index->room, word->skip_count + 1, sizeof *index->skips);
  ScanBrackets *opens = &index->opens;
  opens->count = 0;
  scan_branches(opens, NULL, tables, run, word, 0);
  while (opens->count) {  // an unclosed branch goes on to the end of the word
    uint32_t open = opens->at[--opens->count].open;
    word->skip[open] = (LsysSkip){word->end, NULL, 0, (uint32_t)word->skip_count};
  }
}

void scan_index_free(ScanIndex *index, LsysRun *run) {
  scan_array_free(run, index->skips, index->room, sizeof *index->skips);
  scan_array_free(run, index->opens.at, index->opens.room, sizeof *index->opens.at);
}

// In a ring the window begins with the last seen modules of the word.
static void wrap_window(LsysScan *scan) {
  LsysCursor cursor = {scan->segments[0].sym, scan->segments[0].end, scan->segments[0].arg, NULL, 0, 0};
  uint32_t ring = scan->ring, kind, number = 0;
  scan->ring = 0;
  while ((kind = lsys_ahead(scan, &cursor)) != LSYS_NO_MODULE) {
    for (uint32_t i = scan->window; i-- > 1;) scan->left[i] = scan->left[i - 1];
    if (scan->window) scan->left[0] = (LsysNeighbour){kind, ++number, cursor.found};
  }
  scan->ring = ring;
}

void scan_start(LsysScan *scan, const ScanTables *tables, const LsysContextView *view, LsysRun *run,
                const LsysSegment *segments, uint32_t count, LsysNeighbour *left) {
  const LsysScan kept = *scan;
  const LsysGrammar *grammar = tables->grammar;
  *scan = (LsysScan){.sym = segments[0].sym,
                     .end = segments[0].end,
                     .whole = segments[0].end,
                     .arg = segments[0].arg,
                     .key = segments[0].key,
                     .left = left,
                     .window = grammar->left_window,
                     .run = run,
                     .segments = segments,
                     .segment_count = count,
                     .context_class = view->context_class,
                     .arity = tables->arity,
                     .wide = tables->wide,
                     .ring = view->ring != 0,
                     .behind_kind = LSYS_NO_MODULE,
                     .levels = kept.levels,
                     .level_room = kept.level_room,
                     .saved = kept.saved,
                     .around = kept.around,
                     .around_room = kept.around_room,
                     .code = kept.code,
                     .aside = kept.aside,
                     .code_room = kept.code_room,
                     .aside_room = kept.aside_room};
  forget_left(scan);
  if (scan->ring) wrap_window(scan);
}

void scan_enter(LsysScan *scan, uint32_t segment, const ScanBorder *border) {
  const LsysSegment *from = &scan->segments[segment];
  scan->sym = from->sym;
  scan->end = scan->whole = from->end;
  scan->arg = from->arg;
  scan->key = from->key;
  scan->segment = segment;
  scan->open = 0;
  scan->depth = border->depth;
  scan->fresh = border->fresh;
  scan->ahead_known = 0;
  if (scan->level_room < border->depth) grow_levels(scan, border->depth);
  for (uint32_t i = 0; i < scan->window; i++) scan->left[i] = border->left[i];
  for (size_t i = 0; i < border->depth; i++) scan->levels[i] = (struct LsysLevel){.fresh = border->saved_fresh[i]};
  for (size_t i = 0; i < border->depth * scan->window; i++) scan->saved[i] = border->saved[i];
  scan->behind_kind = border->behind_kind;
  scan->behind = border->behind;
  scan->behind_depth = border->behind_depth;
}

void scan_free(LsysScan *scan, LsysRun *run) {
  lsys_charge(run, -(int64_t)(level_bytes(scan, scan->level_room) + scan->around_room * sizeof *scan->around));
  lsys_charge(run, -(int64_t)(scan->code_room + scan->aside_room * sizeof *scan->aside));
  free(scan->levels);
  free(scan->saved);
  free(scan->around);
  free(scan->code);
  free(scan->aside);
}
