// reader.h -- a file and what it includes -> the statements that count.
//
// Handles #include, #if and its kin, and keeps the #defines that they ask for.
#ifndef LSYSC_FRONTEND_READER_H
#define LSYSC_FRONTEND_READER_H

#include "frontend/parser.h"

typedef struct Reader Reader;

Reader *reader_create(Parser *parser, Sources *sources, const SourceFile *file, const ParseOptions *options);

// The next statement in the order of inclusion; NULL at the end. In the arena.
Statement *reader_next(Reader *reader);

#endif
