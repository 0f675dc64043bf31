// macro.h -- the textual macros of cpfg's files, as C's preprocessor replaces them.
#ifndef LSYSC_FRONTEND_MACRO_H
#define LSYSC_FRONTEND_MACRO_H

#include "frontend/split.h"

typedef struct Macros Macros;

Macros *macros_create(Arena *arena, Sources *sources, Diag *diag);

// Takes a #define or #undef statement in. One that is no definition is reported.
void macros_define(Macros *macros, const Statement *statement);
void macros_undefine(Macros *macros, const char *name);

// Replaces the macros in a statement: its text becomes one line of a text of
// its own, whose places lead back to what the user wrote. Behind `defined`
// nothing is replaced. Without a macro in it the statement stays as it is.
// False if nothing is left of it, or an error was reported.
bool macros_expand(Macros *macros, Statement *statement);

#endif
