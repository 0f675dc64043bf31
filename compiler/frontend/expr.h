// expr.h -- small questions about checked expressions, and their text.
// expr_constant and expr_draws are declared in program.h.
#ifndef LSYSC_FRONTEND_EXPR_H
#define LSYSC_FRONTEND_EXPR_H

#include "frontend/program.h"

// The value of an operator or of a function without randomness and effects
// (function.how == LSYS_FN_PURE), by the run-time library's own functions.
double expr_unary(Operator op, double x);
double expr_binary(Operator op, double x, double y);
double expr_pure(LsysFunction function, const double *args, uint32_t count);

// A number as an expression.
Expr *expr_number(Arena *arena, double value, Span span);

// The value of an expression of numbers alone: no name stands in it.
bool expr_literal(const Expr *expr, double *value);

// True if both are the same tree and so, evaluated for the same module, have the same value.
// Two calls of random functions are different unless they are one site.
bool expr_equal(const Expr *a, const Expr *b);

// Equal expressions have equal hashes. NULL (no expression) has one too.
uint64_t expr_hash(const Expr *expr);

// Writes the expression as one would in a grammar, with as few parentheses as
// the operators' precedence allows. parameters: the names of EXPR_PARAMETER
// slots; where it is NULL or has no name the slot prints as `$3`.
void expr_print(const Program *program, const Expr *expr, const char *const *parameters, FILE *out);

#endif
