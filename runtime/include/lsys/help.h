// help.h -- reference texts made of the tables: what `./plant --help turtle`
// and `lsysc help turtle` print, and what they say of a single word.
#ifndef LSYS_HELP_H
#define LSYS_HELP_H

#include <stdbool.h>
#include <stdio.h>

// Rows under titles: all of them, or those of one word.
typedef struct LsysHelp {
  FILE *to;
  const char *only;   // NULL: all rows
  const char *title;  // of the rows to come, not printed yet
  bool any;           // a row was printed
  char near[32];      // the name spelt most like the one that is asked for; "": none is
} LsysHelp;

// Begins a table. Its title is printed before its first row.
void lsys_help_title(LsysHelp *help, const char *title);

// A row, if it is about one of the names (separated by blanks) that is asked for.
void lsys_help_entry(LsysHelp *help, const char *names, const char *left, const char *doc);

// Remembers that of these names that is spelt most like the one that is asked for.
void lsys_help_near(LsysHelp *help, const char *names);

// The table of one subject: formats, turtle, functions, operators, settings. False: there is no such subject.
bool lsys_help_subject(FILE *to, const char *subject);

// The rows of all these subjects, and of the options of a compiled program.
void lsys_help_tables(LsysHelp *help);

// The options of a compiled program.
void lsys_help_options(FILE *to);

// An option of a compiled program as shells complete it; argument is NULL, a name, or a list a|b|c.
typedef struct LsysHelpOption {
  char letter;  // 0: none
  const char *name, *argument, *doc;
} LsysHelpOption;

// The i-th option, or the name of the i-th format. False, NULL: there are no more.
bool lsys_help_option(int i, LsysHelpOption *option);
const char *lsys_help_format(int i);

// One row of two columns, with doc broken into lines at blanks.
void lsys_help_row(FILE *to, const char *left, const char *doc);

#endif
