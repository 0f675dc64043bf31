// fuzz_parse.c -- any bytes -> parse and check; whatever happens must be a
// message. A libFuzzer target, built and run by tests/fuzz/parse/run. The first
// byte chooses the dialect.
#include "frontend/program.h"
#include "support/diag.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const dialects[] = {"native", "native", "native", "cpfg", "cpfg", "fractint", "mws", NULL};
  enum { DIALECTS = sizeof dialects / sizeof *dialects };
  if (size == 0) return 0;
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  char *messages;
  size_t length;
  DiagOptions options;
  diag_options_default(&options);
  diag_option(&options, "all");
  options.out = open_memstream(&messages, &length);
  Diag *diag = diag_create(arena, sources, &options);
  const SourceFile *file =
    sources_add(sources, "fuzz.lsys", arena_copy(arena, (const char *)data + 1, size - 1), size - 1, (Span){0, 0});
  Ast *ast = parse_file(arena, sources, diag, file, &(ParseOptions){.dialect = dialects[*data % DIALECTS]});
  ast_dump(ast, options.out);
  if (diag_errors(diag) == 0) {
    Program *program = check(arena, ast, diag);
    if (program) program_dump(program, options.out);
  }
  fclose(options.out);
  free(messages);
  arena_destroy(arena);
  return 0;
}
