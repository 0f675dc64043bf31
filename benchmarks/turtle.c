// turtle.c -- words to segments: a derivation flows through the homomorphism,
// where there is one, into a turtle whose segments are counted by the batch and
// not looked at. What derivation alone takes stands beside it.
#include "bench.h"
#include "compile.h"
#include "derive.h"
#include "measure.h"

#include "turtle/turtle.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Row {
  const char *name;
  uint64_t steps;
  bool shown;  // through the homomorphism
  const char *work;
} Row;

static const Row rows[] = {
  {"koch", 8, false, "D0L, 2-D"},
  {"plant", 15, false, "bracketed D0L, 2-D"},
  {"row-of-trees", 21, false, "parametric, 2-D"},
  {"hilbert-3d", 7, false, "D0L, 3-D"},
  {"ternary-tree", 13, false, "parametric, 3-D"},
  {"flowers", 12, true, "homomorphism, 3-D"},
};

typedef struct Drawing {
  LsysSink sink;  // first
  LsysGeometry geometry;
  LsysTurtle *turtle;  // NULL: only modules are counted
  bool draws;
  uint64_t segments, modules;
} Drawing;

typedef struct Job {
  const Row *row;
  const LsysGrammar *grammar;
  bool draws, shown;
  uint64_t segments, modules;
} Job;

static bool count_strokes(LsysGeometry *to, const LsysStrokes *batch) {
  Drawing *drawing = (Drawing *)((char *)to - offsetof(Drawing, geometry));
  drawing->segments += batch->points - batch->count;
  return true;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  Drawing *drawing = (Drawing *)sink;
  if (!drawing->draws) return true;
  drawing->turtle = lsys_turtle_create(run);
  if (drawing->turtle) lsys_turtle_begin(drawing->turtle, axiom, &drawing->geometry);
  return drawing->turtle;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  Drawing *drawing = (Drawing *)sink;
  drawing->modules += part->nsym;
  return !drawing->turtle || lsys_turtle_take(drawing->turtle, part);
}

static bool end(LsysSink *sink) {
  Drawing *drawing = (Drawing *)sink;
  if (!drawing->turtle) return true;
  bool drawn = lsys_turtle_end(drawing->turtle);
  lsys_turtle_destroy(drawing->turtle);
  return drawn;
}

static void destroy(LsysSink *sink) {
  (void)sink;
}

static void run_job(void *data) {
  Job *job = data;
  Drawing drawing = {.sink = {.passes = 1, .begin = begin, .take = take, .end = end, .destroy = destroy},
                     .geometry = {.strokes = count_strokes},
                     .draws = job->draws};
  word_flow(job->grammar, job->row->steps, 0, job->shown, &drawing.sink);
  job->segments = drawing.segments;
  job->modules = drawing.modules;
}

static void print_row(const Options *options, const Job *drawn, const Side *sides) {
  double seconds = median(sides[0].seconds, options->runs), modules = (double)drawn->modules;
  double segments = (double)drawn->segments, share = ratio(&sides[1], &sides[0], options->runs);
  const char *layout = "%-14s %12.0f %12.0f %9.4f %9.1f %9.1f %9.2f   %s\n";
  if (options->json)
    layout = "{\"row\":\"%s\",\"modules\":%.0f,\"segments\":%.0f,\"seconds\":%.6g,\"million_modules_per_second\":%.4g,"
             "\"million_segments_per_second\":%.4g,\"deriving\":%.3g,\"work\":\"%s\"}\n";
  else if (options->markdown)
    layout = "| %s | %.0f | %.0f | %.3f | %.0f | %.0f | %.2f | %s |\n";
  printf(layout, drawn->row->name, modules, segments, seconds, modules / seconds / 1e6, segments / seconds / 1e6, share,
         drawn->row->work);
  fflush(stdout);
}

static void run_row(const Options *options, const Row *row) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s.lsys", options->grammars, row->name);
  Compiled *compiled = compile_grammar(path, options->home);
  Job drawn = {.row = row, .grammar = compiled_grammar(compiled), .draws = true, .shown = row->shown}, derived = drawn;
  derived.draws = derived.shown = false;
  Side sides[] = {{.name = "turtle", .run = run_job, .data = &drawn},
                  {.name = "derivation", .run = run_job, .data = &derived}};
  measure(sides, 2, options->runs);
  print_row(options, &drawn, sides);
  compile_release(compiled);
}

void bench_turtle(const Options *options) {
  if (options->markdown)
    printf("| row | modules | segments | seconds | M modules/s | M segments/s | deriving | work |\n"
           "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  else if (!options->json)
    printf("%-14s %12s %12s %9s %9s %9s %9s\n", "row", "modules", "segments", "seconds", "M mod/s", "M seg/s",
           "deriving");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].name)) run_row(options, &rows[i]);
}
