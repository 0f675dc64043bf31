// words.c -- every row derives a word by the compiled grammar and by C written
// for that grammar, compares the two byte for byte, and then times both beside
// a memcpy of the same bytes, in turns.
#include "bench.h"
#include "compile.h"
#include "derive.h"
#include "measure.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Row {
  const char *name;
  uint64_t steps, seed;
  Baseline baseline;
  const char *work;
} Row;

static const Row rows[] = {
#define ROW(name, steps, seed, baseline, work) {name, steps, seed, baseline, work},
#include "rows.def"
#undef ROW
};

typedef struct Contest {
  const Row *row;
  const LsysGrammar *grammar;
  LsysWhole ours;
  Packed theirs;
  uint8_t *from, *to;  // of the memcpy
  size_t bytes;        // of symbols and arguments together
  bool cold;           // the first write to every page is part of the time
  uint64_t sum;
} Contest;

static void before_ours(void *data) {
  Contest *contest = data;
  if (!contest->cold) return;
  forget_pages(contest->ours.sym, contest->bytes);
}

static void before_theirs(void *data) {
  Contest *contest = data;
  contest->theirs.warm = !contest->cold;
  if (contest->cold) forget_pages(contest->theirs.sym, contest->bytes);
}

static void before_copy(void *data) {
  Contest *contest = data;
  if (contest->cold) forget_pages(contest->to, contest->bytes);
}

static void run_ours(void *data) {
  Contest *contest = data;
  word_store(contest->grammar, contest->row->steps, contest->row->seed, &contest->ours);
}

static void run_theirs(void *data) {
  Contest *contest = data;
  contest->row->baseline(&contest->theirs, (unsigned)contest->row->steps, contest->row->seed);
}

static void run_copy(void *data) {
  Contest *contest = data;
  memcpy(contest->to, contest->from, contest->bytes);
}

static void run_stream(void *data) {
  Contest *contest = data;
  contest->sum = word_stream(contest->grammar, contest->row->steps, contest->row->seed).sum;
}

// Symbols and arguments in one mapping, so that both sides touch the same number of pages.
static LsysWhole word_memory(size_t nsym, size_t narg, size_t *bytes) {
  size_t symbols = (nsym + 64) & ~(size_t)63, arguments = narg * sizeof(double);
  *bytes = symbols + arguments + 64;
  uint8_t *at = fresh_pages(*bytes);
  return (LsysWhole){
    .sym = at, .arg = (double *)(void *)(at + symbols), .sym_bytes = symbols, .arg_bytes = arguments, .given = true};
}

static bool same(const LsysWhole *a, const Packed *b) {
  return a->nsym == b->nsym && a->narg == b->narg && memcmp(a->sym, b->sym, a->nsym) == 0
      && memcmp(a->arg, b->arg, a->narg * sizeof(double)) == 0;
}

static void print_row(const Options *options, const Contest *contest, const char *pages, Side *sides, unsigned runs) {
  double modules = (double)contest->ours.nsym, ours = median(sides[0].seconds, runs);
  double theirs = ratio(&sides[1], &sides[0], runs), copy = ratio(&sides[2], &sides[0], runs);
  if (options->json)
    printf("{\"row\":\"%s\",\"work\":\"%s\",\"pages\":\"%s\",\"steps\":%" PRIu64 ",\"modules\":%.0f,\"bytes\":%zu,"
           "\"seconds\":%.6g,\"modules_per_second\":%.6g,\"times_c\":%.4g,\"times_memcpy\":%.4g}\n",
           contest->row->name, contest->row->work, pages, contest->row->steps, modules, contest->bytes, ours,
           modules / ours, theirs, copy);
  else if (options->markdown)
    printf("| %s | %s | %s | %.0f | %.0f | %.2f | %.2f |\n", contest->row->name, contest->row->work, pages, modules,
           modules / ours / 1e6, theirs, copy);
  else
    printf("%-14s %-5s %12.0f %8.1f %9.1f %9.2f %9.2f   %s\n", contest->row->name, pages, modules,
           (double)contest->bytes / 1e6, modules / ours / 1e6, theirs, copy, contest->row->work);
  fflush(stdout);
}

static void time_row(const Options *options, Contest *contest) {
  for (int cold = 1; cold >= 0; cold--) {
    contest->cold = cold;
    Side sides[] = {{.name = "lsysc", .before = before_ours, .run = run_ours, .data = contest},
                    {.name = "C", .before = before_theirs, .run = run_theirs, .data = contest},
                    {.name = "memcpy", .before = before_copy, .run = run_copy, .data = contest}};
    measure(sides, 3, options->runs);
    print_row(options, contest, cold ? "first" : "warm", sides, options->runs);
  }
  Side stream[] = {{.name = "stream", .run = run_stream, .data = contest},
                   {.name = "C", .before = before_theirs, .run = run_theirs, .data = contest},
                   {.name = "memcpy", .before = before_copy, .run = run_copy, .data = contest}};
  measure(stream, 3, options->runs);
  print_row(options, contest, "sum", stream, options->runs);
}

static void run_row(const Options *options, const Row *row) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, row->name);
  Compiled *compiled = compile_grammar(path, options->home);
  Contest contest = {.row = row, .grammar = compiled_grammar(compiled)};
  size_t nsym, narg;
  word_size(contest.grammar, row->steps, row->seed, &nsym, &narg);
  contest.ours = word_memory(nsym, narg, &contest.bytes);
  LsysWhole theirs = word_memory(nsym, narg, &contest.bytes);
  contest.theirs = (Packed){.sym = theirs.sym, .arg = theirs.arg};
  contest.from = fresh_pages(contest.bytes);
  contest.to = fresh_pages(contest.bytes);
  memset(contest.from, 1, contest.bytes);
  run_ours(&contest);
  run_theirs(&contest);
  if (same(&contest.ours, &contest.theirs)) {
    time_row(options, &contest);
  } else {
    fprintf(stderr, "bench: %s: lsysc and the baseline give different words (%" PRIu64 " and %zu modules)\n", row->name,
            contest.ours.nsym, contest.theirs.nsym);
    exit(1);
  }
  release_pages(contest.ours.sym, contest.bytes);
  release_pages(contest.theirs.sym, contest.bytes);
  release_pages(contest.from, contest.bytes);
  release_pages(contest.to, contest.bytes);
  compile_release(compiled);
}

void bench_words(const Options *options) {
  if (options->markdown)
    printf("| row | work | pages | modules | M modules/s | times C | x memcpy |\n"
           "| --- | --- | --- | --- | --- | --- | --- |\n");
  else if (!options->json)
    printf("%-14s %-5s %12s %8s %9s %9s %9s\n", "row", "pages", "modules", "MB", "M mod/s", "times C", "x memcpy");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].name)) run_row(options, &rows[i]);
}
