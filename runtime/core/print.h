// print.h -- what printf of a grammar makes of numbers, as a text.
#ifndef LSYS_CORE_PRINT_H
#define LSYS_CORE_PRINT_H

#include "lsys/abi.h"

// To be freed; NULL: there is no memory.
char *lsys_print_text(LsysRun *run, const char *format, const double *values, uint32_t count);

#endif
