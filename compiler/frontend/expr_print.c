// expr_print.c -- a checked expression as text, with no more parentheses than
// precedence asks for. The precedences are operators.def's.
#include "frontend/expr.h"

#include "lsys/number.h"

#include <math.h>

typedef struct OperatorInfo {
  const char *spelling;
  int precedence;
  bool right;
} OperatorInfo;

static const OperatorInfo operators[OP_COUNT] = {
#define BINARY(id, spelling, precedence, right, doc) [OP_##id] = {spelling, precedence, right},
#define UNARY(id, spelling, precedence, doc) [OP_##id] = {spelling, precedence, true},
#include "lsys/operators.def"
};

enum { CHOICE_PRECEDENCE = 1, ATOM_PRECEDENCE = 100 };

static void print_number(double x, FILE *out) {
  char text[LSYS_NUMBER_SIZE];
  fwrite(text, 1, (size_t)(lsys_number_print(text, x) - text), out);
}

static int precedence_of(const Expr *expr) {
  switch (expr->kind) {
  case EXPR_UNARY:
  case EXPR_BINARY:
    return operators[expr->op].precedence;
  case EXPR_CHOICE:
    return CHOICE_PRECEDENCE;
  case EXPR_NUMBER:
    return signbit(expr->number) && !isnan(expr->number) ? operators[OP_NEG].precedence : ATOM_PRECEDENCE;
  default:
    return ATOM_PRECEDENCE;
  }
}

typedef struct Printer {
  const Program *program;
  const char *const *parameters;
  FILE *out;
} Printer;

static void print(const Printer *printer, const Expr *expr, int least);

static void print_list(const Printer *printer, const Expr *expr, const char *open, const char *between,
                       const char *close) {
  fputs(open, printer->out);
  for (uint32_t i = 0; i < expr->count; i++) {
    if (i) fputs(between, printer->out);
    print(printer, expr->args[i], 0);
  }
  fputs(close, printer->out);
}

static void print_slot(const Printer *printer, const Expr *expr) {
  const Program *program = printer->program;
  uint32_t slot = expr->slot;
  if (expr->kind == EXPR_PARAMETER && printer->parameters && printer->parameters[slot])
    fputs(printer->parameters[slot], printer->out);
  else if (expr->kind == EXPR_VALUE && slot >= LSYS_SETTING_COUNT)
    fputs(program->values[slot - LSYS_SETTING_COUNT].name, printer->out);
  else
    fprintf(printer->out, "$%u", slot);
}

static void print_operator(const Printer *printer, const Expr *expr) {
  const OperatorInfo *info = &operators[expr->op];
  if (expr->kind == EXPR_UNARY) {
    fputs(info->spelling, printer->out);
    print(printer, expr->args[0], info->precedence);
    return;
  }
  print(printer, expr->args[0], info->precedence + info->right);
  fprintf(printer->out, expr->op == OP_POW ? "%s" : " %s ", info->spelling);
  print(printer, expr->args[1], info->precedence + !info->right);
}

static void print_choice(const Printer *printer, const Expr *expr) {
  print(printer, expr->args[0], CHOICE_PRECEDENCE + 1);
  fputs(" ? ", printer->out);
  print(printer, expr->args[1], 0);
  fputs(" : ", printer->out);
  print(printer, expr->args[2], CHOICE_PRECEDENCE);
}

static void print_naked(const Printer *printer, const Expr *expr) {
  switch (expr->kind) {
  case EXPR_NUMBER:
    print_number(expr->number, printer->out);
    break;
  case EXPR_PARAMETER:
  case EXPR_VALUE:
    print_slot(printer, expr);
    break;
  case EXPR_ELEMENT:
    fputs(printer->program->arrays[expr->slot].name, printer->out);
    print_list(printer, expr, "[", "][", "]");
    break;
  case EXPR_UNARY:
  case EXPR_BINARY:
    print_operator(printer, expr);
    break;
  case EXPR_CHOICE:
    print_choice(printer, expr);
    break;
  case EXPR_CALL:
    fputs(lsys_functions[expr->function].name, printer->out);
    if (expr->site) fprintf(printer->out, "@%u", expr->site);
    print_list(printer, expr, "(", ", ", ")");
    break;
  case EXPR_APPLY:
    fputs(printer->program->functions[expr->slot].name, printer->out);
    print_list(printer, expr, "(", ", ", ")");
    break;
  case EXPR_STRING:
    fprintf(printer->out, "\"%s\"", expr->text);
    break;
  }
}

// least: the weakest precedence that needs no parentheses here.
static void print(const Printer *printer, const Expr *expr, int least) {
  bool parentheses = precedence_of(expr) < least;
  if (parentheses) fputc('(', printer->out);
  print_naked(printer, expr);
  if (parentheses) fputc(')', printer->out);
}

void expr_print(const Program *program, const Expr *expr, const char *const *parameters, FILE *out) {
  print(&(Printer){program, parameters, out}, expr, 0);
}
