// parse.c -- which notation a file is in, and its parser (LANGUAGE.md section 7).
#include "frontend/fractint.h"
#include "frontend/mws.h"
#include "frontend/native.h"
#include "frontend/view.h"
#include "support/diag.h"

#include <string.h>

typedef Ast *Parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                   const ParseOptions *options);

// In the order in which they are tried; the last takes every file.
static const struct {
  const char *name;
  bool (*recognise)(const SourceFile *file);
  Parse *parse;
} dialects[] = {
  {"mws", mws_recognise, mws_parse},
  {"fractint", fractint_recognise, fractint_parse},
  {"cpfg", cpfg_recognise, cpfg_parse},
  {"native", NULL, native_parse},
};
enum { DIALECTS = sizeof dialects / sizeof *dialects, NATIVE = DIALECTS - 1 };

// The dialect asked for or found; -1 if there is none of that name.
static int find_dialect(const SourceFile *file, const ParseOptions *options) {
  for (int i = 0; i < DIALECTS; i++) {
    if (options && options->dialect) {
      if (strcmp(options->dialect, dialects[i].name) == 0) return i;
    } else if (!dialects[i].recognise || dialects[i].recognise(file)) {
      return i;
    }
  }
  return -1;
}

Ast *parse_file(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options) {
  int dialect = find_dialect(file, options);
  if (dialect < 0) {
    diag_error(diag, (Span){0, 0}, "unknown dialect `%s`", options->dialect);
    dialect = NATIVE;
  }
  if (dialect != NATIVE && !(options && options->dialect))
    diag_remark(diag, (Span){file->base, file->base}, "read as a %s file; --dialect=native reads it otherwise",
                dialects[dialect].name);
  Ast *ast = dialects[dialect].parse(arena, sources, diag, file, options);
  if (options && options->view) view_read(arena, sources, diag, options, ast);
  return ast;
}

void parse_dump_tokens(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options,
                       FILE *out) {
  int dialect = find_dialect(file, options);
  bool cpfg = dialect >= 0 && dialects[dialect].parse == cpfg_parse;
  if (dialect == NATIVE || cpfg)
    native_dump_tokens(arena, sources, diag, file, options, cpfg, out);
  else
    diag_error(diag, (Span){0, 0}, "only native and cpfg files have tokens to print");
}
