// shared.c -- --shared: from the command line to a file of shared parts, or drawn
// from them, without deriving a word.
#include "sinks/shared.h"

#include "core/fit.h"
#include "core/message.h"

#include <math.h>
#include <string.h>

typedef struct Task {
  LsysDerivation *derivation;
  LsysParts *parts;
  const LsysOptions *options;
  LsysOut *out;
} Task;

// ---- formats -----------------------------------------------------------------

static bool read_picture(const Task *t, LsysPictureOptions *picture) {
  return lsys_picture_options(t->options, t->derivation->worker.run.grammar, picture);
}

static bool write_svg(const Task *t) {
  LsysPictureOptions picture;
  return read_picture(t, &picture)
      && lsys_shared_svg(t->parts, t->derivation->first_axiom, t->derivation->axiom_end, &picture, t->out);
}

static bool write_png(const Task *t) {
  LsysPictureOptions picture;
  return read_picture(t, &picture)
      && lsys_shared_png(t->parts, t->derivation->first_axiom, t->derivation->axiom_end, &picture, t->out);
}

static bool write_glb(const Task *t) {
  LsysModelOptions model;
  return lsys_model_options(t->options, &model)
      && lsys_shared_glb(t->parts, t->derivation->first_axiom, t->derivation->axiom_end, &model, t->out);
}

typedef struct Format {
  const char *name;
  bool (*write)(const Task *task);
  uint64_t deepest;  // number of steps
  double worth;      // modules from which on it is taken without being asked for
  bool flat;         // figures in space cannot be written so,
  bool other_ways;   //   and those that cannot may be drawn segment by segment, as long as that takes
} Format;

static const Format formats[] = {
  {"svg", write_svg, UINT64_MAX, LSYS_FIT_MINUTES, true, false},
  {"glb", write_glb, UINT64_MAX, LSYS_FIT_MINUTES, false, false},
  {"png", write_png, LSYS_SHARED_DEPTH, 1e9, true, true},
};

static const Format *format_named(const char *name) {
  for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
    if (strcmp(formats[i].name, name) == 0) return &formats[i];
  return NULL;
}

double lsys_shared_worth(const LsysSinkContext *context) {
  const LsysOptionValue *path = &context->options->at[LSYS_OPTION_OUTPUT];
  const LsysOptionValue *name = &context->options->at[LSYS_OPTION_FORMAT];
  const char *dot = path->given ? strrchr(path->text, '.') : NULL;
  const Format *format = format_named(name->given ? name->text : dot ? dot + 1 : "");
  return format ? format->worth : INFINITY;
}

// ---- all together ------------------------------------------------------------

bool lsys_shared_measure(LsysParts *parts, uint32_t axiom, LsysLayout *layout, LsysPose *start) {
  LsysPart whole;
  if (!lsys_parts_figure(parts, axiom, start, &whole)) return false;
  LsysMeasure m = {.segments = whole.segments < 1e18 ? (uint64_t)whole.segments : UINT64_C(1000000000000000000),
                   .length = whole.segments < 1e18 ? whole.length : whole.length / whole.segments * 1e18,
                   .thinnest = start->width,
                   .thickest = start->width};
  if (!lsys_support_box(&parts->directions, whole.support, &m.low, &m.high)) return true;
  m.odd = !isfinite(m.low.x + m.low.y + m.high.x + m.high.y);
  return lsys_layout_add(layout, axiom, &m);
}

static bool write_file(const Format *format, Task *t) {
  const LsysOptionValue *path = &t->options->at[LSYS_OPTION_OUTPUT];
  t->out = lsys_out_open(path->given ? path->text : "-");
  if (!t->out) return false;
  lsys_format_tell_idle(lsys_format_find(format->name, "-"), t->options);
  if (format->write(t)) return lsys_out_commit(t->out);
  lsys_out_abandon(t->out);
  return false;
}

static const char *why_not(const Format *format, const LsysParts *parts) {
  if (parts->steps > format->deepest) return "of its number of steps";
  if (!format->flat) return NULL;
  if (!parts->directions.flat) return "it is a figure in space, for which only glb has any";
  return parts->directions.count ? NULL : "its turns lead to too many directions";
}

static bool run(const Format *format, Task *t, bool asked, bool *done) {
  LsysParts parts;
  if (!lsys_derivation_blocks(t->derivation)) return false;
  const char *why = lsys_parts_create(&parts, &t->derivation->worker.run);
  bool created = !why;
  if (created) why = why_not(format, &parts);
  bool well = !why;
  *done = well || asked || !format->other_ways || !*why;
  if (why && *why && *done) lsys_error("--shared: the figure has no shared parts, because %s", why);
  if (well && !asked)
    lsys_note("the word has %.3g modules: the figure is written as parts that it shares (--shared)",
              lsys_fit_modules(t->derivation));
  t->parts = &parts;
  if (well) well = write_file(format, t);
  if (created) lsys_parts_destroy(&parts);
  return well || !*done;
}

bool lsys_shared_run(LsysDerivation *derivation, const LsysSinkContext *context, bool asked, bool *done) {
  const LsysOptionValue *path = &context->options->at[LSYS_OPTION_OUTPUT];
  const LsysOptionValue *name = &context->options->at[LSYS_OPTION_FORMAT];
  const LsysFormat *wanted = lsys_format_find(name->text, path->given ? path->text : "-");
  *done = true;
  if (!wanted) return false;
  const Format *format = format_named(wanted->name);
  if (!format) {
    lsys_error("--shared: only svg, png and glb can share parts");
    return false;
  }
  LsysColours colours;
  if (!lsys_colours_read(context->options, &colours)) return false;
  if (colours.by != LSYS_BY_PEN) {
    lsys_error("--shared: what is written once has one colour each: --colour-by pen is all there is");
    return false;
  }
  Task task = {.derivation = derivation, .options = context->options};
  return run(format, &task, asked, done);
}
