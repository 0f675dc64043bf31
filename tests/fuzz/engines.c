// engines.c -- one random grammar through all engines.
//
// Interpreter and JIT run in this process and write into memory; executables
// are made by lsysc and compared by what they print.
#include "engines.h"

#include "core/derive.h"
#include "core/message.h"
#include "frontend/fmt.h"
#include "interp/interp.h"
#include "sinks/homomorphism.h"
#include "support/diag.h"

#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const double LONG_WORD = 1e7;  // modules, for threads

const char *const verdict_names[VERDICTS] = {"agree", "refused", "unsupported", "differ", "crash", "late"};

// ---- words in memory -----------------------------------------------------------

typedef struct Collector {
  LsysSink sink;
  Arena *arena;
  VEC(uint8_t) sym;
  VEC(double) arg;
  VEC(uint64_t) born;  // of each module, where births are asked for
  const LsysRun *run;
  unsigned width;
  Lengths lengths;
} Collector;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)axiom, (void)pass;
  ((Collector *)sink)->run = run;
  ((Collector *)sink)->width = run->grammar->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  Collector *to = (Collector *)sink;
  for (uint64_t i = 0; i < part->nsym * to->width; i++) *VEC_PUSH(to->arena, &to->sym) = part->sym[i];
  for (uint64_t i = 0; i < part->narg; i++) *VEC_PUSH(to->arena, &to->arg) = part->arg[i];
  for (uint64_t i = 0; to->run->births && i < part->nsym; i++) *VEC_PUSH(to->arena, &to->born) = to->run->born;
  return true;
}

static bool end(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  (void)sink;
}

static Collector collector(Arena *arena) {
  return (Collector){.sink = {.passes = 1, .begin = begin, .take = take, .end = end, .finish = end, .destroy = destroy},
                     .arena = arena};
}

// The sink is destroyed then. stretch 0: as long as they are for users.
static bool derive_into(const LsysGrammar *grammar, const LsysOptions *options, LsysMemory *memory, LsysSink *sink,
                        uint64_t stretch) {
  LsysDerivation derivation;
  bool well = lsys_derivation_open(&derivation, grammar, options, memory);
  if (stretch) derivation.stretch = stretch;
  for (uint32_t axiom = 0; well && axiom < grammar->axiom_count; axiom++)
    well = lsys_derivation_run(&derivation, axiom, sink, 0);
  sink->destroy(sink);
  lsys_derivation_close(&derivation);
  return well;
}

// The word and, behind it, what the homomorphism makes of it.
static bool derive(const LsysGrammar *grammar, Collector *into) {
  LsysOptions options = {0};
  LsysMemory memory = {.limit = UINT64_C(1) << 31};
  if (!derive_into(grammar, &options, &memory, &into->sink, 0)) return false;
  into->lengths.word = into->lengths.figure = into->sym.count / into->width;
  if (!(grammar->flags & LSYS_GRAMMAR_HOMOMORPHISM)) return true;
  LsysSink *figure =
    lsys_sink_homomorphism(&(LsysSinkContext){.grammar = grammar, .options = &options, .memory = &memory}, &into->sink);
  bool well = figure && derive_into(grammar, &options, &memory, figure, 0);
  into->lengths.figure = into->sym.count / into->width - into->lengths.word;
  return well;
}

// Every nan is the same one.
static bool same_number(double a, double b) {
  return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static bool same_word(const Collector *a, const Collector *b, const char *who) {
  size_t count = a->sym.count < b->sym.count ? a->sym.count : b->sym.count;
  for (size_t i = 0; i < count; i++)
    if (a->sym.at[i] != b->sym.at[i]) {
      fprintf(stderr, "%s: module %zu differs\n", who, i / a->width);
      return false;
    }
  if (a->sym.count != b->sym.count) {
    fprintf(stderr, "%s: %zu modules in place of %zu\n", who, b->sym.count / a->width, a->sym.count / a->width);
    return false;
  }
  for (size_t i = 0; i < a->arg.count && i < b->arg.count; i++)
    if (!same_number(a->arg.at[i], b->arg.at[i])) {
      fprintf(stderr, "%s: argument %zu is %.17g in place of %.17g\n", who, i, b->arg.at[i], a->arg.at[i]);
      return false;
    }
  return true;
}

// ---- compilations ---------------------------------------------------------------

typedef struct Compilation {
  Arena *arena;
  Diag *diag, *quiet;
  const Ast *ast;
  const Program *program;
  const Facts *facts;
  const LsysGrammar *description;
} Compilation;

// Text -> description. False after errors, which are printed; what the code generator says is not.
static bool compile(Compilation *c, Arena *arena, const char *text, size_t length, FILE *nowhere) {
  *c = (Compilation){.arena = arena};
  Sources *sources = sources_create(arena);
  DiagOptions options;
  diag_options_default(&options);
  options.no_warnings = true;
  c->diag = diag_create(arena, sources, &options);
  options.out = nowhere;
  c->quiet = diag_create(arena, sources, &options);
  const SourceFile *file = sources_add(sources, "fuzz.lsys", arena_copy(arena, text, length), length, (Span){0});
  c->ast = parse_file(arena, sources, c->diag, file, &(ParseOptions){0});
  if (!diag_errors(c->diag)) c->program = check(arena, c->ast, c->diag);
  if (!c->program || diag_errors(c->diag)) return false;
  c->facts = facts_find(arena, c->program);
  c->description = describe(arena, c->program, c->facts);
  return true;
}

static bool interpret(const Compilation *c, Collector *into) {
  LsysGrammar *grammar = interp_grammar(c->arena, c->program, c->description);
  bool well = derive(grammar, into);
  interp_release(grammar);
  return well;
}

// What fmt prints must mean the same, and be a fixed point.
static bool survives_printing(const Compilation *c, const Collector *word, FILE *nowhere) {
  char *once, *twice;
  size_t once_size, twice_size;
  FILE *out = open_memstream(&once, &once_size);
  fmt_print(c->ast, out);
  fclose(out);
  Compilation again;
  bool well = compile(&again, c->arena, once, once_size, nowhere);
  if (well) {
    out = open_memstream(&twice, &twice_size);
    fmt_print(again.ast, out);
    fclose(out);
    Collector other = collector(c->arena);
    well = interpret(&again, &other) && same_word(word, &other, "after fmt");
    if (well && (once_size != twice_size || memcmp(once, twice, once_size) != 0)) {
      fputs("fmt: a second pass changes the text\n", stderr);
      well = false;
    }
    free(twice);
  }
  free(once);
  return well;
}

// ---- threads --------------------------------------------------------------------

// A sink that keeps a digest only: words that threads share are too long to be kept.
typedef struct Digest {
  LsysSink sink;
  uint64_t symbols, arguments, modules;
} Digest;

static uint64_t mix(uint64_t digest, uint64_t value) {
  return (digest ^ value) * UINT64_C(0x100000001B3) + 1;
}

static bool digest(LsysSink *sink, const LsysWord *part) {
  Digest *to = (Digest *)sink;
  for (uint64_t i = 0; i < part->nsym; i++) to->symbols = mix(to->symbols, part->sym[i]);
  for (uint64_t i = 0; i < part->narg; i++) {
    uint64_t bits;
    memcpy(&bits, &part->arg[i], sizeof bits);
    to->arguments = mix(to->arguments, part->arg[i] == part->arg[i] ? bits : 0);
  }
  to->modules += part->nsym;
  return true;
}

static bool begin_digest(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)sink, (void)run, (void)axiom, (void)pass;
  return true;
}

static bool derive_digest(const LsysGrammar *grammar, uint64_t steps, uint64_t threads, Digest *into) {
  LsysOptions options = {0};
  options.at[LSYS_OPTION_STEPS] = (LsysOptionValue){.given = true, .whole = steps};
  options.at[LSYS_OPTION_THREADS] = (LsysOptionValue){.given = true, .whole = threads};
  LsysMemory memory = {.limit = UINT64_C(1) << 31};
  *into = (Digest){
    .sink = {.passes = 1, .begin = begin_digest, .take = digest, .end = end, .finish = end, .destroy = destroy}};
  return derive_into(grammar, &options, &memory, &into->sink, 0);
}

// So many steps that the work is worth sharing, on one thread and on seven.
static bool same_on_threads(const LsysGrammar *grammar, uint64_t steps) {
  Digest one, seven;
  if (!derive_digest(grammar, steps, 1, &one) || !derive_digest(grammar, steps, 7, &seven)) return false;
  if (one.modules == seven.modules && one.symbols == seven.symbols && one.arguments == seven.arguments) return true;
  fprintf(stderr, "after %" PRIu64 " steps, %" PRIu64 " modules: seven threads give another word than one\n", steps,
          one.modules);
  return false;
}

// The step engine on three threads, whose words are cut into stretches of a few modules: nearly all contexts reach
// over borders.
static bool same_in_stretches(const LsysGrammar *grammar, Arena *arena, const Collector *word) {
  if (!grammar->step) return true;
  LsysOptions options = {0};
  options.at[LSYS_OPTION_THREADS] = (LsysOptionValue){.given = true, .whole = 3};
  for (uint64_t stretch = 1; stretch <= 7; stretch += 3) {
    LsysMemory memory = {.limit = UINT64_C(1) << 31};
    Collector other = collector(arena);
    if (!derive_into(grammar, &options, &memory, &other.sink, stretch)) return false;
    Collector beginning = *word;
    beginning.sym.count = word->lengths.word * word->width;
    if (beginning.arg.count > other.arg.count) beginning.arg.count = other.arg.count;
    if (!same_word(&beginning, &other, "three threads")) return false;
  }
  return true;
}

// ---- births ---------------------------------------------------------------------

// The word as it is shown, and the step in which each of its modules was born.
static bool derive_births(const LsysGrammar *grammar, bool step, Collector *into) {
  LsysOptions options = {0};
  options.at[LSYS_OPTION_COLOUR_BY] = (LsysOptionValue){.given = true, .text = "age"};
  if (step) options.at[LSYS_OPTION_ENGINE] = (LsysOptionValue){.given = true, .text = "step"};
  LsysMemory memory = {.limit = UINT64_C(1) << 31};
  LsysSinkContext context = {.grammar = grammar, .options = &options, .memory = &memory};
  LsysSink *sink = &into->sink;
  if (grammar->flags & LSYS_GRAMMAR_HOMOMORPHISM) sink = lsys_sink_homomorphism(&context, sink);
  return sink && derive_into(grammar, &options, &memory, sink, 0);
}

static bool same_births(const Collector *a, const Collector *b, const char *who) {
  if (!same_word(a, b, who)) return false;
  for (size_t i = 0; i < a->born.count && i < b->born.count; i++)
    if (a->born.at[i] != b->born.at[i]) {
      fprintf(stderr, "%s: module %zu was born in step %" PRIu64 " in place of %" PRIu64 "\n", who, i, b->born.at[i],
              a->born.at[i]);
      return false;
    }
  return a->born.count == b->born.count;
}

static bool births_agree(const Compilation *c, const LsysGrammar *compiled) {
  LsysGrammar *interpreted = interp_grammar(c->arena, c->program, c->description);
  Collector reference = collector(c->arena), engine = collector(c->arena), step = collector(c->arena);
  bool well = derive_births(interpreted, false, &reference) && derive_births(compiled, false, &engine)
           && same_births(&reference, &engine, "births");
  interp_release(interpreted);
  if (!well || !compiled->expand || !compiled->step) return well;
  return derive_births(compiled, true, &step) && same_births(&reference, &step, "births of the step engine");
}

// ---- compiled code --------------------------------------------------------------

static Verdict compare_jit(const Engines *engines, const Compilation *c, const Collector *word, uint64_t long_steps) {
  if (!engines->backend) return VERDICT_AGREE;
  BackendOptions options = {.optimise = 2, .symbol = "lsys_grammar", .split = true};
  Jit *jit =
    engines->backend->jit(c->program, c->facts, c->description, &options, lsys_symbols, lsys_symbol_count, c->diag);
  if (!jit) return VERDICT_UNSUPPORTED;
  Collector other = collector(c->arena);
  const LsysGrammar *grammar = engines->backend->jit_grammar(jit);
  bool well = derive(grammar, &other) && same_word(word, &other, "jit");
  well = well && same_in_stretches(grammar, c->arena, &other) && births_agree(c, grammar);
  if (well && long_steps) well = same_on_threads(grammar, long_steps);
  engines->backend->jit_free(jit);
  return well ? VERDICT_AGREE : VERDICT_DIFFER;
}

// ---- executables ----------------------------------------------------------------

static Verdict compare_executables(const Engines *engines, Arena *arena, const char *text, size_t length) {
  char *path = arena_printf(arena, "%s/%d", engines->folder, (int)getpid());
  FILE *out = fopen(arena_printf(arena, "%s.lsys", path), "w");
  if (!out) return VERDICT_DIFFER;
  fwrite(text, 1, length, out);
  fclose(out);
  const char *script =
    "\"$L\" interp $G.lsys -w --hash >$G.h && \"$L\" interp $G.lsys -w --homomorphism >$G.w || exit 1\n"
    "for o in 0 2; do\n"
    "  \"$L\" -w -O$o -o $G.x $G.lsys || exit 1\n"
    "  $G.x --hash | cmp - $G.h && $G.x --homomorphism | cmp - $G.w || exit 1\n"
    "done\n";
  char *command = arena_printf(arena, "L='%s' G='%s'\n%s", engines->lsysc, path, script);
  bool well = system(command) == 0;
  for (size_t i = 0; i < 4; i++) {
    static const char *const suffixes[] = {"lsys", "h", "w", "x"};
    unlink(arena_printf(arena, "%s.%s", path, suffixes[i]));
  }
  if (!well) fputs("executables: see above\n", stderr);
  return well ? VERDICT_AGREE : VERDICT_DIFFER;
}

// ---- all together ---------------------------------------------------------------

Verdict engines_compare(const Engines *engines, const FuzzGrammar *grammar, bool thorough, Lengths *lengths) {
  Arena *arena = arena_create();
  char *text;
  size_t length;
  FILE *out = open_memstream(&text, &length);
  fuzz_print(grammar, out);
  fclose(out);
  Compilation c;
  Collector word = collector(arena);
  Verdict verdict = VERDICT_AGREE;
  if (!compile(&c, arena, text, length, engines->nowhere))
    verdict = VERDICT_REFUSED;
  else
    verdict = interpret(&c, &word) ? VERDICT_AGREE : VERDICT_DIFFER;
  if (lengths) *lengths = word.lengths;
  if (verdict == VERDICT_AGREE && !survives_printing(&c, &word, engines->nowhere)) verdict = VERDICT_DIFFER;
  uint64_t long_steps = thorough ? fuzz_most_steps(grammar, LONG_WORD) : 0;
  if (verdict == VERDICT_AGREE) verdict = compare_jit(engines, &c, &word, long_steps);
  if (verdict == VERDICT_AGREE && thorough && engines->lsysc)
    verdict = compare_executables(engines, arena, text, length);
  free(text);
  arena_destroy(arena);
  return verdict;
}

Verdict engines_compare_apart(const Engines *engines, const FuzzGrammar *grammar, bool thorough, Lengths *lengths,
                              bool loud) {
  enum { SECONDS = 60 };
  fflush(NULL);
  pid_t child = fork();
  if (child == 0) {
    if (!loud) {
      int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDERR_FILENO);
    }
    alarm(SECONDS);
    _exit((int)engines_compare(engines, grammar, thorough, lengths));
  }
  int status;
  if (child < 0 || waitpid(child, &status, 0) < 0) return VERDICT_CRASH;
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? VERDICT_LATE : VERDICT_CRASH;
  int code = WEXITSTATUS(status);
  return code < VERDICT_CRASH ? (Verdict)code : VERDICT_CRASH;
}
