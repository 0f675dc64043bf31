// completions.c -- scripts that let bash, zsh and fish complete lsysc's command line.
// In: options.def, warnings.def, the run time's options and formats, the topics of help.
// The build installs what `lsysc help bash` and its like print.
#include "driver/help.h"
#include "driver/manual.h"
#include "lsys/help.h"

#include <ctype.h>
#include <string.h>

// An option of lsysc, or of the programs that `run` and `interp` pass it on to.
typedef struct Candidate {
  const char *spelling;  // with its dashes
  OptionHow how;
  const char *value;  // NULL: none; a list a|b|c; or what it is called
  unsigned commands;
  const char *doc;
} Candidate;

enum { CANDIDATES = OPTION_COUNT + 100, NAMES = 4096 };

typedef struct Candidates {
  Candidate at[CANDIDATES];
  int count;
  char names[NAMES];  // spellings of the program's options
  size_t used;
} Candidates;

static const unsigned on_programs = 1u << COMMAND_RUN | 1u << COMMAND_INTERP;

static bool has(const Candidates *all, const char *spelling, unsigned commands) {
  for (int i = 0; i < all->count; i++)
    if (strcmp(all->at[i].spelling, spelling) == 0 && (all->at[i].commands & commands) == commands) return true;
  return false;
}

static void add_passed(Candidates *all, const char *dashes, const char *name, const LsysHelpOption *option) {
  char *spelling = all->names + all->used;
  size_t size = (size_t)snprintf(spelling, NAMES - all->used, "%s%s", dashes, name) + 1;
  if (all->count == CANDIDATES || size > NAMES - all->used || has(all, spelling, on_programs)) return;
  all->used += size;
  bool flag = !option->argument || strcmp(option->argument, "SUBJECT") == 0;
  all->at[all->count++] =
    (Candidate){spelling, flag ? OPTION_FLAG : OPTION_SPACED, flag ? NULL : option->argument, on_programs, option->doc};
}

static void collect(Candidates *all) {
  all->count = 0;
  all->used = 0;
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *row = &option_table[i];
    all->at[all->count++] = (Candidate){row->spelling, row->how, row->value, row->commands, row->doc};
  }
  LsysHelpOption option;
  for (int i = 0; lsys_help_option(i, &option); i++) {
    add_passed(all, "--", option.name, &option);
    if (option.letter) add_passed(all, "-", (char[]){option.letter, '\0'}, &option);
  }
}

static bool is_list(const Candidate *option) {
  return option->value && (!isupper((unsigned char)option->value[0]) || strcmp(option->value, "FORMAT") == 0);
}

static bool takes_file(const Candidate *option) {
  if (!option->value) return false;
  return strcmp(option->value, "FILE") == 0 || strcmp(option->value, "FOLDER") == 0
      || strcmp(option->spelling, "-o") == 0;
}

// The value is an argument of its own, or may be one.
static bool takes_next(const Candidate *option) {
  return option->how == OPTION_SPACED || option->how == OPTION_EQUALS;
}

// What the value may be, with blanks between.
static void choices(FILE *out, const Candidate *option) {
  if (strcmp(option->value, "FORMAT") == 0)
    for (int i = 0; lsys_help_format(i); i++) fprintf(out, "%s%s", i ? " " : "", lsys_help_format(i));
  else
    for (const char *c = option->value; *c; c++) fputc(*c == '|' ? ' ' : *c, out);
}

static void warning_names(FILE *out, const char *before) {
  fprintf(out, "%sall %serror", before, before);
#define WARNING(id, name, on, doc) fprintf(out, " %s%s %sno-%s", before, name, before, name);
#include "support/warnings.def"
}

static void topic_names(FILE *out) {
  for (int i = 0; help_topic_name(i); i++) fprintf(out, "%s%s", i ? " " : "", help_topic_name(i));
}

// Text inside '...' of a shell.
static void quoted(FILE *out, const char *text, const char *special) {
  for (; *text; text++) {
    if (*text == '\'')
      fputs("'\\'", out);
    else if (strchr(special, *text))
      fputc('\\', out);
    fputc(*text, out);
  }
}

// ---- bash ------------------------------------------------------------------

static void bash_values(FILE *out, const Candidates *all) {
  for (int i = 0; i < all->count; i++) {
    const Candidate *option = &all->at[i];
    if (!takes_next(option)) continue;
    if (option->how == OPTION_SPACED && strcmp(option->spelling, "-D") == 0) {
      fputs("    -D | --define)\n"
            "      local params=$(cat -- \"${COMP_WORDS[@]:1}\" 2> /dev/null |\n"
            "        sed -n 's/^[[:space:]]*param[[:space:]]*\\([A-Za-z_0-9]*\\).*/\\1=/p')\n"
            "      compopt -o nospace\n"
            "      COMPREPLY=($(compgen -W \"$params\" -- \"$word\"))\n"
            "      return ;;\n",
            out);
    } else if (is_list(option)) {
      fprintf(out, "    %s) COMPREPLY=($(compgen -W '", option->spelling);
      choices(out, option);
      fputs("' -- \"$word\")); return ;;\n", out);
    } else {
      fprintf(out, "    %s) %sreturn ;;\n", option->spelling,
              takes_file(option) ? "COMPREPLY=($(compgen -f -- \"$word\")); " : "");
    }
  }
}

static void bash_options(FILE *out, const Candidates *all) {
  for (int command = 1; command <= COMMAND_COUNT; command++) {
    fprintf(out, "      %s) words='", command < COMMAND_COUNT ? command_table[command].name : "*");
    for (int i = 0; i < all->count; i++)
      if (all->at[i].commands & (1u << command % COMMAND_COUNT))
        fprintf(out, "%s%s ", all->at[i].spelling, all->at[i].how == OPTION_EQUALS ? "=" : "");
    fputs("' ;;\n", out);
  }
}

void manual_bash(FILE *out) {
  Candidates all;
  collect(&all);
  fputs("# bash completions for lsysc\n"
        "_lsysc_grammars() {\n"
        "  COMPREPLY+=($(compgen -f -X '!*.lsys' -- \"$word\") $(compgen -f -X '!*.l' -- \"$word\")\n"
        "    $(compgen -d -- \"$word\"))\n"
        "  (( ${#COMPREPLY[@]} )) || COMPREPLY=($(compgen -f -- \"$word\"))\n"
        "}\n"
        "_lsysc() {\n"
        "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
        "  [[ $word == = ]] && word=\n"
        "  [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD-2]}\n"
        "  COMPREPLY=()\n"
        "  case $before in\n",
        out);
  bash_values(out, &all);
  fputs("  esac\n  case $word in\n    -W*) words='", out);
  warning_names(out, "-W");
  fputs("' ;;\n    -O*) words='-O0 -O1 -O2 -O3' ;;\n    -*) case ${COMP_WORDS[1]} in\n", out);
  bash_options(out, &all);
  fputs("      esac ;;\n  esac\n"
        "  if [[ $word == -* ]]; then\n"
        "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
        "    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace\n"
        "  elif (( COMP_CWORD == 1 )); then\n"
        "    COMPREPLY=($(compgen -W '",
        out);
  for (int i = 1; i < COMMAND_COUNT; i++) fprintf(out, "%s ", command_table[i].name);
  fputs("' -- \"$word\"))\n"
        "    _lsysc_grammars\n"
        "  elif [[ ${COMP_WORDS[1]} == help ]]; then\n"
        "    COMPREPLY=($(compgen -W '",
        out);
  topic_names(out);
  fputs("' -- \"$word\"))\n"
        "  else\n"
        "    _lsysc_grammars\n"
        "  fi\n"
        "}\n"
        "complete -o filenames -F _lsysc lsysc\n",
        out);
}

// ---- zsh -------------------------------------------------------------------

static void zsh_option(FILE *out, const Candidate *option) {
  static const char *const marks[] = {
    [OPTION_FLAG] = "", [OPTION_JOINED] = "-", [OPTION_SPACED] = "+", [OPTION_EQUALS] = "="};
  bool word = option->spelling[0] == '-' && option->spelling[1] == '-';
  fprintf(out, "    '%s%s[", option->spelling, option->how == OPTION_SPACED && word ? "=" : marks[option->how]);
  quoted(out, option->doc, "[]");
  fputc(']', out);
  if (strcmp(option->spelling, "-W") == 0) {
    fputs(":warning:(", out);
    warning_names(out, "");
    fputc(')', out);
  } else if (is_list(option)) {
    fputs(":value:(", out);
    choices(out, option);
    fputc(')', out);
  } else if (option->value) {
    fprintf(out, ":%s:%s", option->value, takes_file(option) ? "_files" : " ");
  }
  fputs("'\n", out);
}

void manual_zsh(FILE *out) {
  Candidates all;
  collect(&all);
  fputs("#compdef lsysc\n"
        "_lsysc() {\n"
        "  local -a commands specs\n"
        "  commands=(\n",
        out);
  for (int i = 1; i < COMMAND_COUNT; i++) {
    fprintf(out, "    '%s:", command_table[i].name);
    quoted(out, command_table[i].summary, ":");
    fputs("'\n", out);
  }
  fputs("  )\n"
        "  if (( CURRENT == 2 )) && [[ $PREFIX != -* ]]; then\n"
        "    _describe -t commands command commands\n"
        "    _files -g '*.(lsys|l)(-.)'\n"
        "    return\n"
        "  fi\n"
        "  if [[ $words[2] == help ]]; then\n"
        "    compadd -- ",
        out);
  topic_names(out);
  fputs("\n    return\n  fi\n  case $words[2] in\n", out);
  for (int command = 1; command <= COMMAND_COUNT; command++) {
    fprintf(out, "  %s) specs=(\n", command < COMMAND_COUNT ? command_table[command].name : "*");
    for (int i = 0; i < all.count; i++)
      if (all.at[i].commands & (1u << command % COMMAND_COUNT)) zsh_option(out, &all.at[i]);
    fputs("  ) ;;\n", out);
  }
  fputs("  esac\n"
        "  _arguments -s : $specs '*:grammar:_files -g \"*.(lsys|l)(-.)\"'\n"
        "}\n"
        "if [[ $funcstack[1] == _lsysc ]]; then _lsysc \"$@\"; else compdef _lsysc lsysc; fi\n",
        out);
}

// ---- fish ------------------------------------------------------------------

// The condition that one of the commands in the mask was given.
static void fish_condition(FILE *out, unsigned commands) {
  fputs(" -n '", out);
  if (commands & 1u << COMMAND_COMPILE) {
    fputs("not __fish_seen_subcommand_from", out);
    for (int i = 1; i < COMMAND_COUNT; i++)
      if (!(commands & 1u << i)) fprintf(out, " %s", command_table[i].name);
  } else {
    fputs("__fish_seen_subcommand_from", out);
    for (int i = 1; i < COMMAND_COUNT; i++)
      if (commands & 1u << i) fprintf(out, " %s", command_table[i].name);
  }
  fputc('\'', out);
}

static void fish_option(FILE *out, const Candidate *option) {
  const char *name = option->spelling + strspn(option->spelling, "-");
  fputs("complete -c lsysc", out);
  fish_condition(out, option->commands);
  fprintf(out, " %s %s", option->spelling[1] == '-' ? "-l" : name[1] ? "-o" : "-s", name);
  if (is_list(option)) {
    fputs(" -x -a '", out);
    choices(out, option);
    fputc('\'', out);
  } else if (option->value) {
    fputs(takes_file(option) ? " -r -F" : " -x", out);
  }
  fputs(" -d '", out);
  quoted(out, option->doc, "");
  fputs("'\n", out);
}

void manual_fish(FILE *out) {
  Candidates all;
  collect(&all);
  fputs("# fish completions for lsysc\n"
        "complete -c lsysc -f\n"
        "complete -c lsysc -n 'not __fish_seen_subcommand_from help' -k -a '(__fish_complete_suffix .l; "
        "__fish_complete_suffix .lsys)'\n",
        out);
  for (int i = 1; i < COMMAND_COUNT; i++) {
    fprintf(out, "complete -c lsysc -n __fish_use_subcommand -a %s -d '", command_table[i].name);
    quoted(out, command_table[i].summary, "");
    fputs("'\n", out);
  }
  fputs("complete -c lsysc -n '__fish_seen_subcommand_from help' -a '", out);
  topic_names(out);
  fputs("'\n", out);
#undef WARNING
#define WARNING(id, name, on, doc) fputs("complete -c lsysc -o W" name " -d 'warn of " doc "'\n", out);
#include "support/warnings.def"
  for (int i = 0; i < all.count; i++)
    if (all.at[i].how != OPTION_JOINED) fish_option(out, &all.at[i]);
  for (int level = 0; level < 4; level++) {
    fputs("complete -c lsysc", out);
    fish_condition(out, option_table[OPTION_OPTIMISE].commands);
    fprintf(out, " -o O%d\n", level);
  }
}
