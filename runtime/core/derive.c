// derive.c -- the driver of the engines: packs the start word with its keys and
// lets the grammar derive it on a thread of its own, whose stack fits the depth.
#include "core/derive.h"

#include "core/births.h"
#include "core/files.h"
#include "core/message.h"
#include "core/parallel.h"
#include "core/step.h"
#include "core/stream.h"
#include "core/thread.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_THREADS = 1024 };

// ---- values ------------------------------------------------------------------

static uint32_t find_param(const LsysGrammar *grammar, const char *name, size_t length) {
  uint32_t i = 0;
  while (i < grammar->param_count
         && !(strncmp(grammar->params[i].name, name, length) == 0 && !grammar->params[i].name[length]))
    i++;
  return i;
}

static void no_such_param(const LsysGrammar *grammar, const char *name, int length) {
  const char *near = NULL;
  char wanted[64];
  snprintf(wanted, sizeof wanted, "%.*s", length, name);
  for (uint32_t i = 0; i < grammar->param_count && !near; i++) near = lsys_nearest(wanted, &grammar->params[i].name, 1);
  if (near)
    lsys_error("-D %s: the grammar has no param '%s'; did you mean '%s'?", name, wanted, near);
  else
    lsys_error("-D %s: the grammar has no param '%s'%s", name, wanted,
               grammar->param_count ? "; --help lists them" : "; it declares none");
}

// Stores one -D NAME=VALUE in the run's values.
static bool define(LsysRun *run, const char *definition, uint8_t *given) {
  const LsysGrammar *grammar = run->grammar;
  size_t length = strcspn(definition, "=");
  uint32_t i = find_param(grammar, definition, length);
  if (i == grammar->param_count) {
    no_such_param(grammar, definition, (int)length);
    return false;
  }
  const LsysParam *param = &grammar->params[i];
  const char *text = definition + length + 1;
  char *end;
  double value = strtod(text, &end);
  if (end == text || *end) {
    lsys_error("-D %s: '%s' is not a number", definition, text);
    return false;
  }
  if (!(value >= param->low && value <= param->high) && !(isinf(param->low) && isinf(param->high))) {
    lsys_error("-D %s: %s must be in %.17g..%.17g", definition, param->name, param->low, param->high);
    return false;
  }
  run->value[param->value] = value;
  given[i] = 1;
  return true;
}

static bool initialise_values(LsysWorker *worker, const LsysOptions *options) {
  LsysRun *run = &worker->run;
  LsysMemory *memory = worker->memory;
  const LsysGrammar *grammar = run->grammar;
  run->value = lsys_memory_alloc(memory, grammar->value_count, sizeof *run->value);
  uint8_t *given = lsys_memory_alloc(memory, grammar->param_count, 1);
  bool well = run->value && given;
  for (size_t i = 0; well && i < options->definition_count; i++) well = define(run, options->definitions[i], given);
  if (well && (well = setjmp(worker->stop) == 0)) grammar->init(run, given);
  lsys_memory_free(memory, given, grammar->param_count, 1);
  return well;
}

static bool has_productions(const LsysGrammar *grammar) {
  for (uint32_t i = 0; i < grammar->kind_count; i++)
    if (!(grammar->kinds[i].flags & LSYS_KIND_TERMINAL)) return true;
  return false;
}

static bool choose_steps(LsysRun *run, const LsysOptions *options) {
  const LsysOptionValue *given = &options->at[LSYS_OPTION_STEPS];
  double setting = run->value[LSYS_SETTING_STEPS];
  if (given->given) {
    run->steps = given->whole;
  } else if (!isnan(setting)) {
    if (!(setting >= 0 && setting < 0x1p53 && setting == floor(setting))) {
      lsys_error("the grammar's number of steps is %.17g; it must be a whole number, 0 or more", setting);
      return false;
    }
    run->steps = (uint64_t)setting;
  } else if (has_productions(run->grammar)) {
    lsys_error("how many steps? Give -n STEPS (the grammar has no `steps:` of its own)");
    return false;
  }
  return true;
}

static bool choose_axioms(LsysDerivation *derivation, const LsysOptions *options) {
  const LsysOptionValue *which = &options->at[LSYS_OPTION_AXIOM];
  derivation->first_axiom = 0;
  derivation->axiom_end = derivation->worker.run.grammar->axiom_count;
  if (!which->given) return true;
  if (which->whole < 1 || which->whole > derivation->axiom_end) {
    lsys_error("--axiom %s: the grammar has %u start word%s", which->text, derivation->axiom_end,
               derivation->axiom_end == 1 ? "" : "s");
    return false;
  }
  derivation->first_axiom = (uint32_t)which->whole - 1;
  derivation->axiom_end = (uint32_t)which->whole;
  return true;
}

// expand where it applies and nothing else is asked for.
static bool choose_engine(LsysDerivation *derivation, const LsysOptions *options) {
  const LsysGrammar *grammar = derivation->worker.run.grammar;
  const LsysOptionValue *given = &options->at[LSYS_OPTION_ENGINE];
  derivation->expands = grammar->expand;
  if (!given->given || grammar->derive) return true;
  bool expand = strcmp(given->text, "expand") == 0, step = strcmp(given->text, "step") == 0;
  derivation->expands = expand;
  if ((expand && grammar->expand) || step) return true;
  if (expand)
    lsys_error("--engine expand: the grammar is not context-free");
  else
    lsys_error("--engine %s: the engines are expand and step", given->text);
  return false;
}

static bool choose_threads(LsysDerivation *derivation, const LsysOptions *options) {
  const LsysOptionValue *given = &options->at[LSYS_OPTION_THREADS];
  long cores = sysconf(_SC_NPROCESSORS_ONLN);
  derivation->threads = cores < 1 ? 1 : cores > MOST_THREADS ? MOST_THREADS : (unsigned)cores;
  if (!given->given) return true;
  derivation->threads = (unsigned)given->whole;
  if (given->whole >= 1 && given->whole <= MOST_THREADS) return true;
  lsys_error("--threads %s: it is a number from 1 to %d", given->text, MOST_THREADS);
  return false;
}

bool lsys_derivation_open(LsysDerivation *derivation, const LsysGrammar *grammar, const LsysOptions *options,
                          LsysMemory *memory) {
  const LsysOptionValue *seed = &options->at[LSYS_OPTION_SEED], *range = &options->at[LSYS_OPTION_RANGE];
  *derivation = (LsysDerivation){.stretch = LSYS_STRETCH,
                                 .worker = {.memory = memory, .run = {.grammar = grammar, .memory = memory}}};
  LsysRun *run = &derivation->worker.run;
  run->told = &derivation->told;
  derivation->has_range = range->given;
  if (range->given && !lsys_range_parse(range, &derivation->range)) return false;
  const LsysOptionValue *by = &options->at[LSYS_OPTION_COLOUR_BY];
  run->births = by->given && strcmp(by->text, "age") == 0;
  run->root = lsys_root(seed->given ? seed->whole : grammar->seed);
  if (!choose_threads(derivation, options)) return false;
  run->threads = derivation->threads;
  return initialise_values(&derivation->worker, options) && choose_steps(run, options)
      && choose_axioms(derivation, options) && choose_engine(derivation, options);
}

void lsys_derivation_close(LsysDerivation *derivation) {
  lsys_look_end(&derivation->worker.run);
  lsys_memory_free(derivation->worker.memory, derivation->worker.run.value, derivation->worker.run.grammar->value_count,
                   sizeof(double));
  derivation->worker.run.value = NULL;
  lsys_blocks_free(derivation->blocks, derivation->worker.memory);
  derivation->blocks = NULL;
}

// ---- start words -------------------------------------------------------------

static unsigned symbol_at(const LsysWord *word, unsigned width, uint64_t i) {
  return width == 1 ? word->sym[i] : (unsigned)(word->sym[2 * i] | word->sym[2 * i + 1] << 8);
}

// keys[i] = split(root, number of modules before module i, over all start words).
static void number_modules(const LsysRun *run, uint32_t which, uint64_t *key) {
  const LsysGrammar *grammar = run->grammar;
  uint64_t before = 0;
  for (uint32_t i = 0; i < which; i++) before += grammar->axioms[i].word.nsym;
  for (uint64_t i = 0; i < grammar->axioms[which].word.nsym; i++) key[i] = lsys_split(run->root, before + i);
}

// Leaves only the keys of kinds that store them; returns their number.
static uint64_t keep_stored_keys(const LsysGrammar *grammar, const LsysWord *word, uint64_t *key) {
  unsigned width = lsys_symbol_width(grammar);
  uint64_t kept = 0;
  for (uint64_t i = 0; i < word->nsym; i++)
    if (grammar->kinds[symbol_at(word, width, i)].flags & LSYS_KIND_KEY) key[kept++] = key[i];
  return kept;
}

// The packed start word, its arguments and keys in arrays of its own (args and keys of *word, to be freed).
static bool pack_axiom(LsysWorker *worker, uint32_t which, LsysWord *word) {
  LsysRun *run = &worker->run;
  LsysMemory *memory = worker->memory;
  const LsysGrammar *grammar = run->grammar;
  *word = grammar->axioms[which].word;
  double *arg = lsys_memory_alloc(memory, word->narg, sizeof *arg);
  uint64_t *key = lsys_memory_alloc(memory, word->nsym, sizeof *key);
  if (arg && word->narg) memcpy(arg, word->arg, word->narg * sizeof *arg);
  word->arg = arg;
  word->key = key;
  if (!arg || !key) return false;
  number_modules(run, which, key);
  if (grammar->axiom) grammar->axiom(run, which, arg, key);
  word->nkey = keep_stored_keys(grammar, word, key);
  return true;
}

static void free_axiom(LsysMemory *memory, LsysWord *word) {
  lsys_memory_free(memory, (double *)word->arg, word->narg, sizeof(double));
  lsys_memory_free(memory, (uint64_t *)word->key, word->nsym, sizeof(uint64_t));
}

// ---- the engine's thread -----------------------------------------------------

typedef struct Task {
  LsysDerivation *derivation;
  LsysWorker *worker;  // the derivation's
  LsysSink *sink;
  uint32_t axiom;
  unsigned pass;
  LsysWriter writer;
  LsysWord word;  // the start word, packed
  LsysStepper stepper;
  LsysParallel *parallel;
  LsysWindow window;  // --range: in front of the sink
  LsysDescent *descent;
  LsysBirths *births;
  LsysBirthsStep *births_step;
  bool well;
} Task;

static bool step(Task *task) {
  LsysDerivation *d = task->derivation;
  if (task->worker->run.births) return lsys_births_step(&task->births_step, task->worker, &task->word, task->sink);
  return lsys_stepper_run(&task->stepper, task->worker, &task->word, task->sink, d->threads, d->stretch);
}

// The word flows into the sink: as it is, from the interpreter, or from compiled code.
static bool derive(Task *task) {
  LsysRun *run = &task->worker->run;
  const LsysGrammar *grammar = run->grammar;
  LsysStream *out = &task->writer.stream;
  if (!grammar->derive) {
    if (grammar->block) grammar->block(run, LSYS_BLOCK_START);
    if (!pack_axiom(task->worker, task->axiom, &task->word)) return false;
    run->born = 0;
    if (run->steps == 0 && !grammar->block) return task->sink->take(task->sink, &task->word);
    if (grammar->step && !task->derivation->expands) return step(task);
  }
  if (!task->derivation->blocks && !(task->derivation->blocks = lsys_blocks_build(task->worker))) return false;
  if (run->births && !grammar->derive) return lsys_births_run(&task->births, task->worker, &task->word, task->sink);
  if (!task->derivation->expands && !grammar->derive) return step(task);
  unsigned threads = task->derivation->threads;
  if (task->derivation->has_range && !grammar->derive && grammar->growth.row)
    return lsys_descent_run(&task->descent, task->worker, &task->word, &task->window);
  if (!grammar->derive && threads > 1)
    return lsys_parallel_run(&task->parallel, task->worker, &task->word, task->sink, threads);
  if (!lsys_writer_open(&task->writer, task->worker, task->sink)) return false;
  if (grammar->derive)
    grammar->derive(run, task->axiom, run->steps, out, grammar->derive_data);
  else
    grammar->expand(out, &task->word, run->steps);
  lsys_flush(out);
  return true;
}

static bool begin(Task *task) {
  return task->sink->begin(task->sink, &task->worker->run, task->axiom, task->pass);
}

static bool end(Task *task) {
  return task->sink->end(task->sink);
}

// A part of the work, which may stop by going to worker->stop.
static bool guarded(Task *task, bool (*part)(Task *task)) {
  return setjmp(task->worker->stop) == 0 && part(task);
}

static void *work(void *data) {
  Task *task = data;
  task->well = guarded(task, begin) && (guarded(task, derive) || task->window.done) && guarded(task, end);
  return NULL;
}

bool lsys_derivation_run(LsysDerivation *derivation, uint32_t axiom, LsysSink *sink, unsigned pass) {
  Task task = {.derivation = derivation, .worker = &derivation->worker, .sink = sink, .axiom = axiom, .pass = pass};
  if (derivation->has_range) {
    lsys_window_open(&task.window, derivation->worker.run.grammar, derivation->range, sink);
    task.sink = &task.window.sink;
  }
  LsysThread thread;
  bool well = lsys_thread_start(&thread, task.worker, work, &task);
  if (well) lsys_thread_join(&thread);
  lsys_parallel_close(task.parallel);
  lsys_descent_close(task.descent);
  lsys_births_close(task.births);
  lsys_births_step_close(task.births_step);
  if (task.writer.stream.run) lsys_writer_close(&task.writer);
  lsys_stepper_close(&task.stepper);
  free_axiom(derivation->worker.memory, &task.word);
  bool written = lsys_files_close(&derivation->worker.run);
  return well && task.well && written;
}

static bool build_blocks(Task *task) {
  if (!task->derivation->blocks) task->derivation->blocks = lsys_blocks_build(task->worker);
  return task->derivation->blocks;
}

static void *work_on_blocks(void *data) {
  Task *task = data;
  task->well = guarded(task, build_blocks);
  return NULL;
}

bool lsys_derivation_blocks(LsysDerivation *derivation) {
  Task task = {.derivation = derivation, .worker = &derivation->worker};
  LsysThread thread;
  if (!lsys_thread_start(&thread, task.worker, work_on_blocks, &task)) return false;
  lsys_thread_join(&thread);
  return task.well;
}
