// program.h -- the checked grammar: what every later pass reads.
//
// A Program has no names left to resolve: a symbol with its number of
// arguments is a Kind, a formal parameter is a slot, a #define is a constant
// or a function, a call of a random function knows its site. It is immutable
// once check() has returned it. The interpreter walks it as it is; analysis
// adds facts beside it; the code generator lowers both.
#ifndef LSYSC_FRONTEND_PROGRAM_H
#define LSYSC_FRONTEND_PROGRAM_H

#include "frontend/ast.h"
#include "lsys/abi.h"
#include "lsys/functions.h"
#include "lsys/settings.h"
#include "lsys/turtle.h"

typedef uint32_t KindId;
#define KIND_NONE UINT32_MAX

// A symbol with a number of arguments. Kinds are numbered in the order in
// which they first stand in the grammar: the modules of axioms and of all
// productions (every section and L-system) are read in file order, within a
// production left context, strict predecessor, right context, successor, each
// from left to right. Declarations, `ignore:` and surfaces number nothing, nor
// do `=` and `@]` in a right context; `[`, `]` and `%` are kinds like others.
// The number is the module's symbol byte (LANGUAGE.md section 9).
typedef struct Kind {
  const char *symbol;  // UTF-8, as scanned: "F", "a_r", "plant", "@Gs"
  uint32_t arity;
  const char *text;        // of a label, with a conversion for each argument; NULL
  LsysTurtleOp turtle;     // LSYS_TURTLE_NONE: the turtle ignores it
  const char **arg_names;  // of a declared module; NULL
  bool ignored;            // not seen by context matching (main L-system's ignore/consider)
  bool draws_subfigure;    // `~NAME` was declared as a surface
  Span span;               // where it first stands
} Kind;

// ---- expressions ---------------------------------------------------------

typedef enum ExprKind {
  EXPR_NUMBER,     // number
  EXPR_PARAMETER,  // slot: formal parameter of the production (left context first, then strict, then right),
                   // or of the function in whose body it stands, then the production's local variables
  EXPR_VALUE,      // slot: index into the run's value array (settings, constants, params, globals)
  EXPR_ELEMENT,    // slot: array number; args: one index per dimension
  EXPR_UNARY,      // op, args[0]
  EXPR_BINARY,     // op, args[0..1]; OP_AND and OP_OR are short-circuit
  EXPR_CHOICE,     // args[0] ? args[1] : args[2]
  EXPR_CALL,       // function (functions.def), args; site if it draws
  EXPR_APPLY,      // slot: user function (#define with arguments), args
  EXPR_STRING      // text; only as an argument of printf and the file functions
} ExprKind;

typedef struct Expr Expr;
struct Expr {
  ExprKind kind;
  Operator op;
  LsysFunction function;
  uint32_t slot;
  uint32_t site;  // EXPR_CALL of a random function: its place in the file, from 1 (LANGUAGE.md 5.8)
  double number;
  const char *text;
  Expr **args;
  uint32_t count;
  Span span;
};

// ---- words and contexts --------------------------------------------------

typedef struct Module {
  KindId kind;
  Expr **args;  // kinds[kind].arity of them
  Span span;
} Module;

typedef struct Word {
  Module *at;
  size_t count;
} Word;

typedef enum PatternKind {
  PATTERN_MODULE,  // kind; its arguments go to slots slot .. slot+arity-1
  PATTERN_OPEN,    // [
  PATTERN_CLOSE,   // ]
  PATTERN_REST,    // = : skips the rest of the branch
  PATTERN_END,     // @] : asks for the end of the branch
} PatternKind;

typedef struct Pattern {
  PatternKind what;
  KindId kind;
  uint32_t slot;
  Span span;
} Pattern;

typedef struct Context {
  Pattern *at;
  size_t count;  // 0: no such context
} Context;

// ---- actions (cpfg statement blocks) -------------------------------------

typedef enum ActionKind {
  ACTION_SET_LOCAL,    // slot = value
  ACTION_SET_VALUE,    // run value[slot] = value
  ACTION_SET_ELEMENT,  // array slot, index args, value
  ACTION_IF,           // value, then, otherwise
  ACTION_WHILE,        // value, then
  ACTION_DO,           // then, value
  ACTION_EVALUATE,     // value
  ACTION_USE_TABLE,    // slot: table
} ActionKind;

typedef struct Action Action;
typedef struct Actions {
  Action *at;
  size_t count;
} Actions;

struct Action {
  ActionKind kind;
  uint32_t slot;
  Expr **index;
  uint32_t index_count;
  Expr *value;
  Actions then, otherwise;
  Span span;
};

// ---- productions ---------------------------------------------------------

typedef struct Production {
  const char *label;  // NULL: none
  uint32_t number;    // place in the file, from 0, over all sections
  Span span;          // the whole statement
  Span head;          // the predecessor, for messages and -g
  Context left, right;
  Context strict;           // one PATTERN_MODULE; several in a pseudo-L-system
  uint32_t parameters;      // slots taken by formal parameters
  uint32_t locals;          // slots behind them for variables of before/after
  const char **slot_names;  // parameters + locals of them, NULL for a literal's hidden slot
  Expr *match;              // literal arguments: all of them equal; NULL: none. Tested before `before`
  Actions before, after;
  Expr *guard;  // NULL: always
  Word successor;
  Expr *weight;   // NULL: none
  int32_t table;  // -1: in every table
} Production;

typedef struct Productions {
  Production **at;  // in file order
  size_t count;
} Productions;

typedef struct Rewriting {  // a decomposition or homomorphism section
  Productions productions;
  Expr *depth;  // maximum depth, constant; NULL: 1
  uint64_t seed;
  bool has_seed, warnings;
} Rewriting;

// One L-system: the main one is number 0, the others come from `lsystem: NAME`.
typedef struct LSystem {
  const char *name;
  double called;  // by which number ?(n) calls it
  Productions productions;
  Rewriting decomposition, homomorphism;
  const char **tables;  // names
  size_t table_count;
  uint32_t *schedule;  // tables: one per step, cyclic; NULL: every production always
  size_t schedule_count;
  bool *ignored;  // per kind
  bool ring, pseudo;
} LSystem;

// ---- values --------------------------------------------------------------

// The run's value array: LSYS_SETTING_COUNT settings, then the values below in
// order, then array elements.
typedef enum ValueKind { VALUE_DEFINE, VALUE_PARAM, VALUE_GLOBAL } ValueKind;

typedef struct Value {
  ValueKind kind;
  const char *name;
  Expr *init;        // NULL for a global (starts at 0); evaluated in the order of `order` with key split(root, 2^63)
  Expr *low, *high;  // VALUE_PARAM: constants; NULL: unbounded
  const char *text;  // VALUE_PARAM: the default as written, for --help
  Span span;
  bool known;     // VALUE_DEFINE: init is made of numbers and known values alone, so that
  double number;  //   this is its value in every run
} Value;

typedef struct UserFunction {  // #define NAME(a,b) expr; never recursive
  const char *name;
  uint32_t arity;
  const char **slot_names;  // of its parameters
  Expr *body;               // parameters are EXPR_PARAMETER slots 0..arity-1
  Span span;
  bool draws;  // a call can draw a random number
} UserFunction;

typedef struct Array {
  const char *name;
  uint32_t sizes[4], dimensions;
  uint32_t slot;   // first element in the run's value array
  double *values;  // initial ones; product of sizes
  bool constant;   // no action assigns its elements
} Array;

typedef struct Surface {
  const char *name;
  const char *form;  // "disc", "sphere", "box", "obj", "s"
  const char *path;  // of a file, as written
  Expr **args;
  uint32_t count;
  LsysSurface shape;  // what the turtle draws: sizes, or the mesh of the file
  Span span;
} Surface;

typedef struct Program {
  const char *name;  // file name without folder and suffix
  const SourceFile *file;
  AstRules rules;
  Kind *kinds;
  size_t kind_count;
  KindId open, close, cut;  // kinds of [ ] %, KIND_NONE where the grammar has none
  Word *axioms;
  size_t axiom_count;  // may be 0 only after errors
  LSystem *lsystems;
  size_t lsystem_count;  // at least 1
  Value *values;
  size_t value_count;
  uint32_t *value_order;               // all values (indices) in the order in which they are initialised
  size_t total_values;                 // settings + values + array elements
  Expr *settings[LSYS_SETTING_COUNT];  // NULL: the table's default; evaluated after the values
  uint64_t seed;                       // default seed
  UserFunction *functions;
  size_t function_count;
  Array *arrays;
  size_t array_count;
  Surface *surfaces;
  size_t surface_count;
  LsysContour *contours;  // of `contour N: FILE`, each number once
  size_t contour_count;
  uint32_t *colours;  // 0xRRGGBB of the indices from 0 on that `colours:` gives
  size_t colour_count;
  const char *page[LSYS_PAGE_COUNT];  // what it says of its pictures; NULL: nothing
  const char **names;                 // declared, whether or not a kind has them: how words are cut into symbols
  size_t name_count;
  Actions start, start_each, end_each, end;
  uint32_t sites;                 // calls of random functions, numbered 1..sites
  LsysEnvironmentId environment;  // of ?E; without a statement `point`, if there is any
  const char *environment_path;   // LSYS_ENVIRONMENT_FILE
  double environment_value[LSYS_ENVIRONMENT_VALUES];
} Program;

// Ast -> Program. Never edits the Ast. NULL if there were errors.
// Ensures: every name is a slot, every successor's length is known, literal
// formal arguments are in `match`, calls are numbered in file order.
Program *check(Arena *arena, const Ast *ast, struct Diag *diag);

void program_dump(const Program *program, FILE *out);

// ---- what passes ask of a Program ----------------------------------------

// The value of an expression of numbers and known #defines alone; false when it needs anything else.
// Evaluates with the run-time library's own functions (lsys_pow, ...).
bool expr_constant(const Program *program, const Expr *expr, double *value);

// True if evaluating expr can draw a random number (user functions followed).
bool expr_draws(const Program *program, const Expr *expr);

// Number of arguments in a word, all modules together.
size_t word_arguments(const Program *program, const Word *word);

#endif
