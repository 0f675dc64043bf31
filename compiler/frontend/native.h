// native.h -- the notation of LANGUAGE.md: files -> AST.
#ifndef LSYSC_FRONTEND_NATIVE_H
#define LSYSC_FRONTEND_NATIVE_H

#include "frontend/ast.h"

// As parse_file, for files in the native notation.
Ast *native_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                  const ParseOptions *options);

void native_dump_tokens(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                        const ParseOptions *options, FILE *out);

#endif
