// parse_build.c -- statements, productions and actions from their parts.
#include "frontend/parse_build.h"

#include <string.h>

AstStatement *build_statement(Parser *parser, AstStatementKind kind) {
  const Statement *from = parser->statement;
  AstStatement *s = VEC_PUSH(parser->build.arena, parser->out);
  s->kind = kind;
  s->span = statement_span(from, from->begin, from->end);
  return s;
}

AstStatement *build_named(Parser *parser, AstStatementKind kind, const char *name, Span span) {
  AstStatement *s = build_statement(parser, kind);
  s->name = name;
  s->name_span = span;
  return s;
}

void build_section(Parser *parser, AstStatementKind kind, AstSymbols options) {
  build_statement(parser, kind);
  bool no = strcmp(options.at[0].name, "no") == 0;
  if (options.count == 1u + no && strcmp(options.at[no].name, "warnings") == 0) {
    if (!no) build_statement(parser, AST_WARNINGS);
    return;
  }
  diag_error(parser->diag, options.at[0].span, "unknown option `%s`; expected `warnings` or `no warnings`",
             options.at[0].name);
}

// cpfg lists characters: brackets are never ignored, and behind `?P` an `H` stands for `?H` too.
AstSymbols build_symbol(Parser *parser, AstSymbols symbols, const char *name, Span span) {
  bool characters = parser->notation->characters;
  if (characters && (strcmp(name, "[") == 0 || strcmp(name, "]") == 0)) return symbols;
  const char *before = symbols.count ? symbols.at[symbols.count - 1].name : "";
  *VEC_PUSH(parser->build.arena, &symbols) = (AstSymbol){name, span};
  bool letter = (name[0] | 32) >= 'a' && (name[0] | 32) <= 'z' && !name[1];
  if (characters && letter && before[0] == '?' && before[1]) {
    const char *query = arena_printf(parser->build.arena, "?%s", name);
    *VEC_PUSH(parser->build.arena, &symbols) = (AstSymbol){trie_intern(parser->symbols, query, 2), span};
  }
  return symbols;
}

AstWord build_unless_star(AstWord word, bool context) {
  bool star = word.modules.count == 1 && !word.modules.at[0].parens && strcmp(word.modules.at[0].symbol, "*") == 0;
  if (!star && (!context || word.modules.count)) return word;
  return (AstWord){.span = context ? (Span){0, 0} : word.span};
}

AstProduction *build_production(Parser *parser, Predecessor predecessor, Guard guard) {
  AstProduction *p = ARENA_NEW(parser->build.arena, AstProduction);
  p->left = predecessor.left;
  p->strict = predecessor.strict;
  p->right = predecessor.right;
  p->before = guard.before;
  p->after = guard.after;
  p->has_before = guard.has_before;
  p->has_after = guard.has_after;
  p->guard = guard.condition;
  if (p->strict.modules.count == 0)
    diag_error(parser->diag, p->strict.span, "the predecessor is empty; a production rewrites a module");
  return p;
}

static AstActions one(Parser *parser, AstAction action) {
  AstAction *copy = ARENA_NEW(parser->build.arena, AstAction);
  *copy = action;
  AstActions list = {0};
  *VEC_PUSH(parser->build.arena, &list) = copy;
  return list;
}

AstActions build_assignment(Parser *parser, Span span, AstExpr *target, AstExpr *value) {
  return one(parser, (AstAction){.kind = AST_ASSIGN, .span = span, .target = target, .value = value});
}

AstActions build_evaluation(Parser *parser, Span span, AstExpr *value) {
  return one(parser, (AstAction){.kind = AST_EVALUATE, .span = span, .value = value});
}

AstActions build_if(Parser *parser, Span span, AstExpr *value, AstActions then, AstActions otherwise) {
  return one(parser, (AstAction){.kind = AST_IF, .span = span, .value = value, .then = then, .otherwise = otherwise});
}

AstActions build_loop(Parser *parser, AstActionKind kind, Span span, AstExpr *value, AstActions body) {
  return one(parser, (AstAction){.kind = kind, .span = span, .value = value, .then = body});
}

AstExpr *build_reference(Parser *parser, Span span, AstExpr *expr) {
  if (!parser->notation->references)
    diag_error(parser->diag, span, "unexpected `&`; only cpfg's files write to an argument");
  return expr;
}

AstExprs build_append(Parser *parser, AstExprs list, AstExprs more) {
  for (size_t i = 0; i < more.count; i++) *VEC_PUSH(parser->build.arena, &list) = more.at[i];
  return list;
}

AstActions build_append_actions(Parser *parser, AstActions list, AstActions more) {
  for (size_t i = 0; i < more.count; i++) *VEC_PUSH(parser->build.arena, &list) = more.at[i];
  return list;
}
