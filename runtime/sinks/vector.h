// vector.h -- what the vector formats (SVG, PDF) share: a canvas that cuts strokes into inks and paths, counts places
// in whole parts of a pixel, and has a format put them into words.
#ifndef LSYS_SINKS_VECTOR_H
#define LSYS_SINKS_VECTOR_H

#include "core/out.h"
#include "sinks/picture.h"

enum {
  LSYS_VECTOR_NUMBER = 24,     // characters that a coordinate takes at most
  LSYS_VECTOR_TEXT = 1 << 14,  // characters kept until they are written
};

typedef struct LsysVector LsysVector;

// How a format says things. Text that is always the same stands here; move and step write at most
// 2 * LSYS_VECTOR_NUMBER + 8 characters and return their end; the others use lsys_vector_print. ink, fill, move and
// step are called on any thread, with a vector that is nothing but an LsysVector.
typedef struct LsysVectorFormat {
  bool (*open)(LsysVector *vector, const LsysPage *page);
  void (*ink)(LsysVector *vector, const LsysInk *ink);  // of the strokes up to end_ink
  const char *end_ink;
  const char *begin_path, *end_path;
  void (*fill)(LsysVector *vector, uint32_t rgb);  // of the one polygon up to end_fill
  const char *end_fill;
  char *(*move)(const LsysVector *vector, char *to, int64_t x, int64_t y);  // vector->path: a path is open already
  char *(*step)(const LsysVector *vector, char *to, int64_t x, int64_t y);  // from vector->x, vector->y
  bool (*close)(LsysVector *vector);                                        // all text is written
  // May be NULL: appends to `to`, on any thread, what becomes of a piece of text before it is written.
  bool (*pack)(const void *text, size_t size, LsysPrepared *to);
  bool (*write)(LsysVector *vector, const void *bytes, size_t size);  // one piece, packed if there is `pack`
} LsysVectorFormat;

struct LsysVector {
  LsysCanvas canvas;
  const LsysVectorFormat *format;
  LsysOut *out;
  int decimals;  // of a coordinate in pixels, 2 to 4
  double parts;  // of a pixel: 10^decimals
  int64_t x, y;  // the last point written, in parts
  LsysInk ink;   // of the open group of strokes
  bool group, path;
  struct LsysPress *press;  // makes text of what is drawn
  uint32_t segments;        // and corners, in its block
  LsysPrepared *to;         // where text goes; NULL: to the output
  bool failed;              // after a message
  size_t filled;
  char text[LSYS_VECTOR_TEXT];
};

// A sink that draws to a format's own LsysVector, from calloc, which it takes over; NULL: memory ran out. NULL after
// printing why.
LsysSink *lsys_vector_create(LsysVector *vector, const LsysVectorFormat *format, LsysOut *out,
                             const LsysPictureOptions *options);

// Appends text of at most 1000 characters. False after an error now or before.
bool lsys_vector_print(LsysVector *vector, const char *format, ...) __attribute__((format(printf, 2, 3)));

// Writes parts without trailing zeros, "-12.5", and returns the end.
char *lsys_vector_number(const LsysVector *vector, char *to, int64_t parts);

#endif
