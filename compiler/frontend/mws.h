// mws.h -- L-systems in the notation of a course: sections between `#` lines.
#ifndef LSYSC_FRONTEND_MWS_H
#define LSYSC_FRONTEND_MWS_H

#include "frontend/ast.h"

//   #axiom            word on the next line
//   #rules            rules up to `#end rules` or `#rules end`
//   A -> AB
//   B -> #stochastic  alternatives up to `#stochastic end` or `#end stochastic`
//   p=3 AB
//   p=1 B
//   # any other line that begins with # is a comment
//
// Words, guards and arguments are native; `+` turns clockwise, which the Ast
// says with a `turns:` statement. Never NULL; after errors it holds what could
// be read.
Ast *mws_parse(Arena *arena, Sources *sources, struct Diag *diag, const SourceFile *file, const ParseOptions *options);

// Is this such a file? A line says `#axiom` and nothing else.
bool mws_recognise(const SourceFile *file);

// What a line of such a file is.
typedef enum MwsLine {
  MWS_EMPTY,
  MWS_TEXT,
  MWS_COMMENT,
  MWS_AXIOM,
  MWS_RULES,
  MWS_RULES_END,
  MWS_STOCHASTIC,
  MWS_STOCHASTIC_END,
} MwsLine;

MwsLine mws_line(const char *at, const char *end);

#endif
