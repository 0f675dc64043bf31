// fractint_word.c -- a string of Fractint's commands -> a word of our turtle's symbols.
//
// In: the pieces of one string. Out: modules whose symbols are interned in
// FractintWords. Ensures: brackets are balanced (what is cut off is reported),
// numbers belong to the command before them. Meaning read off lsys.c of
// Fractint 20 and Iterated Dynamics.
#include "frontend/fractint_word.h"

#include "support/diag.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// Commands whose symbol differs from their character; the letters that are no
// commands become capitals, what is left N_ and its code.
static const char *const renamed[256] = {
  ['f'] = "F", ['g'] = "f",  ['d'] = "@d", ['m'] = "@m", ['+'] = "+",   ['-'] = "-",  ['['] = "[",  [']'] = "]",
  ['|'] = "|", ['!'] = "@x", ['@'] = "@s", ['/'] = "@a", ['\\'] = "@a", ['<'] = "@n", ['>'] = "@p", ['c'] = ";",
};

const char *fractint_symbol(FractintWords *words, unsigned char character) {
  const char **symbol = &words->symbols[character];
  if (*symbol) return *symbol;
  if (character == '\\') return *symbol = fractint_symbol(words, '/');
  if (renamed[character]) return *symbol = renamed[character];
  if (isascii(character) && isalnum(character))
    return *symbol = arena_printf(words->build.arena, "%c", toupper(character));
  return *symbol = arena_printf(words->build.arena, "N_%u", character);
}

// ---- reading the string ----------------------------------------------------

typedef struct Cursor {
  const FractintWords *words;
  const FractintString *string;
  size_t piece;
  uint32_t at;  // in the piece; meaningless behind the last one
} Cursor;

static void settle(Cursor *in) {
  while (in->piece < in->string->count && in->at >= in->string->at[in->piece].end) {
    in->piece++;
    if (in->piece < in->string->count) in->at = in->string->at[in->piece].begin;
  }
}

// The character that stands next, in lower case; 0 at the end.
static unsigned char peek(const Cursor *in) {
  if (in->piece == in->string->count) return 0;
  unsigned char c = (unsigned char)in->words->file->text[in->at - in->words->file->base];
  return c >= 'A' && c <= 'Z' ? (unsigned char)(c + ('a' - 'A')) : c;
}

static unsigned char next(Cursor *in) {
  unsigned char c = peek(in);
  in->at++;
  settle(in);
  return c;
}

// From begin to where the cursor stands, as far as that is in the same piece.
static Span since(const Cursor *in, size_t piece, uint32_t begin) {
  bool same = in->piece == piece && in->at > begin;
  return (Span){begin, same ? in->at : in->string->at[piece].end};
}

// ---- numbers ---------------------------------------------------------------

typedef struct Number {
  double value;
  bool root, inverse;
  bool given;
  Span span;
} Number;

// What may follow @ / \ c < >: up to two letters q (root) and i (inverse), then digits and dots.
static Number number(Cursor *in, Span command) {
  Number result = {.span = command};
  size_t piece = in->piece;
  uint32_t begin = in->at;
  for (int i = 0; i < 2 && (peek(in) == 'q' || peek(in) == 'i'); i++)
    *(next(in) == 'q' ? &result.root : &result.inverse) = true;
  VEC(char) digits = {0};
  bool dot = false, odd = false;
  for (unsigned char c; isdigit(c = peek(in)) || c == '.'; next(in)) {
    odd |= c == '.' && dot;
    dot |= c == '.';
    if (!odd) *VEC_PUSH(in->words->build.arena, &digits) = (char)c;
  }
  if (digits.count) {
    *VEC_PUSH(in->words->build.arena, &digits) = 0;
    result.given = true;
    result.value = strtod(digits.at, NULL);
    result.span = since(in, piece, begin);
  }
  if (odd)
    diag_warning(in->words->build.diag, WARN_DIALECT, since(in, piece, begin),
                 "a number with two points; what stands from the second on is ignored");
  return result;
}

// sqrt(n), 1/n and 1/sqrt(n) are kept as written; what is not positive counts as 0.
static AstExpr *number_expr(FractintWords *words, const Number *n) {
  AstExpr *expr = ast_number(words->build, n->span, n->value > 0 ? n->value : 0);
  if (!(n->value > 0)) return expr;
  if (n->root) {
    AstExprs args = {0};
    *VEC_PUSH(words->build.arena, &args) = expr;
    expr = ast_call(words->build, n->span, n->span, "sqrt", args);
  }
  return n->inverse ? ast_binary(words->build, OP_DIV, ast_number(words->build, n->span, 1), expr) : expr;
}

// A number of colours: whole, below 256.
static AstExpr *colours(FractintWords *words, const Number *n) {
  double value = n->value > 0 ? n->root ? sqrt(n->value) : n->value : 0;
  if (n->inverse && value > 0) value = 1 / value;
  return ast_number(words->build, n->span, fmod(trunc(value), 256));
}

// ---- commands --------------------------------------------------------------

// `|` adds floor(n/2) units: with odd n no half circle, so the angle is said.
// The units go clockwise; counted to the left they are (n+1)/2.
static AstExpr *around(FractintWords *words, Span span) {
  if (words->angle % 2 == 0) return NULL;
  AstExpr *circle = ast_number(words->build, span, 360), *angle = ast_number(words->build, span, words->angle);
  AstExpr *unit = ast_binary(words->build, OP_DIV, circle, angle);
  return ast_binary(words->build, OP_MUL, unit, ast_number(words->build, span, (words->angle + 1) / 2));
}

// The argument of a command, NULL for one that has none.
static AstExpr *argument(FractintWords *words, Cursor *in, unsigned char command, Span span) {
  if (command == '|') return around(words, span);
  if (!strchr("@/\\c<>", command)) return NULL;
  Number n = number(in, span);
  if (command == '@' && !(n.value > 0))
    diag_warning(words->build.diag, WARN_DIALECT, span_join(span, n.span),
                 n.given ? "the step is multiplied by 0" : "`@` without a number multiplies the step by 0");
  if (command == '@') return number_expr(words, &n);
  // Both turns of the second direction are one symbol: `\` to the left, `/` to the right.
  if (command == '\\' || command == '/') {
    AstExpr *angle = number_expr(words, &n);
    return command == '/' ? ast_unary(words->build, angle->span, OP_NEG, angle) : angle;
  }
  return colours(words, &n);
}

AstWord fractint_word(FractintWords *words, const FractintString *string) {
  AstWord word = {0};
  Cursor in = {words, string, 0, string->count ? string->at[0].begin : 0};
  settle(&in);
  VEC(Span) open = {0};
  while (in.piece < string->count) {
    size_t piece = in.piece;
    uint32_t begin = in.at;
    unsigned char c = next(&in);
    Span span = {begin, begin + 1};
    if (c < ' ' || c == 0x7F) {
      diag_error(words->build.diag, span, "unprintable character (code %u) in a string of commands", c);
      continue;
    }
    if (c == '[') *VEC_PUSH(words->build.arena, &open) = span;
    if (c == ']' && open.count-- == 0) {
      diag_warning(words->build.diag, WARN_DIALECT, span,
                   "`]` without `[` ends the rule here; what stands behind it is ignored");
      return word;
    }
    AstExpr *arg = argument(words, &in, c, span);
    AstModule *module = VEC_PUSH(words->build.arena, &word.modules);
    *module = (AstModule){.symbol = fractint_symbol(words, c), .span = since(&in, piece, begin), .symbol_span = span};
    if (!arg)
      module->span = span;
    else
      *VEC_PUSH(words->build.arena, &module->args) = arg;
    module->parens = arg != NULL;
    word.span = span_join(word.span, module->span);
  }
  if (open.count)
    diag_error(words->build.diag, open.at[open.count - 1],
               "`[` is never closed in this string; brackets must pair within one rule");
  for (; open.count; open.count--)  // one message is enough
    *VEC_PUSH(words->build.arena, &word.modules) = (AstModule){
      .symbol = fractint_symbol(words, ']'), .span = open.at[open.count - 1], .symbol_span = open.at[open.count - 1]};
  return word;
}
