// ir.h -- code generation's shared state: the one header that includes llvm-c.
//
// An Ir is one module under construction. Passes run in the order of
// module_build: functions of the run time, user functions, rewriting,
// initialisation, and last the descriptor that points at all of them. Every
// value is an IEEE double, every key and count an i64, every word three
// streams (lsys/abi.h). Emission never sets fast-math flags.
#ifndef LSYSC_CODEGEN_IR_H
#define LSYSC_CODEGEN_IR_H

#include "codegen/backend.h"
#include "support/diag.h"

#include <llvm-c/Core.h>
#include <llvm-c/TargetMachine.h>

typedef struct DebugInfo DebugInfo;

// The run time's structs, mirrored once; the fields have the numbers below.
typedef struct IrTypes {
  LLVMTypeRef none, i1, i8, i16, i32, i64, f64, ptr;
  LLVMTypeRef symbol;  // i8, or i16 in wide grammars
  LLVMTypeRef word, stream, block, run, kind, param, axiom, growth;
  LLVMTypeRef scan, neighbour, cursor;
} IrTypes;

enum { WORD_SYM, WORD_ARG, WORD_KEY, WORD_NSYM, WORD_NARG, WORD_NKEY };
enum { STREAM_SYM, STREAM_ARG, STREAM_KEY, STREAM_SYM_LIMIT, STREAM_RUN, STREAM_STOP, STREAM_STACK_LIMIT };
enum { BLOCK_SYM, BLOCK_ARG, BLOCK_NSYM, BLOCK_NARG };
enum {
  SCAN_SYM,
  SCAN_END,
  SCAN_ARG,
  SCAN_KEY,
  SCAN_LEFT,
  SCAN_RUN,
  SCAN_STEP,
  SCAN_DEPTH,
  SCAN_FRESH,
  SCAN_AHEAD_KNOWN,
  SCAN_PASSED,
  SCAN_SYSTEM,
  SCAN_OTHER,
  SCAN_WHOLE
};
enum { NEIGHBOUR_KIND, NEIGHBOUR_WRAP, NEIGHBOUR_ARG, NEIGHBOUR_FIELDS };
enum { CURSOR_SYM, CURSOR_END, CURSOR_ARG, CURSOR_FOUND, CURSOR_SEGMENT, CURSOR_OPEN };
enum { RUN_GRAMMAR, RUN_VALUE, RUN_ROOT, RUN_STEPS, RUN_BLOCK, RUN_BLOCK_LEVELS, RUN_TABLE, RUN_STOPPED };

// A function that rewrites modules of one kind, by how it goes on with the result. The cursors of the streams that the
// grammar uses are handed in and returned, so that they stay in registers.
typedef enum Way {
  WAY_EXPAND,     // (out, cursors, steps, args..., key): derives by that many steps
  WAY_DECOMPOSE,  // (out, cursors, steps, depth, args..., key): decomposes, then derives by steps
  WAY_INTERPRET,  // (out, cursors, depth, args..., key): homomorphism; (out, cursors, scan, depth, args..., key) where
                  // it takes whole words
  WAY_STEP,       // no function of its own: in a loop over the word
  WAY_COUNT
} Way;

typedef struct Ir {
  Arena *arena;
  const Program *program;
  const Facts *facts;
  const LsysGrammar *description;
  const BackendOptions *options;
  struct Diag *diag;

  LLVMContextRef context;
  LLVMModuleRef module;
  LLVMBuilderRef builder;
  IrTypes types;
  unsigned tail_convention;    // calling convention of the rewriting functions
  LLVMTailCallKind tail_kind;  // how their last calls are marked
  unsigned flush_convention;   // of cursors.flush
  DebugInfo *debug;            // NULL without -g

  uint32_t *counter;              // per call site: its repetition counter, or NO_COUNTER
  uint32_t counters;              // how many there are
  LLVMValueRef *functions;        // user functions
  LLVMValueRef *ways[WAY_COUNT];  // per way, L-system and kind: the function, or NULL (expand_function)
  LLVMValueRef *schedules;        // per L-system: table of each step (T0L), or NULL
  bool state;                     // globals or blocks: everything happens in order, one after the other
  bool apart;                     // decomposition is a walk of its own behind each step
  bool stepping;                  // for the step engine: a module is derived by one step at a time
  bool letters;                   // the step goes through a table of cases (letters.c)
  bool shown_keys;                // a homomorphism draws: only then does anyone read the keys of a derived word
  bool uses_stream[3];            // symbols, arguments, keys: whether the grammar has any
  uint32_t room_sym;              // the most modules that room was asked for at once
} Ir;

#define NO_COUNTER UINT32_MAX

// ---- module.c: types, constants, small instructions -----------------------

// An empty module for the target; the caller disposes of it with ir_destroy.
void ir_create(Ir *ir, LLVMContextRef context, LLVMTargetMachineRef machine);
void ir_destroy(Ir *ir);

LLVMValueRef ir_int(const Ir *ir, uint64_t value);
LLVMValueRef ir_double(const Ir *ir, double value);
bool ir_is_double(LLVMValueRef value, double *number);  // true for a constant

LLVMValueRef ir_load(Ir *ir, LLVMTypeRef type, LLVMValueRef object, LLVMTypeRef object_type, unsigned field);
void ir_store(Ir *ir, LLVMValueRef value, LLVMValueRef object, LLVMTypeRef object_type, unsigned field);
void ir_mark(Ir *ir, LLVMValueRef instruction, const char *name);  // by metadata that is empty
void ir_mark_invariant(Ir *ir, LLVMValueRef load);  // what it reads never changes while derivation code runs
LLVMValueRef ir_advance(Ir *ir, LLVMTypeRef element, LLVMValueRef pointer, LLVMValueRef count);

LLVMValueRef ir_call(Ir *ir, LLVMValueRef function, LLVMValueRef *args, unsigned count);
LLVMBasicBlockRef ir_block(Ir *ir, const char *name);  // appended to the function being built
void ir_branch(Ir *ir, LLVMValueRef condition, LLVMBasicBlockRef yes, LLVMBasicBlockRef no);
void ir_branch_unlikely(Ir *ir, LLVMValueRef condition, LLVMBasicBlockRef yes, LLVMBasicBlockRef no);
void ir_at(Ir *ir, LLVMBasicBlockRef block);  // go on building at the end of block
LLVMValueRef ir_local(Ir *ir, LLVMTypeRef type, uint64_t count, const char *name);  // a variable in the entry block
LLVMValueRef ir_data(Ir *ir, LLVMValueRef constant, const char *name);              // a private constant's address

// A function of the run time, declared on first use.
typedef enum IrEffect { IR_PURE, IR_ANY, IR_STOPS } IrEffect;
LLVMValueRef ir_runtime(Ir *ir, const char *name, LLVMTypeRef result, LLVMTypeRef *params, unsigned count,
                        IrEffect effect);
LLVMValueRef ir_intrinsic(Ir *ir, const char *name, LLVMTypeRef type);  // overloaded on one type
void ir_attribute(Ir *ir, LLVMValueRef function, unsigned place, const char *name);

// ---- keys.c: LANGUAGE.md 5.8 in instructions --------------------------------

LLVMValueRef key_split(Ir *ir, LLVMValueRef key, uint64_t child);
LLVMValueRef key_chain(Ir *ir, LLVMValueRef key, LLVMValueRef steps);  // split(key, 0) so many times
LLVMValueRef key_draw(Ir *ir, LLVMValueRef key, LLVMValueRef number);
LLVMValueRef key_bits(Ir *ir, LLVMValueRef key, LLVMValueRef number);  // the 64 bits that the draw is made of
// i1: the draw of these bits times sum is below bound, as if both were multiplied and compared as doubles.
LLVMValueRef key_below(Ir *ir, LLVMValueRef bits, double sum, double bound);
bool key_exceeds(double sum);  // a draw times sum is always below sum

// ---- expr.c, function.c: expressions, statement blocks, user functions --------------------

// A formal parameter or local variable: an SSA value, or a variable in memory.
typedef struct Slot {
  LLVMValueRef value, address;
} Slot;

void slot_bind(Ir *ir, Slot *slot, LLVMValueRef value);

// What an expression sees.
typedef struct Scope {
  Ir *ir;
  LLVMValueRef run;
  LLVMValueRef key;       // NULL where nothing can draw
  LLVMValueRef counters;  // array of repetition counters, NULL where no site can repeat
  Slot *slots;
  bool constant_values;  // values do not change while this code runs
} Scope;

LLVMValueRef expr_value(Scope *scope, const Expr *expr);  // a double
LLVMValueRef expr_test(Scope *scope, const Expr *expr);   // an i1: it holds
// True if nothing in it fails, counts or calls, and all of it costs no more instructions than the budget, which
// shrinks.
bool expr_cheap(const Expr *expr, unsigned *budget);
LLVMValueRef expr_holds(Ir *ir, LLVMValueRef value);           // an i1
LLVMValueRef expr_value_address(Scope *scope, uint32_t slot);  // of an entry of the run's value array
LLVMValueRef expr_element_address(Scope *scope, uint32_t array, Expr *const *index, uint32_t count);
void actions_run(Scope *scope, const Actions *actions);

void counters_assign(Ir *ir);  // finds the sites that can repeat
bool counters_needed(const Ir *ir, const Production *production);
bool counters_needed_word(const Ir *ir, const Word *word);
LLVMValueRef counters_create(Ir *ir);  // the array, in the entry block
void counters_clear(Ir *ir, LLVMValueRef counters);

void functions_declare(Ir *ir);
void functions_define(Ir *ir);

// ---- rewrite.h part: one module's rewriting being emitted --------------------

// The modules that straight-line code will write together.
typedef struct Line {
  VEC(KindId) kinds;
  VEC(LLVMValueRef) args;
  VEC(LLVMValueRef) keys;
} Line;

// Where a loop over a word stands (lsys/scan.h).
typedef struct Walk {
  LLVMValueRef *scans;                        // one for each view
  LLVMValueRef sym, arg, key, end;            // the module at hand
  LLVMBasicBlockRef next;                     // the latch,
  LLVMValueRef next_sym, next_arg, next_key;  //   and its phis
  bool left, right;                           // some production that is tried has such a context
  LLVMValueRef *window;                       // per view, neighbour and field: its variable; NULL: all in the scans
  bool begins;                                // a left context asks for `[`
  LLVMValueRef stop;                          // a variable: there is room up to here; NULL: that is asked line by line
  LLVMValueRef ahead, found;                  // kind and arguments of the next seen module, once known
  LLVMValueRef *tables;                       // T0L: each L-system's table of this step
  LLVMValueRef counters;
} Walk;

// A rewriting function under construction, at one place in it.
typedef struct Rewrite {
  Scope scope;  // of the production at hand; its key is the module's
  Way way;
  KindId kind;
  size_t system;                // the L-system whose productions apply
  LLVMValueRef *args;           // the module's arguments
  LLVMValueRef out;             // the stream
  LLVMValueRef cursor[3];       //   and variables that hold its cursors meanwhile, if not NULL
  bool roomy;                   //   it was made sure that there is room
  uint32_t spare;               // there is room for that many modules
  LLVMBasicBlockRef spare_in;   //   in this block
  LLVMValueRef ahead;           // WAY_EXPAND: steps before out->stop
  LLVMValueRef steps;           // WAY_EXPAND: steps left, this one included; WAY_DECOMPOSE: behind this step
  LLVMValueRef depth;           // levels left, this one included; NULL in WAY_EXPAND
  LLVMValueRef table;           // T0L: the table of this step, NULL where no production asks
  LLVMBasicBlockRef again;      // head of the loop that a last successor of the same kind jumps to,
  VEC(LLVMValueRef) variables;  //   and its variables: the function's parameters behind the cursors
  LLVMValueRef left, deeper;    // steps and levels that the successor's modules have left
  LLVMBasicBlockRef self;       // writes the module as it is, and ends
  LLVMBasicBlockRef deep;       // ends the run for want of stack; NULL until needed
  unsigned near;                // at most so many steps are left, one at least; 0: more
  bool silent;                  // what is written carries no keys
  Walk *walk;                   // where neighbours are looked for; NULL where there are no contexts
  LLVMBasicBlockRef done;       // where to go behind the last module; NULL: the function returns
  Line line;
} Rewrite;

// select.c: the choice among productions (LANGUAGE.md 5.2). Calls take in the block where each is chosen, which
// must end that block; then goes on where none is. False if one always is: then there is no such place.
typedef void (*Take)(Rewrite *rewrite, const Production *production);
bool select_production(Rewrite *rewrite, const Productions *productions, Take take);

// Emits `then`, which ends its block, where some production would apply; goes on where none does.
void select_any(Rewrite *rewrite, const Productions *productions, void (*then)(Rewrite *rewrite));

// walk.c: a function (scan, out) that goes through a word. `each` emits what happens to a module of rewrite->kind that
// belongs to rewrite->system, and ends with walk_pass or walk_cut; `begin`, unless NULL, what is known before the loop.
typedef void (*Each)(Rewrite *rewrite);
LLVMValueRef walk_emit(Ir *ir, const char *name, Way way, Each begin, Each each);
void walk_pass(Rewrite *rewrite, const KindId *kinds, size_t count);         // on behind modules of these kinds
void walk_cut(Rewrite *rewrite);                                             // on at the end of the branch
LLVMValueRef walk_left(const Rewrite *rewrite, uint32_t j, unsigned field);  // of the j-th neighbour, 0 the nearest
bool walk_has_key(const Rewrite *rewrite, KindId kind);  // the word that is read has this kind's keys
void walk_store(const Rewrite *rewrite);                 // lets the scans stand at the module at hand
LLVMValueRef *walk_scans(Ir *ir, LLVMValueRef first);    // the scans of all views
LLVMValueRef walk_scan(const Rewrite *rewrite);          // the one that rewrite->system's contexts look at

// neighbours.c: what productions that are tried one after the other share.
void neighbours_prepare(Rewrite *rewrite, const Productions *productions);
// Goes on only where the rest of the strict predecessor and the contexts fit; binds their parameters.
void neighbours_require(Rewrite *rewrite, const Production *production, Slot *slots, LLVMBasicBlockRef fail);

// A module of a successor, evaluated. Its key is made where it is needed (derived_key).
typedef struct Derived {
  KindId kind;
  LLVMValueRef *args;
  LLVMValueRef key;     // its key if that is there already,
  LLVMValueRef parent;  //   else the key of what was rewritten
  uint64_t child;       //   and its place in the successor
} Derived;

// successor.c: evaluates the arguments of the production's successor, module by module.
Derived *successor_derive(Rewrite *rewrite, const Production *production);
LLVMValueRef derived_key(Ir *ir, const Derived *module);  // NULL where its kind has none

// line.c: modules that are written as they are, with one check for room.
void line_add(Rewrite *rewrite, KindId kind, LLVMValueRef *args, LLVMValueRef key);
void line_flush(Rewrite *rewrite);
uint64_t line_most(uint64_t n);  // places for symbols that lines of n modules ask for at most
// Between the stream and the variables that hold its cursors.
void line_fetch(const Rewrite *rewrite);
void line_settle(const Rewrite *rewrite);
void line_hold(Rewrite *rewrite);             // makes such variables for the rest of the function
void line_write_out(const Rewrite *rewrite);  // lsys_flush
// Cursors as parameters and results of rewriting functions.
unsigned line_cursor_types(const Ir *ir, LLVMTypeRef *types);  // their number, at most 3
LLVMTypeRef line_result_type(const Ir *ir);
void line_begin(Rewrite *rewrite, LLVMValueRef function, unsigned first);  // from parameters to variables
unsigned line_cursors(const Rewrite *rewrite, LLVMValueRef *values);       // what to pass to a call
void line_resume(Rewrite *rewrite, LLVMValueRef result);                   // go on where a call ended
void line_return(Rewrite *rewrite);
void line_reserve(Rewrite *rewrite, uint32_t count);  // one check for all that follows in this block
// A row of symbols alone, copied with so many bytes, of which the modules behind length are overwritten by what
// follows.
void line_copy_row(Rewrite *rewrite, LLVMValueRef symbols, uint32_t bytes, LLVMValueRef length, uint32_t longest);
// Symbols in an integer (line_symbols) and arguments, of which so many count; at most `longest` modules. What stands
// behind them is overwritten by what follows.
void line_pick(Rewrite *rewrite, LLVMValueRef symbols, LLVMValueRef count, uint32_t longest, LLVMValueRef *args,
               uint32_t arguments, LLVMValueRef arg_count);
LLVMValueRef line_symbols(Ir *ir, const KindId *kinds, size_t count, uint32_t places);  // 8 bytes at most
uint32_t line_symbol_bytes(const Ir *ir);                                               // of one symbol
// One module whose symbol is known at run time only.
void line_copy(Rewrite *rewrite, LLVMValueRef symbol, LLVMValueRef *args, uint32_t arity, LLVMValueRef key);

// fuse.c: the last steps of a derivation as straight-line code.
unsigned fuse_levels(Ir *ir, const Production *production);                               // how many; 0: none
void fuse_write(Rewrite *rewrite, const Derived *modules, size_t count, unsigned steps);  // after so many more steps

// pick.c: kinds whose last step cheap guards decide.
bool pick_kind(const Ir *ir, KindId kind);
uint32_t pick_longest(const Ir *ir, KindId kind);  // modules that one becomes at most; 0: it is no such kind
void pick_write(Rewrite *rewrite, KindId kind, LLVMValueRef *args);

// leaf.c: kinds whose last step needs no branch: a draw alone decides, or cheap guards do.
bool leaf_kind(const Ir *ir, KindId kind);
void leaf_write(Rewrite *rewrite, const Derived *module);  // what it becomes by the last step
// Room that the word's last step takes if all that is not terminal in it is of such kinds; else 0.
uint32_t leaf_room(const Ir *ir, const Word *word);
void leaf_write_word(Rewrite *rewrite, const Derived *modules, size_t count, uint32_t room);

// expand.c: the rewriting functions of all reachable kinds.
void expand_declare(Ir *ir);
void expand_define(Ir *ir);
// Levels that the L-system's section of WAY_DECOMPOSE or WAY_INTERPRET allows.
LLVMValueRef expand_depth(Ir *ir, Way way, size_t system);
LLVMValueRef expand_stop(Ir *ir, LLVMValueRef out);  // out->stop
const Productions *expand_productions(const Ir *ir, Way way, size_t system, KindId kind);
LLVMValueRef expand_function(const Ir *ir, Way way, size_t system, KindId kind);  // NULL: none is needed
bool expand_takes_scan(const Ir *ir, Way way);
// Calls the function of a kind with what stands behind the cursors; line_resume or a return takes the result.
LLVMValueRef expand_call(const Rewrite *rewrite, Way way, KindId kind, LLVMValueRef *rest, unsigned count);

// flow.c: where modules go. All but flow_hand_on of a module before the last end the block.
// A module that a rewriting produced goes on by the rewriting's way.
void flow_hand_on(Rewrite *rewrite, const Derived *module, bool last);
unsigned flow_levels(Ir *ir, KindId kind);  // the most steps that are written straight-line for such a module
void flow_take(Rewrite *rewrite, const Production *production);  // what a production writes
void flow_stay(Rewrite *rewrite);                                // where none applies
void flow_settle(Rewrite *rewrite);                              // in rewrite->self: no step or level is left
void flow_finish(Rewrite *rewrite);                              // behind what was written

// entry.c: the descriptor's functions that take packed words; NULL where the grammar has no such thing.
LLVMValueRef entry_expand(Ir *ir);
LLVMValueRef entry_homomorphism(Ir *ir);

// whole.c: the same for whole words, whose modules are replaced where they stand.
LLVMValueRef whole_decompose(Ir *ir);
LLVMValueRef whole_interpret(Ir *ir);
// The key that a module's homomorphism starts from; any, if none is there because no homomorphism draws.
LLVMValueRef image_key(Ir *ir, size_t system, LLVMValueRef key);

// step.c: the descriptor's function that rewrites a word once; NULL where the expand engine does.
LLVMValueRef step_emit(Ir *ir);

// letters.c: a step that goes through a table of cases; NULL for grammars that need code.
LLVMValueRef letters_emit(Ir *ir);

// init.c
LLVMValueRef init_emit(Ir *ir);
void init_arrays(Scope *scope);  // gives arrays the elements that they begin with

// blocks.c: Start, StartEach, EndEach, End; NULL where the grammar has no state.
LLVMValueRef blocks_emit(Ir *ir);
uint32_t blocks_values(const Ir *ir);  // entries of the run's value array that they keep behind the program's
LLVMValueRef axiom_emit(Ir *ir);

// freeze.c: the description as an exported constant that points at the functions.
typedef struct Entries {
  LLVMValueRef init, axiom, expand, step, block, decompose, homomorphism, interpret;
} Entries;
void freeze_grammar(Ir *ir, const Entries *entries);

// split.c: removes from the module what is not in this one of BACKEND_PARTS parts.
void split_keep(Ir *ir, const Entries *entries, unsigned part);

// ---- debug.c: -g ---------------------------------------------------------------

// All but debug_create do nothing without -g.

void debug_create(Ir *ir, const Sources *sources);
void debug_finish(Ir *ir);
void debug_function(Ir *ir, LLVMValueRef function, Span span);
void debug_arguments(Rewrite *rewrite, const Production *production);  // the function's, by their names there
// What follows applies this production: a debugger stops there and shows the parameters in scope.slots.
void debug_enter(Rewrite *rewrite, const Production *production);
void debug_leave(Rewrite *rewrite);

// ---- machine.c, emit.c, jit.c ------------------------------------------------------

// For options->target and cpu, or this very machine. NULL after reporting.
LLVMTargetMachineRef machine_create(const BackendOptions *options, bool this_machine, struct Diag *diag);
LLVMCodeGenOptLevel emit_selection(unsigned optimise);  // how well -O0 to -O3 select instructions
bool emit_passes(Ir *ir, LLVMTargetMachineRef machine);
LLVMMemoryBufferRef emit_buffer(Ir *ir, LLVMTargetMachineRef machine, EmitKind kind);  // NULL after reporting

// Takes over the machine and those objects that become NULL. NULL after reporting.
Jit *jit_create(LLVMTargetMachineRef machine, LLVMMemoryBufferRef *objects, size_t object_count, const char *symbol,
                const LsysSymbol *symbols, size_t symbol_count, struct Diag *diag);
const LsysGrammar *jit_grammar(Jit *jit);
void jit_free(Jit *jit);

#endif
