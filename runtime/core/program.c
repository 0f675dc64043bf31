// program.c -- lsys_main: the command line of a compiled program, from options
// to the last byte written. `lsysc run` and `lsysc interp` come here too.
#include "core/program.h"

#include "core/derive.h"
#include "core/fit.h"
#include "core/formats.h"
#include "core/growth.h"
#include "core/message.h"
#include "core/signals.h"
#include "sinks/figure.h"
#include "sinks/film.h"
#include "sinks/homomorphism.h"
#include "sinks/progress.h"
#include "sinks/shared.h"
#include "sinks/tee.h"

#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

enum { MOST_SINKS = 6 };  // the word or picture, the reports, progress, and a program's own

// What the options ask for: sinks, and where they write.
typedef struct Outputs {
  LsysOut *file;    // of -o; NULL
  LsysOut *screen;  // standard output
  LsysSink *sinks[MOST_SINKS];
  size_t count;
  size_t borrowed;   // the first ones are not ours
  bool only_counts;  // nothing but --count of the derived word: a growth matrix can tell
  bool only_stats;   // nothing but --stats
  bool flows;        // a word to standard output, of which the reader may want the beginning only
} Outputs;

// Adds a format's sink, behind the homomorphism if it draws or the option asks for it.
static bool add_sink(Outputs *outputs, LsysSinkContext context, LsysSinkCreate *create, LsysReads reads, LsysOut *out) {
  context.out = out;
  LsysSink *sink = create(&context);
  bool shown = reads == LSYS_READS_FIGURE || context.options->at[LSYS_OPTION_HOMOMORPHISM].given;
  if (sink && shown && (context.grammar->flags & LSYS_GRAMMAR_HOMOMORPHISM))
    sink = lsys_sink_homomorphism(&context, sink);
  if (sink) outputs->sinks[outputs->count++] = sink;
  return sink;
}

static bool add_reports(Outputs *outputs, const LsysSinkContext *context) {
  const LsysOptionValue *options = context->options->at;
  bool stats = options[LSYS_OPTION_STATS].given;
  if ((stats || options[LSYS_OPTION_COUNTS].given)
      && !add_sink(outputs, *context, lsys_sink_count, LSYS_READS_WORD, outputs->screen))
    return false;
  if (stats && !add_sink(outputs, *context, lsys_sink_stats, LSYS_READS_FIGURE, outputs->screen)) return false;
  return !options[LSYS_OPTION_HASH].given
      || add_sink(outputs, *context, lsys_sink_hash, LSYS_READS_WORD, outputs->screen);
}

static bool add_word(Outputs *outputs, const LsysSinkContext *context, const LsysDerivation *derivation) {
  const LsysOptionValue *options = context->options->at;
  const LsysOptionValue *path = &options[LSYS_OPTION_OUTPUT], *name = &options[LSYS_OPTION_FORMAT];
  bool to_file = path->given && strcmp(path->text, "-") != 0;
  const LsysFormat *format = lsys_format_find(name->text, path->given ? path->text : "-");
  bool whole = format && format->reads == LSYS_READS_WORD && !options[LSYS_OPTION_RANGE].given;
  if (to_file && whole && !lsys_fit_disk(lsys_fit_modules(derivation), path->text)) return false;
  if (!format || (to_file && !(outputs->file = lsys_out_open(path->text)))) return false;
  lsys_format_tell_idle(format, context->options);
  outputs->flows = !to_file && format->reads == LSYS_READS_WORD;
  return add_sink(outputs, *context, format->create, format->reads, to_file ? outputs->file : outputs->screen);
}

// Reports go to standard output; the word too and before them, unless it has a file or only reports were asked for.
static bool open_outputs(Outputs *outputs, const LsysSinkContext *context, const LsysDerivation *derivation) {
  const LsysOptionValue *options = context->options->at;
  bool counts = options[LSYS_OPTION_COUNTS].given;
  bool reports = counts || options[LSYS_OPTION_STATS].given || options[LSYS_OPTION_HASH].given;
  bool asked = options[LSYS_OPTION_OUTPUT].given || options[LSYS_OPTION_FORMAT].given;
  bool word = asked || !(reports || outputs->borrowed);
  outputs->screen = lsys_out_open("-");
  if (!outputs->screen || (word && !add_word(outputs, context, derivation)) || !add_reports(outputs, context))
    return false;
  if (!word && !outputs->borrowed) lsys_format_tell_idle(NULL, context->options);
  outputs->only_stats =
    options[LSYS_OPTION_STATS].given && !word && !options[LSYS_OPTION_RANGE].given && !options[LSYS_OPTION_HASH].given;
  outputs->only_counts =
    counts && !options[LSYS_OPTION_RANGE].given && outputs->count == 1
    && !((context->grammar->flags & LSYS_GRAMMAR_HOMOMORPHISM) && options[LSYS_OPTION_HOMOMORPHISM].given);
  return true;
}

// Completes the files if all went well, else removes them.
static bool close_outputs(Outputs *outputs, bool well) {
  for (size_t i = outputs->borrowed; i < outputs->count; i++) outputs->sinks[i]->destroy(outputs->sinks[i]);
  LsysOut *outs[] = {outputs->file, outputs->screen};
  for (int i = 0; i < 2; i++) {
    if (!outs[i]) continue;
    if (!well)
      lsys_out_abandon(outs[i]);
    else
      well = lsys_out_commit(outs[i]);
  }
  return well;
}

// --progress: only where there is a terminal to show it on.
static bool add_progress(Outputs *outputs, const LsysSinkContext *context) {
  if (!context->options->at[LSYS_OPTION_PROGRESS].given || !isatty(STDERR_FILENO)) return true;
  LsysSink *sink = lsys_sink_progress(context);
  if (sink) outputs->sinks[outputs->count++] = sink;
  return sink;
}

// What is known of a word without walking through it is used.
static bool is_long(const LsysDerivation *derivation) {
  return lsys_fit_modules(derivation) > LSYS_FIT_MINUTES;
}

// Says that nobody will see the end of this.
static void tell_endless(const LsysDerivation *derivation) {
  const double modules_of_a_year = 3e17;  // 10^10 a second
  double modules = lsys_fit_modules(derivation);
  if (modules < modules_of_a_year) return;
  bool told = modules < 1e300;
  lsys_note("the word has %s%.3g modules: to walk through it takes %s", told ? "" : "over ", told ? modules : 1e300,
            modules < 1e3 * modules_of_a_year ? "years" : "longer than anybody lives");
}

static bool print_counts(const LsysDerivation *derivation, LsysOut *out) {
  for (uint32_t axiom = derivation->first_axiom; axiom < derivation->axiom_end; axiom++)
    if (!lsys_growth_print(derivation, axiom, out)) return false;
  return true;
}

static bool derive_into(LsysDerivation *derivation, Outputs *outputs) {
  bool known = derivation->worker.run.grammar->growth.row;
  if (outputs->only_counts && known) return print_counts(derivation, outputs->screen);
  if (outputs->only_stats && known && is_long(derivation)) {
    bool well = lsys_figure_print(derivation, outputs->screen, &known);
    if (!well || known) return well;
  }
  if (!outputs->flows && !outputs->borrowed && !derivation->has_range) tell_endless(derivation);
  LsysTee tee;
  lsys_tee_init(&tee, outputs->sinks, outputs->count);
  LsysSink *sink = outputs->count == 1 ? outputs->sinks[0] : &tee.sink;
  for (unsigned pass = 0; pass < sink->passes; pass++)
    for (uint32_t axiom = derivation->first_axiom; axiom < derivation->axiom_end; axiom++)
      if (!lsys_derivation_run(derivation, axiom, sink, pass)) return false;
  return sink->finish(sink);
}

// --stats: what it cost, which is no part of the result.
static void report_cost(const struct timespec *started) {
  struct timespec now;
  struct rusage usage;
  clock_gettime(CLOCK_MONOTONIC, &now);
  getrusage(RUSAGE_SELF, &usage);
  double seconds = (double)(now.tv_sec - started->tv_sec) + (double)(now.tv_nsec - started->tv_nsec) * 1e-9;
  lsys_note("%.3f s, %.1f MiB of memory at most", seconds, (double)usage.ru_maxrss / 1024);
}

// Figures that nobody would wait for segment by segment are written as their parts, if the format can.
static bool must_share(const LsysDerivation *derivation, const LsysSinkContext *context) {
  const LsysOptionValue *options = context->options->at;
  static const LsysOption other[] = {LSYS_OPTION_RANGE,  LSYS_OPTION_COUNTS,     LSYS_OPTION_STATS,    LSYS_OPTION_HASH,
                                     LSYS_OPTION_CAMERA, LSYS_OPTION_PROJECTION, LSYS_OPTION_COLOUR_BY};
  for (size_t i = 0; i < sizeof other / sizeof *other; i++)
    if (options[other[i]].given) return false;
  return context->grammar->growth.row && context->grammar->expand
      && lsys_fit_modules(derivation) > lsys_shared_worth(context);
}

bool lsys_program_run(const LsysGrammar *grammar, const LsysOptions *options, LsysSink *own) {
  const LsysOptionValue *limit = &options->at[LSYS_OPTION_MAX_MEMORY];
  LsysMemory memory = {.limit = limit->given ? limit->whole : lsys_memory_default()};
  LsysSinkContext context = {.grammar = grammar, .options = options, .memory = &memory};
  LsysDerivation derivation;
  Outputs outputs = {.sinks = {own}, .count = own != NULL, .borrowed = own != NULL};
  lsys_message_quiet(options->at[LSYS_OPTION_QUIET].given);
  struct timespec started;
  clock_gettime(CLOCK_MONOTONIC, &started);
  bool well = lsys_derivation_open(&derivation, grammar, options, &memory);
  bool film = options->at[LSYS_OPTION_FRAMES].given || options->at[LSYS_OPTION_SVG_ANIMATE].given;
  bool asked = options->at[LSYS_OPTION_SHARED].given, done = false;
  if (well && film)
    well = lsys_film_run(&derivation, &context);
  else if (well && (asked || must_share(&derivation, &context)))
    well = lsys_shared_run(&derivation, &context, asked, &done);
  if (film || done) {
    lsys_derivation_close(&derivation);
    return well;
  }
  well = well && open_outputs(&outputs, &context, &derivation) && add_progress(&outputs, &context);
  well = well && derive_into(&derivation, &outputs);
  well = close_outputs(&outputs, well);
  lsys_derivation_close(&derivation);
  if (well && options->at[LSYS_OPTION_STATS].given && isatty(STDERR_FILENO)) report_cost(&started);
  return well;
}

bool lsys_program_fits(const LsysGrammar *grammar) {
  if (grammar->abi_version == LSYS_ABI_VERSION) return true;
  lsys_error("%s was compiled for version %u of the run time, which is version %u", grammar->name, grammar->abi_version,
             LSYS_ABI_VERSION);
  return false;
}

int lsys_main(const LsysGrammar *grammar, int argc, char **argv) {
  lsys_message_program(argc > 0 ? argv[0] : grammar->name);
  if (!lsys_program_fits(grammar)) return 1;
  LsysOptions options;
  bool well = lsys_options_parse(&options, argc > 0 ? argc - 1 : 0, argv + 1);
  if (well && options.at[LSYS_OPTION_HELP].given) {
    well = lsys_help(stdout, grammar, options.at[LSYS_OPTION_HELP].text);
  } else if (well && options.at[LSYS_OPTION_VERSION].given) {
    printf("%s, compiled by lsysc %s\n", grammar->name, LSYS_VERSION);
  } else if (well) {
    lsys_signals_install();
    well = lsys_program_run(grammar, &options, NULL);
  }
  lsys_options_free(&options);
  if ((fflush(stdout) != 0 || ferror(stdout)) && well) {
    lsys_error("cannot write standard output");
    well = false;
  }
  return well ? 0 : 1;
}
