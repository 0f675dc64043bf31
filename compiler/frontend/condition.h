// condition.h -- the value of an `#if`, from the #defines above it.
#ifndef LSYSC_FRONTEND_CONDITION_H
#define LSYSC_FRONTEND_CONDITION_H

#include "frontend/parser.h"

// The #define statements in force, by name; a value of NULL: undefined again.
typedef Trie Defines;

// Whether the condition of `#if` holds. Constants, #defined values without
// parameters, operators and defined(NAME) are known; the rest is reported and does not hold.
bool condition_holds(Parser *parser, const Defines *defines, Statement *statement);

#endif
