// fmt.c -- an Ast as text in the native notation.
//
// In: an Ast without errors. Out: one statement a line, keywords in the
// spelling of the tables, blanks where they help. Ensures: the text reads back
// as the same Ast but for spans, and printing that gives the same text.
#include "frontend/fmt.h"

#include "frontend/fmt_adapt.h"
#include "frontend/fmt_comment.h"
#include "frontend/fmt_word.h"
#include "lsys/settings.h"
#include "lsys/turtle.h"

#include <string.h>

typedef struct Printer {
  FmtWriter writer;
  FmtLines lines;
  const Ast *ast;
  FmtAdaption adaption;
} Printer;

#define OUT(printer) ((printer)->writer.out)

// ---- actions ---------------------------------------------------------------

enum { ONE_LINE = -1 };  // in place of an indentation

static void print_actions(Printer *printer, const AstActions *actions, int indent);

static void line_or_blank(Printer *printer, int indent) {
  if (indent == ONE_LINE)
    fputc(' ', OUT(printer));
  else
    fprintf(OUT(printer), "\n%*s", 2 * indent, "");
}

static void print_condition(Printer *printer, const char *keyword, const AstExpr *condition) {
  fprintf(OUT(printer), "%s (", keyword);
  fmt_expr(&printer->writer, condition);
  fputc(')', OUT(printer));
}

static void print_action(Printer *printer, const AstAction *action, int indent) {
  switch (action->kind) {
  case AST_ASSIGN:
    fmt_expr(&printer->writer, action->target);
    fputs(" = ", OUT(printer));
    fmt_expr(&printer->writer, action->value);
    fputc(';', OUT(printer));
    break;
  case AST_IF:
    print_condition(printer, "if", action->value);
    print_actions(printer, &action->then, indent);
    if (!action->otherwise.count) break;
    fputs(" else", OUT(printer));
    print_actions(printer, &action->otherwise, indent);
    break;
  case AST_WHILE:
    print_condition(printer, "while", action->value);
    print_actions(printer, &action->then, indent);
    break;
  case AST_DO:
    fputs("do", OUT(printer));
    print_actions(printer, &action->then, indent);
    print_condition(printer, " while", action->value);
    fputc(';', OUT(printer));
    break;
  case AST_EVALUATE:
    fmt_expr(&printer->writer, action->value);
    fputc(';', OUT(printer));
    break;
  }
}

// A blank and the actions in braces.
static void print_actions(Printer *printer, const AstActions *actions, int indent) {
  int inner = indent == ONE_LINE ? ONE_LINE : indent + 1;
  fputs(" {", OUT(printer));
  for (size_t i = 0; i < actions->count; i++) {
    line_or_blank(printer, inner);
    print_action(printer, actions->at[i], inner);
  }
  line_or_blank(printer, indent);
  fputc('}', OUT(printer));
}

// ---- statements ------------------------------------------------------------

static void print_production(Printer *printer, const AstProduction *production, bool weigh) {
  FILE *out = OUT(printer);
  if (production->label) fprintf(out, "%s : ", production->label);
  if (production->left.span.end) {
    fmt_word(&printer->writer, &production->left);
    fputs(" < ", out);
  }
  fmt_word(&printer->writer, &production->strict);
  if (production->right.span.end) {
    fputs(" > ", out);
    fmt_right(&printer->writer, &production->right);
  }
  if (production->guard || production->has_before || production->has_after) fputs(" :", out);
  if (production->has_before) print_actions(printer, &production->before, ONE_LINE);
  if (production->guard) {
    fputc(' ', out);
    fmt_closed_expr(&printer->writer, production->guard);
  } else if (production->has_before || production->has_after) {
    fputs(" *", out);
  }
  if (production->has_after) print_actions(printer, &production->after, ONE_LINE);
  fputs(" --> ", out);
  fmt_word(&printer->writer, &production->successor);
  if (production->weight || weigh) fputs(" : ", out);
  if (production->weight) fmt_closed_expr(&printer->writer, production->weight);
  if (weigh) fputc('1', out);
}

// (a, b), or the names behind blanks.
static void print_names(Printer *printer, const AstStatement *statement) {
  const AstSymbols *names = &statement->symbols;
  FILE *out = OUT(printer);
  for (size_t i = 0; i < names->count; i++)
    fprintf(out, "%s%s", !statement->has_params ? " " : i ? ", " : "(", names->at[i].name);
  if (statement->has_params) fputs(names->count ? ")" : "()", out);
}

// Symbols as a word, which says where blanks must stand.
static void print_symbols(Printer *printer, const AstSymbols *symbols) {
  Arena *arena = arena_create();
  AstWord word = {0};
  for (size_t i = 0; i < symbols->count; i++)
    *VEC_PUSH(arena, &word.modules) = (AstModule){.symbol = symbols->at[i].name, .span = symbols->at[i].span};
  fmt_word(&printer->writer, &word);
  arena_destroy(arena);
}

static void print_axiom(Printer *printer, const AstStatement *statement) {
  fputs("axiom: ", OUT(printer));
  for (size_t i = 0; i < statement->words.count; i++) {
    if (i) fputs(", ", OUT(printer));
    fmt_axiom(&printer->writer, &statement->words.at[i]);
  }
}

static void print_param(Printer *printer, const AstStatement *statement) {
  fprintf(OUT(printer), "param %s = ", statement->name);
  fmt_expr(&printer->writer, statement->value);
  if (!statement->low) return;
  fputs(" in ", OUT(printer));
  fmt_operand(&printer->writer, statement->low);
  fputs("..", OUT(printer));
  fmt_operand(&printer->writer, statement->high);
}

static void print_arrays(Printer *printer, const AstStatement *statement) {
  FILE *out = OUT(printer);
  fputs("define: {", out);
  for (size_t i = 0; i < statement->arrays.count; i++) {
    const AstArray *array = &statement->arrays.at[i];
    fprintf(out, "\n  array %s", array->name);
    for (size_t k = 0; k < array->sizes.count; k++) {
      fputc('[', out);
      fmt_expr(&printer->writer, array->sizes.at[k]);
      fputc(']', out);
    }
    for (size_t k = 0; k < array->values.count; k++) {
      fputs(k ? ", " : " = {", out);
      fmt_expr(&printer->writer, array->values.at[k]);
    }
    fputs(array->values.count ? "};" : ";", out);
  }
  fputs("\n}", out);
}

// "keyword value"; a form's file name stands without quotation marks.
static void print_value(Printer *printer, const char *keyword, const AstExpr *value) {
  fputs(keyword, OUT(printer));
  if (!value) return;
  fputc(' ', OUT(printer));
  fmt_expr(&printer->writer, value);
}

static void print_setting(Printer *printer, const AstStatement *statement) {
  fprintf(OUT(printer), "%s:", lsys_settings[statement->setting].keyword);
  if (statement->name)
    fprintf(OUT(printer), " %s", statement->name);
  else
    print_value(printer, "", statement->value);
}

// What gives a name a meaning.
// What is read from a file, or a surface of a simple form. What a view file names has a path of its own, and no name
// that could be written.
static void print_file(Printer *printer, const AstStatement *statement) {
  FILE *out = OUT(printer);
  const char *what = statement->kind == AST_SURFACE ? "surface"
                   : statement->kind == AST_CURVE   ? "curve"
                   : statement->kind == AST_CONTOUR ? "contour"
                                                    : "function";
  if (statement->name) {
    fprintf(out, "%s ", what);
    for (const char *c = statement->name; *c; c++) fputc(*c == '.' ? '_' : *c, out);
    fputc(':', out);
  } else {
    fputs("functions:", out);
  }
  const SourceFile *beside = statement->beside;
  const char *slash = beside ? strrchr(beside->path, '/') : NULL;
  if (slash && statement->value->kind == AST_STRING && *statement->value->text != '/')
    fprintf(out, " \"%.*s%s\"", (int)(slash + 1 - beside->path), beside->path, statement->value->text);
  else
    print_value(printer, "", statement->value);
  if (statement->low) print_value(printer, ",", statement->low);
}

static void print_definition(Printer *printer, const AstStatement *statement) {
  FILE *out = OUT(printer);
  switch (statement->kind) {
  case AST_DEFINE:
    fprintf(out, "#define %s", statement->name);
    if (statement->has_params) print_names(printer, statement);
    print_value(printer, "", statement->value);
    break;
  case AST_UNDEF:
    fprintf(out, "#undef %s", statement->name);
    break;
  case AST_PARAM:
    print_param(printer, statement);
    break;
  case AST_MODULES:
    if (statement->name)
      fprintf(out, "module %s", statement->name);
    else
      fputs("#modules", out);
    print_names(printer, statement);
    break;
  case AST_COLOURS:
    fputs("colours:", out);
    print_names(printer, statement);
    break;
  default:
    print_file(printer, statement);
    break;
  }
}

// What the productions behind it belong to, and how they are applied.
static void print_section(Printer *printer, const AstStatement *statement) {
  FILE *out = OUT(printer);
  switch (statement->kind) {
  case AST_DECOMPOSITION:
    fputs("decomposition", out);
    break;
  case AST_HOMOMORPHISM:
    fputs("homomorphism", out);
    break;
  case AST_PRODUCTIONS:
    fputs("productions", out);
    break;
  case AST_WARNINGS:
    fputs(": warnings", out);
    break;
  case AST_MAXIMUM_DEPTH:
    print_value(printer, "maximum depth:", statement->value);
    break;
  case AST_SECTION_SEED:
    print_value(printer, "seed:", statement->value);
    break;
  case AST_TABLE:
    fprintf(out, "table %s:", statement->name);
    break;
  case AST_TABLES:
    fputs("tables:", out);
    print_names(printer, statement);
    break;
  case AST_RING:
    fputs("ring lsystem", out);
    break;
  case AST_LSYSTEM:
    fprintf(out, "lsystem: %s", statement->name);
    break;
  default:
    fputs("endlsystem", out);
    break;
  }
}

static void print_statement(Printer *printer, const AstStatement *statement, bool weigh) {
  switch (statement->kind) {
  case AST_AXIOM:
    print_axiom(printer, statement);
    break;
  case AST_PRODUCTION:
    print_production(printer, statement->production, weigh);
    break;
  case AST_SETTING:
    print_setting(printer, statement);
    break;
  case AST_PAGE:
    fprintf(OUT(printer), "%s: %s", lsys_page_settings[statement->setting].keyword, statement->name);
    break;
  case AST_ENVIRONMENT:
    print_value(printer, "environment:", statement->value);
    break;
  case AST_IGNORE:
  case AST_CONSIDER:
    fputs(statement->kind == AST_IGNORE ? "ignore: " : "consider: ", OUT(printer));
    print_symbols(printer, &statement->symbols);
    break;
  case AST_BLOCK:
    fprintf(OUT(printer), "%s:", statement->name);
    print_actions(printer, &statement->actions, 0);
    break;
  case AST_ARRAYS:
    print_arrays(printer, statement);
    break;
  case AST_DEFINE:
  case AST_UNDEF:
  case AST_PARAM:
  case AST_MODULES:
  case AST_SURFACE:
  case AST_COLOURS:
  case AST_FUNCTION:
  case AST_CURVE:
  case AST_CONTOUR:
    print_definition(printer, statement);
    break;
  default:
    print_section(printer, statement);
    break;
  }
}

// ---- the file --------------------------------------------------------------

static void collect_names(Arena *arena, Printer *printer) {
  Trie *names = printer->writer.names = trie_create(arena);
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++)
    trie_intern(names, lsys_turtle[op].symbol, strlen(lsys_turtle[op].symbol));
  for (size_t i = 0; i < printer->ast->statements.count; i++) {
    const AstStatement *statement = &printer->ast->statements.at[i];
    if (statement->kind != AST_MODULES && statement->kind != AST_SURFACE) continue;
    if (statement->name) trie_intern(names, statement->name, strlen(statement->name));
    for (size_t k = 0; !statement->name && k < statement->symbols.count; k++)
      trie_intern(names, statement->symbols.at[k].name, strlen(statement->symbols.at[k].name));
  }
}

static void print_gap(Printer *printer, const char *at, const char *end) {
  const char *dialect = printer->ast->rules.dialect;
  if (at >= end) return;
  if (strcmp(dialect, "native") == 0)
    fmt_native_gap(&printer->lines, at, end);
  else
    fmt_foreign_gap(&printer->lines, dialect, at, end);
}

// A setting of a view file that the grammar states itself.
static bool is_overridden(const Ast *ast, const AstStatement *statement) {
  if (!statement->fallback || statement->kind != AST_SETTING) return false;
  for (size_t i = 0; i < ast->statements.count; i++) {
    const AstStatement *other = &ast->statements.at[i];
    if (other->kind == AST_SETTING && !other->fallback && other->setting == statement->setting) return true;
  }
  return false;
}

static void print_all(Printer *printer, const char *at, const char *end) {
  bool native = strcmp(printer->ast->rules.dialect, "native") == 0;
  if (printer->ast->extent.end) {
    // Of an entry's statements several lines may have become one: all comments come first.
    print_gap(printer, at, end);
    printer->lines.blank = false;
    at = end;
  }
  if (printer->adaption.no_environment) {
    fmt_begin_line(&printer->lines);
    fputs("environment: none", OUT(printer));
    fmt_end_line(&printer->lines);
  }
  for (size_t i = 0; i < printer->ast->statements.count; i++) {
    const AstStatement *statement = &printer->ast->statements.at[i];
    const char *text = fmt_text(&printer->writer, statement->span);
    const char *text_end = text + (text ? statement->span.end - statement->span.begin : 0);
    bool included = native && !text && !statement->fallback;
    if (included || is_overridden(printer->ast, statement) || printer->adaption.omit[i]) continue;
    if (text >= at) {
      print_gap(printer, at, text);
      at = text_end;
    }
    // A section's options stand behind its name.
    if (statement->kind != AST_WARNINGS) fmt_begin_line(&printer->lines);
    print_statement(printer, statement, printer->adaption.weigh[i]);
    bool more = i + 1 < printer->ast->statements.count && statement[1].kind == AST_WARNINGS;
    if (text && native && !more) fmt_inner_comments(&printer->lines, text, text_end);
  }
  print_gap(printer, at, end);
  fmt_end_line(&printer->lines);
}

void fmt_print(const Ast *ast, FILE *out) {
  Arena *arena = arena_create();
  Printer *printer = ARENA_NEW(arena, Printer);
  *printer = (Printer){.writer = {.arena = arena, .out = out, .file = ast->file}, .lines = {.out = out}, .ast = ast};
  if (strcmp(ast->rules.dialect, "cpfg") == 0) printer->writer.renamed = trie_create(arena);
  printer->adaption = fmt_adapt(arena, ast);
  collect_names(arena, printer);
  const char *at = ast->file->text, *end = at + ast->file->length;
  if (ast->extent.end) {
    end = at + (ast->extent.end - ast->file->base);
    at += ast->extent.begin - ast->file->base;
  }
  print_all(printer, at, end);
  arena_destroy(arena);
}
