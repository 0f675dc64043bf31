// fmt_adapt.c -- what has to be said otherwise when a cpfg file becomes native text.
//
// In: an Ast. Out: marks on its statements, so that the printed text means the
// same without the rules in Ast.rules.
#include "frontend/fmt_adapt.h"

#include "support/map.h"

#include <string.h>

// Where a statement stands.
typedef struct Where {
  unsigned system, section;
} Where;

static void move(Where *where, const AstStatement *statement) {
  switch (statement->kind) {
  case AST_LSYSTEM:
    where->system++;
    where->section = AST_PRODUCTIONS;
    break;
  case AST_DECOMPOSITION:
  case AST_HOMOMORPHISM:
  case AST_PRODUCTIONS:
    where->section = statement->kind;
    break;
  default:
    break;
  }
}

// The family of productions that compete, as a number for a map beside the symbol.
static uint64_t family(const Where *where, const AstProduction *production) {
  const AstModule *strict = &production->strict.modules.at[0];
  return (uint64_t)strict->args.count << 40 | (uint64_t)where->section << 32 | where->system;
}

// `seed:` of the main L-system, not of its homomorphism.
static bool has_seed(const Ast *ast) {
  Where where = {0, AST_PRODUCTIONS};
  for (size_t i = 0; i < ast->statements.count; i++) {
    move(&where, &ast->statements.at[i]);
    if (ast->statements.at[i].kind == AST_SECTION_SEED && where.section == AST_PRODUCTIONS) return true;
  }
  return false;
}

static void mark_unweighted(Arena *arena, const Ast *ast, bool *weigh) {
  Map *weighted = map_create(arena), *found = map_create(arena);
  bool seeded = has_seed(ast);
  for (int pass = 0; pass < 2; pass++) {
    Where where = {0, AST_PRODUCTIONS};
    for (size_t i = 0; i < ast->statements.count; i++) {
      move(&where, &ast->statements.at[i]);
      const AstProduction *production = ast->statements.at[i].production;
      if (!production || !production->strict.modules.count) continue;
      const char *symbol = production->strict.modules.at[0].symbol;
      uint64_t number = family(&where, production);
      bool main = where.section == AST_PRODUCTIONS && where.system <= 1;
      uint32_t *earlier = map_place(found, symbol, number);
      if (pass == 0 && (production->weight || (seeded && main && *earlier != MAP_NONE)))
        *map_place(weighted, symbol, number) = 1;
      *earlier = 1;
      if (pass == 1) weigh[i] = !production->weight && map_find(weighted, symbol, number) != MAP_NONE;
    }
  }
}

static bool is_list(const AstStatement *statement) {
  return statement->kind == AST_IGNORE || statement->kind == AST_CONSIDER;
}

// Of the lists of a system the last alone counts; further systems have no start word or settings of their own.
static void mark_useless(const Ast *ast, bool *omit) {
  Where where = {0, AST_PRODUCTIONS};
  size_t list = 0, list_system = 0;
  for (size_t i = 0; i < ast->statements.count; i++) {
    const AstStatement *statement = &ast->statements.at[i];
    move(&where, statement);
    if (is_list(statement)) {
      if (list && list_system == where.system) omit[list - 1] = true;
      list = i + 1;
      list_system = where.system;
    }
    if (where.system > 1) omit[i] = statement->kind == AST_AXIOM || statement->kind == AST_SETTING;
  }
}

static bool holds_message(const AstWord *word) {
  for (size_t i = 0; i < word->modules.count; i++)
    if (strcmp(word->modules.at[i].symbol, "?E") == 0) return true;
  return false;
}

// Does something ask the environment, and no statement says which it is?
static bool asks_nobody(const Ast *ast) {
  bool asks = false;
  for (size_t i = 0; i < ast->statements.count; i++) {
    const AstStatement *statement = &ast->statements.at[i];
    if (statement->kind == AST_ENVIRONMENT) return false;
    for (size_t k = 0; k < statement->words.count; k++) asks |= holds_message(&statement->words.at[k]);
    if (statement->production) asks |= holds_message(&statement->production->successor);
  }
  return asks;
}

FmtAdaption fmt_adapt(Arena *arena, const Ast *ast) {
  FmtAdaption adaption = {.omit = arena_array(arena, ast->statements.count, sizeof(bool)),
                          .weigh = arena_array(arena, ast->statements.count, sizeof(bool))};
  if (ast->rules.unweighted_counts_one) mark_unweighted(arena, ast, adaption.weigh);
  if (ast->rules.last_ignore_counts) mark_useless(ast, adaption.omit);
  adaption.no_environment = ast->rules.no_environment && asks_nobody(ast);
  return adaption;
}
