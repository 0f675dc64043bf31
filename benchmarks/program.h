// program.h -- whole runs of a compiled grammar, from options to the last byte written.
#ifndef LSYSC_BENCHMARKS_PROGRAM_H
#define LSYSC_BENCHMARKS_PROGRAM_H

#include "lsys/abi.h"

enum { MOST_ARGUMENTS = 16 };

typedef struct Program {
  const LsysGrammar *grammar;
  char *argv[MOST_ARGUMENTS];
  int argc;
} Program;

// A command line of `bench`, to which arguments are added one by one, or several separated by blanks from text that
// lives as long as the program does and is cut into pieces.
Program program_of(const LsysGrammar *grammar);
void program_add(Program *program, const char *argument);
void program_add_all(Program *program, char *arguments);

// Runs it; exits when that fails. data is a Program.
void program_run(void *data);

// Between these two, what programs print goes nowhere.
int screen_hide(void);
void screen_show(int screen);

#endif
