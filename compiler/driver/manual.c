// manual.c -- the manual page out of options.def and the run time's tables; the
// build installs what `lsysc help man` prints.
#include "driver/manual.h"

#include "lsys/help.h"

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

// What a compiled program takes, and run and interp behind the grammar.
static void roff_program(FILE *out) {
  fputs(".SH OPTIONS OF THE PROGRAM\nThose of a compiled program; \\fBrun\\fR and \\fBinterp\\fR take them, too.\n",
        out);
  LsysHelpOption option;
  for (int i = 0; lsys_help_option(i, &option); i++) {
    fputs(".TP\n\\fB", out);
    if (option.letter) fprintf(out, "\\-%c, ", option.letter);
    roff(out, "--");
    roff(out, option.name);
    if (option.argument) fputc(' ', out), roff(out, option.argument);
    fputs("\\fR\n", out);
    roff(out, option.doc);
    fputs(".\n", out);
  }
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
  roff_program(out);
  fputs(
    ".SH ENVIRONMENT\n"
    ".TP\n.B LSYSC_HOME\nThe folder of liblsysrt.a and lsysc\\-llvm.so; by default ../lib/lsysc beside lsysc's own.\n"
    ".TP\n.B NO_COLOR\nWhen set, messages have no colours unless \\-\\-colour=always.\n"
    ".SH EXIT STATUS\n0 when all went well, 1 after an error. "
    "\\fBrun\\fR and \\fBinterp\\fR end with the status of the program.\n"
    ".SH EXAMPLES\n.nf\n"
    "lsysc plant.lsys && ./plant \\-n 6 \\-o plant.svg\n"
    "lsysc run plant.lsys \\-n 6 \\-o plant.png \\-\\-size 600x600\n"
    "lsysc help turtle\n"
    "lsysc run plant.lsys \\-n 60 \\-\\-count\n.fi\n",
    out);
}
