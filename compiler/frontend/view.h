// view.h -- cpfg's view files: turtle defaults, surfaces, functions -> statements.
#ifndef LSYSC_FRONTEND_VIEW_H
#define LSYSC_FRONTEND_VIEW_H

#include "frontend/ast.h"

// Puts what the file of `--view` means before the statements of the grammar, as statements that those override.
void view_read(Arena *arena, Sources *sources, struct Diag *diag, const ParseOptions *options, Ast *ast);

#endif
