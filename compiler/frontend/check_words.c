// check_words.c -- modules: words of axioms and successors, and the patterns of
// predecessors with their formal parameters. Context matching as in ABOP p. 30-32.
#include "frontend/check.h"

#include <math.h>
#include <string.h>

static bool is_symbol(const AstModule *module, const char *symbol) {
  return strcmp(module->symbol, symbol) == 0;
}

// ---- words -----------------------------------------------------------------------

// `?(NAME, scale)` names a sub-L-system; in the Program it is the number that it is called by.
static Expr *subsystem(Check *check, const AstExpr *ast) {
  const char *name = ast->kind == AST_NAME ? ast->name : NULL;
  if (ast->kind == AST_NUMBER) name = arena_printf(check->arena, "%.17g", ast->number);
  if (!name) return check_expression(check, ast);
  bool known = map_find(check->system_map, name, 0) != MAP_NONE;
  bool number = ast->kind == AST_NUMBER && ast->number < 1e9
             && map_find(check->called_map, NULL, (uint64_t)ast->number) != MAP_NONE;
  bool bound = ast->kind == AST_NAME && name_is_bound(check, name_intern(check, name));
  if (!known && (number || bound)) return check_expression(check, ast);
  uint32_t index = system_named(check, name, ast->span);
  return index == NONE ? check->poison : expr_number(check->arena, (double)check->systems.at[index]->called, ast->span);
}

// What a label says, `@L("%.2f", x)`: it belongs to the kind, and the other arguments are numbers. NULL: no text.
static const char *label_text(Check *check, const AstModule *module) {
  if (!is_symbol(module, "@L") || module->args.count == 0 || module->args.at[0]->kind != AST_STRING) return NULL;
  check_format(check, module->symbol, module->args.at[0], module->args.count - 1, module->span);
  return module->args.at[0]->text;
}

static Expr **module_arguments(Check *check, const AstModule *module, size_t first) {
  if (module->args.count == first) return NULL;
  if (first) {
    AstExprs rest = {module->args.at + first, module->args.count - first, module->args.count - first};
    return check_arguments(check, &rest);
  }
  if (!is_symbol(module, "?")) return check_arguments(check, &module->args);
  Expr **args = arena_array(check->arena, module->args.count, sizeof(Expr *));
  args[0] = subsystem(check, module->args.at[0]);
  for (size_t i = 1; i < module->args.count; i++) args[i] = check_expression(check, module->args.at[i]);
  return args;
}

// Warns at the first `]` that closes nothing and at the last `[` that is never closed.
static void check_balance(Check *check, const AstWord *word, const char *what) {
  VEC(size_t) open = {0};
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    if (is_symbol(module, "[")) {
      *VEC_PUSH(check->arena, &open) = i;
    } else if (is_symbol(module, "]") && open.count) {
      open.count--;
    } else if (is_symbol(module, "]")) {
      diag_warning(check->diag, WARN_BRACKETS, module->symbol_span, "this `]` closes no `[` of the %s", what);
      return;
    }
  }
  if (open.count == 0) return;
  const AstModule *module = &word->modules.at[open.at[open.count - 1]];
  diag_warning(check->diag, WARN_BRACKETS, module->symbol_span, "this `[` is not closed in the %s", what);
}

Word check_word(Check *check, const AstWord *word, const char *what) {
  Word result = {arena_array(check->arena, word->modules.count, sizeof(Module)), word->modules.count};
  for (size_t i = 0; i < result.count; i++) {
    const AstModule *module = &word->modules.at[i];
    if (is_symbol(module, "@]"))
      diag_error(check->diag, module->symbol_span,
                 "`@]` asks for the end of a branch and can only stand in a right context");
    const char *text = label_text(check, module);
    size_t first = text != NULL;
    KindId kind = kind_of(check, module->symbol, text, module->args.count - first, module->span);
    result.at[i] = (Module){kind, module_arguments(check, module, first), module->span};
  }
  check_balance(check, word, what);
  return result;
}

// ---- formal parameters ------------------------------------------------------------

static void tell_hidden(Check *check, const Name *name, Span span) {
  Definition *definition = name_definition(check, name);
  if (definition && !definition->hiding_told) {
    definition->hiding_told = true;
    diag_remark(check->diag, span, "here the parameter `%s` hides the %s of that name", name->text,
                definition->param ? "param" : "#define");
    diag_note(check->diag, definition->span, "it is defined here");
  } else if (name->global != NONE) {
    diag_remark(check->diag, span, "here the parameter `%s` hides the global variable of that name", name->text);
  }
}

void check_formal(Check *check, const char *text, Span span) {
  Name *name = name_intern(check, text);
  const Slot *other = check_bound(check, name);
  if (other) {
    diag_error(check->diag, span, "parameter `%s` is used twice", text);
    diag_note(check->diag, other->span, "the first `%s` is here", text);
    if (check->scope.kind == SCOPE_PRODUCTION)
      diag_hint(check->diag, "to ask for equal values use two names and a condition: `: %s == %s2`", text, text);
  } else {
    tell_hidden(check, name, span);
  }
  check_bind(check, text, span);
}

// A number in a formal position: the argument has to equal it.
static void literal(Check *check, double value, Span span) {
  uint32_t slot = check_bind(check, NULL, span);
  Expr *parts = arena_array(check->arena, 3, sizeof(Expr));
  Expr **args = arena_array(check->arena, 2, sizeof(Expr *));
  parts[0] = (Expr){EXPR_PARAMETER, .slot = slot, .span = span};
  parts[1] = (Expr){EXPR_NUMBER, .number = value, .span = span};
  parts[2] = (Expr){EXPR_BINARY, .op = OP_EQ, .args = args, .count = 2, .span = span};
  args[0] = &parts[0];
  args[1] = &parts[1];
  *VEC_PUSH(check->arena, &check->literals) = &parts[2];
}

// The names of a refused expression are not told to be unknown as well.
static void excuse_names(Check *check, const AstExpr *expr) {
  if (!expr) return;
  if (expr->kind == AST_NAME) name_intern(check, expr->name)->told = check->scope.number;
  excuse_names(check, expr->a);
  excuse_names(check, expr->b);
  excuse_names(check, expr->c);
  for (size_t i = 0; i < expr->args.count; i++) excuse_names(check, expr->args.at[i]);
}

static void formal(Check *check, const AstExpr *arg) {
  if (arg->kind == AST_NAME) {
    check_formal(check, arg->name, arg->span);
  } else if (arg->kind == AST_NUMBER) {
    literal(check, arg->number, arg->span);
  } else if (arg->kind == AST_UNARY && arg->op == OP_NEG && arg->a->kind == AST_NUMBER) {
    literal(check, -arg->a->number, arg->span);
  } else {
    check_bind(check, NULL, arg->span);
    if (arg->kind == AST_POISON) return;
    excuse_names(check, arg);
    diag_error(check->diag, arg->span, "a parameter of a predecessor is a name or a number");
    diag_hint(check->diag, "ask for a value in the condition: `A(x) : x == ... --> ...`");
  }
}

// ---- patterns --------------------------------------------------------------------------

static PatternKind refuse(Check *check, const AstModule *module, Side side) {
  if (is_symbol(module, "@]")) {
    diag_error(check->diag, module->symbol_span,
               "`@]` asks for the end of a branch and can only stand in a right context");
  } else if (side == SIDE_STRICT) {
    diag_error(check->diag, module->symbol_span, "`%s` cannot be replaced alone: brackets keep branches together",
               module->symbol);
    diag_hint(check->diag, "a whole branch can be: `A[B] --> ...` replaces the modules and both brackets");
  } else if (is_symbol(module, "[")) {
    diag_error(check->diag, module->symbol_span, "in a left context `[` can only stand last, next to `<`");
    diag_hint(check->diag, "a left context is the path to the root; `A[ < B` asks that B begin its branch");
  } else {
    diag_error(check->diag, module->symbol_span, "`]` cannot stand in a left context");
    diag_hint(check->diag, "a left context is the path to the root: branches beside it are not on the path");
  }
  return PATTERN_MODULE;
}

static PatternKind right_kind(const Check *check, const AstModule *module) {
  if (is_symbol(module, "@]")) return PATTERN_END;
  if (is_symbol(module, "[")) return PATTERN_OPEN;
  if (is_symbol(module, "=")) return PATTERN_REST;
  bool skips = is_symbol(module, "]") && !check->ast->rules.literal_context_brackets;
  return skips ? PATTERN_CLOSE : PATTERN_MODULE;
}

static PatternKind pattern_kind(Check *check, const AstModule *module, Side side, bool last, bool *refused) {
  if (side == SIDE_RIGHT) return right_kind(check, module);
  if (side == SIDE_LEFT && last && is_symbol(module, "[")) return PATTERN_OPEN;
  if (!is_symbol(module, "[") && !is_symbol(module, "]") && !is_symbol(module, "@]")) return PATTERN_MODULE;
  *refused = true;
  return refuse(check, module, side);
}

// Does every bracket have its other one in the word?
static bool is_balanced(const AstWord *word) {
  size_t depth = 0;
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    depth += is_symbol(module, "[");
    if (is_symbol(module, "]") && depth-- == 0) return false;
  }
  return depth == 0;
}

// A right context never leaves the branch that its module is in.
static void check_closed(Check *check, const AstWord *word) {
  size_t depth = 0;
  for (size_t i = 0; i < word->modules.count; i++) {
    const AstModule *module = &word->modules.at[i];
    if (is_symbol(module, "[")) depth++;
    if (!is_symbol(module, "]")) continue;
    if (depth-- > 0) continue;
    diag_error(check->diag, module->symbol_span, "this `]` closes no `[` of the right context");
    diag_hint(check->diag, "a right context does not leave the branch of its module; `@]` asks for the branch's end");
    return;
  }
}

Context check_context(Check *check, const AstWord *word, Side side) {
  Context context = {arena_array(check->arena, word->modules.count, sizeof(Pattern)), word->modules.count};
  bool refused = false;  // the other bracket of a refused branch is not told too
  bool branches = side == SIDE_STRICT && is_balanced(word);
  for (size_t i = 0; i < context.count; i++) {
    const AstModule *module = &word->modules.at[i];
    Pattern *pattern = &context.at[i];
    bool whole = refused || (branches && !is_symbol(module, "@]"));
    pattern->what = whole ? PATTERN_MODULE : pattern_kind(check, module, side, i + 1 == context.count, &refused);
    pattern->span = module->span;
    pattern->slot = (uint32_t)check->scope.slots.count;
    pattern->kind = KIND_NONE;
    const char *text = label_text(check, module);
    size_t first = text != NULL;
    if (pattern->what != PATTERN_REST && pattern->what != PATTERN_END)
      pattern->kind = kind_of(check, module->symbol, text, module->args.count - first, module->span);
    for (size_t j = first; j < module->args.count; j++) formal(check, module->args.at[j]);
  }
  if (side == SIDE_RIGHT && !check->ast->rules.literal_context_brackets) check_closed(check, word);
  return context;
}

// ---- literals -----------------------------------------------------------------------------

// All tests hold, asked from left to right. A balanced tree: the depth of what
// later passes walk must not grow with the number of arguments.
static Expr *conjunction(Check *check, Expr *const *tests, size_t count) {
  if (count == 1) return tests[0];
  Expr *both = ARENA_NEW(check->arena, Expr);
  Expr **args = arena_array(check->arena, 2, sizeof(Expr *));
  args[0] = conjunction(check, tests, count / 2);
  args[1] = conjunction(check, tests + count / 2, count - count / 2);
  *both = (Expr){EXPR_BINARY, .op = OP_AND, .args = args, .count = 2, .span = span_join(args[0]->span, args[1]->span)};
  return both;
}

Expr *check_match(Check *check) {
  return check->literals.count ? conjunction(check, check->literals.at, check->literals.count) : NULL;
}
