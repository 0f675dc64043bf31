// text.c -- files, and what counts as equal.
#include "golden.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

char *text_read(Arena *arena, const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file) return NULL;
  VEC(char) text = {0};
  for (int c = getc(file); c != EOF; c = getc(file)) *VEC_PUSH(arena, &text) = (char)c;
  fclose(file);
  *VEC_PUSH(arena, &text) = '\0';
  return text.at;
}

bool text_write(const char *path, const char *text, size_t size) {
  FILE *file = fopen(path, "wb");
  if (!file) return false;
  bool done = fwrite(text, 1, size, file) == size;
  return fclose(file) == 0 && done;
}

// Compares the numbers at *a and *b and steps over them; false where they differ or only one is a number.
static bool same_number(const char **a, const char **b) {
  char *a_end, *b_end, a_text[32], b_text[32];
  double x = strtod(*a, &a_end), y = strtod(*b, &b_end);
  if (a_end == *a || b_end == *b) return false;
  *a = a_end;
  *b = b_end;
  snprintf(a_text, sizeof a_text, "%.9g", x + 0.0);
  snprintf(b_text, sizeof b_text, "%.9g", y + 0.0);
  return strcmp(a_text, b_text) == 0;
}

static bool starts_number(const char *c) {
  return isdigit((unsigned char)*c) || strchr("+-.", *c) || strncmp(c, "nan", 3) == 0 || strncmp(c, "inf", 3) == 0;
}

bool text_same_word(const char *a, const char *b) {
  for (int depth = 0;;) {
    while (isspace((unsigned char)*a)) a++;
    while (isspace((unsigned char)*b)) b++;
    if (!*a || !*b) return *a == *b;
    if (depth > 0 && starts_number(a) && starts_number(b)) {
      if (!same_number(&a, &b)) return false;
      continue;
    }
    if (*a != *b) return false;
    depth += *a == '(' ? 1 : *a == ')' ? -1 : 0;
    a++, b++;
  }
}

bool text_same_value(const char *a, const char *b) {
  while (*a && *b) {
    if (starts_number(a) && starts_number(b)) {
      const char *a_next = a, *b_next = b;
      if (same_number(&a_next, &b_next)) {
        a = a_next, b = b_next;
        continue;
      }
    }
    if (*a++ != *b++) return false;
  }
  return *a == *b;
}

static size_t line_length(const char *text) {
  return strcspn(text, "\n");
}

static const char *next_line(const char *text) {
  text += line_length(text);
  return *text ? text + 1 : text;
}

bool text_same_lines(const char *expected, const char *found, bool ellipsis) {
  for (; *expected; expected = next_line(expected), found = next_line(found)) {
    size_t length = line_length(expected);
    if (ellipsis && length == 3 && memcmp(expected, "...", 3) == 0) {
      const char *rest = next_line(expected);
      for (;; found = next_line(found)) {
        if (text_same_lines(rest, found, ellipsis)) return true;
        if (!*found) return false;
      }
    }
    if (!*found || line_length(found) != length || memcmp(expected, found, length) != 0) return false;
  }
  return !*found;
}

void text_report_difference(FILE *out, const char *expected, const char *found) {
  unsigned line = 1;
  while (*expected && *found && line_length(expected) == line_length(found)
         && memcmp(expected, found, line_length(found)) == 0) {
    expected = next_line(expected);
    found = next_line(found);
    line++;
  }
  fprintf(out, "    line %u\n    expected: %.*s\n    found:    %.*s\n", line, (int)line_length(expected), expected,
          (int)line_length(found), found);
}

void text_split(Arena *arena, Strings *words, const char *text) {
  for (text += strspn(text, " \t"); *text; text += strspn(text, " \t")) {
    size_t length = strcspn(text, " \t");
    *VEC_PUSH(arena, words) = arena_copy(arena, text, length);
    text += length;
  }
}
