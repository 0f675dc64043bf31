// film.c -- --frames and --svg-animate: derives every number of steps up to the
// one asked for, the largest first, since its picture decides on page and scale.
#include "sinks/film.h"

#include "core/message.h"
#include "sinks/homomorphism.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static LsysSink *make_sink(const LsysSinkContext *context, const LsysFormat *format) {
  LsysSink *sink = format->create(context);
  return sink && context->grammar->homomorphism ? lsys_sink_homomorphism(context, sink) : sink;
}

static bool shoot(LsysDerivation *d, const LsysSinkContext *context, const LsysFormat *format) {
  LsysSink *sink = make_sink(context, format);
  if (!sink) return false;
  bool well = true;
  for (unsigned pass = 0; well && pass < sink->passes; pass++) {
    for (uint32_t axiom = d->first_axiom; well && axiom < d->axiom_end; axiom++)
      well = lsys_derivation_run(d, axiom, sink, pass);
  }
  well = well && sink->finish(sink);
  sink->destroy(sink);
  return well;
}

// "plant.png" and 7 of 120 steps: "plant-007.png". To be freed; NULL if memory ran out.
static char *frame_name(const char *path, uint64_t step, uint64_t steps) {
  const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
  int digits = snprintf(NULL, 0, "%llu", (unsigned long long)steps), stem = dot ? (int)(dot - path) : (int)strlen(path);
  char *name;
  int length =
    asprintf(&name, "%.*s-%0*llu%s", stem, path, digits < 3 ? 3 : digits, (unsigned long long)step, dot ? dot : "");
  return length < 0 ? NULL : name;
}

static bool shoot_file(LsysDerivation *d, LsysSinkContext context, const LsysFormat *format, const char *path) {
  char *name = frame_name(path, context.film->step, context.film->steps);
  context.out = name ? lsys_out_open(name) : NULL;
  free(name);
  if (!context.out) return false;
  if (shoot(d, &context, format)) return lsys_out_commit(context.out);
  lsys_out_abandon(context.out);
  return false;
}

static bool shoot_all(LsysDerivation *d, const LsysSinkContext *context, const LsysFormat *format, const char *path) {
  LsysFilm *film = context->film;
  bool well = true;
  for (film->step = film->steps;; film->step--) {
    d->worker.run.steps = film->step;
    well = film->animate ? shoot(d, context, format) : shoot_file(d, *context, format, path);
    if (!well || film->step == 0) break;
  }
  d->worker.run.steps = film->steps;
  lsys_layout_destroy(&film->layout);
  free(film->eye);
  return well;
}

bool lsys_film_run(LsysDerivation *derivation, const LsysSinkContext *context) {
  const LsysOptionValue *options = context->options->at, *path = &options[LSYS_OPTION_OUTPUT];
  bool animate = options[LSYS_OPTION_SVG_ANIMATE].given, to_file = path->given && strcmp(path->text, "-") != 0;
  const LsysFormat *format = lsys_format_find(options[LSYS_OPTION_FORMAT].text, path->given ? path->text : "-");
  if (!format) return false;
  if (animate && strcmp(format->name, "svg")) {
    lsys_error("--svg-animate: the output must be an .svg file");
    return false;
  }
  if (!animate && !to_file) {
    lsys_error("--frames: give a file, such as -o plant.png, whose name the files get with a number");
    return false;
  }
  lsys_format_tell_idle(format, context->options);
  LsysFilm film = {.steps = derivation->worker.run.steps, .animate = animate, .seconds = 0.5};
  LsysSinkContext own = *context;
  own.film = &film;
  if (!animate) return shoot_all(derivation, &own, format, path->text);
  own.out = lsys_out_open(to_file ? path->text : "-");
  if (!own.out) return false;
  if (shoot_all(derivation, &own, format, NULL)) return lsys_out_commit(own.out);
  lsys_out_abandon(own.out);
  return false;
}
