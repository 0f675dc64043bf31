// print.c -- random grammars in the native notation.
#include "grammar.h"

#include <string.h>

static void print_node(FILE *out, const Node *node);

static void print_arguments(FILE *out, const Node *node) {
  for (int i = 0; i < node->count; i++) {
    fputs(i ? ", " : "(", out);
    print_node(out, node->kid[i]);
  }
  fputc(')', out);
}

static void print_node(FILE *out, const Node *node) {
  switch (node->kind) {
  case NODE_NUMBER:
    fprintf(out, "%g", node->number);
    break;
  case NODE_FORMAL:
    fprintf(out, "%c", 'a' + node->slot);
    break;
  case NODE_LOCAL:
    fputc('z', out);
    break;
  case NODE_DEFINE:
    fprintf(out, "K%d", node->slot);
    break;
  case NODE_APPLY:
    fprintf(out, "f%d", node->slot);
    print_arguments(out, node);
    break;
  case NODE_UNARY:
    fprintf(out, "%s(", node->text);
    print_node(out, node->kid[0]);
    fputc(')', out);
    break;
  case NODE_BINARY:
    fputc('(', out);
    print_node(out, node->kid[0]);
    fprintf(out, " %s ", node->text);
    print_node(out, node->kid[1]);
    fputc(')', out);
    break;
  case NODE_CHOICE:
    fputc('(', out);
    print_node(out, node->kid[0]);
    fputs(" ? ", out);
    print_node(out, node->kid[1]);
    fputs(" : ", out);
    print_node(out, node->kid[2]);
    fputc(')', out);
    break;
  case NODE_CALL:
    fputs(node->text, out);
    print_arguments(out, node);
    break;
  }
}

static void print_word(FILE *out, const FuzzWord *word) {
  if (word->count == 0) fputc('*', out);
  for (size_t i = 0; i < word->count; i++) {
    const FuzzModule *module = &word->at[i];
    if (strchr("ephlu", module->symbol))
      fprintf(out, "?%c", module->symbol - 'a' + 'A');
    else
      fputc(module->symbol, out);
    for (int k = 0; k < module->arity; k++) {
      fputc(k ? ',' : '(', out);
      print_node(out, module->arg[k]);
    }
    if (module->arity) fputc(')', out);
  }
}

static void print_rule(FILE *out, const FuzzRule *rule) {
  if (rule->left.count) {
    print_word(out, &rule->left);
    fputs(" < ", out);
  }
  print_word(out, &rule->strict);
  if (rule->right.count) {
    fputs(" > ", out);
    print_word(out, &rule->right);
  }
  if (rule->before || rule->guard) fputs(" :", out);
  if (rule->before) {
    fputs(" { z = ", out);
    print_node(out, rule->before);
    fputs("; }", out);
  }
  if (rule->guard) {
    fputc(' ', out);
    print_node(out, rule->guard);
  }
  fputs(" --> ", out);
  print_word(out, &rule->successor);
  if (rule->weight) {
    fputs(" : ", out);
    print_node(out, rule->weight);
  }
  fputc('\n', out);
}

// The rules of an L-system's section and table, in their order.
static void print_rules(const FuzzGrammar *grammar, int system, RuleSection section, int table, FILE *out) {
  for (size_t i = 0; i < grammar->rules.count; i++) {
    const FuzzRule *rule = &grammar->rules.at[i];
    if (rule->system == system && rule->section == section && rule->table == table) print_rule(out, rule);
  }
}

static bool has_rules(const FuzzGrammar *grammar, int system, RuleSection section) {
  bool found = false;
  for (size_t i = 0; i < grammar->rules.count; i++)
    found |= grammar->rules.at[i].system == system && grammar->rules.at[i].section == section;
  return found;
}

static void print_statements(const FuzzGrammar *grammar, FILE *out) {
  for (size_t i = 0; i < grammar->functions.count; i++) {
    fprintf(out, "#define f%zu(a, b) ", i);
    print_node(out, grammar->functions.at[i]);
    fputc('\n', out);
  }
  for (size_t i = 0; i < grammar->defines.count; i++) {
    fprintf(out, "#define K%zu ", i);
    print_node(out, grammar->defines.at[i]);
    fputc('\n', out);
  }
  if (grammar->environment) fprintf(out, "environment: %s\n", grammar->environment);
  if (grammar->ring) fputs("ring lsystem\n", out);
  fprintf(out, "steps: %d\nseed: %llu\n", grammar->steps, (unsigned long long)grammar->seed);
  if (grammar->ignore) fprintf(out, "%s: %s\n", grammar->consider ? "consider" : "ignore", grammar->ignore);
  if (grammar->schedule) fprintf(out, "tables: %s\n", grammar->schedule);
  fputs("axiom: ", out);
  print_word(out, &grammar->axiom);
  fputc('\n', out);
}

static void print_sections(const FuzzGrammar *grammar, int system, FILE *out) {
  static const char *const headers[] = {NULL, "decomposition", "homomorphism"};
  for (RuleSection section = RULE_DECOMPOSITION; section < RULE_SECTIONS; section++) {
    if (!has_rules(grammar, system, section)) continue;
    fprintf(out, "%s\nmaximum depth: %d\n", headers[section], grammar->depth);
    print_rules(grammar, system, section, -1, out);
  }
}

static void print_nested(const FuzzGrammar *grammar, FILE *out) {
  fputs("lsystem: nested\n", out);
  if (grammar->ignore_nested) fprintf(out, "ignore: %s\n", grammar->ignore_nested);
  print_rules(grammar, 1, RULE_DERIVATION, -1, out);
  print_sections(grammar, 1, out);
  fputs("endlsystem\n", out);
}

void fuzz_print(const FuzzGrammar *grammar, FILE *out) {
  print_statements(grammar, out);
  print_rules(grammar, 0, RULE_DERIVATION, -1, out);
  for (int table = 0; grammar->schedule && table < FUZZ_TABLES; table++) {
    fprintf(out, "table t%d:\n", table);
    print_rules(grammar, 0, RULE_DERIVATION, table, out);
  }
  print_sections(grammar, 0, out);
  if (grammar->nested) print_nested(grammar, out);
}
