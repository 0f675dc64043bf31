// help.c -- usage and reference texts, read from the tables that the passes read.
#include "driver/help.h"
#include "driver/manual.h"
#include "frontend/program.h"

#include <math.h>
#include <string.h>

enum { INDENT = 26 };

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

// Prints "  head   text", with the text broken into lines at blanks.
static void row(FILE *out, const char *head, const char *text) {
  enum { WIDTH = 100 };
  int used = fprintf(out, "  %s", head);
  if (used >= INDENT) {
    fputc('\n', out);
    used = 0;
  }
  fprintf(out, "%*s", INDENT - used, "");
  while (*text) {
    size_t length = strlen(text);
    if (length > WIDTH - INDENT) {
      length = WIDTH - INDENT;
      while (length > 1 && text[length] != ' ') length--;
    }
    fprintf(out, "%.*s\n", (int)length, text);
    text += length + strspn(text + length, " ");
    if (*text) fprintf(out, "%*s", INDENT, "");
  }
}

static void options_of(FILE *out, Command command) {
  fputs("\noptions:\n", out);
  for (int i = 0; i < OPTION_COUNT; i++) {
    const OptionRow *option = &option_table[i];
    if (!(option->commands & (1u << command))) continue;
    char head[64];
    options_head(option, head, sizeof head);
    row(out, head, option->doc);
  }
}

static void commands(FILE *out) {
  fputs("\ncommands:\n", out);
  for (int i = 1; i < COMMAND_COUNT; i++) row(out, command_table[i].name, command_table[i].summary);
  fputs("\ntopics (lsysc help TOPIC):\n", out);
}

// ---- topics ------------------------------------------------------------------

static void turtle(FILE *out) {
  fputs("What the turtle does with a symbol; it ignores all others. Behind the text: the default of a missing\n"
        "argument, and where the symbol comes from.\n\n",
        out);
#define TURTLE(id, symbol, least, most, unit, fallback, doc, source)                                                   \
  row(out, most ? symbol "(" unit ")" : symbol, *fallback ? doc " [" fallback "] " source : doc "; " source);
#include "lsys/turtle.def"
}

static void functions(FILE *out) {
  fputs("Functions of expressions; angles are in degrees.\n\n", out);
#define FUNCTION(id, name, least, most, how, doc)                                                                      \
  row(out, most == 1 ? name "(x)" : most == 2 ? name "(x,y)" : name "(x,...)", doc);
#include "lsys/functions.def"
}

static void operators(FILE *out) {
  fputs("Operators of expressions, those that bind loosest first; ?: binds looser than all.\n\n", out);
#define BINARY(id, spelling, precedence, right, doc) row(out, "a " spelling " b", doc);
#define UNARY(id, spelling, precedence, doc) row(out, spelling "a", doc);
#include "lsys/operators.def"
}

static void setting(FILE *out, const char *keyword, const char *others, double value, const char *unit,
                    const char *doc) {
  char head[64], text[256], fallback[32] = "none";
  snprintf(head, sizeof head, "%s: %s%s%s", keyword, *unit ? "(" : "", unit, *unit ? ")" : "");
  if (!isnan(value)) snprintf(fallback, sizeof fallback, "%g", value);
  snprintf(text, sizeof text, "%s [%s]%s%s", doc, fallback, *others ? "; also spelled " : "", others);
  row(out, head, text);
}

static void settings(FILE *out) {
  fputs("Statements `keyword: value` of a grammar, with their [defaults].\n\n", out);
#define SETTING(id, keyword, others, value, unit, doc) setting(out, keyword, others, value, unit, doc);
#include "lsys/settings.def"
}

static void warnings(FILE *out) {
  fputs("-Wname switches a warning on, -Wno-name off; -Wall: all; -Werror: warnings are errors; -w: none.\n\n", out);
#define WARNING(id, name, on, doc) row(out, name, on ? doc : doc " [off unless asked for]");
#include "support/warnings.def"
}

static const struct {
  const char *name;
  void (*print)(FILE *out);
  const char *summary;
} topics[] = {
  {"turtle", turtle, "the symbols that draw"},
  {"functions", functions, "the functions of expressions"},
  {"operators", operators, "the operators of expressions"},
  {"settings", settings, "angle:, step: and other statements that set a default"},
  {"warnings", warnings, "what -W can switch"},
  {"man", manual_page, "this program's manual page, as roff"},
  {"bash", manual_bash, "completions for bash: source <(lsysc help bash)"},
  {"zsh", manual_zsh, "completions for zsh"},
  {"fish", manual_fish, "completions for fish"},
};
enum { TOPIC_COUNT = sizeof topics / sizeof *topics };

void help_command(FILE *out, Command command) {
  const CommandRow *shown = &command_table[command];
  fprintf(out, "usage: lsysc %s%s%s\n", shown->name, *shown->name ? " " : "", shown->arguments);
  if (command == COMMAND_COMPILE) fputs("       lsysc COMMAND ...\n", out);
  fprintf(out, "\n%s\n%s%s", shown->summary, shown->doc, *shown->doc ? "\n" : "");
  options_of(out, command);
  if (command != COMMAND_COMPILE && command != COMMAND_HELP) return;
  commands(out);
  for (int i = 0; i < TOPIC_COUNT; i++) row(out, topics[i].name, topics[i].summary);
}

bool help_topic(FILE *out, const char *name) {
  for (int i = 1; i < COMMAND_COUNT; i++)
    if (strcmp(name, command_table[i].name) == 0) return help_command(out, (Command)i), true;
  for (int i = 0; i < TOPIC_COUNT; i++)
    if (strcmp(name, topics[i].name) == 0) return topics[i].print(out), true;
  return false;
}
