// native.c -- reads all statements first, because a name may be declared below
// the words that it stands in; then parses them in their order.
#include "frontend/native.h"

#include "frontend/parse.tab.h"
#include "frontend/reader.h"

#include <string.h>

typedef VEC(Statement *) Statements;

// The names of #modules, module and surface statements become symbols.
static void declare(Parser *parser, Statement *s) {
  int token = s->first.keyword ? s->first.keyword->token : 0;
  if (token != TOK_MODULES && token != TOK_MODULE && token != TOK_SURFACE) return;
  if (statement_is_production(s, parser->declared)) return;
  parser_ahead(parser, s);
  for (size_t i = 0; i < s->ast.count; i++) {
    const AstStatement *ast = &s->ast.at[i];
    if (ast->name) trie_intern(parser->declared, ast->name, strlen(ast->name));
    for (size_t j = 0; !ast->name && j < ast->symbols.count; j++)
      trie_intern(parser->declared, ast->symbols.at[j].name, strlen(ast->symbols.at[j].name));
  }
}

static Statements read_statements(Parser *parser, Sources *sources, const SourceFile *file,
                                  const ParseOptions *options) {
  Reader *reader = reader_create(parser, sources, file, options);
  Statements all = {0};
  for (Statement *s; (s = reader_next(reader)) != NULL;) {
    declare(parser, s);
    *VEC_PUSH(parser->build.arena, &all) = s;
  }
  return all;
}

Ast *native_parse(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options) {
  Ast *ast = ARENA_NEW(arena, Ast);
  ast->file = file;
  ast->rules.dialect = "native";
  Parser parser;
  parser_init(&parser, arena, diag, sources);
  Statements all = read_statements(&parser, sources, file, options);
  for (size_t i = 0; i < all.count; i++) parser_statement(&parser, all.at[i], &ast->statements);
  parser_finish(&parser);
  return ast;
}

void native_dump_tokens(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options,
                        FILE *out) {
  Parser parser;
  parser_init(&parser, arena, diag, sources);
  Statements all = read_statements(&parser, sources, file, options);
  for (size_t i = 0; i < all.count; i++) parser_tokens(&parser, all.at[i], out);
  parser_finish(&parser);
}
