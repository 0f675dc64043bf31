// spread.c -- see spread.h. Every thread writes what its segments become into
// a store of its own; the next word is a row of stretches of these stores:
//
//   word      | 0 | 1 | 2 | 3 | 4 |
//   store 0   | 0 | 2 | 3 |
//   store 1   | 1 | 4 |
//
// A step has two rounds: all segments are surveyed, then rewritten. Between
// the rounds one thread finds with what a scan enters each of them (survey.h).
#include "core/spread.h"

#include "core/cut.h"
#include "core/pipeline.h"
#include "core/survey.h"

enum { STRIDE = 1 << 10 };  // modules between two places where what is written may be cut

// What is known of a segment beside LsysSegment.
typedef struct Part {
  uint64_t nsym, narg, nkey;
} Part;

// A stretch of a store.
typedef struct Record {
  uint64_t sym, arg, key;  // where it begins
  Part part;
} Record;

// Segments that one thread rewrites one after the other.
typedef struct Group {
  uint32_t first, end;
  unsigned member;               // who did
  size_t first_record, records;  // and what became of them
} Group;

// What a member works with.
typedef struct Share {
  LsysStore words[2];  // take turns
  LsysWriter writer;
  LsysScan scan;
  LsysNeighbour *left;
  Record *records;
  size_t record_count, record_room;
  uint64_t round;  // the step that it writes to words[writes] in
} Share;

struct LsysSpread {
  LsysWorker *worker;
  LsysTeam team;
  ScanTables tables;
  uint64_t stretch;
  Share *shares;
  unsigned writes;  // the store of each share that is written, the other one is read
  uint64_t step, round;
  LsysSegment *segments;
  Part *parts;
  Survey *surveys;
  ScanBorder *borders;
  Group *groups;
  uint32_t count, group_count;
  size_t segment_room, part_room, survey_room, border_room, group_room;
  LsysSkip *skips;
  size_t skip_room;
  SurveyJoin join;
  LsysPipeline *pipeline;
};

bool lsys_spread_applies(const LsysGrammar *grammar) {
  uint32_t barred = LSYS_GRAMMAR_SEQUENTIAL | LSYS_GRAMMAR_RING | LSYS_GRAMMAR_ORDERED | LSYS_GRAMMAR_QUERIES;
  return grammar->step && !grammar->decompose && grammar->view_count == 1 && !(grammar->flags & barred);
}

static LsysRun *run_of(const LsysSpread *s) {
  return &s->worker->run;
}

static const LsysGrammar *grammar_of(const LsysSpread *s) {
  return s->worker->run.grammar;
}

// ---- segments ----------------------------------------------------------------

static void add_segment(LsysSpread *s, LsysSegment segment, Part part) {
  if (s->count == UINT32_MAX) lsys_fail(run_of(s), "the word has too many parts");
  s->segments = scan_array(run_of(s), s->segments, &s->segment_room, s->count + (size_t)1, sizeof *s->segments);
  s->parts = scan_array(run_of(s), s->parts, &s->part_room, s->count + (size_t)1, sizeof *s->parts);
  s->segments[s->count] = segment;
  s->parts[s->count++] = part;
}

// Nothing but symbols can be cut anywhere.
static void add_letters(LsysSpread *s, LsysSegment segment, uint64_t modules) {
  uint64_t pieces = modules / s->stretch, width = lsys_symbol_width(grammar_of(s)), before = 0;
  if (!pieces) pieces = 1;
  for (uint64_t i = 0; i < pieces; i++) {
    uint64_t n = modules / pieces + (i < modules % pieces);
    LsysSegment piece = segment;
    piece.sym = segment.sym + before * width;
    piece.end = piece.sym + n * width;
    add_segment(s, piece, (Part){.nsym = n});
    before += n;
  }
}

void lsys_spread_begin(LsysSpread *s, const LsysWord *word) {
  LsysCut cut;
  lsys_cut_begin(&cut, grammar_of(s), word);
  s->count = 0;
  while (cut.rest.nsym) {
    LsysWord next = lsys_cut_take(&cut, s->stretch);
    const uint8_t *end = next.sym + next.nsym * lsys_symbol_width(grammar_of(s));
    add_segment(s, (LsysSegment){.sym = next.sym, .end = end, .arg = next.arg, .key = next.key},
                (Part){next.nsym, next.narg, next.nkey});
  }
}

uint64_t lsys_spread_modules(const LsysSpread *s) {
  uint64_t sum = 0;
  for (uint32_t i = 0; i < s->count; i++) sum += s->parts[i].nsym;
  return sum;
}

// Neighbouring segments, together of about a stretch.
static void make_groups(LsysSpread *s) {
  s->group_count = 0;
  for (uint32_t i = 0; i < s->count;) {
    Group group = {.first = i};
    for (uint64_t modules = 0; i < s->count && modules < s->stretch; i++) modules += s->parts[i].nsym;
    group.end = i;
    s->groups = scan_array(run_of(s), s->groups, &s->group_room, s->group_count + (size_t)1, sizeof *s->groups);
    s->groups[s->group_count++] = group;
  }
}

// ---- surveying ---------------------------------------------------------------

static void count_skips(LsysMember *member, void *data, uint64_t i) {
  (void)member;
  LsysSpread *s = data;
  for (uint32_t k = s->groups[i].first; k < s->groups[i].end; k++)
    s->segments[k].skip_count = scan_count(&s->segments[k], s->tables.open, s->tables.wide);
}

static bool make_skips(LsysSpread *s) {
  if (s->tables.open == LSYS_NO_MODULE || !(grammar_of(s)->flags & LSYS_GRAMMAR_RIGHT)) return true;
  if (!lsys_team_each(&s->team, s->group_count, count_skips, s)) return false;
  size_t total = 0;
  for (uint32_t i = 0; i < s->count; i++) total += s->segments[i].skip_count;
  s->skips = scan_array(run_of(s), s->skips, &s->skip_room, total + 1, sizeof *s->skips);
  LsysSkip *next = s->skips;
  for (uint32_t i = 0; i < s->count; i++) {
    s->segments[i].skip = next;
    next += s->segments[i].skip_count;
  }
  return true;
}

static void survey_group(const LsysSpread *s, LsysRun *run, uint64_t i) {
  for (uint32_t k = s->groups[i].first; k < s->groups[i].end; k++)
    survey_segment(&s->surveys[k], &s->tables, run, &s->segments[k], k, s->segments[k].arg + s->parts[k].narg);
}

static void survey(LsysMember *member, void *data, uint64_t i) {
  survey_group(data, &member->worker.run, i);
}

// Without brackets there is little to be found, at the borders: other threads would take longer to wake.
static bool survey_all(LsysSpread *s) {
  if (s->tables.open != LSYS_NO_MODULE || s->tables.close != LSYS_NO_MODULE)
    return lsys_team_each(&s->team, s->group_count, survey, s);
  for (uint32_t i = 0; i < s->group_count; i++) survey_group(s, run_of(s), i);
  return true;
}

// The arrays of surveys are kept, but no longer found by scan_array once they moved: new ones begin with zeros.
static void make_surveys(LsysSpread *s) {
  size_t before = s->survey_room;
  s->surveys = scan_array(run_of(s), s->surveys, &s->survey_room, s->count, sizeof *s->surveys);
  for (size_t i = before; i < s->survey_room; i++) s->surveys[i] = (Survey){0};
  s->borders = scan_array(run_of(s), s->borders, &s->border_room, s->count, sizeof *s->borders);
}

static bool prepare(LsysSpread *s, uint64_t step) {
  s->step = step;
  s->round++;
  make_groups(s);
  if (!make_skips(s)) return false;
  make_surveys(s);
  for (unsigned i = 0; i < s->team.count; i++)
    scan_start(&s->shares[i].scan, &s->tables, grammar_of(s)->views, &s->team.members[i].worker.run, s->segments,
               s->count, s->shares[i].left);
  if (!survey_all(s)) return false;
  survey_join(&s->join, s->surveys, &s->tables, run_of(s), s->segments, s->count, s->borders);
  return true;
}

// ---- rewriting ---------------------------------------------------------------

static void open_record(Share *share, LsysRun *run) {
  const LsysStore *store = share->writer.store;
  const LsysStream *out = &share->writer.stream;
  share->records =
    scan_array(run, share->records, &share->record_room, share->record_count + 1, sizeof *share->records);
  share->records[share->record_count] = (Record){
    (uint64_t)(out->sym - store->sym), (uint64_t)(out->arg - store->arg), (uint64_t)(out->key - store->key), {0}};
}

static uint64_t written(const Share *share) {
  const LsysStore *store = share->writer.store;
  return ((uint64_t)(share->writer.stream.sym - store->sym) - share->records[share->record_count].sym) / store->width;
}

static void close_record(Share *share) {
  const LsysStore *store = share->writer.store;
  const LsysStream *out = &share->writer.stream;
  Record *record = &share->records[share->record_count];
  record->part.nsym = written(share);
  record->part.narg = (uint64_t)(out->arg - store->arg) - record->arg;
  record->part.nkey = (uint64_t)(out->key - store->key) - record->key;
  share->record_count += record->part.nsym > 0;
}

// A segment in strides, behind each of which what was written may be cut.
static void rewrite_segment(const LsysSpread *s, Share *share, LsysRun *run) {
  LsysScan *scan = &share->scan;
  const uint8_t *end = scan->end;
  bool whole = grammar_of(s)->flags & LSYS_GRAMMAR_LETTERS;
  size_t stride = (size_t)STRIDE << s->tables.wide;
  while (scan->sym < end) {
    scan->end = whole || (size_t)(end - scan->sym) <= stride ? end : scan->sym + stride;
    grammar_of(s)->step(scan, &share->writer.stream);
    if (written(share) < s->stretch) continue;
    close_record(share);
    open_record(share, run);
  }
}

static void enter(LsysSpread *s, Share *share, const LsysMember *member, uint32_t segment) {
  share->scan.run = (LsysRun *)&member->worker.run;
  share->scan.step = s->step;
  scan_enter(&share->scan, segment, &s->borders[segment]);
}

static void rewrite(LsysMember *member, void *data, uint64_t i) {
  LsysSpread *s = data;
  Share *share = &s->shares[member->number];
  Group *group = &s->groups[i];
  share->writer.stream.stack_limit = member->worker.stack_limit;
  if (share->round != s->round) {
    lsys_writer_enter(&share->writer, &share->words[s->writes]);
    share->round = s->round;
    share->record_count = 0;
  }
  group->member = member->number;
  group->first_record = share->record_count;
  open_record(share, &member->worker.run);
  for (uint32_t k = group->first; k < group->end; k++) {
    enter(s, share, member, k);
    rewrite_segment(s, share, &member->worker.run);
  }
  close_record(share);
  group->records = share->record_count - group->first_record;
}

// What the groups became, in their order, is the word now.
static void collect(LsysSpread *s) {
  for (unsigned i = 0; i < s->team.count; i++)
    if (s->shares[i].round == s->round) lsys_writer_leave(&s->shares[i].writer);
  s->count = 0;
  for (uint32_t g = 0; g < s->group_count; g++) {
    const Group *group = &s->groups[g];
    const Share *share = &s->shares[group->member];
    const LsysStore *store = &share->words[s->writes];
    for (size_t r = 0; r < group->records; r++) {
      const Record *record = &share->records[group->first_record + r];
      const uint8_t *sym = store->sym + record->sym;
      LsysSegment segment = {
        sym, sym + record->part.nsym * store->width, store->arg + record->arg, store->key + record->key, NULL, 0};
      if (record->part.narg || record->part.nkey)
        add_segment(s, segment, record->part);
      else
        add_letters(s, segment, record->part.nsym);
    }
  }
  s->writes = !s->writes;
}

bool lsys_spread_step(LsysSpread *s, uint64_t step) {
  if (!s->count) return true;
  if (!prepare(s, step) || !lsys_team_each(&s->team, s->group_count, rewrite, s)) return false;
  collect(s);
  return true;
}

// ---- the last word -------------------------------------------------------------

static void write_group(LsysMember *member, void *data, uint64_t i, LsysStream *out) {
  LsysSpread *s = data;
  Share *share = &s->shares[member->number];
  for (uint32_t k = s->groups[i].first; k < s->groups[i].end; k++) {
    enter(s, share, member, k);
    grammar_of(s)->step(&share->scan, out);
  }
  lsys_flush(out);
}

static LsysWord word_of(const LsysSpread *s, uint32_t i) {
  const LsysSegment *at = &s->segments[i];
  const Part *part = &s->parts[i];
  return (LsysWord){at->sym, at->arg, at->key, part->nsym, part->narg, part->nkey};
}

static void show_group(LsysMember *member, void *data, uint64_t i, LsysStream *out) {
  (void)member;
  const LsysSpread *s = data;
  for (uint32_t k = s->groups[i].first; k < s->groups[i].end; k++) {
    LsysWord word = word_of(s, k);
    lsys_writer_pass((LsysWriter *)out, &word);
  }
}

bool lsys_spread_each(const LsysSpread *s, LsysSink *sink) {
  for (uint32_t i = 0; i < s->count; i++) {
    LsysWord word = word_of(s, i);
    if (!sink->take(sink, &word)) return false;
  }
  return true;
}

static bool flow(LsysSpread *s, LsysSink *sink, LsysPipelineWrite *write) {
  if (!lsys_pipeline_open(&s->pipeline, &s->team, sink, 0, write, s)) return false;
  for (uint32_t i = 0; i < s->group_count; i++)
    if (!lsys_pipeline_add(s->pipeline, NULL)) return false;
  return lsys_pipeline_finish(s->pipeline);
}

bool lsys_spread_finish(LsysSpread *s, uint64_t step, LsysSink *sink) {
  return !s->count || (prepare(s, step) && flow(s, sink, write_group));
}

bool lsys_spread_show(LsysSpread *s, LsysSink *sink) {
  make_groups(s);
  return flow(s, sink, show_group);
}

// ---- opening and closing -----------------------------------------------------------

bool lsys_spread_open(LsysSpread **place, LsysWorker *worker, unsigned threads, uint64_t stretch) {
  const LsysGrammar *grammar = worker->run.grammar;
  LsysMemory *memory = worker->memory;
  LsysSpread *s = *place = lsys_memory_alloc(memory, 1, sizeof *s);
  if (!s) return false;
  s->worker = worker;
  s->stretch = stretch;
  if (!lsys_team_open(&s->team, worker, threads) || !scan_tables(&s->tables, grammar, memory)) return false;
  s->shares = lsys_memory_alloc(memory, threads, sizeof *s->shares);
  for (unsigned i = 0; s->shares && i < threads; i++) {
    Share *share = &s->shares[i];
    for (int k = 0; k < 2; k++) lsys_store_open(&share->words[k], grammar, memory);
    share->left = lsys_memory_alloc(memory, grammar->left_window, sizeof *share->left);
    if (!share->left || !lsys_writer_open(&share->writer, &s->team.members[i].worker, NULL)) return false;
  }
  return s->shares;
}

static void close_share(const LsysSpread *s, Share *share) {
  LsysRun *run = run_of(s);
  LsysMemory *memory = s->worker->memory;
  for (int k = 0; k < 2; k++)
    if (share->words[k].memory) lsys_store_close(&share->words[k]);
  if (share->writer.stream.run) lsys_writer_close(&share->writer);
  scan_free(&share->scan, run);
  scan_array_free(run, share->records, share->record_room, sizeof *share->records);
  lsys_memory_free(memory, share->left, grammar_of(s)->left_window, sizeof *share->left);
}

void lsys_spread_close(LsysSpread *s) {
  if (!s) return;
  LsysRun *run = run_of(s);
  LsysMemory *memory = s->worker->memory;
  lsys_pipeline_close(s->pipeline);
  for (unsigned i = 0; s->shares && i < s->team.count; i++) close_share(s, &s->shares[i]);
  lsys_memory_free(memory, s->shares, s->team.count, sizeof *s->shares);
  for (size_t i = 0; i < s->survey_room; i++) survey_free(&s->surveys[i], run);
  scan_array_free(run, s->surveys, s->survey_room, sizeof *s->surveys);
  scan_array_free(run, s->segments, s->segment_room, sizeof *s->segments);
  scan_array_free(run, s->parts, s->part_room, sizeof *s->parts);
  scan_array_free(run, s->borders, s->border_room, sizeof *s->borders);
  scan_array_free(run, s->groups, s->group_room, sizeof *s->groups);
  scan_array_free(run, s->skips, s->skip_room, sizeof *s->skips);
  survey_join_free(&s->join, run);
  scan_tables_free(&s->tables);
  if (s->team.worker) lsys_team_close(&s->team);
  lsys_memory_free(memory, s, 1, sizeof *s);
}
