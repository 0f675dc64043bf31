// print.c -- printf of a grammar's blocks and texts of labels, the same for every engine.
// Requires: a format that check has seen: of conversions only d, i, e, f, g
// (and E, F, G), one for each value.
#include "core/print.h"

#include "core/files.h"
#include "core/message.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_WIDTH = 4 };  // digits of a width or precision

// Copies what stands between % and the letter; false where a number in it is too long to be meant.
static const char *copy_flags(const char *from, char *to) {
  size_t flags = strspn(from, "-+ #0");
  size_t width = strspn(from + flags, "0123456789");
  size_t length = flags + width, precision = 0;
  if (from[length] == '.') precision = 1 + strspn(from + length + 1, "0123456789");
  length += precision;
  if (flags > LONGEST_WIDTH || width > LONGEST_WIDTH || precision > LONGEST_WIDTH + 1) return NULL;
  memcpy(to, from, length);
  to[length] = 0;
  from += length;
  return *from == 'l' ? from + 1 : from;
}

// One conversion from behind its %; returns what follows it. d prints whole numbers of any size, and nan.
static const char *print_value(LsysRun *run, FILE *to, const char *from, double value) {
  char flags[4 * LONGEST_WIDTH], format[8 * LONGEST_WIDTH];
  const char *letter = copy_flags(from, flags);
  if (!letter) lsys_fail(run, "printf: the width in %%%.20s... is too big", from);
  bool whole = *letter == 'd' || *letter == 'i';
  if (whole) flags[strcspn(flags, ".")] = 0;
  snprintf(format, sizeof format, whole ? "%%%s.0f" : "%%%s%c", flags, *letter);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
  fprintf(to, format, whole ? trunc(value) : value);
#pragma GCC diagnostic pop
  return letter + 1;
}

void lsys_cut_short(LsysRun *run, uint32_t which) {
  if (!run->told || __atomic_fetch_or(run->told, 1u << which, __ATOMIC_RELAXED) & 1u << which) return;
  lsys_warning("the %s reached its maximum depth; what it left stays as it is (said once)",
               which ? "homomorphism" : "decomposition");
}

static void print(LsysRun *run, FILE *to, const char *format, const double *values, uint32_t count) {
  for (uint32_t used = 0; *format;) {
    if (*format == '%' && format[1] != '%' && used < count) {
      format = print_value(run, to, format + 1, values[used++]);
      continue;
    }
    if (*format == '%' && format[1] == '%') format++;
    fputc(*format++, to);
  }
}

char *lsys_print_text(LsysRun *run, const char *format, const double *values, uint32_t count) {
  char *text = NULL;
  size_t size;
  FILE *to = open_memstream(&text, &size);
  if (!to) return NULL;
  print(run, to, format, values, count);
  if (fclose(to) == 0) return text;
  free(text);
  return NULL;
}

void lsys_print(LsysRun *run, const char *format, const double *values, uint32_t count) {
  print(run, stderr, format, values, count);
}

void lsys_print_to(LsysRun *run, double file, const char *format, const double *values, uint32_t count) {
  print(run, lsys_files_at(run, file, "fprintf"), format, values, count);
}
