// source.h -- the texts of one compilation in one space of byte offsets.
//
// Every file (the main one, each inclusion, the command line's -D texts) gets
// a range of offsets of its own, so that a place is one number and a Span two,
// and includes need no special case. Line and column are worked out when a
// message is printed.
#ifndef LSYSC_SUPPORT_SOURCE_H
#define LSYSC_SUPPORT_SOURCE_H

#include "support/arena.h"

#include <stdbool.h>

// A half-open range of global byte offsets. {0,0} is "nowhere".
typedef struct Span {
  uint32_t begin, end;
} Span;

typedef struct SourceFile {
  const char *path;  // as opened, for messages
  const char *text;  // length bytes and a NUL
  size_t length;
  uint32_t base;       // global offset of text[0]
  Span included_from;  // the #include's place; nowhere for the main file
} SourceFile;

typedef struct Sources Sources;

Sources *sources_create(Arena *arena);

// Takes text (not copied) as a new file. All texts together must stay below
// 2 GiB: NULL when they would not.
const SourceFile *sources_add(Sources *sources, const char *path, const char *text, size_t length, Span included_from);

// Reads a file, or standard input for "-", whole. On failure returns NULL and sets *why to a
// phrase such as "no such file or directory" or "is a directory".
const SourceFile *sources_read(Sources *sources, const char *path, Span included_from, const char **why);

// The file that holds an offset, NULL for nowhere.
const SourceFile *sources_file(const Sources *sources, uint32_t offset);

// Line and column, both from 1; the column counts code points.
typedef struct Place {
  const SourceFile *file;
  uint32_t line, column;
} Place;
Place sources_place(const Sources *sources, uint32_t offset);

static inline Span span_join(Span a, Span b) {
  if (a.end == 0) return b;
  if (b.end == 0) return a;
  return (Span){a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

#endif
