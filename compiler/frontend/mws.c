// mws.c -- sections between `#` lines -> Ast.
//
// Line by line: `#` lines change the section, the others are cut into the
// pieces that the native scanner and parser read (split.h, scan.h).
#include "frontend/mws.h"

#include "frontend/parse.tab.h"
#include "frontend/parser.h"
#include "lsys/settings.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

typedef struct Text {
  const char *at, *end;
} Text;

typedef enum Section { SECTION_NONE, SECTION_AXIOM, SECTION_RULES, SECTION_STOCHASTIC } Section;

typedef struct Mws {
  Parser parser;
  Ast *ast;
  const SourceFile *file;
  Section section;
  Span opened;     // the line that began the section
  Statement head;  // SECTION_STOCHASTIC: `B -> ` up to the `#`
  bool readable;   // head is without errors
  bool any;        // alternatives behind head
  bool has_axiom;
} Mws;

// ---- lines -------------------------------------------------------------------

static Text trimmed(const char *at, const char *end) {
  while (at < end && isspace((unsigned char)*at)) at++;
  while (end > at && isspace((unsigned char)end[-1])) end--;
  return (Text){at, end};
}

static const struct {
  const char *text;
  MwsLine line;
} keywords[] = {
  {"#axiom", MWS_AXIOM},
  {"#rules", MWS_RULES},
  {"#end rules", MWS_RULES_END},
  {"#rules end", MWS_RULES_END},
  {"#stochastic", MWS_STOCHASTIC},
  {"#end stochastic", MWS_STOCHASTIC_END},
  {"#stochastic end", MWS_STOCHASTIC_END},
};
enum { KEYWORDS = sizeof keywords / sizeof *keywords };

// Does the whole line say this? Case and the number of blanks do not matter.
static bool says(Text line, const char *keyword) {
  while (*keyword && line.at < line.end) {
    if (*keyword == ' ') {
      if (!isspace((unsigned char)*line.at)) return false;
      while (line.at < line.end && isspace((unsigned char)*line.at)) line.at++;
    } else if (tolower((unsigned char)*line.at++) != *keyword) {
      return false;
    }
    keyword++;
  }
  return !*keyword && line.at == line.end;
}

MwsLine mws_line(const char *at, const char *end) {
  Text line = trimmed(at, end);
  if (line.at == line.end) return MWS_EMPTY;
  if (*line.at != '#') return MWS_TEXT;
  for (int i = 0; i < KEYWORDS; i++)
    if (says(line, keywords[i].text)) return keywords[i].line;
  return MWS_COMMENT;
}

// Takes the next line off the text; false at its end.
static bool next_line(Text *rest, Text *line) {
  if (rest->at == rest->end) return false;
  const char *newline = memchr(rest->at, '\n', (size_t)(rest->end - rest->at));
  *line = trimmed(rest->at, newline ? newline : rest->end);
  rest->at = newline ? newline + 1 : rest->end;
  return true;
}

bool mws_recognise(const SourceFile *file) {
  Text rest = {file->text, file->text + file->length}, line;
  while (next_line(&rest, &line))
    if (mws_line(line.at, line.end) == MWS_AXIOM) return true;
  return false;
}

static Span span_of(const Mws *mws, Text text) {
  return (Span){mws->file->base + (uint32_t)(text.at - mws->file->text),
                mws->file->base + (uint32_t)(text.end - mws->file->text)};
}

// A comment such as `#rulse` was hardly meant as one.
static void check_comment(Mws *mws, Text line) {
  const char *names[KEYWORDS];
  for (int i = 0; i < KEYWORDS; i++) names[i] = keywords[i].text;
  const char *near =
    diag_nearest(arena_copy(mws->parser.build.arena, line.at, (size_t)(line.end - line.at)), names, KEYWORDS);
  if (near)
    diag_warning(mws->parser.diag, WARN_DIALECT, span_of(mws, line), "this is a comment; did you mean `%s`?", near);
}

// ---- parsing with the native parser ----------------------------------------------

// Parses pieces as a statement that stands at `line`.
static void parse_pieces(Mws *mws, Statement statement, Text line, const Piece *pieces, size_t count) {
  AstStatements *out = &mws->ast->statements;
  size_t before = out->count;
  statement.begin = line.at;
  statement.end = line.end;
  mws->parser.statement = &statement;
  mws->parser.out = out;
  scanner_start(mws->parser.scanner, pieces, count, (Span){span_of(mws, line).end, span_of(mws, line).end});
  if (syntax_parse(&mws->parser) != 0) out->count = before;
}

static void read_axiom(Mws *mws, Text line) {
  if (mws->has_axiom) {
    diag_error(mws->parser.diag, span_of(mws, line), "a second axiom; wanted `#rules`");
    return;
  }
  mws->has_axiom = true;
  Span span = span_of(mws, line);
  const Piece pieces[] = {{SCAN_TOKEN, TOK_AXIOM, 0, line.at, 0, {span.begin, span.begin}},
                          {SCAN_WORD, 0, 0, line.at, (size_t)(line.end - line.at), span}};
  parse_pieces(mws, (Statement){.file = mws->file}, line, pieces, 2);
}

// The statement in a line, which must be a production. False after reporting.
static bool read_production(Mws *mws, Text line, Statement *statement) {
  Splitter splitter;
  splitter_init(&splitter, mws->parser.build.arena, mws->parser.diag, &notation_native, mws->file);
  splitter.at = line.at;
  splitter.end = line.end;
  size_t errors = diag_errors(mws->parser.diag);
  bool any = splitter_next(&splitter, statement);
  if (any && (statement->arrow || statement->unclosed)) return true;
  if (diag_errors(mws->parser.diag) == errors)
    diag_error(mws->parser.diag, span_of(mws, line), "wanted a rule such as `A -> AB`, or `#end rules`");
  return false;
}

static void open_section(Mws *mws, Section section, Text line) {
  mws->section = section;
  mws->opened = span_of(mws, line);
}

// `B -> #stochastic`: what stands before the `#`, empty if the line is none.
static Text before_stochastic(Text line) {
  for (const char *at = line.at; at < line.end; at++)
    if (*at == '#' && mws_line(at, line.end) == MWS_STOCHASTIC) return trimmed(line.at, at);
  return (Text){line.at, line.at};
}

static void read_rule(Mws *mws, Text line) {
  Text head = before_stochastic(line);
  if (head.at < head.end) {
    mws->any = false;
    open_section(mws, SECTION_STOCHASTIC, line);
    mws->readable = read_production(mws, head, &mws->head) && mws->head.arrow && !mws->head.unclosed;
    if (mws->head.unclosed) parser_statement(&mws->parser, &mws->head, &mws->ast->statements);  // it reports that
    return;
  }
  Statement statement;
  if (read_production(mws, line, &statement)) parser_statement(&mws->parser, &statement, &mws->ast->statements);
}

// `p=3 AB`: the head's production with this successor and weight.
static void read_alternative(Mws *mws, Text line) {
  const char *equals = memchr(line.at, '=', (size_t)(line.end - line.at));
  bool begins = equals && trimmed(line.at, equals).end == line.at + 1 && (*line.at == 'p' || *line.at == 'P');
  mws->any = true;
  if (!begins) {
    diag_error(mws->parser.diag, span_of(mws, line),
               "wanted `p=` with a weight and a successor, such as `p=3 AB`, or `#stochastic end`");
    return;
  }
  if (!mws->readable) return;
  Text weight = trimmed(equals + 1, line.end);
  const char *at = weight.at;
  while (at < weight.end && !isspace((unsigned char)*at)) at++;
  weight.end = at;
  Text successor = trimmed(at, line.end);
  if (successor.at == successor.end) {
    diag_error(mws->parser.diag, span_of(mws, line), "wanted a successor behind the weight; the empty word is `*`");
    return;
  }
  Text colon = {equals, equals + 1};
  Piece pieces[MOST_PIECES];
  size_t count = statement_pieces(&mws->head, mws->parser.declared, pieces);
  pieces[count - 1] =
    (Piece){SCAN_WORD, 0, 0, successor.at, (size_t)(successor.end - successor.at), span_of(mws, successor)};
  pieces[count++] = (Piece){SCAN_TOKEN, TOK_COLON, 0, equals, 1, span_of(mws, colon)};
  pieces[count++] = (Piece){SCAN_EXPRESSION, 0, 0, weight.at, (size_t)(weight.end - weight.at), span_of(mws, weight)};
  parse_pieces(mws, mws->head, line, pieces, count);
}

// ---- sections --------------------------------------------------------------------

static void close_stochastic(Mws *mws) {
  if (!mws->any) diag_error(mws->parser.diag, mws->opened, "no alternatives; wanted lines such as `p=3 AB`");
  mws->section = SECTION_RULES;
}

static void read_text(Mws *mws, Text line) {
  switch (mws->section) {
  case SECTION_NONE:
    diag_error(mws->parser.diag, span_of(mws, line), "a line outside of `#axiom` and `#rules`");
    break;
  case SECTION_AXIOM:
    read_axiom(mws, line);
    break;
  case SECTION_RULES:
    read_rule(mws, line);
    break;
  case SECTION_STOCHASTIC:
    read_alternative(mws, line);
    break;
  }
}

static void read_line(Mws *mws, Text line) {
  MwsLine what = mws_line(line.at, line.end);
  bool ends_section = what == MWS_AXIOM || what == MWS_RULES || what == MWS_RULES_END;
  if (ends_section && mws->section == SECTION_STOCHASTIC) {
    diag_error(mws->parser.diag, mws->opened, "`#stochastic` is not closed by `#stochastic end`");
    mws->section = SECTION_RULES;
  }
  switch (what) {
  case MWS_EMPTY:
    break;
  case MWS_COMMENT:
    check_comment(mws, line);
    break;
  case MWS_TEXT:
    read_text(mws, line);
    break;
  case MWS_AXIOM:
    open_section(mws, SECTION_AXIOM, line);
    break;
  case MWS_RULES:
    open_section(mws, SECTION_RULES, line);
    break;
  case MWS_RULES_END:
    if (mws->section != SECTION_RULES)
      diag_error(mws->parser.diag, span_of(mws, line), "an end of rules without `#rules`");
    mws->section = SECTION_NONE;
    break;
  case MWS_STOCHASTIC:
    diag_error(mws->parser.diag, span_of(mws, line),
               "wanted a predecessor before `#stochastic`, as in `B -> #stochastic`");
    break;
  case MWS_STOCHASTIC_END:
    if (mws->section == SECTION_STOCHASTIC)
      close_stochastic(mws);
    else
      diag_error(mws->parser.diag, span_of(mws, line), "an end of alternatives without `#stochastic`");
    break;
  }
}

static void finish(Mws *mws) {
  Text whole = {mws->file->text, mws->file->text};
  if (mws->section == SECTION_STOCHASTIC) {
    diag_error(mws->parser.diag, mws->opened, "`#stochastic` is not closed by `#stochastic end`");
    mws->section = SECTION_RULES;
  }
  if (mws->section == SECTION_RULES)
    diag_warning(mws->parser.diag, WARN_DIALECT, mws->opened, "`#rules` is not closed by `#end rules`");
  if (!mws->has_axiom)
    diag_error(mws->parser.diag, span_of(mws, whole), "no axiom: wanted `#axiom` and a word on the next line");
}

// `turns: clockwise`
static void add_turns(Mws *mws) {
  AstStatement *statement = VEC_PUSH(mws->parser.build.arena, &mws->ast->statements);
  statement->kind = AST_SETTING;
  statement->setting = LSYS_SETTING_TURNS;
  statement->name = "clockwise";
  statement->value = ast_name(mws->parser.build, (Span){0, 0}, "clockwise");
}

Ast *mws_parse(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options) {
  (void)options;  // the dialect has no includes
  Mws *mws = ARENA_NEW(arena, Mws);
  mws->file = file;
  mws->ast = ARENA_NEW(arena, Ast);
  mws->ast->file = file;
  mws->ast->rules.dialect = "mws";
  parser_init(&mws->parser, arena, diag, sources, &notation_native);
  add_turns(mws);
  Text rest = {file->text, file->text + file->length}, line;
  while (next_line(&rest, &line)) read_line(mws, line);
  finish(mws);
  parser_finish(&mws->parser);
  return mws->ast;
}
