// parse.c -- which notation a file is in, and its parser (LANGUAGE.md section 7).
#include "frontend/fractint.h"
#include "frontend/native.h"
#include "support/diag.h"

#include <string.h>

typedef struct Text {
  const char *at, *end;
} Text;

// The first line that is neither blank nor begins with the comment sign.
static Text first_line(const SourceFile *file, char comment) {
  Text rest = {file->text, file->text + file->length};
  for (;;) {
    while (rest.at < rest.end && strchr(" \t\r\n", *rest.at)) rest.at++;
    const char *end = memchr(rest.at, '\n', (size_t)(rest.end - rest.at));
    if (!end) return rest;
    if (*rest.at != comment) return (Text){rest.at, end};
    rest.at = end;
  }
}

static bool is_mws(const SourceFile *file) {
  Text line = first_line(file, '\0');
  return line.end - line.at >= 6 && memcmp(line.at, "#axiom", 6) == 0;
}

// `Name {` or `Name (remark) {`, where no statement has a brace.
static bool is_fractint(const SourceFile *file) {
  Text line = first_line(file, ';');
  const char *at = line.at;
  while (at < line.end && !strchr(" \t\r(;{", *at)) {
    if (strchr("#:/<>", *at) || (*at == '-' && at + 1 < line.end && strchr("->", at[1]))) return false;
    at++;
  }
  if (at == line.at) return false;
  while (at < line.end && (*at == ' ' || *at == '\t')) at++;
  if (at < line.end && *at == '(') {
    const char *close = memchr(at, ')', (size_t)(line.end - at));
    if (!close) return false;
    at = close + 1;
    while (at < line.end && (*at == ' ' || *at == '\t')) at++;
  }
  return at < line.end && *at == '{';
}

typedef Ast *Parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                   const ParseOptions *options);

// In the order in which they are tried; the last takes every file.
static const struct {
  const char *name;
  bool (*is)(const SourceFile *file);
  Parse *parse;
} dialects[] = {
  {"mws", is_mws, NULL},
  {"fractint", is_fractint, fractint_parse},
  {"native", NULL, native_parse},
};
enum { DIALECTS = sizeof dialects / sizeof *dialects, NATIVE = DIALECTS - 1 };

// The dialect asked for or found; -1 if there is none of that name.
static int find_dialect(const SourceFile *file, const ParseOptions *options) {
  for (int i = 0; i < DIALECTS; i++) {
    if (!dialects[i].parse) continue;
    if (options && options->dialect) {
      if (strcmp(options->dialect, dialects[i].name) == 0) return i;
    } else if (!dialects[i].is || dialects[i].is(file)) {
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
  return dialects[dialect].parse(arena, sources, diag, file, options);
}

void parse_dump_tokens(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options,
                       FILE *out) {
  if (find_dialect(file, options) == NATIVE)
    native_dump_tokens(arena, sources, diag, file, options, out);
  else
    diag_error(diag, (Span){0, 0}, "only files in the native notation have tokens to print");
}
