// native.c -- reads all statements first, because a name may be declared below
// the words that it stands in; then parses them in their order.
#include "frontend/native.h"

#include "frontend/parse.tab.h"
#include "frontend/reader.h"

#include <string.h>

typedef VEC(Statement *) Statements;

const Notation notation_native = {.labels = true, .short_arrows = true, .subscripts = true, .start_words = true};
const Notation notation_cpfg = {.macros = true,
                                .tabs_join = true,
                                .any_case = true,
                                .left_power = true,
                                .angle_unequal = true,
                                .characters = true,
                                .references = true,
                                .line_comments = true,
                                .tight_colons = true,
                                .object_arrows = true};

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

static Ast *parse(Parser *parser, Sources *sources, const SourceFile *file, const ParseOptions *options) {
  Ast *ast = ARENA_NEW(parser->build.arena, Ast);
  ast->file = file;
  Statements all = read_statements(parser, sources, file, options);
  for (size_t i = 0; i < all.count; i++)
    if (!all.at[i]->overridden) parser_statement(parser, all.at[i], &ast->statements);
  return ast;
}

Ast *native_parse(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options) {
  Parser parser;
  parser_init(&parser, arena, diag, sources, &notation_native);
  Ast *ast = parse(&parser, sources, file, options);
  ast->rules.dialect = "native";
  parser_finish(&parser);
  return ast;
}

Ast *cpfg_parse(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options) {
  Parser parser;
  parser_init(&parser, arena, diag, sources, &notation_cpfg);
  Ast *ast = parse(&parser, sources, file, options);
  ast->rules = (AstRules){.dialect = "cpfg",
                          .literal_context_brackets = true,
                          .unweighted_counts_one = true,
                          .last_ignore_counts = true,
                          .idle_values = true,
                          .no_environment = true,
                          .textual_macros = true};
  parser_finish(&parser);
  return ast;
}

bool cpfg_recognise(const SourceFile *file) {
  size_t length = strlen(file->path);
  return length > 2 && strcmp(file->path + length - 2, ".l") == 0;
}

void native_dump_tokens(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file, const ParseOptions *options,
                        bool cpfg, FILE *out) {
  Parser parser;
  parser_init(&parser, arena, diag, sources, cpfg ? &notation_cpfg : &notation_native);
  Statements all = read_statements(&parser, sources, file, options);
  for (size_t i = 0; i < all.count; i++) parser_tokens(&parser, all.at[i], out);
  parser_finish(&parser);
}
