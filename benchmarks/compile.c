// compile.c -- the passes of lsysc, through the library and its back end.
#include "compile.h"

#include "codegen/backend.h"
#include "support/diag.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

struct Compiled {
  Arena *arena;
  const Backend *backend;
  Jit *jit;
};

static const Backend *load(Arena *arena, const char *home) {
  void *module = dlopen(arena_printf(arena, "%s/lsysc-llvm.so", home), RTLD_NOW | RTLD_LOCAL);
  const Backend *backend = module ? dlsym(module, "lsysc_backend") : NULL;
  if (!backend) {
    fprintf(stderr, "bench: cannot load the code generator: %s\n", dlerror());
    exit(1);
  }
  return backend;
}

Compiled *compile_grammar(const char *path, const char *home) {
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  DiagOptions options;
  diag_options_default(&options);
  Diag *diag = diag_create(arena, sources, &options);
  const char *why = NULL;
  const SourceFile *file = sources_read(sources, path, (Span){0}, &why);
  if (!file) {
    fprintf(stderr, "bench: %s: %s\n", path, why);
    exit(1);
  }
  const Ast *ast = parse_file(arena, sources, diag, file, &(ParseOptions){0});
  const Program *program = diag_errors(diag) ? NULL : check(arena, ast, diag);
  if (!program) exit(1);
  const Facts *facts = facts_find(arena, program);
  Compiled *compiled = ARENA_NEW(arena, Compiled);
  *compiled = (Compiled){.arena = arena, .backend = load(arena, home)};
  BackendOptions how = {.optimise = 2, .cpu = "native", .symbol = "lsys_grammar", .split = true};
  compiled->jit = compiled->backend->jit(program, facts, describe(arena, program, facts), &how, lsys_symbols,
                                         lsys_symbol_count, diag);
  if (!compiled->jit) exit(1);
  return compiled;
}

const LsysGrammar *compiled_grammar(const Compiled *compiled) {
  return compiled->backend->jit_grammar(compiled->jit);
}

void compile_release(Compiled *compiled) {
  compiled->backend->jit_free(compiled->jit);
  arena_destroy(compiled->arena);
}
