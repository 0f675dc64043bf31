// program.h -- what options ask for, done: shared by lsys_main and lsys_derive.
#ifndef LSYS_CORE_PROGRAM_H
#define LSYS_CORE_PROGRAM_H

#include "core/options.h"
#include "sinks/sink.h"

// Derives and writes. `own` (or NULL) gets the word, too; it is not destroyed.
// False after printing what is wrong.
bool lsys_program_run(const LsysGrammar *grammar, const LsysOptions *options, LsysSink *own);

// False after printing that the grammar was compiled for another run time.
bool lsys_program_fits(const LsysGrammar *grammar);

#endif
