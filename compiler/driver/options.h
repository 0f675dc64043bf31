// options.h -- lsysc's command line, read by the table options.def.
#ifndef LSYSC_DRIVER_OPTIONS_H
#define LSYSC_DRIVER_OPTIONS_H

#include "codegen/backend.h"
#include "support/diag.h"

typedef enum Command {
#define COMMAND(id, name, arguments, summary, doc) COMMAND_##id,
#include "driver/options.def"
  COMMAND_COUNT
} Command;

typedef enum OptionId {
#define OPTION(id, spelling, how, value, commands, doc) OPTION_##id,
#include "driver/options.def"
  OPTION_COUNT
} OptionId;

typedef enum OptionHow { OPTION_FLAG, OPTION_JOINED, OPTION_SPACED, OPTION_EQUALS } OptionHow;

typedef struct CommandRow {
  const char *name, *arguments, *summary, *doc;
} CommandRow;
extern const CommandRow command_table[COMMAND_COUNT];

typedef struct OptionRow {
  const char *spelling;
  OptionHow how;
  const char *value;
  unsigned commands;  // bit 1 << Command
  const char *doc;
} OptionRow;
extern const OptionRow option_table[OPTION_COUNT];

typedef enum Dump { DUMP_NOTHING, DUMP_TOKENS, DUMP_AST, DUMP_PROGRAM, DUMP_FACTS, DUMP_IR } Dump;

typedef VEC(const char *) Strings;

typedef struct Options {
  Command command;
  Strings files;   // of `help`: its topic
  Strings passed;  // run, interp: what goes to the program, in order
  Strings given;   // run, interp: -D behind the grammar, for grammar and program
  bool help, version, verbose, times, list_systems;
  const char *output;      // -o; NULL: from the file's name
  bool program;            // link a program; otherwise backend.emit says what to write
  const char *emit_given;  // the option that said so, or NULL
  BackendOptions backend;
  bool optimise_given;  // -O
  const char *linker;
  ParseOptions parse;
  DiagOptions diag;
  Dump dump;
} Options;

// Reads the command line into *options; strings stay argv's. False after
// printing what was wrong to stderr.
bool options_parse(Arena *arena, int argc, char **argv, Options *options);

// "-o NAME", "--emit=exe|obj": how help and manual show an option.
void options_head(const OptionRow *option, char *head, size_t size);

#endif
