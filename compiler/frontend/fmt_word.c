// fmt_word.c -- words and expressions in the native notation.
//
// In: AstWord, AstExpr. Out: text that scans and parses as the same modules
// and the same tree, with parentheses where the precedences of operators.def
// ask for them and nowhere else.
#include "frontend/fmt_word.h"

#include "lsys/number.h"
#include "lsys/quote.h"
#include "support/utf8.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *fmt_text(const FmtWriter *writer, Span span) {
  const SourceFile *file = writer->file;
  bool inside = span.begin >= file->base && span.end > span.begin && span.end - file->base <= file->length;
  return inside ? file->text + (span.begin - file->base) : NULL;
}

// ---- numbers ---------------------------------------------------------------

enum { LONGEST_NUMBER = 64 };

// Copies a number as the user spelled it; false if the text is no spelling of this value.
static bool spelled(const FmtWriter *writer, const AstExpr *expr, char digits[LONGEST_NUMBER]) {
  const char *text = fmt_text(writer, expr->span);
  size_t length = expr->span.end - expr->span.begin;
  if (!text || length >= LONGEST_NUMBER || !(isdigit((unsigned char)*text) || *text == '.')) return false;
  memcpy(digits, text, length);
  digits[length] = 0;
  char *end;
  return strtod(digits, &end) == expr->number && *end == 0 && !strpbrk(digits, "xX");
}

static void print_number(const FmtWriter *writer, const AstExpr *expr) {
  char digits[LONGEST_NUMBER];
  if (spelled(writer, expr, digits))
    fputs(digits, writer->out);
  else if (isinf(expr->number))
    fputs("1e999", writer->out);  // `inf` would be a name
  else
    fwrite(digits, 1, (size_t)(lsys_number_print(digits, expr->number) - digits), writer->out);
}

// ---- expressions -----------------------------------------------------------

enum { CHOICE_PRECEDENCE = 1, OPERAND_PRECEDENCE = 100 };

static const struct {
  const char *spelling;
  int precedence;
  bool right;
} operators[OP_COUNT] = {
#define BINARY(id, spelling, precedence, right, doc) [OP_##id] = {spelling, precedence, right},
#define UNARY(id, spelling, precedence, doc) [OP_##id] = {spelling, precedence, false},
#include "lsys/operators.def"
};

static int precedence_of(const AstExpr *expr) {
  switch (expr->kind) {
  case AST_CHOICE:
    return CHOICE_PRECEDENCE;
  case AST_UNARY:
  case AST_BINARY:
    return operators[expr->op].precedence;
  default:
    return OPERAND_PRECEDENCE;
  }
}

static void print_expr(const FmtWriter *writer, const AstExpr *expr);

static void print_if(const FmtWriter *writer, const AstExpr *expr, bool parentheses) {
  if (parentheses) fputc('(', writer->out);
  print_expr(writer, expr);
  if (parentheses) fputc(')', writer->out);
}

static void print_list(const FmtWriter *writer, const AstExprs *list, const char *open, const char *close) {
  fputs(open, writer->out);
  for (size_t i = 0; i < list->count; i++) {
    if (i) fputs(", ", writer->out);
    print_expr(writer, list->at[i]);
  }
  fputs(close, writer->out);
}

// A sign on the right of an operator gets parentheses although it needs none: a-(-b).
static void print_binary(const FmtWriter *writer, const AstExpr *expr) {
  int precedence = operators[expr->op].precedence;
  bool right = operators[expr->op].right;
  bool wide = precedence < operators[OP_ADD].precedence;
  int left_precedence = precedence_of(expr->a), right_precedence = precedence_of(expr->b);
  print_if(writer, expr->a, left_precedence < precedence || (left_precedence == precedence && right));
  fprintf(writer->out, wide ? " %s " : "%s", operators[expr->op].spelling);
  print_if(writer, expr->b,
           right_precedence < precedence || (right_precedence == precedence && !right)
             || (!wide && expr->b->kind == AST_UNARY));
}

static void print_expr(const FmtWriter *writer, const AstExpr *expr) {
  switch (expr->kind) {
  case AST_NUMBER:
    print_number(writer, expr);
    break;
  case AST_STRING:
    fmt_string(writer, expr->text);
    break;
  case AST_NAME:
    fputs(expr->name, writer->out);
    break;
  case AST_UNARY:
    fputs(operators[expr->op].spelling, writer->out);
    print_if(writer, expr->a, precedence_of(expr->a) < operators[expr->op].precedence || expr->a->kind == AST_UNARY);
    break;
  case AST_BINARY:
    print_binary(writer, expr);
    break;
  case AST_CHOICE:
    print_if(writer, expr->a, precedence_of(expr->a) <= CHOICE_PRECEDENCE);
    fputs(" ? ", writer->out);
    print_expr(writer, expr->b);
    fputs(" : ", writer->out);
    print_expr(writer, expr->c);
    break;
  case AST_CALL:
    fputs(expr->name, writer->out);
    print_list(writer, &expr->args, "(", ")");
    break;
  case AST_INDEX:
    fputs(expr->name, writer->out);
    for (size_t i = 0; i < expr->args.count; i++) {
      fputc('[', writer->out);
      print_expr(writer, expr->args.at[i]);
      fputc(']', writer->out);
    }
    break;
  case AST_POISON:
    break;
  }
}

void fmt_expr(const FmtWriter *writer, const AstExpr *expr) {
  print_expr(writer, expr);
}

void fmt_closed_expr(const FmtWriter *writer, const AstExpr *expr) {
  print_if(writer, expr, expr->kind == AST_CHOICE);
}

void fmt_operand(const FmtWriter *writer, const AstExpr *expr) {
  bool sign = expr->kind == AST_UNARY && precedence_of(expr->a) == OPERAND_PRECEDENCE;
  print_if(writer, expr, !sign && precedence_of(expr) < OPERAND_PRECEDENCE);
}

void fmt_string(const FmtWriter *writer, const char *text) {
  char *quoted = arena_array(writer->arena, lsys_quoted_size(text), 1);
  fwrite(quoted, 1, (size_t)(lsys_quote(quoted, text) - quoted), writer->out);
}

// ---- words -----------------------------------------------------------------

// cpfg's symbols are characters, or `@` and any other; those that mean something else here, or nothing at all,
// become N_ and their codes.
static const char *symbol_of(const FmtWriter *writer, const char *symbol) {
  size_t length = strlen(symbol);
  if (!writer->renamed) return symbol;
  bool known = *symbol != '@' || strcmp(symbol, "@]") == 0 || trie_find(writer->names, symbol, length);
  if (known && (writer->skips || strcmp(symbol, "=") != 0)) return symbol;
  void **place = trie_at(writer->renamed, symbol, length);
  if (!*place) {
    char *name = arena_printf(writer->arena, "N_%u", (unsigned char)*symbol);
    for (size_t i = 1; i < length; i++) name = arena_printf(writer->arena, "%s%03u", name, (unsigned char)symbol[i]);
    *place = name;
  }
  return *place;
}

// Bytes of the longest symbol that the modules from i on would scan as, were they printed without blanks.
static size_t longest_symbol(const FmtWriter *writer, const AstWord *word, size_t i) {
  enum { LOOK_AHEAD = 64 };  // bytes; no declared name that matters is longer
  char text[LOOK_AHEAD];
  size_t length = 0;
  for (; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    const char *symbol = symbol_of(writer, module->symbol);
    size_t size = strlen(symbol);
    if (length + size > LOOK_AHEAD) break;
    memcpy(text + length, symbol, size);
    length += size;
    if (module->args.count || module->parens) break;
  }
  size_t named = trie_longest(writer->names, text, length), one = utf8_length(text, text + length);
  bool letter = one > 1 || (length && isalpha((unsigned char)text[0]));
  if (letter && one + 1 < length && text[one] == '_' && isalnum((unsigned char)text[one + 1])) {
    one += 2;
    if (isdigit((unsigned char)text[one - 1]))
      while (one < length && isdigit((unsigned char)text[one])) one++;
  } else if (length > 1 && text[0] == '?' && isalpha((unsigned char)text[1])) {
    one = 2;
  }
  return named > one ? named : one;
}

// Does white space stand behind the first of two modules?
static bool apart(const FmtWriter *writer, const AstModule *a, const AstModule *b) {
  const char *text = b->span.begin > a->span.end ? fmt_text(writer, (Span){a->span.end, b->span.begin}) : NULL;
  return text && isspace((unsigned char)*text);
}

static bool needs_blank(const FmtWriter *writer, const AstWord *word, size_t i) {
  const AstModule *a = &word->modules.at[i], *b = &word->modules.at[i + 1];
  if (a->parens || a->args.count) return false;
  // `/*` begins a comment; so does `//` where a statement begins.
  if (strcmp(a->symbol, "/") == 0 && (b->symbol[0] == '*' || (i == 0 && b->symbol[0] == '/'))) return true;
  return longest_symbol(writer, word, i) > strlen(symbol_of(writer, a->symbol));
}

static void print_word(const FmtWriter *writer, const AstWord *word, bool axiom) {
  if (word->modules.count == 0) fputc('*', writer->out);
  bool blank = true;
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    bool last = i + 1 == word->modules.count;
    fputs(symbol_of(writer, module->symbol), writer->out);
    // A `\` between a blank and the line's end would join the next line.
    bool joins = blank && last && strcmp(module->symbol, "\\") == 0;
    if (module->args.count || module->parens || joins || (axiom && strcmp(module->symbol, ",") == 0))
      print_list(writer, &module->args, "(", ")");
    blank = !last && (apart(writer, module, module + 1) || needs_blank(writer, word, i));
    if (blank) fputc(' ', writer->out);
  }
}

void fmt_word(const FmtWriter *writer, const AstWord *word) {
  print_word(writer, word, false);
}

// A literal `]` asks that the branch end there: `@]`, unless `=` skipped its rest, and `]` again if it was opened in
// the context. Behind the end of the module's own branch nothing can be asked for here.
void fmt_right(const FmtWriter *writer, const AstWord *word) {
  if (!writer->renamed) {
    fmt_word(writer, word);
    return;
  }
  size_t depth = 0;
  AstWord native = {0};
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    bool close = strcmp(module->symbol, "]") == 0;
    depth += strcmp(module->symbol, "[") == 0;
    bool skipped = i > 0 && strcmp(word->modules.at[i - 1].symbol, "=") == 0;
    if (close && !skipped)
      *VEC_PUSH(writer->arena, &native.modules) = (AstModule){.symbol = "@]", .span = module->span};
    if (close && depth == 0) break;
    depth -= close;
    *VEC_PUSH(writer->arena, &native.modules) = *module;
  }
  FmtWriter skipping = *writer;
  skipping.skips = true;
  fmt_word(&skipping, &native);
  if (native.modules.count < word->modules.count) fputs(" /* cpfg looks on behind the branch */", writer->out);
}

void fmt_axiom(const FmtWriter *writer, const AstWord *word) {
  print_word(writer, word, true);
}
