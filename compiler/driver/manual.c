// manual.c -- roff and shell scripts out of options.def; the build runs
// `lsysc help man` and its like and installs what they print.
#include "driver/manual.h"

#include <string.h>

// Text for roff: a line must not begin with a dot or quote, `-` is a minus.
static void roff(FILE *out, const char *text) {
  for (; *text; text++)
    if (*text == '\\')
      fputs("\\e", out);
    else if (*text == '-')
      fputs("\\-", out);
    else
      fputc(*text, out);
}

static void roff_option(FILE *out, const OptionRow *option) {
  char head[64];
  options_head(option, head, sizeof head);
  fputs(".TP\n\\fB", out);
  roff(out, head);
  fputs("\\fR\n", out);
  roff(out, option->doc);
  fputs(".\n", out);
}

void manual_page(FILE *out) {
  fputs(".TH LSYSC 1 \"\" \"lsysc " LSYSC_VERSION "\" \"User Commands\"\n"
        ".SH NAME\nlsysc \\- compiler from L\\-system grammars to native code\n.SH SYNOPSIS\n",
        out);
  for (int i = 0; i < COMMAND_COUNT; i++) {
    const CommandRow *command = &command_table[i];
    fprintf(out, "%s.B lsysc%s%s\n", i ? ".br\n" : "", i ? " " : "", command->name);
    roff(out, command->arguments);
    fputc('\n', out);
  }
  fputs(".SH DESCRIPTION\n"
        "lsysc reads a grammar in the notation of \\fIThe Algorithmic Beauty of Plants\\fR and writes a program that "
        "derives and draws it.\n"
        "The program is linked by the system's C compiler and needs nothing but libc to run.\n.SH COMMANDS\n",
        out);
  for (int i = 0; i < COMMAND_COUNT; i++) {
    const CommandRow *command = &command_table[i];
    fprintf(out, ".TP\n.B lsysc%s%s\n", i ? " " : "", command->name);
    roff(out, command->summary);
    fputs(".\n", out);
    roff(out, command->doc);
    fputc('\n', out);
  }
  fputs(".SH OPTIONS\n", out);
  for (int i = 0; i < OPTION_COUNT; i++) roff_option(out, &option_table[i]);
  fputs(
    ".SH ENVIRONMENT\n"
    ".TP\n.B LSYSC_HOME\nThe folder of liblsysrt.a and lsysc\\-llvm.so; by default ../lib/lsysc beside lsysc's own.\n"
    ".TP\n.B NO_COLOR\nWhen set, messages have no colours unless \\-\\-colour=always.\n"
    ".SH EXIT STATUS\n0 when all went well, 1 after an error. "
    "\\fBrun\\fR and \\fBinterp\\fR end with the status of the program.\n"
    ".SH EXAMPLES\n.nf\n"
    "lsysc plant.lsys && ./plant \\-n 6 \\-o plant.svg\n"
    "lsysc run plant.lsys \\-n 60 \\-\\-count\n.fi\n",
    out);
}

// The values of a list a|b|c, with blanks between them.
static void choices(FILE *out, const OptionRow *option) {
  if (!option->value || !strchr(option->value, '|')) return;
  for (const char *c = option->value; *c; c++) fputc(*c == '|' ? ' ' : *c, out);
}

static void words_of(FILE *out, Command command) {
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *option = &option_table[i];
    if (option->commands & (1u << command))
      fprintf(out, "%s%s ", option->spelling, option->how == OPTION_EQUALS ? "=" : "");
  }
}

void manual_bash(FILE *out) {
  fputs("# bash completions for lsysc\n"
        "_lsysc() {\n"
        "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words\n"
        "  [[ $word == = ]] && word=\n"
        "  [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD-2]}\n"
        "  case $before in\n",
        out);
  for (int i = 0; i < OPTION_COUNT; i++)
    if (option_table[i].how == OPTION_EQUALS && strchr(option_table[i].value, '|')) {
      fprintf(out, "    %s) COMPREPLY=($(compgen -W '", option_table[i].spelling);
      choices(out, &option_table[i]);
      fputs("' -- \"$word\")); return ;;\n", out);
    }
  fputs("  esac\n  case ${COMP_WORDS[1]} in\n", out);
  for (int i = 1; i <= COMMAND_COUNT; i++) {
    fprintf(out, "    %s) words='", i < COMMAND_COUNT ? command_table[i].name : "*");
    words_of(out, (Command)(i % COMMAND_COUNT));
    fputs("' ;;\n", out);
  }
  fputs("  esac\n"
        "  if [[ $word == -* ]]; then\n"
        "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
        "    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace\n"
        "  elif (( COMP_CWORD == 1 )); then\n"
        "    COMPREPLY=($(compgen -f -W '",
        out);
  for (int i = 1; i < COMMAND_COUNT; i++) fprintf(out, "%s ", command_table[i].name);
  fputs("' -- \"$word\"))\n"
        "  else\n"
        "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
        "  fi\n"
        "}\n"
        "complete -o filenames -F _lsysc lsysc\n",
        out);
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

void manual_zsh(FILE *out) {
  fputs("#compdef lsysc\n_arguments -s \\\n", out);
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *option = &option_table[i];
    static const char *const marks[] = {
      [OPTION_FLAG] = "", [OPTION_JOINED] = "-", [OPTION_SPACED] = "+", [OPTION_EQUALS] = "="};
    fprintf(out, "  '%s%s[", option->spelling, marks[option->how]);
    quoted(out, option->doc, "[]");
    fputc(']', out);
    if (option->value) {
      fputs(":value:", out);
      if (strchr(option->value, '|'))
        fputc('(', out), choices(out, option), fputc(')', out);
      else
        fputs("_files", out);
    }
    fputs("' \\\n", out);
  }
  fputs("  '1:command or grammar:((", out);
  for (int i = 1; i < COMMAND_COUNT; i++) {
    fprintf(out, "%s\\:\"", command_table[i].name);
    quoted(out, command_table[i].summary, "\":");
    fputs("\" ", out);
  }
  fputs("))' '*:grammar:_files'\n", out);
}

void manual_fish(FILE *out) {
  fputs("# fish completions for lsysc\n", out);
  for (int i = 1; i < COMMAND_COUNT; i++) {
    fprintf(out, "complete -c lsysc -n __fish_use_subcommand -a %s -d '", command_table[i].name);
    quoted(out, command_table[i].summary, "");
    fputs("'\n", out);
  }
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *option = &option_table[i];
    const char *name = option->spelling + strspn(option->spelling, "-");
    const char *kind = option->spelling[1] == '-' ? "-l" : name[1] ? "-o" : "-s";
    fprintf(out, "complete -c lsysc %s %s %s", kind, name, option->value ? "-r " : "");
    if (option->value && strchr(option->value, '|')) fputs("-a '", out), choices(out, option), fputs("' ", out);
    fputs("-d '", out);
    quoted(out, option->doc, "");
    fputs("'\n", out);
  }
}
