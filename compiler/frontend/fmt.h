// fmt.h -- an Ast as text in the native notation.
#ifndef LSYSC_FRONTEND_FMT_H
#define LSYSC_FRONTEND_FMT_H

#include "frontend/ast.h"

// Prints an Ast without errors, of any dialect, so that it reads back with the
// same meaning. Of a native file everything between statements stays as it is
// written: comments, conditions, inclusions (which are not followed). Of other
// files the comments stay.
void fmt_print(const Ast *ast, FILE *out);

#endif
