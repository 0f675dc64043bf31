// source.c -- files in one space of offsets; lines are found by counting when
// a message needs them.
#include "support/source.h"

#include "support/utf8.h"
#include "support/vec.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

struct Sources {
  Arena *arena;
  VEC(SourceFile *) files;  // by base
  uint32_t next;            // base of the next file; offset 0 is nowhere
};

enum { MOST_BYTES = INT32_MAX };

Sources *sources_create(Arena *arena) {
  Sources *sources = ARENA_NEW(arena, Sources);
  sources->arena = arena;
  sources->next = 1;
  return sources;
}

const SourceFile *sources_add(Sources *sources, const char *path, const char *text, size_t length, Span included_from) {
  if (length >= MOST_BYTES - sources->next) return NULL;
  SourceFile *file = ARENA_NEW(sources->arena, SourceFile);
  *file = (SourceFile){path, text, length, sources->next, included_from, NULL, 0};
  *VEC_PUSH(sources->arena, &sources->files) = file;
  sources->next += (uint32_t)length + 1;  // the end of a file is a place of its own
  return file;
}

const SourceFile *sources_add_made(Sources *sources, const char *text, size_t length, const Origin *origins,
                                   size_t count) {
  const SourceFile *from = sources_file(sources, origins->from.begin);
  const SourceFile *file = sources_add(sources, from->path, text, length, from->included_from);
  if (!file) return NULL;
  SourceFile *made = sources->files.at[sources->files.count - 1];
  made->origins = origins;
  made->origin_count = count;
  return file;
}

// All bytes of a stream and a NUL; NULL with *why set when reading fails, or it is a compiled grammar, a picture, a
// device that never ends.
static char *slurp(Arena *arena, FILE *in, size_t *length, const char **why) {
  VEC(char) bytes = {0};
  char buffer[1 << 16];
  size_t got;
  while ((got = fread(buffer, 1, sizeof buffer, in)) > 0) {
    if (!bytes.count && memchr(buffer, '\0', got < 64 ? got : 64)) {  // a page of messages helps nobody
      *why = "this is no text; a grammar's name usually ends in .lsys";
      return NULL;
    }
    if (bytes.count + got >= MOST_BYTES) {
      *why = "is larger than 2 GiB";
      return NULL;
    }
    while (bytes.capacity - bytes.count <= got) bytes.at = vec_grow(arena, bytes.at, bytes.count, &bytes.capacity, 1);
    memcpy(bytes.at + bytes.count, buffer, got);
    bytes.count += got;
  }
  if (ferror(in)) {
    *why = strerror(errno);
    return NULL;
  }
  *length = bytes.count;
  return arena_copy(arena, bytes.at, bytes.count);
}

const SourceFile *sources_read(Sources *sources, const char *path, Span included_from, const char **why) {
  bool standard = strcmp(path, "-") == 0;
  struct stat info;
  if (!standard && stat(path, &info) == 0 && S_ISDIR(info.st_mode)) {
    *why = "is a directory";
    return NULL;
  }
  FILE *in = standard ? stdin : fopen(path, "rb");
  if (!in) {
    *why = errno == ENOENT ? "no such file" : strerror(errno);
    return NULL;
  }
  size_t length = 0;
  char *text = slurp(sources->arena, in, &length, why);
  if (!standard) fclose(in);
  if (!text) return NULL;
  path = arena_copy(sources->arena, standard ? "<stdin>" : path, standard ? 7 : strlen(path));
  const SourceFile *file = sources_add(sources, path, text, length, included_from);
  if (!file) *why = "is too large together with the other files";
  return file;
}

const SourceFile *sources_file(const Sources *sources, uint32_t offset) {
  size_t low = 0, high = sources->files.count;  // the last file that begins at or before offset
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (sources->files.at[middle]->base <= offset)
      low = middle + 1;
    else
      high = middle;
  }
  return offset && low ? sources->files.at[low - 1] : NULL;
}

// The stretch that a place of a made text lies in.
static const Origin *origin_at(const SourceFile *file, uint32_t offset) {
  size_t low = 0, high = file->origin_count;  // the last that begins at or before the place
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (file->origins[middle].at <= offset - file->base)
      low = middle + 1;
    else
      high = middle;
  }
  return &file->origins[low ? low - 1 : 0];
}

Span sources_origin(const Sources *sources, Span span, Span *macro) {
  if (macro) *macro = (Span){0, 0};
  for (const SourceFile *file; (file = sources_file(sources, span.begin)) != NULL && file->origins;) {
    const Origin *first = origin_at(file, span.begin);
    const Origin *last = origin_at(file, span.end > span.begin ? span.end - 1 : span.begin);
    uint32_t begin = first->from.begin, end = last->from.end;
    if (first->macro.end == 0) begin += span.begin - file->base - first->at;
    if (last->macro.end == 0) end = last->from.begin + (span.end - file->base - last->at);
    if (macro && first->macro.end) *macro = first->macro;
    span = (Span){begin, end > begin ? end : begin};
  }
  return span;
}

Place sources_place(const Sources *sources, uint32_t offset) {
  offset = sources_origin(sources, (Span){offset, offset}, NULL).begin;
  Place place = {sources_file(sources, offset), 1, 1};
  if (!place.file) return place;
  const char *text = place.file->text, *end = text + (offset - place.file->base), *line = text;
  for (const char *next; (next = memchr(line, '\n', (size_t)(end - line))) != NULL; line = next + 1) place.line++;
  for (size_t length; line < end; line += length ? length : 1) {
    length = utf8_length(line, end);  // a byte that is no UTF-8 is a column of its own
    place.column++;
  }
  return place;
}
