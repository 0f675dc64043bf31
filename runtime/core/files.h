// files.h -- the files that a grammar's blocks opened.
#ifndef LSYS_CORE_FILES_H
#define LSYS_CORE_FILES_H

#include "lsys/abi.h"

#include <stdbool.h>
#include <stdio.h>

// The open file of a number; ends the run where there is none. what: the function that asks.
FILE *lsys_files_at(LsysRun *run, double number, const char *what);

// Closes those that are still open. False after printing that one was not written.
bool lsys_files_close(LsysRun *run);

#endif
