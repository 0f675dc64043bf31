// turtle.h -- the turtle's symbols as an enumeration; see turtle.def.
#ifndef LSYS_TURTLE_H
#define LSYS_TURTLE_H

typedef enum LsysTurtleOp {
  LSYS_TURTLE_NONE,
#define TURTLE(id, symbol, least, most, unit, default, doc, source) LSYS_TURTLE_##id,
#include "lsys/turtle.def"
  LSYS_TURTLE_COUNT
} LsysTurtleOp;

typedef struct LsysTurtleInfo {
  const char *symbol;
  int least, most;
  const char *unit, *fallback, *doc, *source;
} LsysTurtleInfo;

extern const LsysTurtleInfo lsys_turtle[LSYS_TURTLE_COUNT];

// The operation of a symbol: exact, or F_x and f_x by their first letter;
// LSYS_TURTLE_NONE for what the turtle ignores.
LsysTurtleOp lsys_turtle_op(const char *symbol);

#endif
