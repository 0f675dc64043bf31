// embed.c -- lsys_derive, lsys_derive_word: a grammar inside of somebody else's
// program. Unlike lsys_main they leave the process's signal handlers alone.
#include "core/message.h"
#include "core/program.h"
#include "core/store.h"
#include "lsys/lsys.h"

#include <stdlib.h>

typedef struct Receiver {
  LsysSink sink;
  LsysReceive *receive;
  void *data;
  uint32_t axiom;
} Receiver;

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)pass;
  ((Receiver *)sink)->axiom = axiom;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  Receiver *receiver = (Receiver *)sink;
  return receiver->receive(receiver->data, receiver->axiom, part);
}

static bool nothing(LsysSink *sink) {
  (void)sink;
  return true;
}

static bool derive(const LsysGrammar *grammar, const char *const *options, LsysSink *sink) {
  lsys_message_program(grammar->name);
  if (!lsys_program_fits(grammar)) return false;
  int count = 0;
  while (options[count]) count++;
  LsysOptions parsed;
  // The texts are only pointed to.
  bool well = lsys_options_parse(&parsed, count, (char **)options);
  if (well && (parsed.at[LSYS_OPTION_HELP].given || parsed.at[LSYS_OPTION_VERSION].given)) {
    lsys_error("lsys_derive derives; --help and --version are for lsys_main");
    well = false;
  }
  well = well && lsys_program_run(grammar, &parsed, sink);
  lsys_options_free(&parsed);
  return well;
}

bool lsys_derive(const LsysGrammar *grammar, const char *const *options, LsysReceive *receive, void *data) {
  Receiver receiver = {
    {.passes = 1, .begin = begin, .take = take, .end = nothing, .finish = nothing}, receive, data, 0};
  return derive(grammar, options, &receiver.sink);
}

// ---- the word in one piece ---------------------------------------------------

typedef struct Keeper {
  LsysSink sink;
  LsysStore store;
  LsysWhole *whole;
  bool begun;
} Keeper;

// The arrays of an earlier word are booked as long as they are filled.
static bool begin_whole(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)axiom, (void)pass;
  Keeper *keeper = (Keeper *)sink;
  const LsysWhole *whole = keeper->whole;
  if (keeper->begun) {
    lsys_error("lsys_derive_word derives one start word, and the grammar has several: choose one by --axiom");
    return false;
  }
  keeper->begun = true;
  LsysLoan place = {whole->sym, whole->arg, whole->sym_bytes, whole->arg_bytes / sizeof(double)};
  lsys_store_open_at(&keeper->store, run->grammar, &place);
  if (whole->given) return true;
  uint64_t held = whole->sym_bytes + whole->arg_bytes;
  if (!lsys_memory_take(run->memory, held)) {
    lsys_memory_refuse(run->memory, held);
    return false;
  }
  keeper->store.fixed = false;
  keeper->store.memory = run->memory;
  return true;
}

// Nobody asks for the keys of a last word.
static bool take_whole(LsysSink *sink, const LsysWord *part) {
  LsysStore *store = &((Keeper *)sink)->store;
  LsysWord keyless = *part;
  keyless.nkey = 0;
  return store->sink.take(&store->sink, &keyless);
}

static bool lend_whole(LsysSink *sink, LsysLoan *place) {
  return lsys_store_lend(&((Keeper *)sink)->store, place);
}

bool lsys_derive_word(const LsysGrammar *grammar, const char *const *options, LsysWhole *whole) {
  Keeper keeper = {
    .sink =
      {.passes = 1, .begin = begin_whole, .take = take_whole, .end = nothing, .finish = nothing, .lend = lend_whole},
    .whole = whole};
  bool well = derive(grammar, options, &keeper.sink);
  if (well && !keeper.begun) lsys_error("lsys_derive_word: the options ask for pictures that are made without a word");
  if (!keeper.begun) return false;
  const LsysStore *store = &keeper.store;
  *whole = (LsysWhole){.sym = store->sym,
                       .arg = store->arg,
                       .sym_bytes = store->sym_bytes,
                       .arg_bytes = store->arg_room * sizeof(double),
                       .nsym = store->nsym,
                       .narg = store->narg,
                       .given = whole->given};
  return well;
}

void lsys_whole_free(LsysWhole *whole) {
  if (!whole->given) {
    free(whole->sym);
    free(whole->arg);
  }
  *whole = (LsysWhole){0};
}
