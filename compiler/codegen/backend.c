// backend.c -- the pipeline of code generation, and the table by which the
// driver reaches it: Program + Facts + description -> module -> file or running code.
#include "codegen/ir.h"

#include "support/laps.h"

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

static void build(Ir *ir, LLVMContextRef context, LLVMTargetMachineRef machine) {
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
  freeze_grammar(ir, &entries);
  debug_finish(ir);
}

// The optimised module as bytes; machine is what it was made for. NULL after reporting.
static LLVMMemoryBufferRef generate(Ir *ir, EmitKind kind, LLVMTargetMachineRef machine) {
  LLVMContextRef context = LLVMContextCreate();
  ir->arena = arena_create();
  build(ir, context, machine);
  laps_end(ir->options->laps, "emit IR");
  bool sound = diag_errors(ir->diag) == 0 && emit_passes(ir, machine);
  laps_end(ir->options->laps, "optimise");
  LLVMMemoryBufferRef buffer = sound ? emit_buffer(ir, machine, kind) : NULL;
  laps_end(ir->options->laps, "generate");
  ir_destroy(ir);
  arena_destroy(ir->arena);
  LLVMContextDispose(context);
  return buffer;
}

static const char *version(void) {
  static char text[32];
  unsigned major, minor, patch;
  LLVMGetVersion(&major, &minor, &patch);
  snprintf(text, sizeof text, "LLVM %u.%u.%u", major, minor, patch);
  return text;
}

static bool emit(const Program *program, const Facts *facts, const LsysGrammar *description,
                 const BackendOptions *options, FILE *out, struct Diag *diag) {
  Ir ir = {.program = program, .facts = facts, .description = description, .options = options, .diag = diag};
  LLVMTargetMachineRef machine = machine_create(options, false, diag);
  if (!machine) return false;
  LLVMMemoryBufferRef buffer = generate(&ir, options->emit, machine);
  LLVMDisposeTargetMachine(machine);
  if (!buffer) return false;
  size_t size = LLVMGetBufferSize(buffer);
  bool written = fwrite(LLVMGetBufferStart(buffer), 1, size, out) == size && fflush(out) == 0;
  LLVMDisposeMemoryBuffer(buffer);
  if (!written) diag_error(diag, (Span){0, 0}, "cannot write the generated code");
  return written;
}

static Jit *jit(const Program *program, const Facts *facts, const LsysGrammar *description,
                const BackendOptions *options, const LsysSymbol *symbols, size_t symbol_count, struct Diag *diag) {
  Ir ir = {.program = program, .facts = facts, .description = description, .options = options, .diag = diag};
  LLVMTargetMachineRef machine = machine_create(options, true, diag);
  if (!machine) return NULL;
  LLVMMemoryBufferRef object = generate(&ir, EMIT_OBJECT, machine);
  if (!object) {
    LLVMDisposeTargetMachine(machine);
    return NULL;
  }
  Jit *jit = jit_create(machine, object, options->symbol, symbols, symbol_count, diag);
  laps_end(options->laps, "link");
  return jit;
}

__attribute__((visibility("default"))) const Backend lsysc_backend = {version, emit, jit, jit_grammar, jit_free};
