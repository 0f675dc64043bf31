// backend.c -- the pipeline of code generation, and the table by which the
// driver reaches it: Program + Facts + description -> module -> file or running code.
#include "codegen/ir.h"

#include "support/laps.h"

#include <pthread.h>
#include <stdlib.h>

// Globals, or blocks that may do anything: nothing may happen in another order than it is written.
static bool has_state(const Ir *ir) {
  const Program *program = ir->program;
  for (size_t i = 0; i < program->array_count; i++)
    if (!program->arrays[i].constant) return true;
  if (ir->facts->sequential || program->start.count || program->start_each.count || program->end_each.count
      || program->end.count)
    return true;
  for (size_t i = 0; i < program->value_count; i++)
    if (program->values[i].kind == VALUE_GLOBAL) return true;
  return false;
}

static Entries build(Ir *ir, LLVMContextRef context, LLVMTargetMachineRef machine) {
  ir_create(ir, context, machine);
  ir->state = has_state(ir);
  ir->stepping = !ir->facts->context_free;
  ir->apart = ir->state || ir->program->lsystem_count > 1;
  if (ir->options->debug) debug_create(ir, diag_sources(ir->diag));
  counters_assign(ir);
  functions_declare(ir);
  expand_declare(ir);
  functions_define(ir);
  expand_define(ir);
  Entries entries = {init_emit(ir),   axiom_emit(ir),      entry_expand(ir),       step_emit(ir),
                     blocks_emit(ir), whole_decompose(ir), entry_homomorphism(ir), whole_interpret(ir)};
  return entries;
}

// What one thread compiles.
typedef struct Part {
  Ir ir;
  unsigned number, count;  // this one of so many
  EmitKind kind;
  LLVMTargetMachineRef machine;
  LLVMMemoryBufferRef *buffer;  // in Parts
} Part;

typedef struct Parts {
  Part at[BACKEND_PARTS];
  LLVMMemoryBufferRef buffers[BACKEND_PARTS];  // each optimised part as bytes; NULL after reporting
  unsigned count;
} Parts;

static void generate_part(Part *part) {
  Ir *ir = &part->ir;
  Laps *laps = part->number == 0 ? ir->options->laps : NULL;
  LLVMContextRef context = LLVMContextCreate();
  Entries entries = build(ir, context, part->machine);
  if (part->number == 0) freeze_grammar(ir, &entries);
  debug_finish(ir);
  if (part->count > 1) split_keep(ir, &entries, part->number);
  laps_end(laps, "emit IR");
  bool sound = diag_errors(ir->diag) == 0 && emit_passes(ir, part->machine);
  laps_end(laps, "optimise");
  if (sound) *part->buffer = emit_buffer(ir, part->machine, part->kind);
  ir_destroy(ir);
  LLVMContextDispose(context);
}

static void *run_part(void *part) {
  generate_part(part);
  return NULL;
}

// Starts threads for all parts but the first, which is compiled here; a part that gets no thread is compiled here, too.
static void generate_parts(Parts *parts) {
  enum { STACK = 64 << 20 };  // LLVM goes deep where a successor is long
  pthread_t threads[BACKEND_PARTS];
  bool started[BACKEND_PARTS] = {false};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, STACK);
  for (unsigned i = 1; i < parts->count; i++)
    started[i] = pthread_create(&threads[i], &attributes, run_part, &parts->at[i]) == 0;
  pthread_attr_destroy(&attributes);
  for (unsigned i = 0; i < parts->count; i++)
    if (!started[i]) generate_part(&parts->at[i]);
  for (unsigned i = 1; i < parts->count; i++)
    if (started[i]) pthread_join(threads[i], NULL);
}

static void release(Parts *parts) {
  for (unsigned i = 0; i < parts->count; i++) {
    if (parts->buffers[i]) LLVMDisposeMemoryBuffer(parts->buffers[i]);
    if (parts->at[i].machine) LLVMDisposeTargetMachine(parts->at[i].machine);
    arena_destroy(parts->at[i].ir.arena);
  }
}

// More than one where it pays: optimising is what takes time (-O1 hardly does any, -O3 looks at the whole module, debug
// information describes it), and there are functions enough to share out (a step through neighbours is one).
static unsigned count_parts(const Ir *ir, EmitKind kind) {
  enum { ENOUGH_PRODUCTIONS = 8 };
  const BackendOptions *options = ir->options;
  bool split = kind == EMIT_OBJECT && options->split && options->optimise == 2 && !options->debug;
  size_t productions = 0;
  for (size_t i = 0; i < ir->program->lsystem_count; i++) productions += ir->program->lsystems[i].productions.count;
  return split && ir->facts->context_free && productions >= ENOUGH_PRODUCTIONS ? BACKEND_PARTS : 1;
}

static void part_create(Parts *parts, unsigned number, const Ir *ir, EmitKind kind) {
  Part *part = &parts->at[number];
  *part = (Part){*ir, number, parts->count, kind, NULL, &parts->buffers[number]};
  part->ir.arena = arena_create();
  DiagOptions plain;
  diag_options_default(&plain);
  if (number > 0) part->ir.diag = diag_create(part->ir.arena, diag_sources(ir->diag), &plain);
}

// Compiles *ir as its options have it; parts holds the result until release. False after reporting.
static bool generate(const Ir *ir, EmitKind kind, bool this_machine, Parts *parts) {
  *parts = (Parts){.count = count_parts(ir, kind)};
  for (unsigned i = 0; i < parts->count; i++) part_create(parts, i, ir, kind);
  for (unsigned i = 0; i < parts->count; i++)
    if (!(parts->at[i].machine = machine_create(ir->options, this_machine, ir->diag))) return false;
  generate_parts(parts);
  laps_end(ir->options->laps, "generate");
  for (unsigned i = 0; i < parts->count; i++)
    if (!parts->buffers[i]) return false;
  return true;
}

static const char *version(void) {
  static char text[32];
  unsigned major, minor, patch;
  LLVMGetVersion(&major, &minor, &patch);
  snprintf(text, sizeof text, "LLVM %u.%u.%u", major, minor, patch);
  return text;
}

static bool write(LLVMMemoryBufferRef buffer, FILE *out, struct Diag *diag) {
  size_t size = LLVMGetBufferSize(buffer);
  if (fwrite(LLVMGetBufferStart(buffer), 1, size, out) == size && fflush(out) == 0) return true;
  diag_error(diag, (Span){0, 0}, "cannot write the generated code");
  return false;
}

static bool emit(const Program *program, const Facts *facts, const LsysGrammar *description,
                 const BackendOptions *options, FILE *out[BACKEND_PARTS], struct Diag *diag) {
  Ir ir = {.program = program, .facts = facts, .description = description, .options = options, .diag = diag};
  Parts parts;
  bool done = generate(&ir, options->emit, false, &parts);
  for (unsigned i = 0; done && i < parts.count; i++) done = write(parts.buffers[i], out[i], diag);
  release(&parts);
  return done;
}

static Jit *jit(const Program *program, const Facts *facts, const LsysGrammar *description,
                const BackendOptions *options, const LsysSymbol *symbols, size_t symbol_count, struct Diag *diag) {
  Ir ir = {.program = program, .facts = facts, .description = description, .options = options, .diag = diag};
  Parts parts;
  Jit *jit = NULL;
  if (generate(&ir, EMIT_OBJECT, true, &parts)) {
    LLVMTargetMachineRef machine = parts.at[0].machine;
    parts.at[0].machine = NULL;
    jit = jit_create(machine, parts.buffers, parts.count, options->symbol, symbols, symbol_count, diag);
  }
  laps_end(options->laps, "link");
  release(&parts);
  return jit;
}

__attribute__((visibility("default"))) const Backend lsysc_backend = {version, emit, jit, jit_grammar, jit_free};
