// operators.h -- the operators of expressions as an enumeration; see operators.def.
#ifndef LSYS_OPERATORS_H
#define LSYS_OPERATORS_H

typedef enum Operator {
  OP_NONE,
#define BINARY(id, spelling, precedence, right, doc) OP_##id,
#define UNARY(id, spelling, precedence, doc) OP_##id,
#include "lsys/operators.def"
  OP_COUNT
} Operator;

// A value holds (is true) if it is neither 0 nor nan.
static inline int lsys_holds(double x) {
  return x < 0 || x > 0;
}

#endif
