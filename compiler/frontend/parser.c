// parser.c -- sets scanner and grammar onto one statement.
#include "frontend/parser.h"

#include "frontend/guess.h"
#include "frontend/parse.tab.h"

void parser_init(Parser *parser, Arena *arena, Diag *diag, const Sources *sources, const Notation *notation) {
  *parser = (Parser){.build = {arena, diag}, .notation = notation, .diag = diag, .sources = sources};
  parser->symbols = trie_create(arena);
  parser->declared = trie_create(arena);
  parser->scanner = scanner_create(arena, diag, notation, parser->symbols, parser->declared);
}

void parser_finish(Parser *parser) {
  scanner_destroy(parser->scanner);
}

static Span end_of(const Statement *s) {
  return statement_span(s, s->end, s->end);
}

static bool is_closed(Parser *parser, const Statement *s) {
  if (!s->unclosed) return true;
  diag_error(parser->diag, statement_span(s, s->unclosed, s->unclosed + 1), "`%c` is never closed", *s->unclosed);
  if (s->unclosed_before)
    diag_note(parser->diag, statement_span(s, s->unclosed_before, s->unclosed_before + 1),
              "the statement ends before this line, which begins another");
  return false;
}

// Makes the statement's tokens ready; false after reporting that it has none.
static bool start(Parser *parser, const Statement *s, Piece pieces[MOST_PIECES]) {
  if (!is_closed(parser, s)) return false;
  bool production = statement_is_production(s, parser->declared);
  if (!production && !s->first.keyword) {
    guess_statement(parser, s);
    return false;
  }
  if (!production && s->arrow) {
    diag_error(parser->diag, statement_span(s, s->arrow, s->arrow_end), "unexpected arrow behind `%.*s:`",
               (int)(s->first.end - s->begin), s->begin);
    diag_hint(parser->diag, "a production is a statement of its own and begins with its predecessor");
    return false;
  }
  if (production && s->first.keyword && s->first.keyword->token == TOK_TABLE && s->colons[0]) {
    diag_error(parser->diag, statement_span(s, s->colons[0] + 1, s->end),
               "unexpected production; it stands on a line of its own behind `table NAME:`");
    return false;
  }
  size_t count = statement_pieces(s, parser->declared, pieces);
  scanner_start(parser->scanner, pieces, count, end_of(s));
  return true;
}

static void parse(Parser *parser, const Statement *s, AstStatements *out) {
  Piece pieces[MOST_PIECES];
  size_t before = out->count;
  parser->statement = s;
  parser->out = out;
  if (start(parser, s, pieces) && syntax_parse(parser) != 0) out->count = before;
}

void parser_ahead(Parser *parser, Statement *s) {
  if (!s->parsed) parse(parser, s, &s->ast);
  s->parsed = true;
}

void parser_statement(Parser *parser, const Statement *s, AstStatements *out) {
  if (!s->parsed) parse(parser, s, out);
  for (size_t i = 0; i < s->ast.count; i++) *VEC_PUSH(parser->build.arena, out) = s->ast.at[i];
}

AstExpr *parser_condition(Parser *parser, const Statement *s) {
  if (!is_closed(parser, s)) return NULL;
  Span place = statement_span(s, s->begin, s->first.end), rest = statement_span(s, s->first.rest, s->end);
  Piece pieces[] = {{SCAN_TOKEN, TOK_CONDITION, 0, s->begin, 1, place},
                    {SCAN_EXPRESSION, 0, 0, s->first.rest, (size_t)(s->end - s->first.rest), rest}};
  parser->statement = s;
  parser->condition = NULL;
  scanner_start(parser->scanner, pieces, 2, end_of(s));
  return syntax_parse(parser) == 0 ? parser->condition : NULL;
}

void parser_tokens(Parser *parser, const Statement *s, FILE *out) {
  Piece pieces[MOST_PIECES];
  parser->statement = s;
  if (!start(parser, s, pieces)) return;
  SYNTAX_STYPE value;
  Span span;
  for (int token = 1; token != TOK_END && token != TOK_SYNTAX_error;) {
    token = scanner_next(parser->scanner, &value, &span);
    Place from = sources_place(parser->sources, span.begin);
    const char *text = s->file->text + (span.begin - s->file->base);
    fprintf(out, "%u:%u\t%s\t%.*s\n", from.line, from.column, parser_token_name(token), (int)(span.end - span.begin),
            text);
  }
}
