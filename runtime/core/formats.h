// formats.h -- the formats as a table (formats.def), and how a format's sink is made.
#ifndef LSYS_CORE_FORMATS_H
#define LSYS_CORE_FORMATS_H

#include "core/memory.h"
#include "core/options.h"
#include "core/out.h"
#include "sinks/sink.h"

// What a sink may use; all of it outlives the sink, which does not commit the output.
typedef struct LsysSinkContext {
  const LsysGrammar *grammar;
  const LsysOptions *options;
  LsysMemory *memory;
  LsysOut *out;
  struct LsysFilm *film;  // the picture is one of several; NULL: it is alone
} LsysSinkContext;

// NULL after printing why not.
typedef LsysSink *LsysSinkCreate(const LsysSinkContext *context);

typedef enum LsysReads { LSYS_READS_WORD, LSYS_READS_FIGURE } LsysReads;

typedef struct LsysFormat {
  const char *name, *suffixes;
  LsysReads reads;
  LsysSinkCreate *create;
  const char *options;  // that only some formats read: their names, separated by blanks
  const char *doc;
} LsysFormat;

extern const LsysFormat lsys_formats[];
extern const size_t lsys_format_count;

#define FORMAT(name, suffixes, reads, create, options, doc) LsysSinkCreate create;
#include "core/formats.def"
LsysSinkCreate lsys_sink_stats;  // --stats

// The format called name, or (name NULL) the one of path's suffix, or text for "-"; NULL after printing what there is.
const LsysFormat *lsys_format_find(const char *name, const char *path);

// The formats that read an option as a list, "svg, pdf and png"; empty if the option is not for some formats only. It
// is cut to fit.
void lsys_format_readers(LsysOption option, char *list, size_t size);

// Warns of options that other formats read, but not this one (NULL: nothing but reports is written).
void lsys_format_tell_idle(const LsysFormat *format, const LsysOptions *options);

#endif
