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

// A stretch of a text that was made from another one: from `at` up to the next
// stretch. Copied byte for byte from `from` on if `macro` is nowhere; else all
// of it stands for the use `from` of the macro whose definition is `macro`.
typedef struct Origin {
  uint32_t at;
  Span from, macro;
} Origin;

typedef struct SourceFile {
  const char *path;  // as opened, for messages
  const char *text;  // length bytes and a NUL
  size_t length;
  uint32_t base;          // global offset of text[0]
  Span included_from;     // the #include's place; nowhere for the main file
  const Origin *origins;  // of a text with macros replaced, the first at 0; NULL: what the user wrote
  size_t origin_count;
} SourceFile;

typedef struct Sources Sources;

Sources *sources_create(Arena *arena);

// Takes text (not copied) as a new file. All texts together must stay below
// 2 GiB: NULL when they would not.
const SourceFile *sources_add(Sources *sources, const char *path, const char *text, size_t length, Span included_from);

// A text made from stretches of others, of which it must have one at least (taken, not copied).
const SourceFile *sources_add_made(Sources *sources, const char *text, size_t length, const Origin *origins,
                                   size_t count);

// Reads a file, or standard input for "-", whole. On failure returns NULL and sets *why to a
// phrase such as "no such file or directory" or "is a directory".
const SourceFile *sources_read(Sources *sources, const char *path, Span included_from, const char **why);

// The file that holds an offset, NULL for nowhere.
const SourceFile *sources_file(const Sources *sources, uint32_t offset);

// What the user wrote where span is; *macro is the definition of the macro that
// it comes from, or nowhere. macro may be NULL.
Span sources_origin(const Sources *sources, Span span, Span *macro);

// Line and column of what the user wrote, both from 1; the column counts code points.
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
