// tables.c -- the .def tables as arrays, and the symbols that the turtle knows.
// Everything that lists functions, settings or turtle symbols reads these.
#include "lsys/functions.h"
#include "lsys/settings.h"
#include "lsys/turtle.h"

#include <math.h>
#include <string.h>

// The columns of functions.def have short names.
enum { PURE = LSYS_FN_PURE, RANDOM = LSYS_FN_RANDOM, EFFECT = LSYS_FN_EFFECT, FILE = LSYS_FN_FILE };

const LsysFunctionInfo lsys_functions[LSYS_FN_COUNT] = {
#define FUNCTION(id, name, arguments, least, most, how, doc)                                                           \
  [LSYS_FN_##id] = {name, arguments, least, most, (LsysFunctionHow)how, doc},
#include "lsys/functions.def"
};

const LsysSettingInfo lsys_settings[LSYS_SETTING_COUNT] = {
#define SETTING(id, keyword, others, value, unit, doc) [LSYS_SETTING_##id] = {keyword, others, value, unit, doc},
#include "lsys/settings.def"
};

const LsysPageInfo lsys_page_settings[LSYS_PAGE_COUNT] = {
#define PAGE(id, keyword, others, form, option, doc) [LSYS_PAGE_##id] = {keyword, others, form, doc},
#include "lsys/settings.def"
};

const LsysTurtleInfo lsys_turtle[LSYS_TURTLE_COUNT] = {
#define TURTLE(id, symbol, least, most, unit, fallback, doc, source)                                                   \
  [LSYS_TURTLE_##id] = {symbol, least, most, unit, fallback, doc, source},
#include "lsys/turtle.def"
};

LsysTurtleOp lsys_turtle_op(const char *symbol) {
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++)
    if (strcmp(lsys_turtle[op].symbol, symbol) == 0) return (LsysTurtleOp)op;
  if (symbol[0] == 'F' && symbol[1] == '_') return LSYS_TURTLE_DRAW;
  if (symbol[0] == 'f' && symbol[1] == '_') return LSYS_TURTLE_MOVE;
  return LSYS_TURTLE_NONE;
}
