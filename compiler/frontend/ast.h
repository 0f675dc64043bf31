// ast.h -- what the user wrote, as written: the parser's output.
//
// The parser of every dialect produces these nodes and knows no semantics:
// names are not resolved, arities not compared, statements stand in file
// order. check.h turns an Ast into a Program; fmt prints it. Nodes live in
// the compilation's arena and are never edited after parsing.
#ifndef LSYSC_FRONTEND_AST_H
#define LSYSC_FRONTEND_AST_H

#include "lsys/operators.h"
#include "support/source.h"
#include "support/vec.h"

#include <stdbool.h>
#include <stdio.h>

// ---- expressions ---------------------------------------------------------

typedef enum AstExprKind {
  AST_NUMBER,  // number
  AST_STRING,  // text (printf's format, file names)
  AST_NAME,    // name
  AST_UNARY,   // op, a
  AST_BINARY,  // op, a, b  (also && and ||)
  AST_CHOICE,  // a ? b : c
  AST_CALL,    // name(args)
  AST_INDEX,   // name[args], cpfg arrays
  AST_POISON   // was reported; never reported again
} AstExprKind;

typedef struct AstExpr AstExpr;
typedef VEC(AstExpr *) AstExprs;

enum { AST_DEEPEST = 1000 };  // parsers refuse expressions that nest deeper, so that passes may recurse

struct AstExpr {
  AstExprKind kind;
  Operator op;
  Span span;       // the whole expression
  Span name_span;  // AST_NAME, AST_CALL, AST_INDEX: the name alone
  const char *name, *text;
  double number;
  AstExpr *a, *b, *c;
  AstExprs args;
  uint32_t depth;  // 1 + that of the deepest operand; at most AST_DEEPEST
  bool parenthesized;
};

// ---- words ---------------------------------------------------------------

// One module as written: A, F(1, x+2), +, [, ~, @Gs, a_r. A blank number of
// arguments `A()` is args.count 0 with parens set.
typedef struct AstModule {
  const char *symbol;  // interned: equal symbols are the same pointer; typographic variants already mapped to ASCII
  Span span, symbol_span;
  AstExprs args;
  bool parens;
} AstModule;

typedef struct AstWord {
  VEC(AstModule) modules;  // none: the empty word
  Span span;
} AstWord;

typedef VEC(AstWord) AstWords;

// ---- statement blocks (cpfg) ---------------------------------------------

typedef enum AstActionKind {
  AST_ASSIGN,    // target = value
  AST_IF,        // if (value) then else otherwise
  AST_WHILE,     // while (value) then
  AST_DO,        // do then while (value)
  AST_EVALUATE,  // value; for its effect (printf, stop, useTable)
} AstActionKind;

typedef struct AstAction AstAction;
typedef VEC(AstAction *) AstActions;

struct AstAction {
  AstActionKind kind;
  Span span;
  AstExpr *target, *value;  // target: AST_NAME or AST_INDEX
  AstActions then, otherwise;
};

// ---- statements ----------------------------------------------------------

typedef struct AstProduction {
  const char *label;  // NULL: none
  Span label_span, arrow_span;
  AstWord left, strict, right;  // left.span and right.span are nowhere when there is no such context
  AstActions before, after;
  bool has_before, has_after;
  AstExpr *guard;  // NULL: none, or "*"
  AstWord successor;
  AstExpr *weight;  // NULL: none
} AstProduction;

typedef struct AstSymbol {
  const char *name;
  Span span;
} AstSymbol;
typedef VEC(AstSymbol) AstSymbols;

typedef enum AstStatementKind {
  AST_AXIOM,          // words
  AST_PRODUCTION,     // production
  AST_DEFINE,         // #define: name, symbols = formal parameters (has_params), value
  AST_UNDEF,          // name
  AST_PARAM,          // param: name, value, low, high (NULL when absent)
  AST_MODULES,        // #modules, module NAME(args): name + symbols = argument names (has_params), or symbols = names
  AST_SETTING,        // steps, angle, step, width, colour, turns, ...: setting (index in settings.def), value;
                      // and name where the value is a lone name, as in `turns: clockwise`
  AST_IGNORE,         // symbols
  AST_CONSIDER,       // symbols
  AST_BLOCK,          // Start, StartEach, EndEach, End: name as spelled here, actions
  AST_ARRAYS,         // define: { array NAME[n] ... = { ... } }: arrays
  AST_DECOMPOSITION,  // section header
  AST_HOMOMORPHISM,   // section header
  AST_PRODUCTIONS,    // section header: back to the derivation's productions
  AST_WARNINGS,       // ": warnings" of the section
  AST_MAXIMUM_DEPTH,  // value
  AST_SECTION_SEED,   // value; seed: of the section that it stands in, else of the run
  AST_TABLE,          // table NAME:
  AST_TABLES,         // tables: NAME NAME ...: symbols
  AST_RING,           // ring lsystem
  AST_LSYSTEM,        // lsystem: NAME
  AST_ENDLSYSTEM,
  AST_SURFACE,      // surface NAME: form(args) or a file name: name, value = AST_CALL or AST_STRING
  AST_COLOURS,      // colours: #rrggbb NAME ...: symbols
  AST_ENVIRONMENT,  // value = AST_CALL, AST_NAME or AST_STRING
  AST_FUNCTION,     // function NAME: file; functions: file (name NULL): all of the file; value = AST_STRING
  AST_CURVE,        // curve NAME: file
  AST_CONTOUR,      // contour N: file; the number is the name
  AST_PAGE,         // size, background, camera, projection: setting (LsysPageSetting), name = what it says
} AstStatementKind;

typedef struct AstArray {
  const char *name;
  Span span;
  AstExprs sizes, values;
} AstArray;
typedef VEC(AstArray) AstArrays;

typedef struct AstStatement {
  AstStatementKind kind;
  Span span, name_span;
  const char *name;
  bool has_params;
  AstSymbols symbols;
  AstWords words;
  AstProduction *production;
  AstExpr *value, *low, *high;
  AstActions actions;
  AstArrays arrays;
  unsigned setting;          // AST_SETTING, AST_PAGE
  const SourceFile *beside;  // files that it names are beside this one; NULL: beside the main file
  bool fallback;             // of a view file: a setting that the grammar does not state itself
} AstStatement;
typedef VEC(AstStatement) AstStatements;

// What a dialect does differently in meaning; set by its parser (LANGUAGE.md section 7).
typedef struct AstRules {
  const char *dialect;            // "native", "cpfg", "fractint", "mws"
  bool literal_context_brackets;  // cpfg: "]" in right contexts
  bool unweighted_counts_one;     // cpfg: no weight among weighted ones is 1
  bool last_ignore_counts;        // cpfg
  bool idle_values;               // cpfg: a statement may compute a value that nothing uses
  bool no_environment;            // cpfg: without a statement nobody answers ?E
  bool textual_macros;            // cpfg: -D of a name that is no param is a macro, not the program's business
} AstRules;

typedef struct Ast {
  AstStatements statements;
  AstRules rules;
  const SourceFile *file;  // the main file
  Span extent;             // the part of it that was read; nowhere: all (fractint: one of several systems)
  unsigned call_sites;     // the parser numbers nothing; check counts calls in file order
} Ast;

struct Diag;
struct Interner;

// How files are looked for and read.
typedef struct ParseOptions {
  const char *const *include_dirs;  // -I, in order
  size_t include_count;
  const char *dialect;  // --dialect, NULL: by the file
  const char *view;     // --view FILE, NULL: none
  const char *system;   // --system NAME (fractint), NULL: the first

  // -D NAME=VALUE, as written. `defines` hold whatever the notation; `given` were meant for the program too, and
  // define textual macros only.
  const char *const *defines, *const *given;
  size_t define_count, given_count;
} ParseOptions;

// Text -> Ast. Never NULL; on errors (diag_errors() > 0) it holds what could
// be read, for tools that go on. file was added to sources by the caller.
Ast *parse_file(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file, const ParseOptions *options);

// --dump=tokens and --dump=ast.
void parse_dump_tokens(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                       const ParseOptions *options, FILE *out);
void ast_dump(const Ast *ast, FILE *out);

#endif
