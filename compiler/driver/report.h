// report.h -- errors that belong to no place in a grammar: bad options, missing files, a failing linker.
#ifndef LSYSC_DRIVER_REPORT_H
#define LSYSC_DRIVER_REPORT_H

#include <stdbool.h>

// Prints "lsysc: error: ..." to stderr. Always false, so that a caller can return it.
bool report_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
