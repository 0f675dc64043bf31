// formats.c -- the table of formats, and how a name or a suffix picks one.
#include "core/formats.h"

#include "core/message.h"

#include <stdio.h>
#include <string.h>

const LsysFormat lsys_formats[] = {
#define FORMAT(name, suffixes, reads, create, options, doc) {name, suffixes, LSYS_READS_##reads, create, options, doc},
#include "core/formats.def"
};
const size_t lsys_format_count = sizeof lsys_formats / sizeof *lsys_formats;

enum { FORMATS = sizeof lsys_formats / sizeof *lsys_formats };

// True if word is one of the blank-separated words of list.
static bool listed(const char *list, const char *word) {
  size_t length = strlen(word);
  for (const char *at = list; length && (at = strstr(at, word)); at += length) {
    bool starts = at == list || at[-1] == ' ', ends = at[length] == 0 || at[length] == ' ';
    if (starts && ends) return true;
  }
  return false;
}

static const LsysFormat *by_name(const char *name) {
  const char *names[FORMATS];
  for (size_t i = 0; i < FORMATS; i++) {
    if (strcmp(lsys_formats[i].name, name) == 0 || listed(lsys_formats[i].suffixes, name)) return &lsys_formats[i];
    names[i] = lsys_formats[i].name;
  }
  const char *near = lsys_nearest(name, names, FORMATS);
  if (near)
    lsys_error("there is no format '%s'; did you mean '%s'?", name, near);
  else
    lsys_error("there is no format '%s'; --help formats lists them", name);
  return NULL;
}

const LsysFormat *lsys_format_find(const char *name, const char *path) {
  if (name) return by_name(name);
  if (strcmp(path, "-") == 0) return by_name("text");
  const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
  for (size_t i = 0; dot && i < FORMATS; i++)
    if (listed(lsys_formats[i].suffixes, dot + 1)) return &lsys_formats[i];
  if (!dot && strncmp(path, "/dev/", 5) == 0) return by_name("text");
  lsys_error("the suffix of '%s' names no format: give one with --format (--help formats lists them)", path);
  return NULL;
}

// ---- options of some formats -------------------------------------------------

void lsys_format_readers(LsysOption option, char *list, size_t size) {
  const char *names[FORMATS];
  size_t count = 0, used = 0;
  for (size_t i = 0; i < FORMATS; i++)
    if (listed(lsys_formats[i].options, lsys_options[option].name)) names[count++] = lsys_formats[i].name;
  *list = 0;
  for (size_t i = 0; i < count && used < size; i++)
    used += (size_t)snprintf(list + used, size - used, "%s%s", !i ? "" : i + 1 < count ? ", " : " and ", names[i]);
}

void lsys_format_tell_idle(const LsysFormat *format, const LsysOptions *options) {
  for (int i = 0; i < LSYS_OPTION_COUNT_; i++) {
    char readers[160];
    const char *name = lsys_options[i].name;
    if (!options->at[i].given || (format && listed(format->options, name))) continue;
    lsys_format_readers((LsysOption)i, readers, sizeof readers);
    if (*readers) lsys_warning("--%s changes nothing here: it is for %s", name, readers);
  }
}
