// utf8.h -- the little that a scanner must know about UTF-8.
#ifndef LSYSC_SUPPORT_UTF8_H
#define LSYSC_SUPPORT_UTF8_H

#include <stddef.h>
#include <string.h>

// Bytes of the well-formed sequence at `at` (Unicode 15, table 3-7), 0 if none stands there.
static inline size_t utf8_length(const char *at, const char *end) {
  const unsigned char *u = (const unsigned char *)at;
  size_t left = (size_t)(end - at);
  if (left == 0) return 0;
  if (u[0] < 0x80) return 1;
  size_t length = u[0] >= 0xF0 ? 4 : u[0] >= 0xE0 ? 3 : 2;
  if (u[0] < 0xC2 || u[0] > 0xF4 || left < length) return 0;
  unsigned low = u[0] == 0xE0 ? 0xA0 : u[0] == 0xF0 ? 0x90 : 0x80;
  unsigned high = u[0] == 0xED ? 0x9F : u[0] == 0xF4 ? 0x8F : 0xBF;
  if (u[1] < low || u[1] > high) return 0;
  for (size_t i = 2; i < length; i++)
    if ((u[i] & 0xC0) != 0x80) return 0;
  return length;
}

// Length of `text` if [at, end) begins with it, else 0.
static inline size_t utf8_starts(const char *at, const char *end, const char *text) {
  size_t length = strlen(text);
  return (size_t)(end - at) >= length && memcmp(at, text, length) == 0 ? length : 0;
}

// Length of the white space other than a line's end at `at`: ASCII's, and the
// blanks that come along when text is copied from a page; 0 if there is none.
static inline size_t utf8_blank(const char *at, const char *end) {
  static const char *const blanks[] = {"\u00A0", "\u1680", "\u2000", "\u2001", "\u2002", "\u2003", "\u2004",
                                       "\u2005", "\u2006", "\u2007", "\u2008", "\u2009", "\u200A", "\u200B",
                                       "\u2028", "\u2029", "\u202F", "\u205F", "\u3000", "\uFEFF"};
  if (at == end) return 0;
  if (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\v' || *at == '\f') return 1;
  if ((unsigned char)*at < 0x80) return 0;
  for (size_t i = 0; i < sizeof blanks / sizeof *blanks; i++)
    if (utf8_starts(at, end, blanks[i])) return strlen(blanks[i]);
  return 0;
}

#endif
