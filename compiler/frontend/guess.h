// guess.h -- what a statement that is none was probably meant to be.
#ifndef LSYSC_FRONTEND_GUESS_H
#define LSYSC_FRONTEND_GUESS_H

#include "frontend/parser.h"

// Reports a statement that has neither an arrow nor a keyword with its colon.
void guess_statement(Parser *parser, const Statement *statement);

#endif
