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

static void option_row(FILE *to, LsysOption option) {
  const LsysOptionInfo *info = &lsys_options[option];
  char left[80], letter[8] = "";
  if (info->letter) snprintf(letter, sizeof letter, "-%c, ", info->letter);
  const char *argument = info->argument ? info->argument : "";
  bool optional = info->type == LSYS_OPTION_SUBJECT;
  snprintf(left, sizeof left, "%s--%s%s%s%s", letter, info->name,
           optional    ? " ["
           : *argument ? " "
                       : "",
           argument, optional ? "]" : "");
  lsys_help_row(to, left, info->doc);
}

static void option_rows(FILE *to) {
#define GROUP(title) fprintf(to, "\n%s\n", title);
#define OPTION(id, letter, name, argument, type, doc) option_row(to, LSYS_OPTION_##id);
#include "core/options.def"
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
  option_rows(to);
  param_rows(to, grammar);
  fprintf(to, "\nExamples\n");
#define EXAMPLE(arguments, doc) fprintf(to, "  %s %-34s %s\n", program, arguments, doc);
#include "core/options.def"
}

static void formats(FILE *to) {
  fprintf(to, "Formats (--format NAME, or by the suffix of -o FILE)\n");
  for (size_t i = 0; i < lsys_format_count; i++) {
    char left[80], *at = left;
    at += snprintf(left, sizeof left, "%s", lsys_formats[i].name);
    for (const char *suffix = lsys_formats[i].suffixes; *suffix && at < left + 40;) {
      int length = (int)strcspn(suffix, " ");
      at += snprintf(at, 20, " .%.*s", length, suffix);
      suffix += length + (suffix[length] == ' ');
    }
    lsys_help_row(to, left, lsys_formats[i].doc);
  }
}

static void turtle(FILE *to) {
  fprintf(to, "What the turtle reads; it ignores every other symbol. F_x is read as F, f_x as f.\n");
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++) {
    const LsysTurtleInfo *info = &lsys_turtle[op];
    char left[80], doc[320];
    snprintf(left, sizeof left, info->most ? "%s(%s)" : "%s", info->symbol, info->unit);
    snprintf(doc, sizeof doc, *info->fallback ? "%s [%s] (default: %s)" : "%s [%s]", info->doc, info->source,
             info->fallback);
    lsys_help_row(to, left, doc);
  }
}

static void functions(FILE *to) {
  fprintf(to, "Functions of expressions (angles in degrees)\n");
  for (int i = 0; i < LSYS_FN_COUNT; i++) lsys_help_row(to, lsys_functions[i].name, lsys_functions[i].doc);
}

static void settings(FILE *to) {
  fprintf(to, "Statements of a grammar that set a default, `keyword: value`\n");
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) {
    const LsysSettingInfo *info = &lsys_settings[i];
    char doc[256];
    snprintf(doc, sizeof doc, isnan(info->value) ? "%s" : "%s (default: %g %s)", info->doc, info->value, info->unit);
    lsys_help_row(to, info->keyword, doc);
  }
}

static void operators(FILE *to) {
  fprintf(to, "Operators of expressions, those that bind loosest first; a ? b : c binds looser than all\n");
#define BINARY(id, spelling, precedence, right, doc) lsys_help_row(to, "a " spelling " b", doc);
#define UNARY(id, spelling, precedence, doc) lsys_help_row(to, spelling "a", doc);
#include "lsys/operators.def"
}

bool lsys_help_subject(FILE *to, const char *subject) {
  static const struct {
    const char *name;
    void (*print)(FILE *to);
  } subjects[] = {
    {"formats", formats},     {"turtle", turtle},     {"functions", functions},
    {"operators", operators}, {"settings", settings},
  };
  for (size_t i = 0; i < sizeof subjects / sizeof *subjects; i++) {
    if (strcmp(subjects[i].name, subject) != 0) continue;
    subjects[i].print(to);
    return true;
  }
  return false;
}

bool lsys_help(FILE *to, const LsysGrammar *grammar, const char *subject) {
  if (subject && lsys_help_subject(to, subject)) return true;
  if (!subject) {
    usage(to, grammar);
    return true;
  }
  lsys_error("there is no help on '%s'; there is on: formats, turtle, functions, operators, settings", subject);
  return false;
}
