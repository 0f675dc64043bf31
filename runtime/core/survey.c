// survey.c -- see survey.h. First the brackets of a segment that have no
// partner in it are found, then what stands nearest to them on their axes, where
// finished branches are only counted through. Joining costs what there are such
// brackets.
#include "core/survey.h"

#include <stdlib.h>
#include <string.h>

#define INLINE static inline __attribute__((always_inline))

enum {
  WORD = 8,    // letters in 64 bits
  BLOCK = 64,  // letters that are looked at together
};

// What `[` saves on the path.
struct SurveyLevel {
  LsysSkip *skip;
  uint32_t fresh;
};

INLINE uint32_t symbol(const uint8_t *at, bool wide) {
  uint16_t pair;
  if (!wide) return *at;
  memcpy(&pair, at, sizeof pair);
  return pair;
}

static uint32_t window(const ScanTables *tables) {
  return tables->grammar->left_window;
}

// ---- one segment -------------------------------------------------------------

// From one end of a segment to the other: `[` behind which no `]` of its own follows, or, going forward, `]` before
// which there is no `[`.
typedef struct Search {
  const ScanTables *tables;
  const uint8_t *at, *end;  // going back, modules below `at` down to `end`
  ptrdiff_t depth;          // brackets that wait for their partners
} Search;

static bool has_blocks(const ScanTables *tables) {
  return !tables->wide && tables->open != LSYS_NO_MODULE && tables->close != LSYS_NO_MODULE;
}

// Passes words of letters that hold no bracket to be found: none whose partner would have to come before all that wait.
// Byte i of `sums` is what the depth gains in the first i + 1 letters, and i + 1 more, so that none is negative.
INLINE void skip_words(Search *search, bool back) {
  const uint64_t each = UINT64_C(0x0101010101010101), high = each << 7, start = high - UINT64_C(0x0807060504030201);
  const uint8_t up = (uint8_t)(back ? search->tables->close : search->tables->open);
  const uint8_t down = (uint8_t)(back ? search->tables->open : search->tables->close);
  const uint8_t *at = search->at;
  ptrdiff_t depth = search->depth;
  while ((back ? at - search->end : search->end - at) >= BLOCK) {
    const uint8_t *letters = back ? at - BLOCK : at;
    uint8_t turn[BLOCK];
    int i = 0;
    for (int k = 0; k < BLOCK; k++) turn[k] = (uint8_t)(1 - -(letters[k] == up) + -(letters[k] == down));
#pragma GCC unroll 8
    for (; i < BLOCK; i += WORD) {
      uint64_t word, level = depth < WORD ? (uint64_t)depth : WORD;
      memcpy(&word, back ? turn + BLOCK - WORD - i : turn + i, sizeof word);
      uint64_t sums = (back ? __builtin_bswap64(word) : word) * each;
      if (~(sums + level * each + start) & high) break;
      depth += (ptrdiff_t)(sums >> 56) - WORD;
    }
    at += back ? -i : i;
    if (i < BLOCK) break;
  }
  search->at = at;
  search->depth = depth;
}

INLINE const uint8_t *find_lone(Search *search, bool back) {
  const ScanTables *tables = search->tables;
  const ptrdiff_t width = 1 + tables->wide;
  bool skips = has_blocks(tables);
  while (search->at != search->end) {
    for (int i = 0; i < WORD && search->at != search->end; i++) {
      const uint8_t *at = back ? search->at - width : search->at;
      int turn = tables->turn[symbol(at, tables->wide)];
      search->at = back ? at : at + width;
      search->depth += back ? -turn : turn;
      if (search->depth >= 0) continue;
      search->depth = 0;
      return at;
    }
    if (skips) skip_words(search, back);
  }
  return NULL;
}

static const uint8_t *next_close(Search *search) {
  return find_lone(search, false);
}

static const uint8_t *last_open(Search *search) {
  return find_lone(search, true);
}

static void find_brackets(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment) {
  Search ahead = {.tables = tables, .at = segment->sym, .end = segment->end};
  const uint8_t *at;
  while ((at = next_close(&ahead))) scan_add(run, &survey->closes, (ScanBracket){.sym = at});
  Search back = {.tables = tables, .at = segment->end, .end = segment->sym};
  ScanBrackets *opens = &survey->opens;
  opens->count = (size_t)ahead.depth;
  opens->at = scan_array(run, opens->at, &opens->room, opens->count, sizeof *opens->at);
  for (size_t i = opens->count; i-- > 0;) opens->at[i] = (ScanBracket){.sym = last_open(&back)};
}

// The places of arguments behind the brackets, which stand in order.
static void find_arguments(Survey *survey, const ScanTables *tables, const LsysSegment *segment) {
  ScanBrackets *lists[] = {&survey->closes, &survey->opens};
  const uint8_t *at = segment->sym, width = (uint8_t)(1 + tables->wide);
  const double *arg = segment->arg;
  for (int l = 0; l < 2; l++)
    for (size_t i = 0; i < lists[l]->count; i++) {
      for (; at <= lists[l]->at[i].sym; at += width) arg += tables->arity[symbol(at, tables->wide)];
      lists[l]->at[i].arg = arg;
    }
}

static void find(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment, uint32_t number) {
  if (segment->skip) {
    scan_branches(&survey->opens, &survey->closes, tables, run, segment, number);
    return;
  }
  find_brackets(survey, tables, run, segment);
  if (tables->parametric) find_arguments(survey, tables, segment);
}

// The `[` of the branch whose `]` stands at `at`, and the other way round; it is there.
static const uint8_t *branch_before(const ScanTables *tables, const uint8_t *begin, const uint8_t *at) {
  Search back = {.tables = tables, .at = at, .end = begin};
  return last_open(&back);
}

static const uint8_t *branch_behind(const ScanTables *tables, const uint8_t *at, const uint8_t *end) {
  Search ahead = {.tables = tables, .at = at + 1, .end = end};
  return next_close(&ahead);
}

// The last seen modules of an axis between begin and at, which no branch enters or leaves: at most the window, and at
// least whether there is one.
static uint32_t look_back(const ScanTables *tables, const uint8_t *begin, const uint8_t *at, const double *arg,
                          LsysNeighbour *near) {
  const uint8_t *class = tables->grammar->views->context_class;
  uint32_t count = 0, most = window(tables) ? window(tables) : 1;
  size_t depth = 0;
  while (at > begin && count < most) {
    at -= 1 + tables->wide;
    uint32_t kind = symbol(at, tables->wide);
    arg -= tables->arity[kind];
    if (kind == tables->close && !tables->parametric)
      at = branch_before(tables, begin, at);
    else if (class[kind] == LSYS_CLASS_CLOSE)
      depth++;
    if (class[kind] == LSYS_CLASS_OPEN) depth--;
    if (class[kind] != LSYS_CLASS_SEEN || depth) continue;
    if (count < window(tables)) near[count] = (LsysNeighbour){.kind = kind, .arg = arg};
    count++;
  }
  return count;
}

static void find_near(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment,
                      const double *end) {
  const ScanBrackets *closes = &survey->closes, *opens = &survey->opens;
  size_t frames = opens->count + 1, width = 1 + (size_t)tables->wide;
  survey->near = scan_array(run, survey->near, &survey->near_room, frames * window(tables), sizeof *survey->near);
  survey->near_count = scan_array(run, survey->near_count, &survey->count_room, frames, sizeof *survey->near_count);
  const uint8_t *begin = closes->count ? closes->at[closes->count - 1].sym + width : segment->sym;
  for (size_t f = 0; f < frames; f++) {
    bool last = f == opens->count;
    const uint8_t *at = last ? segment->end : opens->at[f].sym;
    const double *arg = last ? end : opens->at[f].arg - tables->arity[tables->open];
    survey->near_count[f] = look_back(tables, begin, at, arg, survey->near + f * window(tables));
    begin = at + width;
  }
}

static uint32_t look_ahead(const ScanTables *tables, const uint8_t *at, const uint8_t *end) {
  const uint8_t *class = tables->grammar->views->context_class;
  for (; at < end; at++) {
    if (class[*at] == LSYS_CLASS_SEEN) return *at;
    if (*at == tables->open) at = branch_behind(tables, at, end);
  }
  return LSYS_NO_MODULE;
}

static void find_next(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment) {
  const ScanBrackets *closes = &survey->closes, *opens = &survey->opens;
  survey->next = scan_array(run, survey->next, &survey->next_room, closes->count + 1, sizeof *survey->next);
  for (size_t c = 0; c <= closes->count; c++) {
    const uint8_t *begin = c ? closes->at[c - 1].sym + 1 : segment->sym;
    const uint8_t *end = c < closes->count ? closes->at[c].sym : opens->count ? opens->at[0].sym : segment->end;
    survey->next[c] = look_ahead(tables, begin, end);
  }
}

void survey_segment(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment, uint32_t number,
                    const double *end) {
  survey->closes.count = survey->opens.count = 0;
  if (tables->open != LSYS_NO_MODULE || tables->close != LSYS_NO_MODULE) find(survey, tables, run, segment, number);
  find_near(survey, tables, run, segment, end);
  if (tables->grammar->flags & LSYS_GRAMMAR_LETTERS) find_next(survey, tables, run, segment);
}

void survey_free(Survey *survey, LsysRun *run) {
  scan_array_free(run, survey->closes.at, survey->closes.room, sizeof *survey->closes.at);
  scan_array_free(run, survey->opens.at, survey->opens.room, sizeof *survey->opens.at);
  scan_array_free(run, survey->near, survey->near_room, sizeof *survey->near);
  scan_array_free(run, survey->near_count, survey->count_room, sizeof *survey->near_count);
  scan_array_free(run, survey->next, survey->next_room, sizeof *survey->next);
}

// ---- the path ----------------------------------------------------------------

// Where the path stands between two segments.
typedef struct Path {
  SurveyJoin *join;
  LsysRun *run;
  uint32_t window;
  LsysNeighbour *left;
  uint32_t fresh;
  size_t depth;
  size_t windows, freshes;  // used by borders
} Path;

static void *copy(void *to, const void *from, size_t count, size_t size) {
  return count ? memcpy(to, from, count * size) : to;
}

static void forget(Path *path) {
  for (uint32_t i = 0; i < path->window; i++) path->left[i] = (LsysNeighbour){.kind = LSYS_NO_MODULE};
  path->fresh = 0;
}

static void push(Path *path, LsysSkip *skip) {
  SurveyJoin *join = path->join;
  size_t at = path->depth * path->window;
  join->levels = scan_array(path->run, join->levels, &join->level_room, path->depth + 1, sizeof *join->levels);
  join->saved = scan_array(path->run, join->saved, &join->saved_room, at + path->window, sizeof *join->saved);
  join->levels[path->depth++] = (struct SurveyLevel){skip, path->fresh};
  copy(join->saved + at, path->left, path->window, sizeof *path->left);
  path->fresh = 1;
}

static void pop(Path *path, LsysSkip skip) {
  if (!path->depth) {
    forget(path);
    return;
  }
  const struct SurveyLevel *level = &path->join->levels[--path->depth];
  if (level->skip) *level->skip = skip;
  path->fresh = level->fresh;
  copy(path->left, path->join->saved + path->depth * path->window, path->window, sizeof *path->left);
}

// Modules of the segment are the nearest now.
static void pass(Path *path, const LsysNeighbour *near, uint32_t count) {
  if (count) path->fresh = 0;
  if (count > path->window) count = path->window;
  for (uint32_t i = path->window; i-- > count;) path->left[i] = path->left[i - count];
  copy(path->left, near, count, sizeof *near);
}

// Pointers into the arrays of all borders are offsets as long as these grow.
static void enter(Path *path, ScanBorder *border, size_t closes) {
  SurveyJoin *join = path->join;
  border->depth = closes < path->depth ? closes : path->depth;
  border->fresh = path->fresh;
  size_t first = path->depth - border->depth, saved = border->depth * path->window;
  size_t windows = path->windows + path->window + saved, freshes = path->freshes + border->depth;
  join->windows = scan_array(path->run, join->windows, &join->window_room, windows, sizeof *join->windows);
  join->fresh = scan_array(path->run, join->fresh, &join->fresh_room, freshes, sizeof *join->fresh);
  LsysNeighbour *to = join->windows + path->windows;
  copy(to, path->left, path->window, sizeof *to);
  copy(to + path->window, join->saved + first * path->window, saved, sizeof *to);
  for (size_t i = 0; i < border->depth; i++) join->fresh[path->freshes + i] = (uint8_t)join->levels[first + i].fresh;
  path->windows = windows;
  path->freshes = freshes;
}

static void follow_path(Path *path, const Survey *surveys, const ScanTables *tables, const LsysSegment *segments,
                        uint32_t count, ScanBorder *borders) {
  size_t width = 1 + (size_t)tables->wide;
  for (uint32_t i = 0; i < count; i++) {
    const Survey *survey = &surveys[i];
    enter(path, &borders[i], survey->closes.count);
    for (size_t c = 0; c < survey->closes.count; c++) {
      const ScanBracket *close = &survey->closes.at[c];
      pop(path, (LsysSkip){close->sym + width, close->arg, i, close->open});
    }
    for (size_t f = 0; f <= survey->opens.count; f++) {
      if (f) push(path, segments[i].skip ? &segments[i].skip[survey->opens.at[f - 1].open] : NULL);
      pass(path, survey->near + f * path->window, survey->near_count[f]);
    }
  }
  const LsysSegment *last = &segments[count - 1];  // an unclosed branch goes on to the end of the word
  while (path->depth) pop(path, (LsysSkip){last->end, NULL, count - 1, (uint32_t)last->skip_count});
}

static void place_borders(const SurveyJoin *join, uint32_t count, uint32_t width, ScanBorder *borders) {
  const LsysNeighbour *windows = join->windows;
  const uint8_t *fresh = join->fresh;
  for (uint32_t i = 0; i < count; i++) {
    borders[i].left = windows;
    borders[i].saved = width ? windows + width : windows;
    borders[i].saved_fresh = fresh;
    windows += width * (borders[i].depth + 1);
    fresh += borders[i].depth;
  }
}

// ---- the path ahead ------------------------------------------------------------

// Words of letters: from the end to the beginning, kinds only.
static void follow_back(SurveyJoin *join, const Survey *surveys, LsysRun *run, uint32_t count, ScanBorder *borders) {
  size_t depth = 0, used = 0;
  uint32_t next = LSYS_NO_MODULE;
  for (uint32_t i = count; i-- > 0;) {
    const Survey *survey = &surveys[i];
    size_t opens = survey->opens.count, closes = survey->closes.count;
    borders[i].behind_kind = next;
    borders[i].behind_depth = opens < depth ? opens : depth;
    join->behind = scan_array(run, join->behind, &join->behind_room, used + opens, sizeof *join->behind);
    join->kinds = scan_array(run, join->kinds, &join->kind_room, depth + closes, sizeof *join->kinds);
    copy(join->behind + used, join->kinds + depth - borders[i].behind_depth, borders[i].behind_depth,
         sizeof *join->kinds);
    used += borders[i].behind_depth;
    for (size_t o = 0; o < opens; o++) next = depth ? join->kinds[--depth] : LSYS_NO_MODULE;
    if (survey->next[closes] != LSYS_NO_MODULE) next = survey->next[closes];
    for (size_t c = closes; c-- > 0;) {
      join->kinds[depth++] = next;
      next = survey->next[c];
    }
  }
  const uint32_t *behind = join->behind;
  for (uint32_t i = count; i-- > 0;) {
    borders[i].behind = behind;
    behind += borders[i].behind_depth;
  }
}

void survey_join(SurveyJoin *join, const Survey *surveys, const ScanTables *tables, LsysRun *run,
                 const LsysSegment *segments, uint32_t count, ScanBorder *borders) {
  uint32_t width = window(tables);
  join->left = scan_array(run, join->left, &join->left_room, width, sizeof *join->left);
  Path path = {.join = join, .run = run, .window = width, .left = join->left};
  forget(&path);
  follow_path(&path, surveys, tables, segments, count, borders);
  place_borders(join, count, width, borders);
  if (tables->grammar->flags & LSYS_GRAMMAR_LETTERS) follow_back(join, surveys, run, count, borders);
}

void survey_join_free(SurveyJoin *join, LsysRun *run) {
  scan_array_free(run, join->left, join->left_room, sizeof *join->left);
  scan_array_free(run, join->levels, join->level_room, sizeof *join->levels);
  scan_array_free(run, join->saved, join->saved_room, sizeof *join->saved);
  scan_array_free(run, join->windows, join->window_room, sizeof *join->windows);
  scan_array_free(run, join->fresh, join->fresh_room, sizeof *join->fresh);
  scan_array_free(run, join->behind, join->behind_room, sizeof *join->behind);
  scan_array_free(run, join->kinds, join->kind_room, sizeof *join->kinds);
}
