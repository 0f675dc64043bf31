// grammar.h -- what unit tests of the later passes share: text -> Program,
// and the word that the interpreter derives.
#ifndef TESTS_UNIT_GRAMMAR_H
#define TESTS_UNIT_GRAMMAR_H

#include "analysis/facts.h"
#include "interp/interp.h"
#include "support/diag.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <stdio.h>
#include <unistd.h>

typedef struct Grammar {
  Arena *arena;
  const Program *program;
  const Facts *facts;
  const LsysGrammar *description;
} Grammar;

// Fails the test with the messages on standard error if text has errors.
static inline Grammar grammar_read(const char *text) {
  Grammar grammar = {.arena = arena_create()};
  Sources *sources = sources_create(grammar.arena);
  DiagOptions options;
  diag_options_default(&options);
  options.no_warnings = true;
  Diag *diag = diag_create(grammar.arena, sources, &options);
  const SourceFile *file = sources_add(sources, "test.lsys", text, strlen(text), (Span){0});
  ParseOptions parse = {.dialect = "native"};
  const Ast *ast = parse_file(grammar.arena, sources, diag, file, &parse);
  assert_int_equal(diag_errors(diag), 0);
  grammar.program = check(grammar.arena, ast, diag);
  assert_int_equal(diag_errors(diag), 0);
  assert_non_null(grammar.program);
  grammar.facts = facts_find(grammar.arena, grammar.program);
  grammar.description = describe(grammar.arena, grammar.program, grammar.facts);
  return grammar;
}

static inline void grammar_free(Grammar *grammar) {
  arena_destroy(grammar->arena);
}

// The first kind of that symbol; fails the test if there is none.
static inline KindId grammar_kind(const Grammar *grammar, const char *symbol) {
  for (KindId k = 0; k < grammar->program->kind_count; k++) {
    if (strcmp(grammar->program->kinds[k].symbol, symbol) == 0) return k;
  }
  fail_msg("no kind %s", symbol);
  return KIND_NONE;
}

// What the program writes with these arguments, up to eight, the last NULL; to be freed. The interpreter derives.
static inline char *grammar_run(const Grammar *grammar, const char *const *arguments) {
  char path[] = "/tmp/lsysc-test-XXXXXX.txt";
  int file = mkstemps(path, 4);
  assert_true(file >= 0);
  close(file);
  char *argv[12] = {"test", "-o", path};
  int argc = 3;
  for (; *arguments; arguments++) argv[argc++] = (char *)*arguments;
  const LsysGrammar *interp = interp_grammar(grammar->arena, grammar->program, grammar->description);
  assert_int_equal(lsys_main(interp, argc, argv), 0);
  interp_release(interp);
  FILE *in = fopen(path, "r");
  assert_non_null(in);
  char *text = calloc(1, 1 << 20);
  size_t length = fread(text, 1, (1 << 20) - 1, in);
  while (length && text[length - 1] == '\n') text[--length] = 0;
  fclose(in);
  unlink(path);
  return text;
}

// The word of the grammar in text at a step is expected.
static inline void assert_word(const char *text, const char *steps, const char *expected) {
  Grammar grammar = grammar_read(text);
  char *word = grammar_run(&grammar, (const char *[]){"-n", steps, NULL});
  assert_string_equal(word, expected);
  free(word);
  grammar_free(&grammar);
}

#endif
