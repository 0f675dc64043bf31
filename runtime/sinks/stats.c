// stats.c -- what the turtle draws, in numbers: the rows that --stats adds to those of --count.
//
//   segments<TAB>n   polygons<TAB>n   colour N<TAB>n for each colour in use   length<TAB>x
//   low<TAB>x y z    high<TAB>x y z (the bounding box; left out if nothing is drawn)   end<TAB>x y z
//   places<TAB>n (different ones that segments end at; left out if there are too many)
// and of a word with branches:
//   order N<TAB>segments   axes N<TAB>n (Gravelius orders, the trunk 1)   strahler<TAB>order
//   streams N<TAB>n   ratio N<TAB>streams N / streams N+1 (Horton-Strahler orders, twigs 1)
#include "sinks/stats.h"

#include "core/formats.h"
#include "lsys/number.h"
#include "turtle/measure.h"
#include "turtle/places.h"
#include "turtle/tree.h"
#include "turtle/turtle.h"

#include <stdio.h>

typedef struct StatsSink {
  LsysSink sink;
  LsysMemory *memory;
  LsysOut *out;
  LsysTurtle *turtle;
  LsysMeasure measure;
  LsysPlaces places;
  LsysTree *tree;
} StatsSink;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  StatsSink *stats = (StatsSink *)sink;
  lsys_measure_begin(&stats->measure, true);
  lsys_turtle_destroy(stats->turtle);
  stats->turtle = lsys_turtle_create(run);
  if (!stats->tree) stats->tree = lsys_tree_create(run);
  if (!stats->turtle || !stats->tree) return false;
  lsys_places_free(&stats->places);
  lsys_places_begin(&stats->places, stats->memory, &stats->measure.geometry);
  lsys_turtle_begin(stats->turtle, axiom, &stats->places.geometry);
  lsys_tree_begin(stats->tree);
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  StatsSink *stats = (StatsSink *)sink;
  return lsys_turtle_take(stats->turtle, part) && lsys_tree_take(stats->tree, part);
}

bool lsys_stats_point(LsysOut *out, const char *name, LsysVec3 point) {
  char text[3 * (LSYS_NUMBER_SIZE + 1)], *at = text;
  double numbers[3] = {point.x, point.y, point.z};
  for (int i = 0; i < 3; i++) {
    at = lsys_number_print(at, numbers[i]);
    *at++ = i < 2 ? ' ' : '\n';
  }
  return lsys_out_print(out, "%s\t%.*s", name, (int)(at - text), text);
}

// What branches: nothing is said of a single axis.
static void print_orders(LsysOut *out, const LsysTreeOrders *orders) {
  if (!orders->axes[2]) return;
  for (int i = 1; i <= LSYS_TREE_ORDERS; i++)
    if (orders->axes[i])
      lsys_out_print(out, "order %d\t%llu\naxes %d\t%llu\n", i, (unsigned long long)orders->segments[i], i,
                     (unsigned long long)orders->axes[i]);
  lsys_out_print(out, "strahler\t%u\n", orders->strahler);
  for (int i = 1; i <= LSYS_TREE_ORDERS && orders->streams[i]; i++) {
    lsys_out_print(out, "streams %d\t%llu\n", i, (unsigned long long)orders->streams[i]);
    if (i < LSYS_TREE_ORDERS && orders->streams[i + 1])
      lsys_out_print(out, "ratio %d\t%.4g\n", i, (double)orders->streams[i] / (double)orders->streams[i + 1]);
  }
}

static bool print_rows(const StatsSink *stats) {
  const LsysMeasure *measure = &stats->measure;
  LsysOut *out = stats->out;
  char length[LSYS_NUMBER_SIZE];
  lsys_out_print(out, "segments\t%llu\npolygons\t%llu\n", (unsigned long long)measure->segments,
                 (unsigned long long)measure->polygons);
  for (int colour = 0; colour < 256; colour++)
    if (measure->of_colour[colour])
      lsys_out_print(out, "colour %d\t%llu\n", colour, (unsigned long long)measure->of_colour[colour]);
  lsys_out_print(out, "length\t%.*s\n", (int)(lsys_number_print(length, measure->length) - length), length);
  if (lsys_measure_any(measure)) {
    lsys_stats_point(out, "low", measure->low);
    lsys_stats_point(out, "high", measure->high);
  }
  lsys_stats_point(out, "end", lsys_turtle_position(stats->turtle));
  if (measure->segments && !stats->places.full)
    lsys_out_print(out, "places\t%llu\n", (unsigned long long)stats->places.count);
  print_orders(out, lsys_tree_orders(stats->tree));
  return lsys_out_write(out, "", 0);
}

static bool end(LsysSink *sink) {
  StatsSink *stats = (StatsSink *)sink;
  if (!lsys_turtle_end(stats->turtle)) return false;
  lsys_tree_end(stats->tree);
  return print_rows(stats);
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  StatsSink *stats = (StatsSink *)sink;
  lsys_turtle_destroy(stats->turtle);
  lsys_places_free(&stats->places);
  lsys_tree_destroy(stats->tree);
  lsys_memory_free(stats->memory, stats, 1, sizeof *stats);
}

LsysSink *lsys_sink_stats(const LsysSinkContext *context) {
  StatsSink *stats = lsys_memory_alloc(context->memory, 1, sizeof *stats);
  if (!stats) return NULL;
  stats->sink = (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  stats->memory = context->memory;
  stats->out = context->out;
  return &stats->sink;
}
