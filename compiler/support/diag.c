// diag.c -- messages in the form that editors and people know:
//
//   plant.lsys:3:14: error: unknown name `lenght`; did you mean `length`?
//       3 | F(x) --> F(lenght*2)
//         |            ^~~~~~
#include "support/diag.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct Diag {
  Arena *arena;
  const Sources *sources;
  DiagOptions options;
  bool colour;
  bool shown;  // was the last message shown? Its notes go the same way.
  size_t errors;
};

static const struct {
  const char *name;
  bool on;
} warnings[WARN_COUNT] = {
#define WARNING(id, name, on, doc) [WARN_##id] = {name, on},
#include "support/warnings.def"
#undef WARNING
};

void diag_options_default(DiagOptions *options) {
  *options = (DiagOptions){.colour = COLOUR_AUTO, .max_errors = 20, .out = stderr};
  for (int i = 0; i < WARN_COUNT; i++) options->on[i] = warnings[i].on;
}

bool diag_option(DiagOptions *options, const char *argument) {
  if (strcmp(argument, "error") == 0) return options->warnings_are_errors = true;
  bool on = strncmp(argument, "no-", 3) != 0;
  const char *name = on ? argument : argument + 3;
  bool all = strcmp(name, "all") == 0, found = all;
  for (int i = 0; i < WARN_COUNT; i++)
    if (all || strcmp(name, warnings[i].name) == 0) {
      options->on[i] = on;
      found = true;
    }
  return found;
}

Diag *diag_create(Arena *arena, const Sources *sources, const DiagOptions *options) {
  Diag *diag = ARENA_NEW(arena, Diag);
  *diag = (Diag){.arena = arena, .sources = sources, .options = *options};
  diag->colour = options->colour == COLOUR_ALWAYS
              || (options->colour == COLOUR_AUTO && isatty(fileno(options->out)) && !getenv("NO_COLOR"));
  return diag;
}

size_t diag_errors(const Diag *diag) {
  return diag->errors;
}

const Sources *diag_sources(const Diag *diag) {
  return diag->sources;
}

static const char *paint(const Diag *diag, const char *code) {
  return diag->colour ? code : "";
}

// Writes count columns of the line's text from `at`, as blanks (tabs stay tabs) or as a caret range.
static const char *columns(FILE *out, const char *at, const char *end, const char *line_end, char first, char rest) {
  for (char mark = first; at < end && at < line_end; at++) {
    if (((unsigned char)*at & 0xC0) == 0x80) continue;
    fputc(first == ' ' && *at == '\t' ? '\t' : mark, out);
    mark = rest;
  }
  return at;
}

static void show_line(const Diag *diag, Span span, const char *fix) {
  FILE *out = diag->options.out;
  Place place = sources_place(diag->sources, span.begin);
  if (!place.file) return;
  const char *text = place.file->text, *file_end = text + place.file->length;
  const char *at = text + (span.begin - place.file->base), *line = at;
  while (line > text && line[-1] != '\n') line--;
  const char *line_end = memchr(line, '\n', (size_t)(file_end - line));
  if (!line_end) line_end = file_end;
  if (line_end > line && line_end[-1] == '\r') line_end--;

  enum { WIDEST = 160 };  // a word of a million modules is shown around the place only
  const char *from = at - line > WIDEST / 2 ? at - WIDEST / 2 : line;
  while (from > line && ((unsigned char)*from & 0xC0) == 0x80) from--;
  const char *to = line_end - from > WIDEST ? from + WIDEST : line_end;
  while (to < line_end && ((unsigned char)*to & 0xC0) == 0x80) to++;

  fprintf(out, "%5u | %s", place.line, from > line ? "..." : "");
  for (const char *c = from; c < to; c++) fputc((unsigned char)*c < ' ' && *c != '\t' ? '?' : *c, out);
  fprintf(out, "%s\n      | %s%s", to < line_end ? "..." : "", from > line ? "   " : "", paint(diag, "\033[1;32m"));
  columns(out, from, at, to, ' ', ' ');
  const char *end = text + (span.end - place.file->base);
  if (columns(out, at, end, to, '^', '~') == at) fputc('^', out);
  fprintf(out, "%s\n", paint(diag, "\033[0m"));
  if (fix && *fix) {
    fprintf(out, "      | %s", from > line ? "   " : "");
    columns(out, from, at, to, ' ', ' ');
    fprintf(out, "%s%s%s\n", paint(diag, "\033[32m"), fix, paint(diag, "\033[0m"));
  }
}

static void show_includes(const Diag *diag, Span span) {
  const SourceFile *file = sources_file(diag->sources, span.begin);
  if (!file || file->included_from.end == 0) return;
  Place from = sources_place(diag->sources, file->included_from.begin);
  if (!from.file) return;
  show_includes(diag, file->included_from);
  fprintf(diag->options.out, "in the file included at %s:%u:\n", from.file->path, from.line);
}

static void show(const Diag *diag, const char *what, const char *code, Span span, const char *name, const char *format,
                 va_list args) {
  FILE *out = diag->options.out;
  Place place = sources_place(diag->sources, span.begin);
  fputs(paint(diag, "\033[1m"), out);
  if (place.file)
    fprintf(out, "%s:%u:%u: ", place.file->path, place.line, place.column);
  else
    fputs("lsysc: ", out);
  fprintf(out, "%s%s:%s ", paint(diag, code), what, paint(diag, "\033[0m"));
  vfprintf(out, format, args);
  if (name) fprintf(out, " [-W%s]", name);
  fputc('\n', out);
  show_line(diag, span, NULL);
}

static void report(Diag *diag, bool error, const char *name, Span span, const char *format, va_list args) {
  if (error && ++diag->errors > diag->options.max_errors) {
    diag->shown = false;
    if (diag->errors == diag->options.max_errors + 1)
      fprintf(diag->options.out, "lsysc: note: further errors are not shown\n");
    return;
  }
  diag->shown = true;
  show_includes(diag, span);
  show(diag, error ? "error" : "warning", error ? "\033[31m" : "\033[35m", span, name, format, args);
}

void diag_error(Diag *diag, Span span, const char *format, ...) {
  va_list args;
  va_start(args, format);
  report(diag, true, NULL, span, format, args);
  va_end(args);
}

void diag_warning(Diag *diag, WarningId id, Span span, const char *format, ...) {
  diag->shown = diag->options.on[id] && !diag->options.no_warnings;
  if (!diag->shown) return;
  va_list args;
  va_start(args, format);
  report(diag, diag->options.warnings_are_errors, warnings[id].name, span, format, args);
  va_end(args);
}

void diag_note(Diag *diag, Span span, const char *format, ...) {
  if (!diag->shown) return;
  va_list args;
  va_start(args, format);
  show(diag, "note", "\033[36m", span, NULL, format, args);
  va_end(args);
}

void diag_remark(Diag *diag, Span span, const char *format, ...) {
  diag->shown = !diag->options.no_warnings;
  if (!diag->shown) return;
  va_list args;
  va_start(args, format);
  show(diag, "note", "\033[36m", span, NULL, format, args);
  va_end(args);
}

void diag_hint(Diag *diag, const char *format, ...) {
  if (!diag->shown) return;
  va_list args;
  va_start(args, format);
  fprintf(diag->options.out, "      %s= hint:%s ", paint(diag, "\033[1;34m"), paint(diag, "\033[0m"));
  vfprintf(diag->options.out, format, args);
  fputc('\n', diag->options.out);
  va_end(args);
}

void diag_fix(Diag *diag, Span span, const char *text) {
  if (!diag->shown) return;
  show_line(diag, span, text);
}

// Edit distance where a swap of neighbours counts once (optimal string alignment); names over 63 bytes are far.
static size_t distance(const char *a, const char *b) {
  size_t n = strlen(a), m = strlen(b);
  enum { LONGEST = 64 };
  if (n >= LONGEST || m >= LONGEST) return LONGEST;
  size_t row[3][LONGEST];
  for (size_t j = 0; j <= m; j++) row[0][j] = j;
  for (size_t i = 1; i <= n; i++) {
    size_t *now = row[i % 3], *above = row[(i + 2) % 3], *before = row[(i + 1) % 3];
    now[0] = i;
    for (size_t j = 1; j <= m; j++) {
      size_t best = above[j - 1] + (a[i - 1] != b[j - 1]);
      if (above[j] + 1 < best) best = above[j] + 1;
      if (now[j - 1] + 1 < best) best = now[j - 1] + 1;
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && before[j - 2] + 1 < best)
        best = before[j - 2] + 1;
      now[j] = best;
    }
  }
  return row[n % 3][m];
}

const char *diag_nearest(const char *name, const char *const *candidates, size_t count) {
  size_t length = strlen(name), best = (length < 6 ? 1 : length / 3) + 1;
  const char *nearest = NULL;
  for (size_t i = 0; i < count; i++) {
    if (!candidates[i]) continue;
    size_t d = distance(name, candidates[i]);
    if (d < best && d < length) {
      best = d;
      nearest = candidates[i];
    }
  }
  return nearest;
}
