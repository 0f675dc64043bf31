// stats.c -- what the turtle draws, in numbers: the rows that --stats adds to those of --count.
//
//   segments<TAB>n   polygons<TAB>n   colour N<TAB>n for each colour in use   length<TAB>x
//   low<TAB>x y z    high<TAB>x y z (the bounding box; left out if nothing is drawn)   end<TAB>x y z
#include "core/formats.h"
#include "lsys/number.h"
#include "turtle/measure.h"
#include "turtle/turtle.h"

#include <stdio.h>

typedef struct StatsSink {
  LsysSink sink;
  LsysMemory *memory;
  LsysOut *out;
  LsysTurtle *turtle;
  LsysMeasure measure;
} StatsSink;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  StatsSink *stats = (StatsSink *)sink;
  lsys_measure_begin(&stats->measure, true);
  lsys_turtle_destroy(stats->turtle);
  stats->turtle = lsys_turtle_create(run);
  if (stats->turtle) lsys_turtle_begin(stats->turtle, axiom, &stats->measure.geometry);
  return stats->turtle;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((StatsSink *)sink)->turtle, part);
}

static bool print_point(LsysOut *out, const char *name, LsysVec3 point) {
  char text[3 * (LSYS_NUMBER_SIZE + 1)], *at = text;
  double numbers[3] = {point.x, point.y, point.z};
  for (int i = 0; i < 3; i++) {
    at = lsys_number_print(at, numbers[i]);
    *at++ = i < 2 ? ' ' : '\n';
  }
  return lsys_out_print(out, "%s\t%.*s", name, (int)(at - text), text);
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
    print_point(out, "low", measure->low);
    print_point(out, "high", measure->high);
  }
  return print_point(out, "end", lsys_turtle_position(stats->turtle));
}

static bool end(LsysSink *sink) {
  StatsSink *stats = (StatsSink *)sink;
  return lsys_turtle_end(stats->turtle) && print_rows(stats);
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  StatsSink *stats = (StatsSink *)sink;
  lsys_turtle_destroy(stats->turtle);
  lsys_memory_free(stats->memory, stats, 1, sizeof *stats);
}

LsysSink *lsys_sink_stats(const LsysSinkContext *context) {
  StatsSink *stats = lsys_memory_alloc(context->memory, 1, sizeof *stats);
  if (!stats) return NULL;
  stats->sink = (LsysSink){1, begin, take, end, finish, destroy};
  stats->memory = context->memory;
  stats->out = context->out;
  return &stats->sink;
}
