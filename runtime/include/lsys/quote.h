// quote.h -- texts in quotes, as they stand in grammars: quotes and backslashes
// with a backslash before them, `\n` and `\t` for line ends and tabs.
#ifndef LSYS_QUOTE_H
#define LSYS_QUOTE_H

#include <stddef.h>

// Bytes of the text in quotes.
size_t lsys_quoted_size(const char *text);

// Writes it and returns the end; writes no terminating zero.
char *lsys_quote(char *to, const char *text);

#endif
