// quote.c -- see lsys/quote.h.
#include "lsys/quote.h"

// What stands behind the backslash; 0: none is needed.
static char escape(char c) {
  switch (c) {
  case '\n':
    return 'n';
  case '\t':
    return 't';
  case '"':
  case '\\':
    return c;
  default:
    return 0;
  }
}

size_t lsys_quoted_size(const char *text) {
  size_t size = 2;
  for (; *text; text++) size += escape(*text) ? 2 : 1;
  return size;
}

char *lsys_quote(char *to, const char *text) {
  *to++ = '"';
  for (; *text; text++) {
    char letter = escape(*text);
    if (letter) *to++ = '\\';
    *to++ = letter ? letter : *text;
  }
  *to++ = '"';
  return to;
}
