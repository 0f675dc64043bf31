// help.c -- --help and --version, generated from the .def tables and the grammar's params.
#include "lsys/help.h"
#include "core/formats.h"
#include "core/message.h"
#include "lsys/operators.h"

#include <math.h>
#include <string.h>

enum { LEFT_COLUMN = 26, WIDTH = 96 };

void lsys_help_row(FILE *to, const char *left, const char *doc) {
  int column = fprintf(to, "  %s", left);
  if (column >= LEFT_COLUMN) {
    fputc('\n', to);
    column = 0;
  }
  for (int first = column; *doc; first = 0) {
    int length = (int)strlen(doc);
    if (length > WIDTH - LEFT_COLUMN) {
      length = WIDTH - LEFT_COLUMN;
      while (length > 1 && doc[length] != ' ') length--;
    }
    fprintf(to, "%*s%.*s\n", LEFT_COLUMN - first, "", length, doc);
    doc += length;
    while (*doc == ' ') doc++;
  }
}

void lsys_help_title(LsysHelp *help, const char *title) {
  help->title = title;
}

// Is word one of the names? A statement may be asked for with its colon.
static bool is_named(const char *names, const char *word) {
  size_t length = strlen(word);
  if (length > 1 && word[length - 1] == ':') length--;
  while (*names) {
    size_t name = strcspn(names, " ");
    if (name == length && strncmp(names, word, length) == 0) return true;
    names += name + (names[name] == ' ');
  }
  return false;
}

void lsys_help_near(LsysHelp *help, const char *names) {
  while (*names) {
    size_t length = strcspn(names, " ");
    char name[sizeof help->near];
    const char *candidates[] = {name, help->near};
    snprintf(name, sizeof name, "%.*s", (int)length, names);
    if (length < sizeof name && lsys_nearest(help->only, candidates, *help->near ? 2 : 1) == name)
      memcpy(help->near, name, length + 1);
    names += length + (names[length] == ' ');
  }
}

void lsys_help_entry(LsysHelp *help, const char *names, const char *left, const char *doc) {
  if (help->only && !is_named(names, help->only)) {
    lsys_help_near(help, names);
    return;
  }
  if (help->title) fprintf(help->to, "%s%s\n", help->any ? "\n" : "", help->title);
  help->title = NULL;
  help->any = true;
  lsys_help_row(help->to, left, doc);
}

static void option_entry(LsysHelp *help, LsysOption option) {
  const LsysOptionInfo *info = &lsys_options[option];
  char left[80], names[80], letter[8] = "";
  if (info->letter) snprintf(letter, sizeof letter, "-%c, ", info->letter);
  const char *argument = info->argument ? info->argument : "";
  bool optional = info->type == LSYS_OPTION_SUBJECT;
  snprintf(left, sizeof left, "%s--%s%s%s%s", letter, info->name,
           optional    ? " ["
           : *argument ? " "
                       : "",
           argument, optional ? "]" : "");
  snprintf(names, sizeof names, "%s --%s -%c", info->name, info->name, info->letter ? info->letter : '-');
  lsys_help_entry(help, names, left, info->doc);
}

static void options(LsysHelp *help) {
#define GROUP(title) lsys_help_title(help, title);
#define OPTION(id, letter, name, argument, type, doc) option_entry(help, LSYS_OPTION_##id);
#include "core/options.def"
}

void lsys_help_options(FILE *to) {
  LsysHelp help = {.to = to};
  options(&help);
}

bool lsys_help_option(int i, LsysHelpOption *option) {
  if (i >= LSYS_OPTION_COUNT_) return false;
  const LsysOptionInfo *info = &lsys_options[i];
  *option = (LsysHelpOption){info->letter, info->name, info->argument, info->doc};
  return true;
}

const char *lsys_help_format(int i) {
  return (size_t)i < lsys_format_count ? lsys_formats[i].name : NULL;
}

static void param_rows(FILE *to, const LsysGrammar *grammar) {
  if (!grammar->param_count) return;
  fprintf(to, "\nParams of this grammar (-D NAME=VALUE)\n");
  for (uint32_t i = 0; i < grammar->param_count; i++) {
    const LsysParam *param = &grammar->params[i];
    char doc[256];
    int length = snprintf(doc, sizeof doc, "default %s", param->text ? param->text : "given in the grammar");
    if (length > 0 && length < (int)sizeof doc && (isfinite(param->low) || isfinite(param->high)))
      snprintf(doc + length, sizeof doc - (size_t)length, ", in %.17g..%.17g", param->low, param->high);
    lsys_help_row(to, param->name, doc);
  }
}

static void usage(FILE *to, const LsysGrammar *grammar) {
  const char *program = lsys_message_name();
  fprintf(to, "usage: %s [options]\n\nDerives the L-system %s and prints or draws what it becomes.\n", program,
          grammar->name);
  fputc('\n', to);
  lsys_help_options(to);
  param_rows(to, grammar);
  fprintf(to, "\nExamples\n");
#define EXAMPLE(arguments, doc) fprintf(to, "  %s %-34s %s\n", program, arguments, doc);
#include "core/options.def"
}

static void options_of_formats(LsysHelp *help) {
  lsys_help_title(help, "Options that only some formats read");
  for (int i = 0; i < LSYS_OPTION_COUNT_; i++) {
    char readers[160], left[80];
    lsys_format_readers((LsysOption)i, readers, sizeof readers);
    snprintf(left, sizeof left, "--%s", lsys_options[i].name);
    if (*readers) lsys_help_entry(help, lsys_options[i].name, left, readers);
  }
}

static void formats(LsysHelp *help) {
  lsys_help_title(help, "Formats (--format NAME, or by the suffix of -o FILE)");
  for (size_t i = 0; i < lsys_format_count; i++) {
    char left[80], names[80], *at = left;
    snprintf(names, sizeof names, "%s %s", lsys_formats[i].name, lsys_formats[i].suffixes);
    at += snprintf(left, sizeof left, "%s", lsys_formats[i].name);
    for (const char *suffix = lsys_formats[i].suffixes; *suffix && at < left + 40;) {
      int length = (int)strcspn(suffix, " ");
      at += snprintf(at, 20, " .%.*s", length, suffix);
      suffix += length + (suffix[length] == ' ');
    }
    lsys_help_entry(help, names, left, lsys_formats[i].doc);
  }
  if (!help->only) options_of_formats(help);
}

static void turtle(LsysHelp *help) {
  lsys_help_title(help, "What the turtle reads; it ignores every other symbol. F_x is read as F, f_x as f.");
  LsysTurtleOp asked = help->only ? lsys_turtle_op(help->only) : LSYS_TURTLE_NONE;
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++) {
    const LsysTurtleInfo *info = &lsys_turtle[op];
    char left[80], doc[320];
    snprintf(left, sizeof left, info->most ? "%s(%s)" : "%s", info->symbol, info->unit);
    snprintf(doc, sizeof doc, *info->fallback ? "%s [%s] (default: %s)" : "%s [%s]", info->doc, info->source,
             info->fallback);
    lsys_help_entry(help, op == (int)asked ? help->only : info->symbol, left, doc);
  }
}

static void functions(LsysHelp *help) {
  lsys_help_title(help, "Functions of expressions (angles in degrees)");
  for (int i = 0; i < LSYS_FN_COUNT; i++) {
    const LsysFunctionInfo *info = &lsys_functions[i];
    char left[80];
    snprintf(left, sizeof left, "%s(%s)", info->name, info->arguments);
    lsys_help_entry(help, info->name, left, info->doc);
  }
}

static void pages(LsysHelp *help) {
  lsys_help_title(help, "Statements of a grammar about its pictures");
  for (int i = 0; i < LSYS_PAGE_COUNT; i++) {
    const LsysPageInfo *info = &lsys_page_settings[i];
    char names[80], left[80];
    snprintf(names, sizeof names, "%s %s", info->keyword, info->others);
    snprintf(left, sizeof left, "%s: %s", info->keyword, info->form);
    lsys_help_entry(help, names, left, info->doc);
  }
}

static void settings(LsysHelp *help) {
  lsys_help_title(help, "Statements of a grammar that set a default, `keyword: value`");
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) {
    const LsysSettingInfo *info = &lsys_settings[i];
    if (!*info->doc) continue;
    char names[80], left[80], doc[256];
    snprintf(names, sizeof names, "%s %s", info->keyword, info->others);
    snprintf(left, sizeof left, "%s:", info->keyword);
    const char *unit = strcmp(info->unit, "degrees") == 0 ? " degrees" : "";
    snprintf(doc, sizeof doc, isnan(info->value) ? "%s" : "%s (default: %g%s)", info->doc, info->value, unit);
    lsys_help_entry(help, names, left, doc);
  }
  pages(help);
}

static void environments(LsysHelp *help) {
  lsys_help_title(help, "Environments of open L-systems, `environment: NAME(parameter=number)`");
  for (int id = 0; id < LSYS_ENVIRONMENT_COUNT; id++) {
    const LsysEnvironmentInfo *info = &lsys_environment_table[id];
    char left[80];
    int at = snprintf(left, sizeof left, "%s", info->name);
    for (int i = 0; i < LSYS_ENVIRONMENT_VALUES && *info->parameter[i]; i++)
      at += snprintf(left + at, sizeof left - (size_t)at, "%s%s=%g", i ? "," : "(", info->parameter[i], info->value[i]);
    if (*info->parameter[0]) snprintf(left + at, sizeof left - (size_t)at, ")");
    lsys_help_entry(help, info->name, left, info->doc);
  }
}

static void operators(LsysHelp *help) {
  lsys_help_title(help, "Operators of expressions, those that bind loosest first");
  lsys_help_entry(help, "? :", "a ? b : c", "b if a holds, else c; the other one is not evaluated");
#define BINARY(id, spelling, precedence, right, doc) lsys_help_entry(help, spelling, "a " spelling " b", doc);
#define UNARY(id, spelling, precedence, doc) lsys_help_entry(help, spelling, spelling "a", doc);
#include "lsys/operators.def"
}

static const struct {
  const char *name;
  void (*print)(LsysHelp *help);
} subjects[] = {
  {"formats", formats},     {"turtle", turtle},     {"functions", functions},
  {"operators", operators}, {"settings", settings}, {"environments", environments},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

bool lsys_help_subject(FILE *to, const char *subject) {
  for (size_t i = 0; i < SUBJECTS; i++) {
    if (strcmp(subjects[i].name, subject) != 0) continue;
    subjects[i].print(&(LsysHelp){.to = to});
    return true;
  }
  return false;
}

void lsys_help_tables(LsysHelp *help) {
  for (size_t i = 0; i < SUBJECTS; i++) subjects[i].print(help);
  options(help);
}

bool lsys_help(FILE *to, const LsysGrammar *grammar, const char *subject) {
  if (!subject) {
    usage(to, grammar);
    return true;
  }
  LsysHelp word = {.to = to, .only = subject};
  if (lsys_help_subject(to, subject)) return true;
  for (size_t i = 0; i < SUBJECTS; i++) lsys_help_near(&word, subjects[i].name);
  lsys_help_tables(&word);
  if (word.any) return true;
  if (*word.near) {
    lsys_error("there is no help on '%s'; did you mean '%s'?", subject, word.near);
    return false;
  }
  lsys_error("there is no help on '%s'; there is on: formats, turtle, functions, operators, settings, environments, "
             "and on every "
             "name and symbol in them",
             subject);
  return false;
}
