// options.c -- argv -> LsysOptions, by the table options.def.
// Accepts -n 8, -n8, --steps 8, --steps=8; -- has no meaning: there are no operands.
#include "core/options.h"

#include "core/message.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const LsysOptionInfo lsys_options[LSYS_OPTION_COUNT_] = {
#define OPTION(id, letter, name, argument, type, doc)                                                                  \
  [LSYS_OPTION_##id] = {LSYS_OPTION_##id, letter, name, argument, LSYS_OPTION_##type, doc},
#include "core/options.def"
};

static bool parse_whole(const char *text, uint64_t *value, const char **end) {
  if (*text < '0' || *text > '9') return false;
  char *stop;
  errno = 0;
  *value = strtoull(text, &stop, 10);
  *end = stop;
  return errno == 0;
}

// A whole number with K, M, G or T (powers of 1024) behind it.
static bool parse_size(const char *text, uint64_t *value) {
  const char *end;
  if (!parse_whole(text, value, &end)) return false;
  if (!*end) return true;
  const char *units = "KMGT", *unit = strchr(units, *end & ~0x20);
  if (!unit || end[1]) return false;
  return !__builtin_mul_overflow(*value, UINT64_C(1) << (10 * (unit - units + 1)), value);
}

// Stores an option's argument; false after printing what was wanted.
static bool store(LsysOptions *options, const LsysOptionInfo *info, const char *text) {
  LsysOptionValue *value = &options->at[info->option];
  const char *end = "", *wanted = NULL;
  char *stop;
  value->given = true;
  value->text = text;
  if (!text) return true;
  switch (info->type) {
  case LSYS_OPTION_WHOLE:
    if (!parse_whole(text, &value->whole, &end) || *end) wanted = "a whole number from 0 to 18446744073709551615";
    break;
  case LSYS_OPTION_SIZE:
    if (!parse_size(text, &value->whole)) wanted = "a number of bytes such as 512M or 2G";
    break;
  case LSYS_OPTION_REAL:
    value->real = strtod(text, &stop);
    if (stop == text || *stop) wanted = "a number";
    break;
  case LSYS_OPTION_DEFINITION:
    if (!strchr(text, '=')) wanted = "NAME=VALUE";
    options->definitions[options->definition_count++] = text;
    break;
  case LSYS_OPTION_FLAG:
  case LSYS_OPTION_TEXT:
  case LSYS_OPTION_SUBJECT:
    break;
  }
  if (!wanted) return true;
  lsys_error("--%s wants %s, not '%s'", info->name, wanted, text);
  return false;
}

static void unknown(const char *argument) {
  const char *names[LSYS_OPTION_COUNT_];
  for (int i = 0; i < LSYS_OPTION_COUNT_; i++) names[i] = lsys_options[i].name;
  char name[64];
  snprintf(name, sizeof name, "%.*s", (int)strcspn(argument + 2, "="), argument + 2);
  const char *near = lsys_nearest(name, names, LSYS_OPTION_COUNT_);
  if (near)
    lsys_error("unknown option --%s; did you mean --%s?", name, near);
  else
    lsys_error("unknown option --%s; --help lists them", name);
}

// Finds argument in the table; *attached is the text that follows it in the same argument, or NULL.
static const LsysOptionInfo *find(const char *argument, const char **attached) {
  *attached = NULL;
  if (argument[0] != '-' || !argument[1]) return NULL;
  bool is_long = argument[1] == '-';
  for (int i = 0; i < LSYS_OPTION_COUNT_; i++) {
    const LsysOptionInfo *info = &lsys_options[i];
    size_t length = is_long ? strlen(info->name) : 0;
    if (!is_long && info->letter != argument[1]) continue;
    if (is_long && (strncmp(argument + 2, info->name, length) != 0 || (argument[2 + length] & ~'='))) continue;
    const char *rest = argument + 2 + length;
    if (*rest) *attached = is_long ? rest + 1 : rest;
    return info;
  }
  return NULL;
}

static void not_found(const char *argument) {
  if (argument[0] != '-' || !argument[1])
    lsys_error("'%s' is not an option; %s", argument,
               argument[0] && !argument[strspn(argument, "0123456789")] ? "the number of steps is given with -n"
                                                                        : "a file is named with -o");
  else if (argument[1] == '-')
    unknown(argument);
  else
    lsys_error("unknown option %.2s; --help lists the options", argument);
}

// The option that argv[*i] names, *i then being the last argument that belongs to it; NULL if it names none.
static const LsysOptionInfo *next(int argc, char **argv, int *i, const char **text) {
  const LsysOptionInfo *info = find(argv[*i], text);
  if (!info) return NULL;
  bool optional = info->type == LSYS_OPTION_SUBJECT;
  if (info->argument && !*text && *i + 1 < argc && !(optional && argv[*i + 1][0] == '-')) *text = argv[++*i];
  return info;
}

bool lsys_options_parse(LsysOptions *options, int argc, char **argv) {
  *options = (LsysOptions){.definitions = calloc((size_t)argc + 1, sizeof *options->definitions)};
  if (!options->definitions) {
    lsys_error("out of memory");
    return false;
  }
  for (int i = 0; i < argc; i++) {
    const char *text, *argument = argv[i];
    const LsysOptionInfo *info = next(argc, argv, &i, &text);
    if (!info) {
      not_found(argument);
      return false;
    }
    if (!info->argument && text) {
      lsys_error("%s: --%s takes no argument", argument, info->name);
      return false;
    }
    if (info->argument && !text && info->type != LSYS_OPTION_SUBJECT) {
      lsys_error("%s wants %s behind it", argument, info->argument);
      return false;
    }
    if (!store(options, info, text)) return false;
  }
  return true;
}

bool lsys_steps_asked(int argc, char **argv, uint64_t *steps) {
  bool asked = false;
  for (int i = 0; i < argc; i++) {
    const char *text, *end;
    const LsysOptionInfo *info = next(argc, argv, &i, &text);
    if (info && info->option == LSYS_OPTION_STEPS && text) asked = parse_whole(text, steps, &end);
  }
  return asked;
}

void lsys_options_free(LsysOptions *options) {
  free(options->definitions);
  options->definitions = NULL;
}
