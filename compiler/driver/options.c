// options.c -- argv -> Options. Knows no option by name: all come from options.def.
//
// `run` and `interp` share their command line with the program that they run:
// behind FILE, what lsysc does not know is the program's, and so are --help
// and --version; behind `--` everything is.
#include "driver/options.h"
#include "driver/report.h"

#include <ctype.h>
#include <string.h>
#include <sys/stat.h>

enum {
#define COMMAND(id, name, arguments, summary, doc) ON_##id = 1 << COMMAND_##id,
#include "driver/options.def"
  ON_CODE = ON_COMPILE | ON_RUN,
  ON_FILES = (1 << COMMAND_COUNT) - 1 - ON_HELP,
};

const CommandRow command_table[COMMAND_COUNT] = {
#define COMMAND(id, name, arguments, summary, doc) {name, arguments, summary, doc},
#include "driver/options.def"
};

const OptionRow option_table[OPTION_COUNT] = {
#define OPTION(id, spelling, how, value, commands, doc) {spelling, OPTION_##how, value, commands, doc},
#include "driver/options.def"
};

typedef struct Reader {
  Arena *arena;
  Options *options;
  Strings include_dirs, defines;
  char **at;  // the rest of argv, NULL at its end
} Reader;

// The place of value in a list "a|b|c", or -1.
static int place_in(const char *list, const char *value) {
  size_t length = strlen(value);
  for (int place = 0;; place++) {
    size_t item = strcspn(list, "|");
    if (item == length && memcmp(list, value, length) == 0) return place;
    if (!list[item]) return -1;
    list += item + 1;
  }
}

// option: as it was given. A second one may only repeat what the first one said.
static bool set_emit(Options *options, const char *option, int place) {
  static const EmitKind kinds[] = {EMIT_OBJECT, EMIT_OBJECT, EMIT_ASSEMBLY, EMIT_LLVM, EMIT_BITCODE};
  bool program = place == 0;
  if (options->emit_given && (options->program != program || options->backend.emit != kinds[place]))
    return report_error("`%s` and `%s` ask for different files; lsysc writes one at a time", options->emit_given,
                        option);
  options->emit_given = option;
  options->program = program;
  options->backend.emit = kinds[place];
  return true;
}

// Options behind the grammar of `run` and `interp` are the program's, too.
static bool runs_file(const Options *options) {
  return options->files.count > 0 && (options->command == COMMAND_RUN || options->command == COMMAND_INTERP);
}

// A name of C, alone or with `=` behind it.
static bool is_definition(const char *text) {
  const char *names = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  size_t length = strspn(text, names);
  if (length > 0)
    while (text[length] && (strchr(names, text[length]) || (text[length] >= '0' && text[length] <= '9'))) length++;
  return length > 0 && (!text[length] || text[length] == '=') && !strchr(text, '\n');
}

// Where a value that is kept as it is given goes; NULL: it is not.
static const char **text_of(Options *options, OptionId id) {
  switch (id) {
  case OPTION_OUTPUT:
    return &options->output;
  case OPTION_TARGET:
    return &options->backend.target;
  case OPTION_MARCH:
    return &options->backend.cpu;
  case OPTION_LINKER:
    return &options->linker;
  case OPTION_DIALECT:
    return &options->parse.dialect;
  case OPTION_VIEW:
    return &options->parse.view;
  case OPTION_SYSTEM:
    return &options->parse.system;
  default:
    return NULL;
  }
}

// What an option sets by being there; NULL: it does something else.
static bool *flag_of(Options *options, OptionId id) {
  switch (id) {
  case OPTION_DEBUG:
    return &options->backend.debug;
  case OPTION_LIST_SYSTEMS:
    return &options->list_systems;
  case OPTION_NO_WARNINGS:
    return &options->diag.no_warnings;
  case OPTION_VERBOSE:
    return &options->verbose;
  case OPTION_TIMES:
    return &options->times;
  case OPTION_HELP:
    return &options->help;
  case OPTION_VERSION:
    return &options->version;
  default:
    return NULL;
  }
}

// place: of value in the option's list of accepted values; 0 for options without such a list.
static bool apply_other(Reader *reader, OptionId id, const char *value, int place) {
  Options *options = reader->options;
  switch (id) {
  case OPTION_OPTIMISE:
    options->backend.optimise = (unsigned)place;
    options->optimise_given = true;
    break;
  case OPTION_OBJECT:
    return set_emit(options, "-c", 1);
  case OPTION_ASSEMBLY:
    return set_emit(options, "-S", 2);
  case OPTION_EMIT:
    return set_emit(options, arena_printf(reader->arena, "--emit=%s", value), place);
  case OPTION_INCLUDE:
    *VEC_PUSH(reader->arena, &reader->include_dirs) = value;
    break;
  case OPTION_DEFINE:
    if (!is_definition(value)) return report_error("`-D` takes NAME=VALUE, not `%s`", value);
    *VEC_PUSH(reader->arena, runs_file(options) ? &options->given : &reader->defines) = value;
    break;
  case OPTION_DUMP:
    options->dump = (Dump)(place + 1);
    break;
  case OPTION_WARNING:
    return diag_option(&options->diag, value)
        || report_error("unknown warning `-W%s`; `lsysc help warnings` lists them", value);
  case OPTION_COLOUR:
    options->diag.colour = (ColourMode)place;
    break;
  default:  // --to has one value, which is what happens without it, too
    break;
  }
  return true;
}

static bool apply(Reader *reader, OptionId id, const char *value, int place) {
  const char **text = text_of(reader->options, id);
  bool *flag = flag_of(reader->options, id);
  if (text)
    *text = value;
  else if (flag)
    *flag = true;
  else
    return apply_other(reader, id, value, place);
  return true;
}

// Whether argument is the option, and what stands behind it in the same argument (NULL: nothing can).
static bool matches(const OptionRow *row, const char *argument, const char **rest) {
  size_t length = strlen(row->spelling);
  if (strncmp(argument, row->spelling, length) != 0) return false;
  const char *behind = argument + length;
  *rest = *behind ? behind : NULL;
  switch (row->how) {
  case OPTION_FLAG:
    return !*behind;
  case OPTION_JOINED:
    *rest = behind;
    return true;
  case OPTION_SPACED:
    return true;
  case OPTION_EQUALS:
    *rest = *behind == '=' ? behind + 1 : NULL;
    return !*behind || *behind == '=';
  }
  return false;
}

static bool take_option(Reader *reader, OptionId id, const char *value) {
  const OptionRow *row = &option_table[id];
  if (row->how == OPTION_FLAG) return apply(reader, id, NULL, 0);
  if (!value && *reader->at) value = *reader->at++;
  if (!value || !*value) return report_error("`%s` needs a value: %s", row->spelling, row->value);
  int place = !isupper((unsigned char)row->value[0]) ? place_in(row->value, value) : 0;
  if (place < 0) return report_error("`%s` takes %s, not `%s`", row->spelling, row->value, value);
  return apply(reader, id, value, place);
}

static bool unknown(const Reader *reader, const char *argument) {
  const char *names[OPTION_COUNT];
  for (int i = 0; i < OPTION_COUNT; i++) names[i] = option_table[i].spelling;
  const char *name = arena_copy(reader->arena, argument, strcspn(argument, "="));
  const char *nearest = strlen(name) > 3 ? diag_nearest(name, names, OPTION_COUNT) : NULL;
  if (nearest) return report_error("unknown option `%s`; did you mean `%s`?", name, nearest);
  Command command = reader->options->command;
  if (command == COMMAND_RUN || command == COMMAND_INTERP)
    return report_error("unknown option `%s`; options of the program go behind the grammar: lsysc %s plant.lsys %s",
                        argument, command_table[command].name, argument);
  if (command == COMMAND_COMPILE)
    return report_error("unknown option `%s`; options such as -n are the program's: lsysc run plant.lsys -n 8",
                        argument);
  return report_error("unknown option `%s`; see `lsysc help`", argument);
}

static bool take_argument(Reader *reader, const char *argument) {
  Options *options = reader->options;
  bool behind_file = runs_file(options);
  if (strcmp(argument, "-h") == 0) argument = option_table[OPTION_HELP].spelling;
  if (argument[0] == '-' && argument[1]) {
    for (int id = 0; id < OPTION_COUNT; id++) {
      const char *value;
      if (!matches(&option_table[id], argument, &value)) continue;
      if (behind_file && (id == OPTION_HELP || id == OPTION_VERSION)) continue;
      if (option_table[id].commands & (1u << options->command)) return take_option(reader, (OptionId)id, value);
      if (!behind_file)
        return report_error("`lsysc %s` does not take `%s`; see `lsysc help %s`", command_table[options->command].name,
                            argument, command_table[options->command].name);
    }
    if (!behind_file) return unknown(reader, argument);
  }
  if (behind_file)
    *VEC_PUSH(reader->arena, &options->passed) = argument;
  else
    *VEC_PUSH(reader->arena, &options->files) = argument;
  return true;
}

static bool take_rest(Reader *reader) {
  Options *options = reader->options;
  for (; *reader->at; reader->at++)
    if (runs_file(options))
      *VEC_PUSH(reader->arena, &options->passed) = *reader->at;
    else
      *VEC_PUSH(reader->arena, &options->files) = *reader->at;
  return true;
}

// A word that is no file's name was hardly meant as one: `lsysc chek plant.lsys`.
static bool is_command_like(const char *word) {
  struct stat info;
  return !strpbrk(word, "./") && strcmp(word, "-") != 0 && stat(word, &info) != 0;
}

static bool unknown_command(Arena *arena, const char *word) {
  struct stat info;
  const char *file = arena_printf(arena, "%s.lsys", word);
  if (stat(file, &info) == 0) return report_error("there is no file `%s`; did you mean `%s`?", word, file);
  const char *names[COMMAND_COUNT];
  for (int i = 1; i < COMMAND_COUNT; i++) names[i - 1] = command_table[i].name;
  const char *nearest = diag_nearest(word, names, COMMAND_COUNT - 1);
  if (nearest) return report_error("unknown command `%s`; did you mean `%s`?", word, nearest);
  return report_error("`%s` is no command and no file; `lsysc help` lists the commands", word);
}

static bool complete(Arena *arena, const Options *options) {
  size_t files = options->files.count;
  if (options->help || options->version || options->command == COMMAND_HELP) return true;
  if (files == 0) return report_error("no grammar was given: lsysc %s", command_table[options->command].arguments);
  if (options->command == COMMAND_COMPILE && is_command_like(options->files.at[0]))
    return unknown_command(arena, options->files.at[0]);
  const char *cpu = options->backend.cpu;
  if (options->command == COMMAND_RUN && cpu && strcmp(cpu, "native") != 0)
    return report_error("`run` generates code for the processor here, not for `%s`; "
                        "compile a program for that one: lsysc %s -march=%s",
                        cpu, options->files.at[0], cpu);
  if (files > 1 && options->command != COMMAND_CHECK)
    return report_error("one grammar at a time, not `%s` and `%s`", options->files.at[0], options->files.at[1]);
  return true;
}

bool options_parse(Arena *arena, int argc, char **argv, Options *options) {
  *options = (Options){.program = true, .linker = "cc", .backend = {.emit = EMIT_OBJECT, .optimise = 2}};
  options->backend.symbol = "lsys_grammar";
  diag_options_default(&options->diag);
  Reader reader = {.arena = arena, .options = options, .at = argv + 1};
  for (int id = 1; id < COMMAND_COUNT && argc > 1; id++)
    if (strcmp(argv[1], command_table[id].name) == 0) {
      options->command = (Command)id;
      reader.at++;
    }
  while (*reader.at) {
    const char *argument = *reader.at++;
    if (strcmp(argument, "--") == 0) {
      take_rest(&reader);
      break;
    }
    if (!take_argument(&reader, argument)) return false;
  }
  options->parse.include_dirs = reader.include_dirs.at;
  options->parse.include_count = reader.include_dirs.count;
  options->parse.defines = reader.defines.at;
  options->parse.define_count = reader.defines.count;
  options->parse.given = options->given.at;
  options->parse.given_count = options->given.count;
  return complete(arena, options);
}

void options_head(const OptionRow *option, char *head, size_t size) {
  const char *value = option->value ? option->value : "";
  const char *between = option->how == OPTION_EQUALS ? "=" : option->how == OPTION_SPACED ? " " : "";
  snprintf(head, size, "%s%s%s", option->spelling, between, value);
}
