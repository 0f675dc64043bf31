// model.c -- words to models: measured first, so that widths become lengths and
// tubes get as many sides as the model can bear; then drawn through tubes.c.
// Several start words stand side by side.
#include "sinks/model.h"

#include "core/message.h"
#include "sinks/gauge.h"
#include "sinks/layout.h"
#include "sinks/tubes.h"
#include "turtle/turtle.h"
#include "turtle/vector.h"

#include <math.h>
#include <stdlib.h>

enum { FEW_SEGMENTS = 20000, SOME_SEGMENTS = 60000, MANY_SEGMENTS = 300000 };

typedef struct ModelSink {
  LsysSink sink;
  LsysModel *model;
  LsysModelOptions options;
  const LsysGrammar *grammar;  // NULL before the first start word
  LsysTurtle *turtle;
  LsysGauge gauge;
  LsysLayout layout;
  LsysPalette palette;
  LsysRecolour recolour;
  LsysTubes tubes;
  uint32_t current;
  bool open, drawing;
} ModelSink;

// Fewer sides the more segments there are; a figure in the page, or a huge one, is lines.
static uint32_t choose_sides(const ModelSink *m) {
  if (m->options.sides) return m->options.sides;
  uint64_t segments = m->layout.segments;
  if (lsys_turtle_flat(m->turtle) || segments > MANY_SEGMENTS) return 1;
  return segments > SOME_SEGMENTS ? 4 : segments > FEW_SEGMENTS ? 6 : 8;
}

// Models hold 32-bit numbers, and what is done with them squares them.
static bool check_reach(const ModelSink *m) {
  const double most = 1e18, thick = m->layout.thickest * m->tubes.width;
  for (uint32_t i = 0; i < m->layout.figures; i++) {
    const LsysFigure *f = &m->layout.figure[i];
    double reach = fmax(fmax(vec_reach(f->low), vec_reach(f->high)), thick);
    if (!f->drawn || reach <= most) continue;
    lsys_error("the figure of axiom %u reaches to %g: a model holds numbers up to %g", i + 1, reach, most);
    return false;
  }
  return true;
}

static bool open_model(ModelSink *m) {
  LsysPictureOptions options = lsys_picture_defaults;
  options.line_width = m->options.line_width;
  LsysPage page = {.solid = true};
  lsys_layout_fit(&m->layout, &options, &page);
  m->tubes.width = lsys_turtle_widths_are_lengths(m->turtle) ? 1 : m->layout.unit / m->layout.scale;
  m->tubes.sides = choose_sides(m);
  if (!check_reach(m)) return false;
  m->open = true;
  lsys_palette_make(&m->palette, &m->options.colours, m->grammar, true);
  return m->model->open(m->model, &m->palette);
}

// The first figure stays where the turtle drew it; the others move beside it.
static LsysVec3 shift_of(const ModelSink *m) {
  const LsysFigure *f = m->layout.figure;
  uint32_t first = 0;
  while (first < m->current && !f[first].drawn) first++;
  double x = (f[m->current].x - f[first].x) / m->layout.scale;
  return (LsysVec3){f[m->current].drawn ? x : 0, 0, 0};
}

static bool start(ModelSink *m, const LsysRun *run) {
  if (m->turtle) return true;
  if (!lsys_layout_create(&m->layout, run->grammar->axiom_count)) return false;
  m->grammar = run->grammar;
  m->tubes.memory = m->model->memory = run->memory;
  m->model->threads = run->threads;
  m->turtle = lsys_turtle_create(run);
  return m->turtle != NULL;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  ModelSink *m = (ModelSink *)sink;
  if (!start(m, run)) return false;
  m->current = axiom;
  m->drawing = pass == 1;
  if (!m->drawing) {
    LsysGeometry *gauge = lsys_gauge_begin(&m->gauge, run->memory, run->threads);
    if (gauge) lsys_turtle_begin(m->turtle, axiom, gauge);
    return gauge;
  }
  lsys_gauge_close(&m->gauge);
  if (!m->open && !open_model(m)) return false;
  m->tubes.shift = shift_of(m);
  if (m->model->group && !m->model->group(m->model, axiom)) return false;
  uint64_t segments = m->layout.figure[axiom].segments;
  LsysGeometry *to =
    lsys_recolour_begin(&m->recolour, &m->options.colours, segments, run->steps, m->turtle, &m->tubes.geometry);
  lsys_turtle_begin(m->turtle, axiom, to);
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((ModelSink *)sink)->turtle, part);
}

static bool end(LsysSink *sink) {
  ModelSink *m = (ModelSink *)sink;
  if (!lsys_turtle_end(m->turtle)) return false;
  if (m->drawing) return lsys_tubes_flush(&m->tubes);
  return lsys_gauge_end(&m->gauge) && lsys_layout_add(&m->layout, m->current, &m->gauge.measure);
}

static bool finish(LsysSink *sink) {
  ModelSink *m = (ModelSink *)sink;
  if (!m->options.film) lsys_layout_tell_empty(&m->layout);
  return (m->open || open_model(m)) && m->model->close(m->model);
}

static void destroy(LsysSink *sink) {
  ModelSink *m = (ModelSink *)sink;
  lsys_turtle_destroy(m->turtle);
  lsys_layout_destroy(&m->layout);
  lsys_tubes_destroy(&m->tubes);
  lsys_gauge_close(&m->gauge);
  m->model->destroy(m->model);
  free(m);
}

LsysSink *lsys_model_create(LsysModel *model, const LsysModelOptions *options) {
  ModelSink *m = calloc(1, sizeof *m);
  if (!m || !lsys_tubes_create(&m->tubes, model)) {
    if (!m) lsys_error("out of memory");
    free(m);
    model->destroy(model);
    return NULL;
  }
  m->sink = (LsysSink){.passes = 2, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  m->model = model;
  m->options = *options;
  return &m->sink;
}
