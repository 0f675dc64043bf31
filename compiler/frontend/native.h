// native.h -- the notation of LANGUAGE.md, and cpfg's, which is near to it: files -> AST.
#ifndef LSYSC_FRONTEND_NATIVE_H
#define LSYSC_FRONTEND_NATIVE_H

#include "frontend/ast.h"

// As parse_file, for files in the native notation.
Ast *native_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                  const ParseOptions *options);

// The same for cpfg's files (LANGUAGE.md section 7).
Ast *cpfg_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file, const ParseOptions *options);

// Is this such a file? Its name ends with `.l`.
bool cpfg_recognise(const SourceFile *file);

// cpfg: in cpfg's notation.
void native_dump_tokens(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file,
                        const ParseOptions *options, bool cpfg, FILE *out);

#endif
