// figure.c -- --stats of words that nobody can walk through: counts by the
// growth matrix, the figure by composing its parts over (kind, step).
//
// Numbers beyond 2^53 are rounded. The rows are those of stats.c that can be told so: segments, polygons, length,
// low, high (of figures in the page, where turns are no whole parts of a circle a little larger than the figure; in
// space of those that turn by right angles) and end.
#include "sinks/figure.h"

#include "core/growth.h"
#include "core/message.h"
#include "lsys/number.h"
#include "sinks/stats.h"
#include "turtle/parts.h"
#include "turtle/vector.h"

static void print_number(LsysOut *out, const char *name, double number) {
  char text[LSYS_NUMBER_SIZE];
  lsys_out_print(out, "%s\t%.*s\n", name, (int)(lsys_number_print(text, number) - text), text);
}

static bool print_figure(LsysParts *parts, uint32_t axiom, LsysOut *out) {
  LsysPose start;
  LsysPart whole;
  if (!lsys_parts_figure(parts, axiom, &start, &whole)) return false;
  LsysVec3 low, high;
  print_number(out, "segments", whole.segments);
  print_number(out, "polygons", whole.polygons);
  print_number(out, "length", whole.length);
  if (lsys_support_box(&parts->directions, whole.support, &low, &high) && isfinite(vec_reach(low))
      && isfinite(vec_reach(high))) {
    lsys_stats_point(out, "low", low);
    lsys_stats_point(out, "high", high);
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
