// fractint.c -- a file of Fractint's L-systems -> the Ast of one of them.
//
// In: a file of entries `Name { statements }`. Out: settings, one axiom, one
// production a letter, all in our turtle's symbols (fractint_word.c). Ensures:
// the Ast needs no rule of its own in later passes.
// The format as its reader (lsys.c, scan_entries) takes it, not as its help
// describes it; oddities that it swallows silently are warned of.
#include "frontend/fractint.h"

#include "frontend/fractint_word.h"
#include "lsys/settings.h"
#include "support/diag.h"

#include <string.h>
#include <strings.h>

enum {
  LONGEST_NAME = 18,
  LEAST_ANGLE = 3,
  MOST_ANGLE = 50,
  DEFAULT_ORDER = 2,  // Fractint's, where the user gives none
  START_COLOUR = 15,
  END_OF_FILE = 0x1A  // ^Z of DOS
};

// ---- entries ---------------------------------------------------------------

typedef struct System {
  Span name;     // without a "lsys:" before it
  Span brace;    // its {
  Span body;     // between the braces
  bool closed;   // there was a } before the next {
  bool foreign;  // a comment or an entry of another kind
} System;
typedef VEC(System) Systems;

typedef struct Scan {
  const char *text;
  size_t at, end;
  uint32_t base;
} Scan;

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

static void skip_line(Scan *in) {
  const char *newline = memchr(in->text + in->at, '\n', in->end - in->at);
  in->at = newline ? (size_t)(newline - in->text) : in->end;
}

static bool has_prefix(const Scan *in, Span name, const char *prefix) {
  size_t length = strlen(prefix);
  return name.end - name.begin >= length && strncasecmp(in->text + (name.begin - in->base), prefix, length) == 0;
}

static void classify(const Scan *in, System *system) {
  system->foreign = has_prefix(in, system->name, "frm:") || has_prefix(in, system->name, "ifs:")
                 || has_prefix(in, system->name, "par:") || system->name.begin == system->name.end
                 || (has_prefix(in, system->name, "comment") && system->name.end - system->name.begin == 7);
  if (has_prefix(in, system->name, "lsys:")) system->name.begin += 5;
  if (system->name.end - system->name.begin > LONGEST_NAME) system->name.end = system->name.begin + LONGEST_NAME;
}

// Reads the name and what stands up to the { on the same line. False: the line is none of an entry.
static bool entry_head(Scan *in, System *system) {
  size_t begin = in->at;
  while (in->at < in->end && !is_blank(in->text[in->at]) && !strchr("(;{", in->text[in->at])) in->at++;
  system->name = (Span){in->base + (uint32_t)begin, in->base + (uint32_t)in->at};
  while (in->at < in->end && !strchr("{;\n", in->text[in->at])) in->at++;
  if (in->at == in->end || in->text[in->at] != '{') return false;
  system->brace = (Span){in->base + (uint32_t)in->at, in->base + (uint32_t)in->at + 1};
  in->at++;
  return true;
}

// Reads on to the }. At another { the entry is none, and reading goes on behind its first line.
static void entry_body(Scan *in, System *system) {
  size_t begin = in->at;
  while (in->at < in->end && in->text[in->at] != '}' && in->text[in->at] != '{') {
    if (in->text[in->at] == ';')
      skip_line(in);
    else
      in->at++;
  }
  system->closed = in->at < in->end && in->text[in->at] == '}';
  system->body = (Span){in->base + (uint32_t)begin, in->base + (uint32_t)in->at};
  if (system->closed) {
    in->at++;
  } else if (in->at < in->end) {
    in->at = begin;
    skip_line(in);
  }
}

static Systems find_systems(Arena *arena, const SourceFile *file) {
  Systems systems = {0};
  const char *stop = memchr(file->text, END_OF_FILE, file->length);
  Scan in = {file->text, 0, stop ? (size_t)(stop - file->text) : file->length, file->base};
  while (in.at < in.end) {
    if (is_blank(in.text[in.at])) {
      in.at++;
    } else if (in.text[in.at] == ';') {
      skip_line(&in);
    } else {
      System system = {0};
      if (!entry_head(&in, &system)) {
        skip_line(&in);
        continue;
      }
      entry_body(&in, &system);
      classify(&in, &system);
      *VEC_PUSH(arena, &systems) = system;
    }
  }
  return systems;
}

// A line that begins with a keyword which no other notation writes without a colon.
static bool has_keyword(const char *at, const char *end) {
  while (at < end) {
    while (at < end && is_blank(*at)) at++;
    bool keyword = end - at > 5 && (strncasecmp(at, "axiom", 5) == 0 || strncasecmp(at, "angle", 5) == 0);
    if (keyword && (is_blank(at[5]) || at[5] == '=')) return true;
    const char *newline = memchr(at, '\n', (size_t)(end - at));
    at = newline ? newline + 1 : end;
  }
  return false;
}

// `Start: {` and `A : { ... }` are blocks of native and cpfg files.
static bool has_colon(const char *at, const char *end) {
  return memchr(at, ':', (size_t)(end - at)) != NULL;
}

bool fractint_recognise(const SourceFile *file) {
  Arena *arena = arena_create();
  Systems systems = find_systems(arena, file);
  bool found = false;
  for (size_t i = 0; i < systems.count && !found; i++) {
    const System *system = &systems.at[i];
    const char *name = file->text + (system->name.begin - file->base);
    const char *body = file->text + (system->body.begin - file->base);
    bool block = has_colon(name, file->text + (system->brace.begin - file->base));
    found = !system->foreign && !block && has_keyword(body, body + (system->body.end - system->body.begin));
  }
  arena_destroy(arena);
  return found;
}

void fractint_list(const SourceFile *file, FILE *out) {
  Arena *arena = arena_create();
  Systems systems = find_systems(arena, file);
  for (size_t i = 0; i < systems.count; i++) {
    const System *system = &systems.at[i];
    if (system->foreign || !system->closed) continue;
    fprintf(out, "%.*s\n", (int)(system->name.end - system->name.begin),
            file->text + (system->name.begin - file->base));
  }
  arena_destroy(arena);
}

// ---- statements ------------------------------------------------------------

typedef struct Rule {
  unsigned char letter;
  Span head, all;
  FractintString string;
} Rule;

typedef struct Parser {
  Arena *arena;
  struct Diag *diag;
  const SourceFile *file;
  FractintWords words;
  VEC(Rule) rules;    // in the order in which their letters first stand
  size_t index[256];  // letter -> rule + 1
  Span axiom_line;    // the last `axiom`; nowhere: none yet
  FractintString axiom;
  Span angle_line;
  Span angle;  // its number
} Parser;

static const char *text_at(const Parser *parser, uint32_t offset) {
  return parser->file->text + (offset - parser->file->base);
}

// Spans as printf's %.*s
#define QUOTE(parser, span) (int)((span).end - (span).begin), text_at((parser), (span).begin)

static bool is_word(const Parser *parser, Span span, const char *word) {
  return span.end - span.begin == strlen(word) && strncasecmp(text_at(parser, span.begin), word, strlen(word)) == 0;
}

// The next word of a line: what stands between blanks and any of `separators`; empty at the end.
static Span take_word(const Parser *parser, Span *line, const char *separators) {
  const char *at = text_at(parser, line->begin), *end = text_at(parser, line->end);
  while (at < end && (is_blank(*at) || (*at && strchr(separators, *at)))) at++;
  const char *begin = at;
  while (at < end && !is_blank(*at) && !(*at && strchr(separators, *at))) at++;
  Span word = {line->begin + (uint32_t)(begin - text_at(parser, line->begin)), 0};
  word.end = word.begin + (uint32_t)(at - begin);
  line->begin = word.end;
  return word;
}

static bool is_empty(Span span) {
  return span.begin == span.end;
}

static void read_axiom(Parser *parser, Span keyword, Span *line) {
  Span word = take_word(parser, line, "=");
  if (is_empty(word)) {
    diag_error(parser->diag, keyword, "`axiom` wants a string of commands behind it, such as `axiom f--f--f`");
    parser->axiom_line = keyword;
    return;
  }
  if (parser->axiom.count) {
    diag_warning(parser->diag, WARN_DIALECT, keyword, "a second axiom takes the place of the first");
    diag_note(parser->diag, parser->axiom_line, "the first stands here");
  }
  parser->axiom = (FractintString){0};
  *VEC_PUSH(parser->arena, &parser->axiom) = word;
  parser->axiom_line = span_join(keyword, word);
}

static void read_angle(Parser *parser, Span keyword, Span *line) {
  Span word = take_word(parser, line, "=");
  parser->angle_line = span_join(keyword, word);
  parser->angle = word;
  unsigned value = 0;
  bool digits = !is_empty(word);
  for (uint32_t i = word.begin; i < word.end; i++) {
    char c = *text_at(parser, i);
    if (c < '0' || c > '9')
      digits = false;
    else if (value <= MOST_ANGLE)
      value = value * 10 + (unsigned)(c - '0');
  }
  if (digits && value >= LEAST_ANGLE && value <= MOST_ANGLE) {
    parser->words.angle = value;
    return;
  }
  diag_error(parser->diag, is_empty(word) ? keyword : word,
             "`angle` wants a whole number from %d to %d: the number of turns in a circle, so that 6 is 60 degrees",
             LEAST_ANGLE, MOST_ANGLE);
}

static void read_rule(Parser *parser, Span letter, Span *line) {
  static const char reserved[] = "+-/\\@|!cC<>[]";
  char c = *text_at(parser, letter.begin);
  Span string = take_word(parser, line, "=");
  if (c && strchr(reserved, c)) {
    diag_error(parser->diag, letter, "`%c` is a command and cannot have a rule", c);
    return;
  }
  if (c >= 'A' && c <= 'Z') c = (char)(c + ('a' - 'A'));
  size_t *index = &parser->index[(unsigned char)c];
  if (!*index) {
    *VEC_PUSH(parser->arena, &parser->rules) = (Rule){.letter = (unsigned char)c, .head = letter, .all = letter};
    *index = parser->rules.count;
  }
  Rule *rule = &parser->rules.at[*index - 1];
  // Further lines for the same letter go on with its string.
  if (!is_empty(string)) *VEC_PUSH(parser->arena, &rule->string) = string;
  rule->all = span_join(rule->all, span_join(letter, string));
}

static void read_line(Parser *parser, Span line) {
  static const char *const keywords[] = {"axiom", "angle"};
  Span word = take_word(parser, &line, "=");
  if (is_empty(word)) return;
  if (is_word(parser, word, "axiom")) {
    read_axiom(parser, word, &line);
  } else if (is_word(parser, word, "angle")) {
    read_angle(parser, word, &line);
  } else if (word.end - word.begin == 1) {
    read_rule(parser, word, &line);
  } else {
    char *name = arena_copy(parser->arena, text_at(parser, word.begin), word.end - word.begin);
    const char *near = diag_nearest(name, keywords, 2);
    diag_error(parser->diag, word, "unknown statement `%s`: wanted `axiom`, `angle` or a rule such as `x=f+f`", name);
    if (near) diag_hint(parser->diag, "did you mean `%s`?", near);
    return;
  }
  Span extra = take_word(parser, &line, "=");
  if (!is_empty(extra))
    diag_error(parser->diag, extra, "unexpected `%.*s`: a string of commands holds no blanks and no `=`",
               QUOTE(parser, extra));
}

static void read_body(Parser *parser, Span body) {
  while (body.begin < body.end) {
    const char *at = text_at(parser, body.begin), *end = text_at(parser, body.end);
    const char *newline = memchr(at, '\n', (size_t)(end - at));
    const char *stop = newline ? newline : end;
    const char *comment = memchr(at, ';', (size_t)(stop - at));
    Span line = {body.begin, body.begin + (uint32_t)((comment ? comment : stop) - at)};
    read_line(parser, line);
    body.begin += (uint32_t)(stop - at) + (newline != NULL);
  }
}

// ---- lowering --------------------------------------------------------------

static AstStatement *add(Parser *parser, Ast *ast, AstStatementKind kind, Span span) {
  AstStatement *statement = VEC_PUSH(parser->arena, &ast->statements);
  *statement = (AstStatement){.kind = kind, .span = span, .name_span = span};
  return statement;
}

static void add_setting(Parser *parser, Ast *ast, LsysSetting setting, Span span, AstExpr *value) {
  AstStatement *statement = add(parser, ast, AST_SETTING, span);
  statement->setting = setting;
  statement->value = value;
}

// What every system has: a turn of 360/n degrees, a start to the right in colour 15, order 2.
static void add_settings(Parser *parser, Ast *ast) {
  AstBuilder build = parser->words.build;
  Span span = parser->angle_line;
  AstExpr *circle = ast_number(build, parser->angle, 360);
  AstExpr *turn = ast_binary(build, OP_DIV, circle, ast_number(build, parser->angle, parser->words.angle));
  add_setting(parser, ast, LSYS_SETTING_ANGLE, span, turn);
  add_setting(parser, ast, LSYS_SETTING_HEADING, span, ast_number(build, span, 0));
  add_setting(parser, ast, LSYS_SETTING_COLOUR, span, ast_number(build, span, START_COLOUR));
  add_setting(parser, ast, LSYS_SETTING_STEPS, span, ast_number(build, span, DEFAULT_ORDER));
}

static void add_production(Parser *parser, Ast *ast, const Rule *rule) {
  AstProduction *production = ARENA_NEW(parser->arena, AstProduction);
  production->arrow_span = (Span){rule->head.end, rule->head.end + 1};
  AstModule *module = VEC_PUSH(parser->arena, &production->strict.modules);
  *module =
    (AstModule){.symbol = fractint_symbol(&parser->words, rule->letter), .span = rule->head, .symbol_span = rule->head};
  production->strict.span = rule->head;
  production->successor = fractint_word(&parser->words, &rule->string);
  if (is_empty(production->successor.span)) production->successor.span = (Span){rule->all.end, rule->all.end};
  add(parser, ast, AST_PRODUCTION, rule->all)->production = production;
}

static void lower(Parser *parser, const System *system, Ast *ast) {
  if (!parser->words.angle && !parser->angle_line.end)
    diag_error(parser->diag, system->name, "`%.*s` has no `angle`", QUOTE(parser, system->name));
  if (!parser->words.angle) parser->words.angle = 4;  // reported; the words can still be checked
  if (!parser->axiom_line.end)
    diag_error(parser->diag, system->name, "`%.*s` has no `axiom`", QUOTE(parser, system->name));
  add_settings(parser, ast);
  AstWord axiom = fractint_word(&parser->words, &parser->axiom);
  AstStatement *statement = add(parser, ast, AST_AXIOM, parser->axiom_line);
  *VEC_PUSH(parser->arena, &statement->words) = axiom;
  for (size_t i = 0; i < parser->rules.count; i++) add_production(parser, ast, &parser->rules.at[i]);
}

// ---- choosing a system -----------------------------------------------------

static char *lower_case(Arena *arena, const char *text, size_t length) {
  char *copy = arena_copy(arena, text, length);
  for (size_t i = 0; i < length; i++)
    if (copy[i] >= 'A' && copy[i] <= 'Z') copy[i] = (char)(copy[i] + ('a' - 'A'));
  return copy;
}

static void report_unknown(const Parser *parser, const Systems *systems, const char *wanted) {
  VEC(const char *) names = {0};
  for (size_t i = 0; i < systems->count; i++) {
    Span name = systems->at[i].name;
    *VEC_PUSH(parser->arena, &names) = lower_case(parser->arena, text_at(parser, name.begin), name.end - name.begin);
  }
  diag_error(parser->diag, (Span){0}, "`%s` has no system `%s`", parser->file->path, wanted);
  const char *near = diag_nearest(lower_case(parser->arena, wanted, strlen(wanted)), names.at, names.count);
  if (!near) diag_hint(parser->diag, "--list-systems shows those that it has");
  for (size_t i = 0; near && i < systems->count; i++) {
    Span name = systems->at[i].name;  // as the file writes it
    if (names.at[i] != near) continue;
    diag_hint(parser->diag, "did you mean `%.*s`?", (int)(name.end - name.begin), text_at(parser, name.begin));
    return;
  }
}

// A } that was forgotten makes Fractint skip the entry without a word.
static void warn_skipped(const Parser *parser, const Systems *systems, const System *found) {
  for (const System *system = systems->at; system < found; system++) {
    if (system->foreign || system->closed) continue;
    diag_warning(parser->diag, WARN_DIALECT, system->brace,
                 "`%.*s` is skipped: its `{` is not closed before the next one", QUOTE(parser, system->name));
    return;
  }
}

// The system of that name; without one the first that is whole, else the first at all. NULL after reporting.
static const System *choose(const Parser *parser, const Systems *systems, const char *wanted) {
  size_t length = wanted ? strnlen(wanted, LONGEST_NAME) : 0, whole = 0;
  const System *found = NULL;
  for (size_t i = 0; i < systems->count; i++) {
    const System *system = &systems->at[i];
    if (system->foreign) continue;
    whole += system->closed;
    if (wanted
        && (system->name.end - system->name.begin != length
            || strncasecmp(text_at(parser, system->name.begin), wanted, length) != 0))
      continue;
    if (!found || (system->closed && !found->closed)) found = system;
  }
  if (!found && wanted)
    report_unknown(parser, systems, wanted);
  else if (!found)
    diag_error(parser->diag, (Span){parser->file->base, parser->file->base},
               "no L-system here: wanted an entry such as `Koch { angle 6 ... }`");
  if (!wanted && found) warn_skipped(parser, systems, found);
  if (!wanted && whole > 1)
    diag_remark(parser->diag, found->name, "`%.*s` is the first of %zu systems; --system NAME picks another",
                QUOTE(parser, found->name), whole);
  return found;
}

Ast *fractint_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                    const ParseOptions *options) {
  (void)sources;  // the dialect has no includes
  Parser *parser = ARENA_NEW(arena, Parser);
  *parser = (Parser){.arena = arena, .diag = diag, .file = file};
  parser->words = (FractintWords){.build = {arena, diag}, .file = file};
  Ast *ast = ARENA_NEW(arena, Ast);
  ast->file = file;
  ast->rules.dialect = "fractint";
  Systems systems = find_systems(arena, file);
  const System *system = choose(parser, &systems, options->system);
  if (!system) return ast;
  if (!system->closed) {
    diag_error(diag, system->brace, "`{` of `%.*s` is not closed by a `}` before the next entry or the end of the file",
               QUOTE(parser, system->name));
    bool runs_into_next = *text_at(parser, system->body.end) == '{';
    if (runs_into_next) return ast;
  }
  ast->extent = system->body;
  read_body(parser, system->body);
  lower(parser, system, ast);
  return ast;
}
