// embed.c -- lsys_derive: a grammar inside of somebody else's program. Unlike
// lsys_main it leaves the process's signal handlers alone.
#include "core/message.h"
#include "core/program.h"
#include "lsys/lsys.h"

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

bool lsys_derive(const LsysGrammar *grammar, const char *const *options, LsysReceive *receive, void *data) {
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
  Receiver receiver = {
    {.passes = 1, .begin = begin, .take = take, .end = nothing, .finish = nothing}, receive, data, 0};
  well = well && lsys_program_run(grammar, &parsed, &receiver.sink);
  lsys_options_free(&parsed);
  return well;
}
