// fmt_adapt.h -- what has to be said otherwise when a cpfg file becomes native text.
#ifndef LSYSC_FRONTEND_FMT_ADAPT_H
#define LSYSC_FRONTEND_FMT_ADAPT_H

#include "frontend/ast.h"

// By statement. All false unless the Ast's rules ask for it.
typedef struct FmtAdaption {
  bool *omit;           // has no effect there, or would be an error here
  bool *weigh;          // a production without weight that counts 1
  bool no_environment;  // of the whole file: nobody answers ?E, which has to be said
} FmtAdaption;

FmtAdaption fmt_adapt(Arena *arena, const Ast *ast);

#endif
