// program_dump.c -- a Program as text (`--dump=program`): everything that later
// passes see, in a notation close to the grammar's.
#include "frontend/expr.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

typedef struct Dump {
  const Program *program;
  const char *const *slots;  // names of the production's slots, NULL outside of one
  FILE *out;
} Dump;

static void print(const Dump *dump, const Expr *expr) {
  expr_print(dump->program, expr, dump->slots, dump->out);
}

// ---- words ---------------------------------------------------------------------

static void print_arguments(const Dump *dump, Expr *const *args, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    fputs(i ? "," : "(", dump->out);
    print(dump, args[i]);
  }
  if (count) fputc(')', dump->out);
}

static void dump_word(const Dump *dump, const Word *word) {
  if (word->count == 0) fputs(" (empty)", dump->out);
  for (size_t i = 0; i < word->count; i++) {
    const Kind *kind = &dump->program->kinds[word->at[i].kind];
    fprintf(dump->out, " %s", kind->symbol);
    print_arguments(dump, word->at[i].args, kind->arity);
  }
}

static void dump_slots(const Dump *dump, uint32_t first, uint32_t count) {
  for (uint32_t slot = first; slot < first + count; slot++) {
    fputs(slot == first ? "(" : ",", dump->out);
    if (dump->slots[slot])
      fputs(dump->slots[slot], dump->out);
    else
      fprintf(dump->out, "$%u", slot);
  }
  if (count) fputc(')', dump->out);
}

static void dump_context(const Dump *dump, const Context *context) {
  static const char *const names[] = {
    [PATTERN_OPEN] = "[", [PATTERN_CLOSE] = "]", [PATTERN_REST] = "=", [PATTERN_END] = "@]"};
  for (size_t i = 0; i < context->count; i++) {
    const Pattern *pattern = &context->at[i];
    if (pattern->what != PATTERN_MODULE) {
      fprintf(dump->out, " %s", names[pattern->what]);
      continue;
    }
    const Kind *kind = &dump->program->kinds[pattern->kind];
    fprintf(dump->out, " %s", kind->symbol);
    dump_slots(dump, pattern->slot, kind->arity);
  }
}

// ---- blocks ----------------------------------------------------------------------

static void dump_actions(const Dump *dump, const Actions *actions, int indent);

static void dump_target(const Dump *dump, const Action *action) {
  const Program *program = dump->program;
  if (action->kind == ACTION_SET_VALUE) {
    fputs(program->values[action->slot - LSYS_SETTING_COUNT].name, dump->out);
  } else if (action->kind == ACTION_SET_LOCAL) {
    fputs(dump->slots[action->slot], dump->out);
  } else {
    fputs(program->arrays[action->slot].name, dump->out);
    for (uint32_t i = 0; i < action->index_count; i++) {
      fputc('[', dump->out);
      print(dump, action->index[i]);
      fputc(']', dump->out);
    }
  }
}

static void dump_condition(const Dump *dump, const char *word, const Expr *condition) {
  fprintf(dump->out, "%s (", word);
  print(dump, condition);
  fputs(")\n", dump->out);
}

static void dump_action(const Dump *dump, const Action *action, int indent) {
  fprintf(dump->out, "%*s", indent, "");
  switch (action->kind) {
  case ACTION_SET_LOCAL:
  case ACTION_SET_VALUE:
  case ACTION_SET_ELEMENT:
    dump_target(dump, action);
    fputs(" = ", dump->out);
    print(dump, action->value);
    fputc('\n', dump->out);
    break;
  case ACTION_IF:
  case ACTION_WHILE:
    dump_condition(dump, action->kind == ACTION_IF ? "if" : "while", action->value);
    dump_actions(dump, &action->then, indent + 2);
    if (action->otherwise.count) fprintf(dump->out, "%*selse\n", indent, "");
    dump_actions(dump, &action->otherwise, indent + 2);
    break;
  case ACTION_DO:
    fputs("do\n", dump->out);
    dump_actions(dump, &action->then, indent + 2);
    fprintf(dump->out, "%*s", indent, "");
    dump_condition(dump, "while", action->value);
    break;
  case ACTION_EVALUATE:
    print(dump, action->value);
    fputc('\n', dump->out);
    break;
  case ACTION_USE_TABLE:
    fprintf(dump->out, "use table %s\n", dump->program->lsystems[0].tables[action->slot]);
    break;
  }
}

static void dump_actions(const Dump *dump, const Actions *actions, int indent) {
  for (size_t i = 0; i < actions->count; i++) dump_action(dump, &actions->at[i], indent);
}

static void dump_block(const Dump *dump, const char *name, const Actions *actions, int indent) {
  if (actions->count == 0) return;
  fprintf(dump->out, "%*s%s\n", indent, "", name);
  dump_actions(dump, actions, indent + 2);
}

// ---- productions --------------------------------------------------------------------

static void dump_test(const Dump *dump, const char *name, const Expr *expr) {
  if (!expr) return;
  fprintf(dump->out, "    %s ", name);
  print(dump, expr);
  fputc('\n', dump->out);
}

static void dump_production(const Dump *outer, const LSystem *lsystem, const Production *production) {
  Dump inner = *outer, *dump = &inner;
  FILE *out = dump->out;
  dump->slots = production->slot_names;
  fprintf(out, "  production %u", production->number);
  if (production->label) fprintf(out, " %s", production->label);
  if (production->table >= 0) fprintf(out, " in table %s", lsystem->tables[production->table]);
  fputs(":", out);
  dump_context(dump, &production->left);
  if (production->left.count) fputs(" <", out);
  dump_context(dump, &production->strict);
  if (production->right.count) fputs(" >", out);
  dump_context(dump, &production->right);
  fputs("  -->", out);
  dump_word(dump, &production->successor);
  fputc('\n', out);
  dump_test(dump, "match", production->match);
  dump_block(dump, "before", &production->before, 4);
  dump_test(dump, "guard", production->guard);
  dump_test(dump, "weight", production->weight);
  dump_block(dump, "after", &production->after, 4);
}

static void dump_rewriting(const Dump *dump, const LSystem *lsystem, const char *name, const Rewriting *rewriting) {
  if (rewriting->productions.count == 0) return;
  fprintf(dump->out, "%s depth ", name);
  if (rewriting->depth)
    print(dump, rewriting->depth);
  else
    fputc('1', dump->out);
  if (rewriting->has_seed) fprintf(dump->out, " seed %" PRIu64, rewriting->seed);
  fprintf(dump->out, "%s\n", rewriting->warnings ? " warnings" : "");
  for (size_t i = 0; i < rewriting->productions.count; i++)
    dump_production(dump, lsystem, rewriting->productions.at[i]);
}

static void dump_lsystem(const Dump *dump, uint32_t number, const LSystem *lsystem) {
  FILE *out = dump->out;
  bool ignores = false;
  fprintf(out, "lsystem %u%s%s%s%s\n", number, lsystem->name ? " " : "", lsystem->name ? lsystem->name : "",
          lsystem->ring ? " ring" : "", lsystem->pseudo ? " pseudo" : "");
  for (size_t i = 0; i < dump->program->kind_count; i++) {
    if (!lsystem->ignored[i]) continue;
    fprintf(out, "%s %s/%u", ignores ? "" : "  ignore", dump->program->kinds[i].symbol, dump->program->kinds[i].arity);
    ignores = true;
  }
  if (ignores) fputc('\n', out);
  if (lsystem->schedule_count) fputs("  tables", out);
  for (size_t i = 0; i < lsystem->schedule_count; i++) fprintf(out, " %s", lsystem->tables[lsystem->schedule[i]]);
  if (lsystem->schedule_count) fputc('\n', out);
  for (size_t i = 0; i < lsystem->productions.count; i++) dump_production(dump, lsystem, lsystem->productions.at[i]);
  dump_rewriting(dump, lsystem, "decomposition", &lsystem->decomposition);
  dump_rewriting(dump, lsystem, "homomorphism", &lsystem->homomorphism);
}

// ---- values ---------------------------------------------------------------------------

static void dump_kinds(const Dump *dump) {
  for (size_t i = 0; i < dump->program->kind_count; i++) {
    const Kind *kind = &dump->program->kinds[i];
    fprintf(dump->out, "kind %zu: %s/%u", i, kind->symbol, kind->arity);
    if (kind->text) fprintf(dump->out, " \"%s\"", kind->text);
    for (uint32_t j = 0; kind->arg_names && j < kind->arity; j++)
      fprintf(dump->out, "%s%s", j ? "," : " (", kind->arg_names[j]);
    if (kind->arg_names && kind->arity) fputc(')', dump->out);
    if (kind->draws_subfigure) fputs(" surface", dump->out);
    fputc('\n', dump->out);
  }
}

static void dump_value(const Dump *dump, const Value *value) {
  static const char *const names[] = {[VALUE_DEFINE] = "define", [VALUE_PARAM] = "param", [VALUE_GLOBAL] = "global"};
  fprintf(dump->out, "%s %s", names[value->kind], value->name);
  if (value->init) {
    fputs(" = ", dump->out);
    print(dump, value->init);
  }
  if (value->low || value->high) {
    fputs(" in ", dump->out);
    if (value->low) print(dump, value->low);
    fputs("..", dump->out);
    if (value->high) print(dump, value->high);
  }
  if (value->known && value->init->kind != EXPR_NUMBER) {
    fputs("  is ", dump->out);
    print(dump, &(Expr){EXPR_NUMBER, .number = value->number});
  }
  fputc('\n', dump->out);
}

static void dump_function(const Dump *outer, const UserFunction *function) {
  Dump dump = {outer->program, function->slot_names, outer->out};
  fprintf(dump.out, "function %s", function->name);
  dump_slots(&dump, 0, function->arity);
  fputs(function->draws ? " draws = " : " = ", dump.out);
  print(&dump, function->body);
  fputc('\n', dump.out);
}

static void dump_values(const Dump *dump) {
  const Program *program = dump->program;
  for (size_t i = 0; i < program->value_count; i++) dump_value(dump, &program->values[program->value_order[i]]);
  for (size_t i = 0; i < program->function_count; i++) dump_function(dump, &program->functions[i]);
  for (size_t i = 0; i < program->array_count; i++) {
    const Array *array = &program->arrays[i];
    fprintf(dump->out, "array %s", array->name);
    for (uint32_t j = 0; j < array->dimensions; j++) fprintf(dump->out, "[%u]", array->sizes[j]);
    fprintf(dump->out, " at value %u\n", array->slot);
  }
  for (int i = 0; i < LSYS_SETTING_COUNT; i++) {
    if (!program->settings[i]) continue;
    fprintf(dump->out, "%s: ", lsys_settings[i].keyword);
    print(dump, program->settings[i]);
    fputc('\n', dump->out);
  }
}

static void dump_surface(const Dump *dump, const Surface *surface) {
  fprintf(dump->out, "surface %s: %s", surface->name, surface->path ? surface->path : surface->form);
  print_arguments(dump, surface->args, surface->count);
  fputc('\n', dump->out);
}

void program_dump(const Program *program, FILE *out) {
  const Dump dump = {program, NULL, out};
  fprintf(out, "program %s (%s), seed %" PRIu64 ", %u call%s of random functions\n", program->name,
          program->rules.dialect ? program->rules.dialect : "native", program->seed, program->sites,
          program->sites == 1 ? "" : "s");
  dump_kinds(&dump);
  dump_values(&dump);
  for (size_t i = 0; i < program->surface_count; i++) dump_surface(&dump, &program->surfaces[i]);
  for (size_t i = 0; i < program->contour_count; i++) {
    const LsysContour *c = &program->contours[i];
    fprintf(out, "contour %u: %s, %u pieces\n", c->number, c->closed ? "closed" : "open", c->pieces);
  }
  if (program->colour_count) fputs("colours:", out);
  for (size_t i = 0; i < program->colour_count; i++)
    fprintf(out, " #%06x%s", program->colours[i], i + 1 < program->colour_count ? "" : "\n");
  for (int i = 0; i < LSYS_PAGE_COUNT; i++)
    if (program->page[i]) fprintf(out, "%s: %s\n", lsys_page_settings[i].keyword, program->page[i]);
  dump_block(&dump, "start", &program->start, 0);
  dump_block(&dump, "start each", &program->start_each, 0);
  dump_block(&dump, "end each", &program->end_each, 0);
  dump_block(&dump, "end", &program->end, 0);
  for (size_t i = 0; i < program->axiom_count; i++) {
    fprintf(out, "axiom %zu:", i);
    dump_word(&dump, &program->axioms[i]);
    fputc('\n', out);
  }
  for (uint32_t i = 0; i < program->lsystem_count; i++) dump_lsystem(&dump, i, &program->lsystems[i]);
}
