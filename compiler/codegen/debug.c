// debug.c -- -g: a production is a lexical block at its place in the grammar,
// its parameters and variables are doubles in it.
//
// Code that tries productions belongs to line 0, code that applies one to that
// production's line: a breakpoint there stops where the production is applied.
// Parameters are kept in memory, so that a debugger finds them at -O0; the
// optimiser lifts them into registers again.
#include "codegen/ir.h"

#include <llvm-c/DebugInfo.h>
#include <string.h>

#define DW_ATE_FLOAT 4

struct DebugInfo {
  const Sources *sources;
  LLVMDIBuilderRef builder;
  LLVMMetadataRef number;    // the type double
  LLVMMetadataRef function;  // the one being built
};

static LLVMMetadataRef file_of(Ir *ir, const SourceFile *file) {
  const char *path = file ? file->path : "<command line>";
  return LLVMDIBuilderCreateFile(ir->debug->builder, path, strlen(path), ".", 1);
}

void debug_create(Ir *ir, const Sources *sources) {
  DebugInfo *debug = ir->debug = ARENA_NEW(ir->arena, DebugInfo);
  debug->sources = sources;
  debug->builder = LLVMCreateDIBuilder(ir->module);
  LLVMDIBuilderCreateCompileUnit(debug->builder, LLVMDWARFSourceLanguageC, file_of(ir, ir->program->file), "lsysc", 5,
                                 ir->options->optimise > 0, "", 0, 0, "", 0, LLVMDWARFEmissionFull, 0, false, false, "",
                                 0, "", 0);
  debug->number = LLVMDIBuilderCreateBasicType(debug->builder, "double", strlen("double"), 64, DW_ATE_FLOAT, 0);
  LLVMValueRef version = LLVMConstInt(ir->types.i32, LLVMDebugMetadataVersion(), false);
  LLVMAddModuleFlag(ir->module, LLVMModuleFlagBehaviorWarning, "Debug Info Version", strlen("Debug Info Version"),
                    LLVMValueAsMetadata(version));
}

void debug_finish(Ir *ir) {
  if (!ir->debug) return;
  LLVMDIBuilderFinalize(ir->debug->builder);
  LLVMDisposeDIBuilder(ir->debug->builder);
}

static void set_location(Ir *ir, LLVMMetadataRef scope, unsigned line, unsigned column) {
  LLVMMetadataRef at = LLVMDIBuilderCreateDebugLocation(ir->context, line, column, scope, NULL);
  LLVMSetCurrentDebugLocation2(ir->builder, at);
}

void debug_function(Ir *ir, LLVMValueRef function, Span span) {
  DebugInfo *debug = ir->debug;
  if (!debug) return;
  Place place = sources_place(debug->sources, span.begin);
  LLVMMetadataRef file = file_of(ir, place.file ? place.file : ir->program->file);
  LLVMMetadataRef type = LLVMDIBuilderCreateSubroutineType(debug->builder, file, NULL, 0, 0);
  size_t length;
  const char *name = LLVMGetValueName2(function, &length);
  debug->function = LLVMDIBuilderCreateFunction(debug->builder, file, name, length, name, length, file, place.line,
                                                type, true, true, 0, 0, ir->options->optimise > 0);
  LLVMSetSubprogram(function, debug->function);
  set_location(ir, debug->function, 0, 0);
}

// A variable of scope named name that lives in memory from here on.
static void show(Ir *ir, const Slot *slot, const char *name, unsigned parameter, LLVMMetadataRef scope, Place place) {
  DebugInfo *debug = ir->debug;
  LLVMMetadataRef file = file_of(ir, place.file), variable;
  LLVMValueRef address = slot->address;
  if (!address) {
    address = ir_local(ir, ir->types.f64, 1, name);
    LLVMBuildStore(ir->builder, slot->value, address);
  }
  if (parameter)
    variable = LLVMDIBuilderCreateParameterVariable(debug->builder, scope, name, strlen(name), parameter, file,
                                                    place.line, debug->number, true, 0);
  else
    variable = LLVMDIBuilderCreateAutoVariable(debug->builder, scope, name, strlen(name), file, place.line,
                                               debug->number, true, 0, 0);
  LLVMMetadataRef at = LLVMDIBuilderCreateDebugLocation(ir->context, place.line, place.column, scope, NULL);
  LLVMMetadataRef plain = LLVMDIBuilderCreateExpression(debug->builder, NULL, 0);
  LLVMDIBuilderInsertDeclareRecordAtEnd(debug->builder, address, variable, plain, at, LLVMGetInsertBlock(ir->builder));
}

void debug_arguments(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  if (!ir->debug) return;
  const Pattern *strict = &production->strict.at[0];
  for (uint32_t i = 0; i < ir->program->kinds[rewrite->kind].arity; i++) {
    const char *name = production->slot_names[strict->slot + i];
    Slot slot = {.value = rewrite->args[i]};
    Place place = sources_place(ir->debug->sources, production->head.begin);
    if (name) show(ir, &slot, name, i + 1, ir->debug->function, place);
  }
}

// The stores stand before the production's line begins: where a debugger stops, they are done.
void debug_enter(Rewrite *rewrite, const Production *production) {
  Ir *ir = rewrite->scope.ir;
  DebugInfo *debug = ir->debug;
  if (!debug) return;
  Place place = sources_place(debug->sources, production->head.begin);
  LLVMMetadataRef block =
    LLVMDIBuilderCreateLexicalBlock(debug->builder, debug->function, file_of(ir, place.file), place.line, place.column);
  for (uint32_t i = 0; i < production->parameters + production->locals; i++)
    if (production->slot_names[i]) show(ir, &rewrite->scope.slots[i], production->slot_names[i], 0, block, place);
  set_location(ir, block, place.line, place.column);
}

void debug_leave(Rewrite *rewrite) {
  Ir *ir = rewrite->scope.ir;
  if (ir->debug) set_location(ir, ir->debug->function, 0, 0);
}
