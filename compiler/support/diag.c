// diag.c -- messages in the form that editors and people know:
//
//   plant.lsys:3:14: error: unknown name `lenght`; did you mean `length`?
//       3 | F(x) --> F(lenght*2)
//         |            ^~~~~~
#include "support/diag.h"

#include "support/utf8.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

// The part of a source line that a message shows.
typedef struct Excerpt {
  const SourceFile *file;  // NULL: none
  const char *from, *to;
  bool cut_before, cut_behind;
  uint32_t line;
} Excerpt;

struct Diag {
  Arena *arena;
  const Sources *sources;
  DiagOptions options;
  bool colour;
  bool shown;       // was the last message shown? Its notes go the same way.
  Excerpt excerpt;  // that was shown last
  size_t errors, warnings;
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

// Length of the character at `at`; a byte that is no UTF-8 counts as one.
static size_t character(const char *at, const char *end) {
  size_t length = utf8_length(at, end);
  return length ? length : 1;
}

static Excerpt excerpt(const Diag *diag, Span span) {
  enum { WIDEST = 120 };  // a word of a million modules is shown around the place only
  Place place = sources_place(diag->sources, span.begin);
  if (!place.file) return (Excerpt){0};
  const char *text = place.file->text, *file_end = text + place.file->length;
  const char *at = text + (span.begin - place.file->base), *line = at;
  while (line > text && line[-1] != '\n') line--;
  const char *line_end = memchr(line, '\n', (size_t)(file_end - line));
  if (!line_end) line_end = file_end;
  if (line_end > line && line_end[-1] == '\r') line_end--;
  const char *from = at - line > WIDEST / 2 ? at - WIDEST / 2 : line;
  while (from < at && ((unsigned char)*from & 0xC0) == 0x80) from++;
  const char *to = from;
  while (to < line_end && to - from < WIDEST) to += character(to, line_end);
  return (Excerpt){place.file, from, to, from > line, to < line_end, place.line};
}

static void show_text(FILE *out, const Excerpt *e) {
  fprintf(out, "%5u | %s", e->line, e->cut_before ? "..." : "");
  for (const char *at = e->from; at < e->to;) {
    size_t length = utf8_length(at, e->to);
    if (length == 0)
      fputs("\uFFFD", out);
    else if (((unsigned char)*at < ' ' && *at != '\t') || *at == 0x7F)
      fputc('?', out);
    else
      fwrite(at, 1, length, out);
    at += length ? length : 1;
  }
  fprintf(out, "%s\n", e->cut_behind ? "..." : "");
}

// The margin of a line below the text, up to the column of a place in it.
static void show_margin(FILE *out, const Excerpt *e, const char *place) {
  fprintf(out, "      | %s", e->cut_before ? "   " : "");
  for (const char *at = e->from; at < place && at < e->to; at += character(at, e->to))
    fputc(*at == '\t' ? '\t' : ' ', out);
}

static void show_line(Diag *diag, Span span) {
  Excerpt e = diag->excerpt = excerpt(diag, span);
  if (!e.file) return;
  FILE *out = diag->options.out;
  const char *at = e.file->text + (span.begin - e.file->base), *end = e.file->text + (span.end - e.file->base);
  show_text(out, &e);
  show_margin(out, &e, at);
  fprintf(out, "%s^", paint(diag, "\033[1;32m"));
  if (at < e.to) at += character(at, e.to);
  for (; at < end && at < e.to; at += character(at, e.to)) fputc('~', out);
  fprintf(out, "%s\n", paint(diag, "\033[0m"));
}

static void show_includes(const Diag *diag, Span span) {
  const SourceFile *file = sources_file(diag->sources, span.begin);
  if (!file || file->included_from.end == 0) return;
  Place from = sources_place(diag->sources, file->included_from.begin);
  if (!from.file) return;
  show_includes(diag, file->included_from);
  fprintf(diag->options.out, "in the file included at %s:%u:\n", from.file->path, from.line);
}

static void show(Diag *diag, const char *what, const char *code, Span span, const char *name, const char *format,
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
  show_line(diag, span);
}

// Whether the message numbered `number` of its sort is one too many to be shown.
static bool too_many(Diag *diag, size_t number, const char *sort) {
  size_t most = diag->options.max_errors;
  if (number == most + 1) fprintf(diag->options.out, "lsysc: note: further %s are not shown\n", sort);
  return number > most;
}

static void report(Diag *diag, bool error, const char *name, Span span, const char *format, va_list args) {
  diag->shown = !too_many(diag, error ? ++diag->errors : ++diag->warnings, error ? "errors" : "warnings");
  if (!diag->shown) return;
  Span macro;
  span = sources_origin(diag->sources, span, &macro);
  show_includes(diag, span);
  show(diag, error ? "error" : "warning", error ? "\033[31m" : "\033[35m", span, name, format, args);
  if (macro.end) diag_note(diag, macro, "from this macro");
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
  show(diag, "note", "\033[36m", sources_origin(diag->sources, span, NULL), NULL, format, args);
  va_end(args);
}

void diag_remark(Diag *diag, Span span, const char *format, ...) {
  diag->shown = !diag->options.no_warnings;
  if (!diag->shown) return;
  va_list args;
  va_start(args, format);
  show(diag, "note", "\033[36m", sources_origin(diag->sources, span, NULL), NULL, format, args);
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
  span = sources_origin(diag->sources, span, NULL);
  const Excerpt *e = &diag->excerpt;
  const char *at = e->file && span.begin >= e->file->base ? e->file->text + (span.begin - e->file->base) : NULL;
  if (!at || at < e->from || at > e->to) {
    show_line(diag, span);
    if (!e->file) return;
    at = e->file->text + (span.begin - e->file->base);
  }
  show_margin(diag->options.out, e, at);
  fprintf(diag->options.out, "%s%s%s\n", paint(diag, "\033[32m"), text, paint(diag, "\033[0m"));
}

// Edit distance where a swap of neighbours counts once (optimal string alignment); names over 63 bytes are far.
static size_t distance(const char *a, const char *b) {
  size_t n = strlen(a), m = strlen(b);
  enum { LONGEST = 64 };
  if (n >= LONGEST || m >= LONGEST) return SIZE_MAX;
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
    bool other_case = strcmp(name, candidates[i]) != 0 && strcasecmp(name, candidates[i]) == 0;
    size_t d = other_case ? 1 : distance(name, candidates[i]);
    if (d < best && d < length) {
      best = d;
      nearest = candidates[i];
    }
  }
  return nearest;
}
