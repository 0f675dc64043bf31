// parser.c -- sets scanner and grammar onto one statement.
#include "frontend/parser.h"

#include "frontend/guess.h"
#include "frontend/parse.tab.h"

void parser_init(Parser *parser, Arena *arena, Diag *diag, const Sources *sources) {
  *parser = (Parser){.build = {arena, diag}, .diag = diag, .sources = sources};
  parser->symbols = trie_create(arena);
  parser->declared = trie_create(arena);
  parser->scanner = scanner_create(arena, diag, parser->symbols, parser->declared);
}

void parser_finish(Parser *parser) {
  scanner_destroy(parser->scanner);
}

static Span end_of(const Statement *s) {
  return statement_span(s, s->end, s->end);
}

// Makes the statement's tokens ready; false if there is no telling what it is, which was reported.
static bool start(Parser *parser, Statement *s, Piece pieces[MOST_PIECES]) {
  bool production = statement_is_production(s, parser->declared);
  if (!production && !s->first.keyword) {
    guess_statement(parser, s);
    return false;
  }
  if (!production && s->arrow) {
    diag_error(parser->diag, statement_span(s, s->arrow, s->arrow_end), "a `%.*s:` statement holds no arrow",
               (int)(s->first.end - s->begin), s->begin);
    return false;
  }
  size_t count = statement_pieces(s, parser->declared, pieces);
  scanner_start(parser->scanner, pieces, count, end_of(s));
  return true;
}

void parser_statement(Parser *parser, Statement *s) {
  if (s->parsed || s->broken) return;
  s->parsed = true;
  parser->statement = s;
  Piece pieces[MOST_PIECES];
  if (start(parser, s, pieces) && syntax_parse(parser) != 0) s->ast.count = 0;
}

AstExpr *parser_condition(Parser *parser, Statement *s) {
  if (s->broken) return NULL;
  Span place = statement_span(s, s->begin, s->first.end), rest = statement_span(s, s->first.rest, s->end);
  Piece pieces[] = {{SCAN_TOKEN, TOK_CONDITION, 0, s->begin, 1, place},
                    {SCAN_EXPRESSION, 0, 0, s->first.rest, (size_t)(s->end - s->first.rest), rest}};
  parser->statement = s;
  parser->condition = NULL;
  scanner_start(parser->scanner, pieces, 2, end_of(s));
  return syntax_parse(parser) == 0 ? parser->condition : NULL;
}

void parser_tokens(Parser *parser, Statement *s, FILE *out) {
  Piece pieces[MOST_PIECES];
  parser->statement = s;
  if (s->broken || !start(parser, s, pieces)) return;
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
