// parse_error.h -- the words of the grammar's messages.
#ifndef LSYSC_FRONTEND_PARSE_ERROR_H
#define LSYSC_FRONTEND_PARSE_ERROR_H

#include "frontend/parser.h"

// Reports the token at span, where one of expected[0..count) could have stood; names may repeat.
void parse_error(Parser *parser, Span span, const char **expected, size_t count);

#endif
