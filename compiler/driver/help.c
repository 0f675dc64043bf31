// help.c -- usage and reference texts, read from the tables that the passes read.
#include "driver/help.h"
#include "driver/manual.h"
#include "driver/report.h"
#include "lsys/help.h"

#include <string.h>

void help_short(FILE *out) {
  fputs("lsysc compiles L-system grammars to programs. With the grammar\n"
        "\n"
        "  axiom: X\n"
        "  X --> F[+X][-X]FX\n"
        "  F --> FF\n"
        "  angle: 25.7\n"
        "\n"
        "in plant.lsys:\n"
        "\n"
        "  lsysc plant.lsys                     compile it to the program ./plant\n"
        "  ./plant -n 6 -o plant.svg            derive 6 steps and draw them\n"
        "  lsysc run plant.lsys -n 2            derive at once; the word goes to the terminal\n"
        "  lsysc check plant.lsys               look for mistakes only\n"
        "\n"
        "`lsysc help` shows all commands and options.\n",
        out);
}

static void options_of(FILE *out, Command command) {
  fputs("\noptions:\n", out);
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *option = &option_table[i];
    if (!(option->commands & (1u << command))) continue;
    char head[64];
    options_head(option, head, sizeof head);
    lsys_help_row(out, head, option->doc);
  }
}

// ---- topics ------------------------------------------------------------------

static void warning_rows(LsysHelp *help) {
  lsys_help_title(help,
                  "-Wname switches a warning on, -Wno-name off; -Wall: all; -Werror: warnings are errors; -w: none.");
#define WARNING(id, name, on, doc) lsys_help_entry(help, name, name, on ? doc : doc " [off unless asked for]");
#include "support/warnings.def"
}

static void statement_rows(LsysHelp *help) {
  lsys_help_title(help, "Statements of a grammar, one a line");
  lsys_help_entry(help, "production --> -> :", "[L <] PRED [> R] [: COND] --> WORD [: WEIGHT]",
                  "a production: PRED becomes WORD where it stands between L and R, and COND holds");
#define KEYWORD(token, spellings, colon, rest, form, doc) lsys_help_entry(help, spellings, form, doc);
#include "frontend/keywords.def"
}

static void drawn_rows(LsysHelp *help) {
  lsys_help_title(help, "Functions of expressions that files hold");
#define DRAWN(id, name, arguments, doc) lsys_help_entry(help, name, name "(" arguments ")", doc);
#include "frontend/drawn.def"
}

static void functions(FILE *out) {
  lsys_help_subject(out, "functions");
  fputc('\n', out);
  drawn_rows(&(LsysHelp){.to = out});
}

// The options of lsysc itself, for a word such as dump.
static void option_entries(LsysHelp *help) {
  lsys_help_title(help, "Options of lsysc");
  for (int i = 0; i < OPTION_COUNT; i++) {
    char head[64];
    options_head(&option_table[i], head, sizeof head);
    lsys_help_entry(help, option_table[i].spelling + strspn(option_table[i].spelling, "-"), head, option_table[i].doc);
  }
}

static void warnings(FILE *out) {
  warning_rows(&(LsysHelp){.to = out});
}

static void statements(FILE *out) {
  statement_rows(&(LsysHelp){.to = out});
  fputs("\nAnd `lsysc help settings`.\n", out);
}

static const struct {
  const char *name;
  void (*print)(FILE *out);  // NULL: the run time has the table
  const char *summary;
} topics[] = {
  {"formats", NULL, "what a compiled program can write"},
  {"statements", statements, "what a grammar is made of"},
  {"turtle", NULL, "the symbols that draw"},
  {"functions", functions, "the functions of expressions"},
  {"operators", NULL, "the operators of expressions"},
  {"settings", NULL, "angle:, step: and other statements that set a default"},
  {"environments", NULL, "what answers the modules ?E of open L-systems"},
  {"warnings", warnings, "what -W can switch"},
  {"man", manual_page, "this program's manual page, as roff"},
  {"bash", manual_bash, "completions for bash: source <(lsysc help bash)"},
  {"zsh", manual_zsh, "completions for zsh"},
  {"fish", manual_fish, "completions for fish"},
};
enum { TOPIC_COUNT = sizeof topics / sizeof *topics };

static void usage(FILE *out, const CommandRow *shown) {
  fprintf(out, "usage: lsysc %s%s%s\n", shown->name, *shown->name ? " " : "", shown->arguments);
  if (shown == &command_table[COMMAND_COMPILE]) fputs("       lsysc COMMAND ...\n", out);
  fprintf(out, "\n%s\n%s%s", shown->summary, shown->doc, *shown->doc ? "\n" : "");
}

void help_command(FILE *out, Command command) {
  bool all = command == COMMAND_COMPILE || command == COMMAND_HELP;
  usage(out, &command_table[command]);
  if (all) {
    fputs("\ncommands:\n", out);
    for (int i = 1; i < COMMAND_COUNT; i++) lsys_help_row(out, command_table[i].name, command_table[i].summary);
    fputs("\ntopics (lsysc help TOPIC):\n", out);
    for (int i = 0; i < TOPIC_COUNT; i++) lsys_help_row(out, topics[i].name, topics[i].summary);
    fputs("\nEverything in these tables can be asked for: lsysc help F, lsysc help nran, lsysc help axiom, ...\n", out);
  }
  options_of(out, command);
  if (command == COMMAND_RUN || command == COMMAND_INTERP) {
    fputs("\nOptions of the program\n\n", out);
    lsys_help_options(out);
  }
}

const char *help_topic_name(int i) {
  if (i < COMMAND_COUNT - 1) return command_table[i + 1].name;
  i -= COMMAND_COUNT - 1;
  return i < TOPIC_COUNT ? topics[i].name : NULL;
}

bool help_topic(FILE *out, const char *name) {
  for (int i = 1; i < COMMAND_COUNT; i++)
    if (strcmp(name, command_table[i].name) == 0) return help_command(out, (Command)i), true;
  for (int i = 0; i < TOPIC_COUNT; i++)
    if (topics[i].print && strcmp(name, topics[i].name) == 0) return topics[i].print(out), true;
  if (lsys_help_subject(out, name)) return true;
  LsysHelp word = {.to = out, .only = name};
  statement_rows(&word);
  lsys_help_tables(&word);
  drawn_rows(&word);
  warning_rows(&word);
  option_entries(&word);
  if (word.any) return true;
  for (int i = 0; help_topic_name(i); i++) lsys_help_near(&word, help_topic_name(i));
  if (*word.near) return report_error("there is no help on `%s`; did you mean `%s`?", name, word.near);
  return report_error("there is no help on `%s`; `lsysc help` lists commands and topics", name);
}
