// figure.c -- --stats of words that nobody can walk through: counts by the
// growth matrix, the figure by composing its parts over (kind, step).
//
// Numbers beyond 2^53 are rounded. The rows are those of stats.c that can be told so: segments, polygons, length,
// low, high (of figures in the page; where turns are no whole parts of a circle
// the box is a little larger than the figure) and end.
#include "sinks/figure.h"

#include "core/growth.h"
#include "core/message.h"
#include "lsys/number.h"
#include "sinks/stats.h"
#include "turtle/parts.h"

#include <math.h>

static void print_number(LsysOut *out, const char *name, double number) {
  char text[LSYS_NUMBER_SIZE];
  lsys_out_print(out, "%s\t%.*s\n", name, (int)(lsys_number_print(text, number) - text), text);
}

static bool print_figure(LsysParts *parts, uint32_t axiom, LsysOut *out) {
  LsysPose start;
  LsysPart whole;
  if (!lsys_parts_figure(parts, axiom, &start, &whole)) return false;
  const uint32_t n = parts->directions;
  const double *support = whole.support;
  print_number(out, "segments", whole.segments);
  print_number(out, "polygons", whole.polygons);
  print_number(out, "length", whole.length);
  if (n && support[0] > -INFINITY) {
    lsys_stats_point(out, "low", (LsysVec3){0 - support[n / 2], 0 - support[3 * n / 4], 0});
    lsys_stats_point(out, "high", (LsysVec3){support[0], support[n / 4], 0});
  }
  return lsys_stats_point(out, "end", whole.exit.at);
}

bool lsys_figure_print(LsysDerivation *d, LsysOut *out, bool *known) {
  LsysParts parts;
  *known = false;
  if (!lsys_derivation_blocks(d)) return false;
  const char *why = lsys_parts_create(&parts, &d->worker.run);
  if (why) return *why;  // "": an error was printed
  *known = true;
  bool well = true;
  for (uint32_t axiom = d->first_axiom; well && axiom < d->axiom_end; axiom++)
    well = lsys_growth_print(d, axiom, out) && print_figure(&parts, axiom, out);
  lsys_parts_destroy(&parts);
  return well;
}
