// shared.c -- --shared: from the command line to a file of shared parts, without
// deriving a word.
#include "sinks/shared.h"

#include "core/message.h"

#include <string.h>

static bool write_svg(LsysDerivation *d, LsysParts *parts, const LsysOptions *options, LsysOut *out) {
  LsysPictureOptions picture;
  if (!lsys_picture_options(options, d->worker.run.grammar, &picture)) return false;
  if (parts->directions.flat) return lsys_shared_svg(parts, d->first_axiom, d->axiom_end, &picture, out);
  lsys_error("--shared: a figure in space has no shared parts as SVG; write a .glb");
  return false;
}

static bool write_glb(LsysDerivation *d, LsysParts *parts, const LsysOptions *options, LsysOut *out) {
  LsysModelOptions model;
  return lsys_model_options(options, &model) && lsys_shared_glb(parts, d->first_axiom, d->axiom_end, &model, out);
}

static bool write_parts(LsysDerivation *d, const LsysOptions *options, bool glb, LsysOut *out) {
  LsysParts parts;
  if (!lsys_derivation_blocks(d)) return false;
  const char *why = lsys_parts_create(&parts, &d->worker.run);
  if (why && *why) lsys_error("--shared: the figure has no shared parts, because %s", why);
  if (why) return false;
  bool well = (glb ? write_glb : write_svg)(d, &parts, options, out);
  lsys_parts_destroy(&parts);
  return well;
}

bool lsys_shared_format(const LsysSinkContext *context) {
  const LsysOptionValue *path = &context->options->at[LSYS_OPTION_OUTPUT];
  const LsysOptionValue *name = &context->options->at[LSYS_OPTION_FORMAT];
  const char *dot = path->given ? strrchr(path->text, '.') : NULL, *format = name->given ? name->text
                                                                           : dot         ? dot + 1
                                                                                         : "";
  return strcmp(format, "svg") == 0 || strcmp(format, "glb") == 0;
}

bool lsys_shared_run(LsysDerivation *derivation, const LsysSinkContext *context) {
  const LsysOptionValue *path = &context->options->at[LSYS_OPTION_OUTPUT];
  const LsysOptionValue *name = &context->options->at[LSYS_OPTION_FORMAT];
  const LsysFormat *format = lsys_format_find(name->text, path->given ? path->text : "-");
  if (!format) return false;
  bool glb = strcmp(format->name, "glb") == 0;
  if (!glb && strcmp(format->name, "svg")) {
    lsys_error("--shared: only svg and glb can share parts");
    return false;
  }
  LsysColours colours;
  if (!lsys_colours_read(context->options, &colours)) return false;
  if (colours.by != LSYS_BY_PEN) {
    lsys_error("--shared: what is written once has one colour each: --colour-by pen is all there is");
    return false;
  }
  LsysOut *out = lsys_out_open(path->given ? path->text : "-");
  if (!out) return false;
  if (write_parts(derivation, context->options, glb, out)) return lsys_out_commit(out);
  lsys_out_abandon(out);
  return false;
}
