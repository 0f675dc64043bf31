// help.h -- reference texts made of the tables: what `./plant --help turtle`
// and `lsysc help turtle` print.
#ifndef LSYS_HELP_H
#define LSYS_HELP_H

#include <stdbool.h>
#include <stdio.h>

// The table of one subject: formats, turtle, functions, operators, settings. False: there is no such subject.
bool lsys_help_subject(FILE *to, const char *subject);

// One row of two columns, with doc broken into lines at blanks.
void lsys_help_row(FILE *to, const char *left, const char *doc);

#endif
