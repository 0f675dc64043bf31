// parsing.h -- what tests of parsers share: a text through a parser, with its messages.
#ifndef LSYSC_TEST_PARSING_H
#define LSYSC_TEST_PARSING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frontend/ast.h"
#include "support/diag.h"

#include <stdlib.h>
#include <string.h>

typedef Ast *ParseFunction(Arena *arena, Sources *sources, Diag *diag, const SourceFile *file,
                           const ParseOptions *options);

typedef struct Parsed {
  Arena *arena;
  Ast *ast;
  size_t errors;
  char *messages, *dump;
} Parsed;

static inline Parsed parse_bytes(ParseFunction *how, const char *name, const char *text, size_t length,
                                 const ParseOptions *asked) {
  Parsed parsed = {.arena = arena_create()};
  Sources *sources = sources_create(parsed.arena);
  const SourceFile *file = sources_add(sources, name, arena_copy(parsed.arena, text, length), length, (Span){0});
  DiagOptions options;
  diag_options_default(&options);
  options.colour = COLOUR_NEVER;
  size_t size;
  options.out = open_memstream(&parsed.messages, &size);
  Diag *diag = diag_create(parsed.arena, sources, &options);
  parsed.ast = how(parsed.arena, sources, diag, file, asked);
  parsed.errors = diag_errors(diag);
  fclose(options.out);
  FILE *dump = open_memstream(&parsed.dump, &size);
  if (parsed.ast) ast_dump(parsed.ast, dump);
  fclose(dump);
  return parsed;
}

static inline void parsed_free(Parsed *parsed) {
  arena_destroy(parsed->arena);
  free(parsed->messages);
  free(parsed->dump);
}

// Fails unless the text is read without a message as the statements of dump.
static inline void parse_reads(ParseFunction *how, const char *name, const char *text, const ParseOptions *asked,
                               const char *dump) {
  Parsed parsed = parse_bytes(how, name, text, strlen(text), asked);
  assert_string_equal(parsed.messages, "");
  assert_string_equal(parsed.dump, dump);
  parsed_free(&parsed);
}

// Fails unless the text has so many errors and the messages hold `message`.
static inline void parse_says(ParseFunction *how, const char *name, const char *text, const ParseOptions *asked,
                              size_t errors, const char *message) {
  Parsed parsed = parse_bytes(how, name, text, strlen(text), asked);
  if (parsed.errors != errors || !strstr(parsed.messages, message))
    fail_msg("wanted %zu errors with\n  %s\nfor\n%s\nbut got\n%s", errors, message, text, parsed.messages);
  parsed_free(&parsed);
}

// text = before, count times repeated, after.
static inline char *repeated(const char *before, const char *part, size_t count, const char *after) {
  size_t length = strlen(part), at = strlen(before);
  char *text = malloc(at + length * count + strlen(after) + 1);
  assert_non_null(text);
  memcpy(text, before, at);
  for (size_t i = 0; i < count; i++, at += length) memcpy(text + at, part, length);
  strcpy(text + at, after);
  return text;
}

// Every prefix of a text, and the text with any of its bytes changed, must be survived.
static inline void parse_survives(ParseFunction *how, const char *text) {
  size_t length = strlen(text);
  char *changed = malloc(length + 1);
  assert_non_null(changed);
  for (size_t n = 0; n <= length; n++) {
    Parsed cut = parse_bytes(how, "test", text, n, &(ParseOptions){0});
    parsed_free(&cut);
    for (int c = 0; c < 256; c += 5) {
      memcpy(changed, text, length);
      changed[n] = (char)c;
      Parsed parsed = parse_bytes(how, "test", changed, length, &(ParseOptions){0});
      parsed_free(&parsed);
    }
  }
  free(changed);
}

#endif
