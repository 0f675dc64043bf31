// check.h -- what the files check*.c share: the state of one check and the
// steps in the order in which check() takes them. Nobody else includes this.
#ifndef LSYSC_FRONTEND_CHECK_H
#define LSYSC_FRONTEND_CHECK_H

#include "frontend/expr.h"
#include "support/diag.h"
#include "support/map.h"

enum {
  MOST_DEPTH = 2000,       // nesting of one expression or statement block
  MOST_ARGUMENTS = 255,    // of a module
  MOST_KINDS = 65536,      // a symbol takes at most two bytes
  MOST_SITES = 1 << 20,    // LSYS_SITE_BITS
  MOST_REWRITING = 65536,  // maximum depth of decomposition and homomorphism
  MOST_ELEMENTS = 1 << 24  // of all arrays together
};

#define NONE UINT32_MAX
#define NEVER SIZE_MAX
#define LARGEST_WHOLE 9007199254740992.0  // 2^53: doubles count without gaps up to here

// ---- names ------------------------------------------------------------------

// One #define or param. Statements behind `at`, up to `until`, see it; those
// before `at` see it if they see no earlier one.
typedef struct Definition {
  bool function, param;
  bool made;       // by a statement `function`: hides nothing and is never unused
  uint32_t index;  // of values or functions
  size_t at, until;
  Span span, undefined;
  bool used, hiding_told;
} Definition;

// A name and everything that it stands for. Equal names are one Name.
typedef struct Name {
  const char *text;
  VEC(Definition) definitions;
  uint32_t global, array;  // index of values, of arrays; NONE
  uint32_t slot;           // in the scope whose number is `scope`
  uint64_t scope;
  uint64_t told;  // the scope in which it was reported as unknown
  bool unread;    // the file of this function could not be read, which was reported
} Name;

typedef enum ScopeKind {
  SCOPE_CONSTANT,  // #define, param, settings: no globals, which have no value yet
  SCOPE_FUNCTION,  // the body of #define NAME(a)
  SCOPE_AXIOM,
  SCOPE_PRODUCTION,
  SCOPE_BLOCK  // Start, StartEach, EndEach, End
} ScopeKind;

typedef struct Slot {
  const char *name;  // NULL: the hidden slot of a literal
  Span span;
  bool used;
} Slot;

// Which names are bound to slots where an expression stands.
typedef struct Scope {
  ScopeKind kind;
  bool start;        // SCOPE_BLOCK: of Start
  uint64_t number;   // never the same for two scopes
  VEC(Slot) slots;   // formal parameters, then local variables
  uint32_t visible;  // slots below it are seen
} Scope;

// What a definition refers to.
typedef struct Reference {
  uint32_t index;  // of values or functions
  bool function;
  Span span;
} Reference;

typedef struct References {
  VEC(Reference) list;
} References;

typedef struct ArrayEntry {
  const AstArray *array;
  Expr **sizes, **values;
  Span span;
  bool constant;  // nothing assigns its elements
} ArrayEntry;

// ---- modules -------------------------------------------------------------------

// `module NAME(args)` or `surface NAME: ...`
typedef struct Declaration {
  const char *name;
  Span span;
  bool has_arity, surface;
  uint32_t arity;
  const char **arg_names;
  uint32_t next;  // another one of the same name, NONE
} Declaration;

typedef enum Side { SIDE_LEFT, SIDE_STRICT, SIDE_RIGHT } Side;

// ---- L-systems -------------------------------------------------------------------

typedef enum Section { SECTION_MAIN, SECTION_DECOMPOSITION, SECTION_HOMOMORPHISM, SECTION_COUNT } Section;

typedef VEC(Production *) ProductionList;

typedef struct Table {
  const char *name;
  Span span;
} Table;

// An LSystem while it is read.
typedef struct System {
  const char *name;  // NULL: the main one
  Span span;
  uint32_t number;  // its place
  uint64_t called;  // by which number ?(n) calls it
  ProductionList productions[SECTION_COUNT];
  Expr *depth[SECTION_COUNT], *seed[SECTION_COUNT];
  bool warnings[SECTION_COUNT];
  VEC(const AstStatement *) lists;  // ignore: and consider:
  VEC(Table) tables;
  const AstStatement *schedule;
  bool ring;
} System;

// A function of a file: the array NAME.samples of pieces + 1 elements and the functions that read it.
typedef struct Samples {
  const char *name;
  uint32_t pieces;
  uint32_t between, at, value;  // of functions
  double range[2];              // of x
  size_t statement;
} Samples;

// ---- the state --------------------------------------------------------------------

typedef struct Check {
  Arena *arena;
  Diag *diag;
  const Ast *ast;
  Program *program;
  bool partial;  // there were errors before: what seems to be missing may stand where they are
  bool failed;   // gave up: nested too deep

  Map *name_map;
  VEC(Name *) names;
  VEC(Value) values, globals;  // globals move behind the values once all are known
  VEC(UserFunction) functions;
  VEC(ArrayEntry) arrays;
  References *references;  // per value, then per function
  References *referring;   // of the definition whose expression is being read, NULL

  Map *kind_map, *declaration_map;
  VEC(Kind) kinds;
  VEC(bool) predecessor;  // per kind: some production replaces it
  VEC(Declaration) declarations;
  VEC(const char *) symbols;  // every declared name, of modules and surfaces

  Map *system_map, *table_map;
  Map *called_map;  // number of an L-system -> its place
  VEC(System *) systems;
  bool first_is_main;
  System *system;  // where the statement stands that is being read
  Section section;
  int32_t table;
  size_t statement;  // its number

  Scope scope;
  uint64_t scopes;       // how many there were
  uint32_t depth;        // nesting of what is being read
  Expr *poison;          // stands for what was reported
  VEC(Expr *) literals;  // tests of the production's literal arguments
  VEC(Expr *) divisions;
  uint32_t productions, sites;

  VEC(Samples) samples;
  VEC(const char *) splines, curves;  // the names of functions and curves, in the order of their numbers
  bool unread[2];                     // some function, some curve could not be read
  VEC(double) curve_lengths;
  uint32_t chains[4];  // 1 + the function behind func, curveX, curveY, curveZ; 0: there is none

  VEC(Word) axioms;
  VEC(Surface) surfaces;
  VEC(LsysContour) contours;
  VEC(uint32_t) colours;
  const AstStatement *page[LSYS_PAGE_COUNT];  // what the grammar says of its pictures
  VEC(Action) blocks[4];                      // Start, StartEach, EndEach, End
  const AstStatement *environment;
  Expr *parameters[LSYS_ENVIRONMENT_VALUES];  // of it
  Expr *settings[LSYS_SETTING_COUNT], *seed;
  Expr *start_seed;                   // srand in Start
  bool fallback[LSYS_SETTING_COUNT];  // the setting is of a view file: the grammar's own counts
  bool uses_tables;                   // some block calls useTable
} Check;

// ---- steps, in the order in which check() takes them -----------------------------------

// check_names.c: what names, tables, L-systems and declared symbols there are, wherever they stand.
void check_collect(Check *check);

// check_sections.c: every statement in file order.
void check_statements(Check *check);

// check_values.c: the order in which values are made, constants, arrays.
void check_values(Check *check);

// check_systems.c: what is known at the end of the file only: ignored symbols, schedules, depths, seeds.
void check_systems(Check *check);

// check_warnings.c, check_families.c: what is allowed but hardly meant. Read the finished Program.
void check_warnings(Check *check);
void check_families(Check *check);

// check_reach.c: per kind, can it come to stand in a word?
const bool *check_reachable(Check *check);

// ---- what the steps use -------------------------------------------------------------------

// check_names.c
Name *name_intern(Check *check, const char *text);
Definition *name_definition(const Check *check, const Name *name);
bool name_is_bound(const Check *check, const Name *name);  // does it stand for a number or a function here?
void name_unknown(Check *check, Name *name, Span span, bool call);
void check_scope(Check *check, ScopeKind kind);
uint32_t check_bind(Check *check, const char *name, Span span);
Slot *check_bound(const Check *check, const Name *name);  // NULL: not bound there

// check_expressions.c
Expr *check_expression(Check *check, const AstExpr *ast);
Expr **check_arguments(Check *check, const AstExprs *args);
uint32_t check_element(Check *check, const AstExpr *ast, Expr ***index);
LsysFunction function_named(const char *name);  // LSYS_FN_COUNT: there is none
const char *function_arguments(Check *check, const LsysFunctionInfo *info);

// One level deeper; false after an error. On success the caller does check->depth-- when it is done.
bool check_deeper(Check *check, Span span);

// check_kinds.c
void kinds_declare(Check *check, const AstStatement *statement);
KindId kind_of(Check *check, const char *symbol, const char *text, size_t arity,
               Span span);  // text: a label's, or NULL

// check_words.c; what: "axiom" or "successor", for messages
Word check_word(Check *check, const AstWord *word, const char *what);
Context check_context(Check *check, const AstWord *word, Side side);
void check_formal(Check *check, const char *text, Span span);
Expr *check_match(Check *check);

// check_productions.c, check_actions.c, check_values.c: one statement
void check_production(Check *check, const AstStatement *statement);
void check_unused(Check *check, size_t parameters);  // warns of the scope's first slots that nothing used
Actions check_actions(Check *check, const AstActions *actions);

// Tells what is wrong with a text of `name` that is to be printed with that many values.
void check_format(Check *check, const char *name, const AstExpr *format, size_t values, Span span);
void values_begin(Check *check);  // once all values and functions are collected
void check_definition(Check *check, const AstStatement *statement);
void check_arrays(Check *check, const AstStatement *statement);

// check_environment.c
void check_environment(Check *check, const AstStatement *statement);
void check_queries(Check *check);  // once all kinds are known

// check_functions.c
void functions_collect(Check *check, const AstStatement *statement);
void functions_collected(Check *check);
void functions_read(Check *check);
// A call as it is computed: `func(growth, x)` is `growth(x)`, `curveGAL(n)` a number. NULL after an error.
const AstExpr *functions_call(Check *check, const AstExpr *ast);
bool functions_are_meant(const char *name);  // `func`, `curveX`, ...

// check_sections.c: the path of a file that a statement names, beside the file that it stands in
const char *check_beside(Check *check, const AstStatement *statement, const char *path);

// check_systems.c
void systems_begin(Check *check);
void systems_collect(Check *check, const AstStatement *statement);
void systems_number(Check *check);
uint32_t system_named(Check *check, const char *name, Span span);  // NONE after an error
uint32_t table_named(Check *check, const System *system, const char *name, Span span);

#endif
