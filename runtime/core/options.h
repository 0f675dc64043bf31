// options.h -- the command line, parsed (options.def).
#ifndef LSYS_CORE_OPTIONS_H
#define LSYS_CORE_OPTIONS_H

#include "lsys/abi.h"

#include <stdbool.h>
#include <stdio.h>

typedef enum LsysOption {
#define OPTION(id, letter, name, argument, type, doc) LSYS_OPTION_##id,
#include "core/options.def"
  LSYS_OPTION_COUNT_
} LsysOption;

typedef enum LsysOptionType {
  LSYS_OPTION_FLAG,
  LSYS_OPTION_WHOLE,
  LSYS_OPTION_SIZE,
  LSYS_OPTION_REAL,
  LSYS_OPTION_TEXT,
  LSYS_OPTION_DEFINITION,
  LSYS_OPTION_SUBJECT
} LsysOptionType;

typedef struct LsysOptionInfo {
  LsysOption option;
  char letter;           // 0: none
  const char *name;      // without --
  const char *argument;  // NULL: takes none
  LsysOptionType type;
  const char *doc;
} LsysOptionInfo;

extern const LsysOptionInfo lsys_options[LSYS_OPTION_COUNT_];

typedef struct LsysOptionValue {
  bool given;
  uint64_t whole;    // WHOLE, SIZE
  double real;       // REAL
  const char *text;  // the argument as written; NULL if there is none
} LsysOptionValue;

typedef struct LsysOptions {
  LsysOptionValue at[LSYS_OPTION_COUNT_];
  const char **definitions;  // the NAME=VALUE of every -D, in order
  size_t definition_count;
} LsysOptions;

// Reads argv[0..argc), without a program's name. False after printing what is wrong. The texts point into argv.
bool lsys_options_parse(LsysOptions *options, int argc, char **argv);
void lsys_options_free(LsysOptions *options);

// --help: usage, options, the grammar's params; or one subject's table. False after printing that there is no such
// subject.
bool lsys_help(FILE *to, const LsysGrammar *grammar, const char *subject);

#endif
