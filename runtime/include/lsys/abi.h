// abi.h -- the contract between a compiled grammar and the run time.
//
// Code generation exports one LsysGrammar, a constant descriptor: metadata and
// function pointers. The interpreter fills the same descriptor with its own
// `derive`. The run time (drivers, sinks, turtle, command line) knows grammars
// by this header alone; compiled code calls only the functions at its end.
//
// A word is three parallel streams, without padding:
//
//   sym   | A | [ | F | ] | ...       one byte a module (two where a grammar has over 256 kinds)
//   arg   | A.0 | A.1 | F.0 | ...     doubles, all arguments back to back
//   key   | A | ...                   64 bits, only of kinds with LSYS_KIND_KEY
#ifndef LSYS_ABI_H
#define LSYS_ABI_H

#include "lsys/environment.h"
#include "lsys/functions.h"
#include "lsys/keys.h"
#include "lsys/scan.h"
#include "lsys/settings.h"
#include "lsys/turtle.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define LSYS_ABI_VERSION 6u

#define LSYS_FAR (UINT64_C(1) << 62)  // more steps than any derivation has; see expand

typedef struct LsysGrammar LsysGrammar;
typedef struct LsysRun LsysRun;
typedef struct LsysStream LsysStream;

enum {
  LSYS_KIND_KEY = 1,       // its modules carry a key: it can still draw in the derivation
  LSYS_KIND_TERMINAL = 2,  // no production of any table, no decomposition: it stays as it is for ever
  LSYS_KIND_FIXED = 4,     // no arguments, no key, and its derivation never reads globals, tables or contexts:
                           // after s steps it is always the same word (blocks, below)
};

typedef struct LsysKind {
  const char *symbol;  // UTF-8, as written
  uint16_t arity;
  uint8_t turtle;  // LsysTurtleOp
  uint8_t flags;   // LSYS_KIND_*
} LsysKind;

// A packed word, or a part of one: nsym modules, narg arguments, nkey keys.
typedef struct LsysWord {
  const uint8_t *sym;
  const double *arg;
  const uint64_t *key;
  uint64_t nsym, narg, nkey;
} LsysWord;

// Where a compiled production writes. The cursors are the next free places;
// room is checked once per production, and lsys_flush makes some. One limit
// serves all three streams: where sym has room for modules, arg and key have
// room for theirs, whatever kinds they are.
struct LsysStream {
  uint8_t *sym;
  double *arg;
  uint64_t *key;
  uint8_t *sym_limit;
  LsysRun *run;
  uint64_t stop;          // expand: 0, or what is left where modules are written, with keys, and not derived further
  uintptr_t stack_limit;  // a recursion whose frame lies below calls lsys_too_deep
};

// A word that a fixed kind becomes.
typedef struct LsysBlock {
  const uint8_t *sym;
  const double *arg;
  uint64_t nsym, narg;
} LsysBlock;

struct LsysRun {
  const LsysGrammar *grammar;
  double *value;                  // settings, constants, params, globals, array elements
  uint64_t root;                  // lsys_root(seed)
  uint64_t steps;                 // of the whole derivation
  const LsysBlock *const *block;  // block[kind][s], s < block_levels[kind]: what a fixed kind is after s steps
  const uint64_t *block_levels;   // 0 for a kind without blocks
  int64_t table;                  // the table that `useTable` chose; -1: none yet, all apply
  int64_t stopped;                // not 0: `stop` was called, this step is the last

  // Of the run time and the interpreter: with `births`, a word comes in parts whose modules were born in one step,
  // `born`: 0 in the start word, n in the n-th step. A module that a step turns into itself alone is not born again.
  bool births;
  uint64_t born;
  const uint64_t *birth;  // of each module, in place of `born`, where `homomorphism` takes a whole word; else NULL

  struct LsysMemory *memory;  // the run time's account of what is held; NULL: none is kept
  uint32_t threads;           // that may work for what reads the word; 0: one
  uint32_t *told;             // of lsys_cut_short, for all threads; NULL: nothing is told

  struct LsysFiles *files;                // the run time's, of fopen
  struct LsysSurroundings *surroundings;  // the run time's, of lsys_look
};

typedef struct LsysParam {
  const char *name;
  uint32_t value;    // its slot in LsysRun.value
  double low, high;  // inclusive; infinite where unbounded
  const char *text;  // the default as written in the grammar
} LsysParam;

typedef struct LsysAxiom {
  LsysWord word;  // nkey = 0: the run time makes the keys; arguments that are no constants hold 0 until `axiom` ran
} LsysAxiom;

// The number of modules of each kind that one module of a kind becomes in one step, as sparse rows:
// entries row[k] .. row[k+1]-1 belong to kind k. Present (row != NULL) only if the counts depend on kinds alone.
typedef struct LsysGrowth {
  const uint32_t *row;
  const uint32_t *kind;
  const uint32_t *count;
} LsysGrowth;

enum {
  LSYS_GRAMMAR_RANDOM = 1,         // something draws: the seed matters
  LSYS_GRAMMAR_EXPAND = 2,         // context-free: `expand` is there
  LSYS_GRAMMAR_SEQUENTIAL = 4,     // productions write globals: in order, one thread
  LSYS_GRAMMAR_TABLES = 8,         // which productions apply depends on the step's number
  LSYS_GRAMMAR_HOMOMORPHISM = 16,  // `homomorphism` or `interpret` is there
  LSYS_GRAMMAR_WIDE = 32,          // symbols take two bytes
  LSYS_GRAMMAR_WHOLE = 64,         // the homomorphism has contexts or several L-systems: it takes a whole word
  LSYS_GRAMMAR_RIGHT = 128,        // something looks ahead: a step needs the index of branches
  LSYS_GRAMMAR_RING = 256,         // first and last module are neighbours
  LSYS_GRAMMAR_QUERIES = 1024,     // queries or communication modules: lsys_look before each step
  LSYS_GRAMMAR_ORDERED = 512,      // pseudo-productions, a cut, sub-L-systems: a step goes through the word in order
  LSYS_GRAMMAR_LETTERS = 2048,     // `step` is lsys_step_letters: it takes whole segments
};

// What `~NAME` draws. Meshes are read when the grammar is compiled.
typedef enum LsysSurfaceForm {
  LSYS_SURFACE_DISC,
  LSYS_SURFACE_SPHERE,
  LSYS_SURFACE_BOX,
  LSYS_SURFACE_MESH
} LsysSurfaceForm;

typedef struct LsysSurface {
  const char *name;  // the symbol of the module behind `~`
  uint32_t form;     // LsysSurfaceForm
  uint32_t vertices, triangles;
  uint32_t reserved;       // 0
  double size[3];          // diameter; sides
  const double *vertex;    // MESH: x, y, z of each: y goes ahead, z up
  const double *normal;    // likewise, or NULL
  const uint32_t *corner;  // three vertices a triangle
} LsysSurface;

enum { LSYS_MOST_CONTOUR = 255 };  // the greatest number of one

// A contour of generalised cylinders from a file, sampled when the grammar is compiled. A closed one goes from L to U
// and ends in its first point.
typedef struct LsysContour {
  uint32_t number;      // of @#(number), 1 .. LSYS_MOST_CONTOUR
  uint32_t pieces;      // 1 or more, equally long along the contour
  uint32_t closed;      // 0 or 1
  uint32_t reserved;    // 0
  const double *point;  // pieces + 1: along L, along U, in halves of the width
} LsysContour;

// The statement blocks of a grammar.
enum { LSYS_BLOCK_START, LSYS_BLOCK_START_EACH, LSYS_BLOCK_END_EACH, LSYS_BLOCK_END };

struct LsysGrammar {
  uint32_t abi_version;
  uint32_t flags;
  const char *name;
  const char *names;  // declared ones, separated by blanks; NULL: none. Words are cut into symbols by them, too
  uint32_t kind_count;
  const LsysKind *kinds;
  uint32_t param_count;
  const LsysParam *params;
  uint32_t axiom_count;
  const LsysAxiom *axioms;
  uint32_t value_count;  // size of LsysRun.value
  uint64_t seed;         // default seed
  uint32_t room_sym;     // the most modules that are written between two checks for room
  uint32_t frame_bytes;  // bound on the native stack that one level of `expand` takes
  LsysGrowth growth;

  // Fills run->value: settings, constants, params. given[i] says that param i was set on the
  // command line and its value already stands in its slot.
  void (*init)(LsysRun *run, const uint8_t *given);

  // Overwrites the arguments of axiom `which` that are not constants. arg has room for all of them;
  // key[i] = lsys_split(root, place of module i among all start words), one per module. NULL: none to do.
  void (*axiom)(LsysRun *run, uint32_t which, double *arg, const uint64_t *key);

  // Derives every module of `in`, which has so many steps left, until out->stop are left, and writes the result in
  // order to out. Code for the last steps goes to the end at once: for another stop than 0, LSYS_FAR is to be added to
  // stop, steps and run->steps. Of the last word (stop 0) the keys count only where the homomorphism draws, as nobody
  // else reads them: otherwise there are fewer, or none. NULL for grammars that are not context-free.
  void (*expand)(LsysStream *out, const LsysWord *in, uint64_t steps);

  // The step engine: rewrites the modules from scan->sym to scan->end (see scan.h) and writes what they become to
  // out, with keys. Every grammar of compiled code has it but those without productions.
  void (*step)(LsysScan *scan, LsysStream *out);
  const LsysContextView
    *views;                     // how the L-systems' contexts see a word; step takes a scan of the first, others linked
  uint32_t view_count;          // 1 or more
  uint32_t left_window;         // the most modules that a left context asks for
  uint32_t system_count;        // L-systems, sub-L-systems included
  const double *system_number;  // by which ?(n) calls each

  // Runs a block, LSYS_BLOCK_*; Start first resets globals, arrays, table and stopped. NULL: the grammar has no state.
  void (*block)(LsysRun *run, uint32_t which);

  // Grammars with state or several L-systems: decomposes a whole word behind a step, in order. NULL: `step` has done
  // so.
  void (*decompose)(LsysScan *scan, LsysStream *out);

  // The interpreter: derives axiom `which` by `steps` steps and writes the result to out. NULL in compiled grammars.
  void (*derive)(LsysRun *run, uint32_t which, uint64_t steps, LsysStream *out, void *data);
  void *derive_data;

  // Writes what the homomorphism makes of the modules of `in`, in order and without keys, for sinks; `in` has its keys
  // and is a part of a word, or a whole one if LSYS_GRAMMAR_WHOLE. NULL: a word is shown as it is.
  void (*homomorphism)(LsysRun *run, const LsysWord *in, LsysStream *out);

  // The same for LSYS_GRAMMAR_WHOLE in compiled code, in place of `homomorphism`.
  void (*interpret)(LsysScan *scan, LsysStream *out);

  uint32_t surface_count;
  const LsysSurface *surfaces;

  // 0xRRGGBB of the first colour indices (`colours:`).
  uint32_t colour_count;
  const uint32_t *colours;

  // What the grammar says of its pictures: LSYS_PAGE_COUNT texts, NULL where nothing; NULL: nothing at all.
  const char *const *page;

  uint32_t environment;             // LsysEnvironmentId
  const char *environment_path;     // LSYS_ENVIRONMENT_FILE: of the shared object
  const double *environment_value;  // LSYS_ENVIRONMENT_VALUES of them

  uint32_t contour_count;
  const LsysContour *contours;

  // What labels say, kind_count of them: formats like lsys_print's, with a conversion for each argument; NULL of kinds
  // that say nothing. NULL: no kind does.
  const char *const *texts;
};

// ---- what compiled code calls ----------------------------------------------

// Hands on what was written and makes room for at least the grammar's room_sym modules.
// Does not return when the run has to stop (longjmp to the driver: compiled code owns nothing).
void lsys_flush(LsysStream *out);

// Appends a word of any length without keys.
void lsys_append(LsysStream *out, const uint8_t *sym, uint64_t nsym, const double *arg, uint64_t narg);

// Reports that the recursion took all of the stack that was set aside; does not return.
void lsys_too_deep(LsysStream *out);

// Tells that bytes more (fewer if negative) are held for this run. Does not return when that
// exceeds --max-memory: call it before allocating, and keep what is held where the next run finds it.
void lsys_charge(LsysRun *run, int64_t bytes);

// Ends the run with a message for the user, such as an array's index out of range; does not return.
void lsys_fail(LsysRun *run, const char *format, ...) __attribute__((format(printf, 2, 3), noreturn));

// Tells the user, once, that a maximum depth cut a decomposition (0) or homomorphism (1) off; any thread may call it.
void lsys_cut_short(LsysRun *run, uint32_t which);

// Before a step: sets the arguments of queries and communication modules in the word whose arguments are `argument`
// (those of word). Does nothing for grammars without any; does not return where there is no memory.
void lsys_look(LsysRun *run, const LsysWord *word, double *argument);
void lsys_look_end(LsysRun *run);

// printf of a block, to standard error: format holds one conversion d, i, e, f or g for each value.
void lsys_print(LsysRun *run, const char *format, const double *values, uint32_t count);

// The same into a file that lsys_fopen opened; and what else blocks do with files. None returns where that fails.
void lsys_print_to(LsysRun *run, double file, const char *format, const double *values, uint32_t count);
double lsys_fopen(LsysRun *run, const char *name, const char *mode);
void lsys_fclose(LsysRun *run, double file);
double lsys_fscanf(LsysRun *run, double file);  // the next number; nan where there is none

// The functions that compiled code may call, by name: what the JIT binds.
typedef struct LsysSymbol {
  const char *name;
  void *address;
} LsysSymbol;
extern const LsysSymbol lsys_symbols[];
extern const size_t lsys_symbol_count;

// The command line of a compiled program around a grammar (options.def); returns the exit status.
int lsys_main(const LsysGrammar *grammar, int argc, char **argv);

// The number of steps that arguments of a program (without its name) ask for; false if they do not. Prints nothing.
bool lsys_steps_asked(int argc, char **argv, uint64_t *steps);

#endif
