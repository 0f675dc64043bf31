// fractint.h -- L-systems in the notation of Fractint and Iterated Dynamics.
#ifndef LSYSC_FRONTEND_FRACTINT_H
#define LSYSC_FRONTEND_FRACTINT_H

#include "frontend/ast.h"

// Is this such a file? It holds a `Name { ... }` with a line of `axiom` or `angle` in it.
bool fractint_recognise(const SourceFile *file);

// A file of `Name { ... }` entries -> the Ast of one of them, options->system
// or the first. Its commands become symbols of our turtle: the result is a
// native grammar, and no later pass knows where it came from.
// Never NULL; after errors it holds what could be read.
Ast *fractint_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                    const ParseOptions *options);

// Prints the names of the systems in a file, one a line (--list-systems).
void fractint_list(const SourceFile *file, FILE *out);

#endif
