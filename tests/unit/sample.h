// sample.h -- words for the turtle's tests, packed by hand from text.
#ifndef LSYSC_TESTS_SAMPLE_H
#define LSYSC_TESTS_SAMPLE_H

#include "lsys/abi.h"

#include <stdlib.h>
#include <string.h>

// A grammar without productions, a run and a word of it, made from text: modules such as F(1,2) or
// @s(2); every pair of symbol and number of arguments is a kind.
typedef struct Sample {
  LsysKind kind[256];
  char name[256][4];
  LsysGrammar grammar;
  LsysRun run;
  double value[LSYS_SETTING_COUNT];
  uint8_t *sym;
  double *arg;
  LsysWord word;
} Sample;

static inline uint8_t sample_kind(Sample *s, const char *symbol, uint16_t arity) {
  uint32_t i = 0;
  while (i < s->grammar.kind_count && !(strcmp(s->name[i], symbol) == 0 && s->kind[i].arity == arity)) i++;
  if (i == s->grammar.kind_count) {
    s->grammar.kind_count++;
    strcpy(s->name[i], symbol);
    s->kind[i] = (LsysKind){.symbol = s->name[i], .arity = arity, .turtle = (uint8_t)lsys_turtle_op(s->name[i])};
  }
  return (uint8_t)i;
}

static inline void sample_word(Sample *s, const char *text) {
  size_t n = 0, a = 0;
  s->sym = malloc(strlen(text) + 1);
  s->arg = malloc((strlen(text) + 1) * sizeof *s->arg);
  while (*text) {
    char symbol[4] = {*text++};
    if (*symbol == '@') symbol[1] = *text++;
    if (*symbol == '@' && strchr("DTGP", symbol[1]) && *text && strchr("idspfcetrSCD", *text)) symbol[2] = *text++;
    uint16_t arity = 0;
    while (*text == (arity ? ',' : '(')) {
      char *end;
      s->arg[a++] = strtod(text + 1, &end);
      text = end;
      arity++;
    }
    if (arity) text++;
    s->sym[n++] = sample_kind(s, symbol, arity);
  }
  s->word = (LsysWord){.sym = s->sym, .arg = s->arg, .nsym = n, .narg = a};
}

static inline Sample *sample(const char *text, double angle) {
  Sample *s = calloc(1, sizeof *s);
  s->grammar = (LsysGrammar){.name = "test", .kinds = s->kind, .axiom_count = 1};
  s->run = (LsysRun){.grammar = &s->grammar, .value = s->value};
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) s->value[i] = lsys_settings[i].value;
  s->value[LSYS_SETTING_ANGLE] = angle;
  sample_word(s, text);
  return s;
}

// Rewrites a D0L word `steps` times, to be freed; rules are "L=+RF-LFL-FR+", the last one NULL.
static inline char *sample_rewrite(const char *axiom, const char *const *rules, int steps) {
  char *word = strdup(axiom);
  for (int s = 0; s < steps; s++) {
    size_t room = 1;
    for (const char *c = word; *c; c++) {
      size_t n = 1;
      for (const char *const *r = rules; *r; r++)
        if ((*r)[0] == *c) n = strlen(*r) - 2;
      room += n;
    }
    char *next = malloc(room), *out = next;
    for (const char *c = word; *c; c++) {
      const char *successor = NULL;
      for (const char *const *r = rules; *r; r++)
        if ((*r)[0] == *c) successor = *r + 2;
      if (successor) {
        out = stpcpy(out, successor);
      } else {
        *out++ = *c;
      }
    }
    *out = 0;
    free(word);
    word = next;
  }
  return word;
}

static inline void sample_release(Sample *s) {
  free(s->sym);
  free(s->arg);
  free(s);
}

#endif
