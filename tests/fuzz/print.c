// print.c -- random grammars in the native notation.
#include "grammar.h"

static void print_node(FILE *out, const Node *node) {
  switch (node->kind) {
  case NODE_NUMBER:
    fprintf(out, "%g", node->number);
    break;
  case NODE_FORMAL:
    fprintf(out, "%c", 'a' + node->slot);
    break;
  case NODE_DEFINE:
    fprintf(out, "K%d", node->slot);
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
    fprintf(out, "%s(", node->text);
    for (int i = 0; i < node->count; i++) {
      if (i) fputs(", ", out);
      print_node(out, node->kid[i]);
    }
    fputc(')', out);
    break;
  }
}

static void print_word(FILE *out, const FuzzWord *word) {
  if (word->count == 0) fputc('*', out);
  for (size_t i = 0; i < word->count; i++) {
    const FuzzModule *module = &word->at[i];
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
  if (rule->guard) {
    fputs(" : ", out);
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

void fuzz_print(const FuzzGrammar *grammar, FILE *out) {
  static const char *const headers[] = {NULL, "decomposition", "homomorphism"};
  for (size_t i = 0; i < grammar->defines.count; i++) {
    fprintf(out, "#define K%zu ", i);
    print_node(out, grammar->defines.at[i]);
    fputc('\n', out);
  }
  if (grammar->ring) fputs("ring lsystem\n", out);
  fprintf(out, "steps: %d\nseed: %llu\n", grammar->steps, (unsigned long long)grammar->seed);
  if (grammar->ignore) fprintf(out, "%s: %s\n", grammar->consider ? "consider" : "ignore", grammar->ignore);
  fputs("axiom: ", out);
  print_word(out, &grammar->axiom);
  fputc('\n', out);
  for (int section = 0; section < RULE_SECTIONS; section++) {
    bool open = section == RULE_DERIVATION;
    for (size_t i = 0; i < grammar->rules.count; i++) {
      if ((int)grammar->rules.at[i].section != section) continue;
      if (!open) fprintf(out, "%s\nmaximum depth: %d\n", headers[section], grammar->depth);
      open = true;
      print_rule(out, &grammar->rules.at[i]);
    }
  }
}
