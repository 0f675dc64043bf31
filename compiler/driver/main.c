// main.c -- lsysc: options, then the passes in order.
//
//   source -> Ast -> Program -> Facts, LsysGrammar -> interpreter | JIT | object -> program
#include "analysis/analyze.h"
#include "driver/help.h"
#include "driver/link.h"
#include "driver/load.h"
#include "driver/report.h"
#include "frontend/fmt.h"
#include "frontend/fractint.h"
#include "interp/interp.h"
#include "support/laps.h"

#include <stdlib.h>
#include <string.h>

typedef struct Session {
  const Options *options;
  Arena *arena;
  Sources *sources;
  Diag *diag;
  const Program *checked;
  const Facts *facts;
  const LsysGrammar *description;
  Laps *laps;  // NULL: nobody asks
} Session;

static bool failed(const Session *session) {
  return diag_errors(session->diag) > 0;
}

// Flushes what was printed to standard output; a full disk or a closed pipe is an error too.
static bool printed(void) {
  return (fflush(stdout) == 0 && !ferror(stdout)) || report_error("cannot write standard output");
}

// ---- what is done with a checked grammar ---------------------------------

// Whether a -D goes to the program: not where it defined a macro.
static bool is_for_program(const Session *session, const char *definition) {
  const Program *program = session->checked;
  if (!program->rules.textual_macros) return true;
  size_t length = strcspn(definition, "=");
  for (size_t i = 0; i < program->value_count; i++) {
    const Value *value = &program->values[i];
    if (value->kind == VALUE_PARAM && strlen(value->name) == length && memcmp(value->name, definition, length) == 0)
      return true;
  }
  return false;
}

// The command line of the program: "lsysc run plant.lsys" stands for its name.
static int run_program(const Session *session, const LsysGrammar *grammar) {
  const Options *options = session->options;
  size_t count = 0, most = 2 + 2 * options->given.count + options->passed.count;
  char **argv = arena_array(session->arena, most, sizeof *argv);
  argv[count++] =
    arena_printf(session->arena, "lsysc %s %s", command_table[options->command].name, options->files.at[0]);
  for (size_t i = 0; i < options->given.count; i++) {
    if (!is_for_program(session, options->given.at[i])) continue;
    argv[count++] = (char *)"-D";
    argv[count++] = (char *)options->given.at[i];
  }
  for (size_t i = 0; i < options->passed.count; i++) argv[count++] = (char *)options->passed.at[i];
  return lsys_main(grammar, (int)count, argv);
}

// How many modules code must write before it is worth its optimiser's time: about what code that was hardly optimised
// writes while more would be done about it.
#define WORTH_OPTIMISING 2e6

// What `run` does without -O: code for a short derivation is wanted at once.
static unsigned level_for(const Session *session) {
  const Options *options = session->options;
  const Expr *setting = session->checked->settings[LSYS_SETTING_STEPS];
  uint64_t steps;
  double given;
  if (options->optimise_given) return options->backend.optimise;
  if (!lsys_steps_asked((int)options->passed.count, (char **)options->passed.at, &steps)) {
    if (!setting || !expr_constant(session->checked, setting, &given) || !(given >= 0 && given < 1e9)) return 2;
    steps = (uint64_t)given;
  }
  double work = work_bound(session->arena, session->checked, session->facts, steps, WORTH_OPTIMISING);
  return work <= WORTH_OPTIMISING ? 1 : 2;
}

static int run_jit(const Session *session) {
  const Backend *backend = backend_load(session->arena, home_find(session->arena));
  if (!backend) return EXIT_FAILURE;
  laps_end(session->laps, "load LLVM");
  BackendOptions how = session->options->backend;
  how.laps = session->laps;
  how.optimise = level_for(session);
  how.split = true;
  Jit *jit = backend->jit(session->checked, session->facts, session->description, &how, lsys_symbols, lsys_symbol_count,
                          session->diag);
  if (!jit) return EXIT_FAILURE;
  if (session->laps) laps_print(session->laps, stderr);
  int status = run_program(session, backend->jit_grammar(jit));
  backend->jit_free(jit);
  return status;
}

static int run_interp(const Session *session) {
  const LsysGrammar *grammar = interp_grammar(session->arena, session->checked, session->description);
  int status = run_program(session, grammar);
  interp_release(grammar);
  return status;
}

static void release(Code *code) {
  for (int i = 0; i < BACKEND_PARTS; i++) free(code[i].bytes);
}

// Generated code as the back end writes it, in memory, so that no half-written file can be left behind.
static bool generate(const Session *session, EmitKind kind, Code code[BACKEND_PARTS]) {
  const Backend *backend = backend_load(session->arena, home_find(session->arena));
  if (!backend) return false;
  laps_end(session->laps, "load LLVM");
  BackendOptions how = session->options->backend;
  how.emit = kind;
  how.split = session->options->program;
  how.laps = session->laps;
  FILE *out[BACKEND_PARTS];
  bool done = true;
  for (int i = 0; i < BACKEND_PARTS; i++) {
    code[i] = (Code){0};
    out[i] = open_memstream(&code[i].bytes, &code[i].size);
    if (!out[i]) done = report_error("out of memory");
  }
  done = done && backend->emit(session->checked, session->facts, session->description, &how, out, session->diag);
  for (int i = 0; i < BACKEND_PARTS; i++)
    if (out[i] && fclose(out[i]) != 0) done = report_error("out of memory");
  if (!done) release(code);
  return done;
}

static int emit(const Session *session) {
  const Options *options = session->options;
  const char *name = output_name(session->arena, options, options->files.at[0]);
  if (!name) return EXIT_FAILURE;
  Code code[BACKEND_PARTS];
  if (!generate(session, options->backend.emit, code)) return EXIT_FAILURE;
  bool done = options->program ? link_program(session->arena, options, home_find(session->arena), name, code)
                               : output_write(session->arena, name, code[0].bytes, code[0].size);
  release(code);
  laps_end(session->laps, options->program ? "link" : "write");
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int dump_ir(const Session *session) {
  Code code[BACKEND_PARTS];
  if (!generate(session, EMIT_LLVM, code)) return EXIT_FAILURE;
  fwrite(code[0].bytes, 1, code[0].size, stdout);
  release(code);
  return printed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int print_native(const Session *session, const Ast *ast) {
  const char *name = session->options->output ? session->options->output : "-";
  char *text = NULL;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  if (!out) return EXIT_FAILURE;
  fmt_print(ast, out);
  bool done = fclose(out) == 0 && output_write(session->arena, name, text, size);
  free(text);
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}

// ---- the passes ------------------------------------------------------------

static int process(Session *session, const char *path) {
  const Options *options = session->options;
  const char *why;
  const SourceFile *file = sources_read(session->sources, path, (Span){0}, &why);
  if (!file) return report_error("%s: %s", path, why), EXIT_FAILURE;

  if (options->list_systems) return fractint_list(file, stdout), !printed();
  if (options->dump == DUMP_TOKENS) {
    parse_dump_tokens(session->arena, session->sources, session->diag, file, &options->parse, stdout);
    return printed() && !failed(session) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  const Ast *ast = parse_file(session->arena, session->sources, session->diag, file, &options->parse);
  laps_end(session->laps, "parse");
  if (options->dump == DUMP_AST) ast_dump(ast, stdout);
  if (failed(session)) {
    check(session->arena, ast, session->diag);  // what else is wrong is told in the same run
    return EXIT_FAILURE;
  }
  if (options->dump == DUMP_AST) return printed() ? EXIT_SUCCESS : EXIT_FAILURE;
  if (options->command == COMMAND_FMT) return print_native(session, ast);

  session->checked = check(session->arena, ast, session->diag);
  laps_end(session->laps, "check");
  if (failed(session) || !session->checked) return EXIT_FAILURE;
  if (options->dump == DUMP_PROGRAM) return program_dump(session->checked, stdout), !printed();
  if (options->command == COMMAND_CHECK) return EXIT_SUCCESS;

  session->facts = facts_find(session->arena, session->checked);
  if (options->dump == DUMP_FACTS || options->command == COMMAND_ANALYZE)
    return analyze_print(session->checked, session->facts, stdout), !printed();

  session->description = describe(session->arena, session->checked, session->facts);
  laps_end(session->laps, "analyze");
  if (options->dump == DUMP_IR) return dump_ir(session);
  if (options->command == COMMAND_RUN) return run_jit(session);
  if (options->command == COMMAND_INTERP) return run_interp(session);
  return emit(session);
}

// One file is one compilation: its memory is released before the next one begins.
static int compile(const Options *options, const char *path) {
  Arena *arena = arena_create();
  Session session = {.options = options, .arena = arena, .sources = sources_create(arena)};
  session.diag = diag_create(arena, session.sources, &options->diag);
  Laps laps;
  laps_begin(&laps);
  if (options->times) session.laps = &laps;
  int status = process(&session, path);
  if (session.laps && options->command != COMMAND_RUN) laps_print(&laps, stderr);
  arena_destroy(arena);
  return status;
}

// ---- the command line --------------------------------------------------------

static int version(Arena *arena, const Options *options) {
  puts("lsysc " LSYSC_VERSION);
  if (options->verbose) {
    const Backend *backend = backend_load(arena, home_find(arena));
    if (!backend) return EXIT_FAILURE;
    puts(backend->version());
  }
  return printed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int help(const Options *options) {
  if (options->command != COMMAND_HELP || options->files.count == 0)
    help_command(stdout, options->command == COMMAND_HELP ? COMMAND_COMPILE : options->command);
  else if (!help_topic(stdout, options->files.at[0]))
    return EXIT_FAILURE;
  return printed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv) {
  if (argc < 2) {
    help_short(stderr);
    return EXIT_FAILURE;
  }
  Arena *arena = arena_create();
  Options options;
  int status = EXIT_FAILURE;
  if (!options_parse(arena, argc, argv, &options))
    ;
  else if (options.version)
    status = version(arena, &options);
  else if (options.help || options.command == COMMAND_HELP)
    status = help(&options);
  else {
    status = EXIT_SUCCESS;
    for (size_t i = 0; i < options.files.count; i++)
      if (compile(&options, options.files.at[i]) != EXIT_SUCCESS) status = EXIT_FAILURE;
  }
  arena_destroy(arena);
  return status;
}
