// view.c -- a line of a view file is a command, a colon and its values, behind
// C's preprocessor. Commands that say how cpfg's window looks are read over.
// Source: view.def; the manual of cpfg.
#include "frontend/view.h"

#include "frontend/reader.h"
#include "lsys/settings.h"
#include "support/utf8.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef enum Meaning {
  VIEW_NUMBER,
  VIEW_FACTOR,
  VIEW_LEVEL,
  VIEW_WIDTH,
  VIEW_STYLE,
  VIEW_VECTOR,
  VIEW_TROPISM,
  VIEW_TORQUE,
  VIEW_SURFACE,
  VIEW_FUNCTION,
  VIEW_FUNCTIONS,
  VIEW_CURVE,
  VIEW_CONTOUR,
  VIEW_NOTHING
} Meaning;

typedef struct Command {
  const char *keyword;
  Meaning meaning;
  unsigned setting;
} Command;

static const Command commands[] = {
#define VIEW(keyword, meaning, setting) {keyword, VIEW_##meaning, LSYS_SETTING_##setting},
#include "frontend/view.def"
};
enum { COMMANDS = sizeof commands / sizeof *commands };

typedef struct View {
  AstBuilder build;
  Diag *diag;
  const SourceFile *file;
  AstStatements *out;
  const Statement *line;  // that is being read
  const char *at;         // in it
  unsigned functions, curves;
  unsigned long contour;  // number of the last one
  unsigned tropisms;
  VEC(const char *) idle;  // commands without a meaning, each once
} View;

static const Notation notation_view = {.macros = true, .any_case = true, .lines = true, .line_comments = true};

// ---- values ------------------------------------------------------------------

static const char *skip(const char *at, const char *end) {
  for (;;) {
    size_t blank = utf8_blank(at, end);
    if (blank) {
      at += blank;
    } else if (at < end && *at == ',') {
      at++;
    } else if (utf8_starts(at, end, "/*")) {
      const char *close = memmem(at, (size_t)(end - at), "*/", 2);
      at = close ? close + 2 : end;
    } else {
      return utf8_starts(at, end, "//") ? end : at;
    }
  }
}

// The next word; false: there is none.
static bool word(View *view, Span *span, const char **text) {
  const char *begin = view->at = skip(view->at, view->line->end);
  while (view->at < view->line->end && skip(view->at, view->line->end) == view->at) view->at++;
  *span = statement_span(view->line, begin, view->at);
  *text = arena_copy(view->build.arena, begin, (size_t)(view->at - begin));
  return view->at > begin;
}

static bool number(View *view, const char *what, AstExpr **value) {
  Span span;
  const char *text;
  char *end;
  if (!word(view, &span, &text)) span = statement_span(view->line, view->line->begin, view->line->end);
  double parsed = strtod(text, &end);
  if (!*text || *end || !isfinite(parsed)) {
    diag_error(view->diag, span, "`%s:` needs %s", what,
               strcmp(what, "tropism") && strcmp(what, "torque") ? "a number"
                                                                 : "numbers behind its letters, three behind `T:`");
    return false;
  }
  *value = ast_number(view->build, span, parsed);
  return true;
}

static AstStatement *add(View *view, AstStatementKind kind) {
  AstStatement *statement = VEC_PUSH(view->build.arena, view->out);
  *statement = (AstStatement){.kind = kind, .beside = view->file, .fallback = true};
  statement->span = statement->name_span = statement_span(view->line, view->line->begin, view->line->end);
  return statement;
}

static AstStatement *given(const View *view, unsigned setting) {
  for (size_t i = 0; i < view->out->count; i++)
    if (view->out->at[i].kind == AST_SETTING && view->out->at[i].setting == setting) return &view->out->at[i];
  return NULL;
}

static void set(View *view, unsigned setting, AstExpr *value) {
  AstStatement *statement = given(view, setting);  // the last one counts
  if (!statement) statement = add(view, AST_SETTING);
  statement->setting = setting;
  statement->value = value;
}

// `pixels` and `pixel` of what may stand there: else a line is a polygon or a cylinder as wide as cpfg is told.
static void style(View *view) {
  Span span;
  const char *text;
  bool pixels = word(view, &span, &text) && (*text | 0x20) == 'p' && (text[1] | 0x20) == 'i';
  set(view, LSYS_SETTING_WIDTHS, ast_number(view->build, span, !pixels));
}

// A direction: three numbers, of which cpfg makes a vector of length 1.
static bool direction(View *view, const char *what, AstExpr *value[3]) {
  for (int i = 0; i < 3; i++)
    if (!number(view, what, &value[i])) return false;
  double length = hypot(hypot(value[0]->number, value[1]->number), value[2]->number);
  for (int i = 0; i < 3 && length > 0; i++) value[i]->number /= length;
  return true;
}

static void vector(View *view, const Command *command) {
  AstExpr *value[3];
  if (!direction(view, command->keyword, value)) return;
  for (unsigned i = 0; i < 3; i++) set(view, command->setting + i, value[i]);
}

// The next number times a factor.
static bool scale(View *view, const char *what, AstExpr *value[3], double least, double most) {
  AstExpr *factor;
  if (!number(view, what, &factor)) return false;
  double by = fmax(least, fmin(most, factor->number));
  for (int i = 0; i < 3; i++) value[i]->number *= by;
  return true;
}

// T: x y z [A: angle] [I: intensity] [E: elasticity] [S: increment]. cpfg makes the vector as long as the intensity,
// and no longer than 1.
static void tropism(View *view, const Command *command) {
  static const char keys[] = "AES";
  static const unsigned settings[] = {LSYS_SETTING_TROPISM_1_ANGLE, LSYS_SETTING_TROPISM_1_ELASTICITY,
                                      LSYS_SETTING_TROPISM_1_STEP};
  const unsigned shift = view->tropisms * LSYS_TROPISM_SETTINGS;
  Span span;
  const char *text;
  AstExpr *towards[3] = {NULL}, *value;
  if (view->tropisms == LSYS_TROPISMS) {
    diag_error(view->diag, statement_span(view->line, view->line->begin, view->line->end),
               "the turtle has room for %d tropisms and torques", LSYS_TROPISMS);
    return;
  }
  while (word(view, &span, &text)) {
    const char key = (char)(text[0] & ~0x20), *const known = strchr(keys, key);
    const bool well = key && strcmp(text + 1, ":") == 0;
    if (well && key == 'T') {
      if (!direction(view, command->keyword, towards)) return;
    } else if (well && key == 'I' && towards[0]) {
      if (!scale(view, command->keyword, towards, -1, 1)) return;
    } else if (well && known) {
      if (!number(view, command->keyword, &value)) return;
      set(view, settings[known - keys] + shift, value);
    } else {
      diag_error(view->diag, span, "`%s:` knows T: x y z, A: angle, I: intensity, E: elasticity and S: increment",
                 command->keyword);
      return;
    }
  }
  if (!towards[0]) {
    diag_error(view->diag, statement_span(view->line, view->line->begin, view->line->end),
               "`%s:` needs `T:` and three numbers", command->keyword);
    return;
  }
  for (unsigned i = 0; i < 3; i++) set(view, LSYS_SETTING_TROPISM_1_X + i + shift, towards[i]);
  if (command->meaning == VIEW_TORQUE)
    set(view, LSYS_SETTING_TROPISM_1_TORQUE + shift, ast_number(view->build, span, 1));
  view->tropisms++;
}

// ---- files -------------------------------------------------------------------

static AstExpr *file_name(View *view) {
  Span span;
  const char *text;
  if (word(view, &span, &text)) return ast_string(view->build, span, text);
  diag_error(view->diag, statement_span(view->line, view->line->begin, view->line->end), "a file's name is missing");
  return NULL;
}

static void surface(View *view) {
  Span span, size_span;
  const char *name, *size;
  bool named = word(view, &span, &name);
  AstExpr *path = file_name(view);
  if (!named || !path) return;
  AstStatement *statement = add(view, AST_SURFACE);
  statement->name = name;
  statement->name_span = span;
  statement->value = path;
  if (!word(view, &size_span, &size)) return;
  char *end;
  double scale = strtod(size, &end);
  if (*end || !isfinite(scale)) {
    diag_error(view->diag, size_span, "behind the file of a surface stands its size");
    return;
  }
  if (scale > 0) statement->low = ast_number(view->build, size_span, scale);
}

static void spline(View *view, Meaning meaning) {
  AstExpr *path = file_name(view);
  if (!path) return;
  AstStatement *statement = add(view, meaning == VIEW_CURVE ? AST_CURVE : AST_FUNCTION);
  statement->value = path;
  if (meaning == VIEW_FUNCTION) statement->name = arena_printf(view->build.arena, "func.%u", ++view->functions);
  if (meaning == VIEW_CURVE) statement->name = arena_printf(view->build.arena, "curve.%u", ++view->curves);
}

static bool is_whole(const char *text) {
  return *text && strspn(text, "0123456789") == strlen(text);
}

// number file, as in cpfg; or file [number].
static void contour(View *view) {
  Span span = {0, 0};
  const char *number = "";
  const char *before = view->at;
  bool first = word(view, &span, &number) && is_whole(number);
  if (!first) view->at = before;
  AstExpr *path = file_name(view);
  if (!path) return;
  AstStatement *statement = add(view, AST_CONTOUR);
  statement->value = path;
  if (first || word(view, &span, &number)) {
    statement->name = number;
    statement->name_span = span;
    view->contour = strtoul(number, NULL, 10);
  } else {
    statement->name = arena_printf(view->build.arena, "%lu", ++view->contour);
  }
}

// ---- commands ----------------------------------------------------------------

// The command that the line begins with; *rest is behind its colon.
static const Command *find(const Statement *line, const char **rest) {
  const char *colon = memchr(line->begin, ':', (size_t)(line->end - line->begin));
  if (!colon) return NULL;
  const char *end = colon;
  while (end > line->begin && (end[-1] == ' ' || end[-1] == '\t')) end--;
  *rest = colon + 1;
  for (int i = 0; i < COMMANDS; i++) {
    const char *at = line->begin, *keyword = commands[i].keyword;
    for (; *keyword && at < end; keyword++)
      if (*keyword == ' ' && utf8_blank(at, end))
        while (at < end && utf8_blank(at, end)) at += utf8_blank(at, end);
      else if ((*at | 0x20) == (*keyword | 0x20))
        at++;
      else
        break;
    if (!*keyword && at == end) return &commands[i];
  }
  return NULL;
}

// As commands are spelt in the table: small letters, single blanks.
static const char *plain_spelling(const View *view, const char *at, const char *end) {
  char *copy = arena_array(view->build.arena, (size_t)(end - at) + 1, 1), *to = copy;
  while (at < end) {
    size_t blank = utf8_blank(at, end);
    if (blank && to > copy && to[-1] != ' ') *to++ = ' ';
    if (!blank) *to++ = (char)(*at >= 'A' && *at <= 'Z' ? *at | 0x20 : *at);
    at += blank ? blank : 1;
  }
  while (to > copy && to[-1] == ' ') to--;
  *to = '\0';
  return copy;
}

static void unknown(View *view) {
  const Statement *line = view->line;
  const char *names[COMMANDS], *colon = memchr(line->begin, ':', (size_t)(line->end - line->begin));
  const char *end = colon ? colon : line->end;
  for (int i = 0; i < COMMANDS; i++) names[i] = commands[i].keyword;
  const char *given = arena_copy(view->build.arena, line->begin, (size_t)(end - line->begin));
  const char *meant = diag_nearest(plain_spelling(view, line->begin, end), names, COMMANDS);
  if (meant)
    diag_error(view->diag, statement_span(line, line->begin, end),
               "unknown command `%s:` of a view file; did you mean `%s:`?", given, meant);
  else
    diag_error(view->diag, statement_span(line, line->begin, end),
               "this is no command of a view file, such as `angle factor: 12`");
}

static void note_idle(View *view, const char *keyword) {
  for (size_t i = 0; i < view->idle.count; i++)
    if (view->idle.at[i] == keyword) return;
  *VEC_PUSH(view->build.arena, &view->idle) = keyword;
}

static void read_line(View *view) {
  const Command *command = find(view->line, &view->at);
  AstExpr *value;
  if (!command) {
    unknown(view);
    return;
  }
  switch (command->meaning) {
  case VIEW_NUMBER:
    if (number(view, command->keyword, &value)) set(view, command->setting, value);
    break;
  case VIEW_FACTOR:
    if (!number(view, command->keyword, &value)) break;
    set(view, command->setting, ast_binary(view->build, OP_DIV, ast_number(view->build, value->span, 360), value));
    break;
  case VIEW_LEVEL:
    if (!number(view, command->keyword, &value)) break;
    set(view, command->setting, ast_number(view->build, value->span, exp2(value->number + 1)));
    break;
  case VIEW_WIDTH:
    if (!number(view, command->keyword, &value)) break;
    set(view, command->setting, value);
    style(view);
    break;
  case VIEW_STYLE:
    style(view);
    break;
  case VIEW_VECTOR:
    vector(view, command);
    break;
  case VIEW_TROPISM:
  case VIEW_TORQUE:
    tropism(view, command);
    break;
  case VIEW_SURFACE:
    surface(view);
    break;
  case VIEW_FUNCTION:
  case VIEW_FUNCTIONS:
  case VIEW_CURVE:
    spline(view, command->meaning);
    break;
  case VIEW_CONTOUR:
    contour(view);
    break;
  case VIEW_NOTHING:
    note_idle(view, command->keyword);
    break;
  }
}

// What cpfg starts with where its view file says nothing.
static void add_defaults(View *view) {
  static const struct {
    unsigned setting;
    double value;
  } defaults[] = {{LSYS_SETTING_ANGLE, 45}, {LSYS_SETTING_WIDTH_STEP, 0}, {LSYS_SETTING_TROPISM_Y, 1}};
  const Statement nowhere = {.file = view->file, .begin = view->file->text, .end = view->file->text};
  view->line = &nowhere;
  for (size_t i = 0; i < sizeof defaults / sizeof *defaults; i++)
    if (!given(view, defaults[i].setting))
      set(view, defaults[i].setting,
          ast_number(view->build, (Span){view->file->base, view->file->base}, defaults[i].value));
  view->line = NULL;
}

static void tell_idle(View *view) {
  const char *list = "";
  for (size_t i = 0; i < view->idle.count; i++)
    list = arena_printf(view->build.arena, "%s%s%s:", list, i ? ", " : "", view->idle.at[i]);
  if (view->idle.count)
    diag_remark(view->diag, (Span){view->file->base, view->file->base}, "read over, as it has no meaning here: %s",
                list);
}

void view_read(Arena *arena, Sources *sources, Diag *diag, const ParseOptions *options, Ast *ast) {
  const char *why;
  const SourceFile *file = sources_read(sources, options->view, (Span){0, 0}, &why);
  if (!file) {
    diag_error(diag, (Span){0, 0}, "cannot read the view file `%s`: %s", options->view, why);
    return;
  }
  Parser parser;
  parser_init(&parser, arena, diag, sources, &notation_view);
  AstStatements statements = {0};
  View view = {.build = parser.build, .diag = diag, .file = file, .out = &statements};
  Reader *reader = reader_create(&parser, sources, file, options);
  while ((view.line = reader_next(reader)) != NULL) read_line(&view);
  add_defaults(&view);
  tell_idle(&view);
  parser_finish(&parser);
  for (size_t i = 0; i < ast->statements.count; i++) *VEC_PUSH(arena, &statements) = ast->statements.at[i];
  ast->statements = statements;
}
