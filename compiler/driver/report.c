// report.c -- see report.h.
#include "driver/report.h"

#include <stdarg.h>
#include <stdio.h>

bool report_error(const char *format, ...) {
  va_list args;
  va_start(args, format);
  fputs("lsysc: error: ", stderr);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
  va_end(args);
  return false;
}
