// grammar.h -- random grammars as data: what the generator makes, the reducer
// takes apart and the printer turns into text.
#ifndef LSYSC_FUZZ_GRAMMAR_H
#define LSYSC_FUZZ_GRAMMAR_H

#include "support/arena.h"
#include "support/vec.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef enum NodeKind {
  NODE_NUMBER,
  NODE_FORMAL,
  NODE_LOCAL,
  NODE_DEFINE,
  NODE_APPLY,
  NODE_UNARY,
  NODE_BINARY,
  NODE_CHOICE,
  NODE_CALL
} NodeKind;

typedef struct Node Node;
struct Node {
  NodeKind kind;
  const char *text;  // operator or function
  double number;
  int slot;  // formal parameter, define or function
  int count;
  Node *kid[3];
};

enum { MOST_ARGS = 3, FUZZ_TABLES = 2 };

typedef struct FuzzModule {
  char symbol;  // of e, p, h, l, u: a query
  int arity;
  Node *arg[MOST_ARGS];  // of a predecessor: formal parameters, or numbers to match
} FuzzModule;
typedef VEC(FuzzModule) FuzzWord;

typedef enum RuleSection { RULE_DERIVATION, RULE_DECOMPOSITION, RULE_HOMOMORPHISM, RULE_SECTIONS } RuleSection;

typedef struct FuzzRule {
  RuleSection section;
  int system;                    // 1: of the sub-L-system
  FuzzWord left, strict, right;  // left and right may be empty: no context
  Node *before;                  // assigned to the local variable before the guard; NULL: no such block
  Node *guard, *weight;          // NULL: none
  int table;                     // -1: every table
  FuzzWord successor;
} FuzzRule;

typedef struct FuzzGrammar {
  uint64_t number;  // the seed that makes this grammar
  FuzzWord axiom;
  VEC(Node *) defines;
  VEC(Node *) functions;  // of two arguments
  VEC(FuzzRule) rules;
  int steps;
  uint64_t seed;
  int depth;           // of decomposition and homomorphism
  const char *ignore;  // NULL: no such statement
  bool consider;       // `ignore` is a consider:
  bool ring;
  const char *schedule;       // tables by step, NULL: no tables
  const char *environment;    // NULL: no such statement
  bool nested;                // there is a sub-L-system, number 1,
  const char *ignore_nested;  //   with its own ignored symbols; NULL: none
} FuzzGrammar;

// The grammar that a number stands for: always the same one. Its words stay short: `longest` bounds
// the modules of the last step.
FuzzGrammar *fuzz_generate(Arena *arena, uint64_t number, double longest);

// In the native notation.
void fuzz_print(const FuzzGrammar *grammar, FILE *out);

// True if a word could become longer than `longest` after the grammar's steps.
bool fuzz_too_long(const FuzzGrammar *grammar, double longest);

// The most steps after which no word can be longer than `longest`; at least the grammar's own.
uint64_t fuzz_most_steps(const FuzzGrammar *grammar, double longest);

// Tries smaller and smaller grammars as long as `fails` holds of them; the smallest that was found.
typedef bool FuzzFails(const FuzzGrammar *grammar, void *data);
FuzzGrammar *fuzz_reduce(Arena *arena, const FuzzGrammar *grammar, FuzzFails *fails, void *data);

#endif
