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
  char *messages;
} Parsed;

static inline Parsed parse_bytes(ParseFunction *how, const char *name, const char *text, size_t length,
                                 const char *system) {
  Parsed parsed = {.arena = arena_create()};
  Sources *sources = sources_create(parsed.arena);
  const SourceFile *file = sources_add(sources, name, arena_copy(parsed.arena, text, length), length, (Span){0});
  DiagOptions options;
  diag_options_default(&options);
  options.colour = COLOUR_NEVER;
  size_t size;
  options.out = open_memstream(&parsed.messages, &size);
  Diag *diag = diag_create(parsed.arena, sources, &options);
  parsed.ast = how(parsed.arena, sources, diag, file, &(ParseOptions){.system = system});
  parsed.errors = diag_errors(diag);
  fclose(options.out);
  return parsed;
}

static inline void parsed_free(Parsed *parsed) {
  arena_destroy(parsed->arena);
  free(parsed->messages);
}

// Fails unless the text has so many errors and the messages hold `message`.
static inline void parse_says(ParseFunction *how, const char *name, const char *text, const char *system, size_t errors,
                              const char *message) {
  Parsed parsed = parse_bytes(how, name, text, strlen(text), system);
  if (!strstr(parsed.messages, message)) fail_msg("wanted: %s\ngot: %s", message, parsed.messages);
  assert_int_equal(parsed.errors, errors);
  parsed_free(&parsed);
}

// Every prefix of a text, and the text with any of its bytes changed, must be survived.
static inline void parse_survives(ParseFunction *how, const char *text) {
  size_t length = strlen(text);
  char *changed = malloc(length + 1);
  assert_non_null(changed);
  for (size_t n = 0; n <= length; n++) {
    Parsed cut = parse_bytes(how, "test", text, n, NULL);
    parsed_free(&cut);
    for (int c = 0; c < 256; c += 5) {
      memcpy(changed, text, length);
      changed[n] = (char)c;
      Parsed parsed = parse_bytes(how, "test", changed, length, NULL);
      parsed_free(&parsed);
    }
  }
  free(changed);
}

#endif
