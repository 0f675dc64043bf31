// macro.c -- #define as text. Names are C's identifiers; strings, comments and
// numbers are passed over; a macro is not replaced within its own replacement.
//
// What replacing makes of a use is one stretch of the new text, so that a
// message about any part of it points to the use and to the definition.
#include "frontend/macro.h"

#include "support/utf8.h"

#include <stdlib.h>

enum { DEEPEST_MACRO = 100, MOST_BYTES = 1 << 24 };

typedef Stretch Text;
typedef VEC(Text) Texts;
typedef VEC(char) Bytes;

typedef struct Macro {
  const char *name;
  Span span;
  Text body;
  bool function;
  Texts parameters;
} Macro;

struct Macros {
  Arena *arena;
  Sources *sources;
  Diag *diag;
  Trie *defined;
  size_t bytes;  // made so far
};

// A macro that is being replaced; those around it hang on `around`.
typedef struct Use {
  const Macro *macro;
  const struct Use *around;
} Use;

// The expansion of one statement.
typedef struct Expansion {
  Macros *macros;
  const Statement *statement;
  Bytes out;
  VEC(Origin) origins;  // of out
  Span use;             // of the outermost macro that is being replaced
  unsigned depth;       // of macros and arguments in one another
  bool failed;          // was reported
} Expansion;

Macros *macros_create(Arena *arena, Sources *sources, Diag *diag) {
  Macros *macros = ARENA_NEW(arena, Macros);
  *macros = (Macros){.arena = arena, .sources = sources, .diag = diag, .defined = trie_create(arena)};
  return macros;
}

// ---- tokens of C ---------------------------------------------------------------

static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

static const char *skip_blanks(const char *at, const char *end) {
  for (;;) {
    size_t blank = at < end && *at == '\n' ? 1 : utf8_blank(at, end);
    if (blank) {
      at += blank;
    } else if (utf8_starts(at, end, "/*")) {
      const char *close = memmem(at + 2, (size_t)(end - at - 2), "*/", 2);
      at = close ? close + 2 : end;
    } else {
      return at;
    }
  }
}

static const char *name_end(const char *at, const char *end) {
  while (at < end && (is_letter(*at) || is_digit(*at))) at++;
  return at;
}

static const char *number_end(const char *at, const char *end) {
  while (at < end && (is_letter(*at) || is_digit(*at) || *at == '.')) at++;
  return at;
}

static const char *string_end(const char *at, const char *end) {
  for (at++; at < end && *at != '"' && *at != '\n'; at++)
    if (*at == '\\' && at + 1 < end) at++;
  return at < end && *at == '"' ? at + 1 : at;
}

// What a token that no macro can be in ends at; NULL: the byte is none.
static const char *inert_end(const char *at, const char *end) {
  if (*at == '"') return string_end(at, end);
  bool number = is_digit(*at) || (*at == '.' && at + 1 < end && is_digit(at[1]));
  return number ? number_end(at, end) : NULL;
}

// Behind a `\` that joins the next line; NULL: this is none.
static const char *join_end(const char *at, const char *end) {
  if (at == end || *at != '\\') return NULL;
  at++;
  for (size_t n; (n = utf8_blank(at, end)) > 0;) at += n;
  return at < end && *at == '\n' ? at + 1 : NULL;
}

// ---- definitions ---------------------------------------------------------------

// The parameters of `NAME(a,b)`, from the parenthesis on; where they end, NULL if they do not.
static const char *parameters(Macros *macros, Macro *macro, const char *at, const char *end) {
  at = skip_blanks(at + 1, end);
  if (at < end && *at == ')') return at + 1;
  for (;;) {
    const char *behind = name_end(at, end);
    if (at == end || !is_letter(*at)) return NULL;
    *VEC_PUSH(macros->arena, &macro->parameters) = (Text){at, behind};
    at = skip_blanks(behind, end);
    if (at < end && *at == ')') return at + 1;
    if (at == end || *at != ',') return NULL;
    at = skip_blanks(at + 1, end);
  }
}

void macros_define(Macros *macros, const Statement *s) {
  const char *at = skip_blanks(s->first.rest, s->end), *end = name_end(at, s->end);
  if (at == s->end || !is_letter(*at)) {
    diag_error(macros->diag, statement_span(s, s->begin, s->first.end), "`#define` needs a name");
    return;
  }
  Macro *macro = ARENA_NEW(macros->arena, Macro);
  macro->name = arena_copy(macros->arena, at, (size_t)(end - at));
  macro->span = statement_span(s, at, end);
  macro->function = end < s->end && *end == '(';
  const char *body = macro->function ? parameters(macros, macro, end, s->end) : end;
  if (!body) {
    diag_error(macros->diag, statement_span(s, end, end + 1), "the parameters of a macro are names with `,` between");
    return;
  }
  macro->body = (Text){body, s->end};
  *trie_at(macros->defined, at, (size_t)(end - at)) = macro;
}

void macros_undefine(Macros *macros, const char *name) {
  *trie_at(macros->defined, name, strlen(name)) = NULL;
}

// ---- expansion -------------------------------------------------------------------

static void append(Expansion *e, Bytes *out, const char *at, const char *end) {
  Macros *macros = e->macros;
  size_t length = (size_t)(end - at);
  macros->bytes += length;
  if (macros->bytes > MOST_BYTES) {
    if (!e->failed) diag_error(macros->diag, e->use, "the macros here become longer than %d bytes", MOST_BYTES);
    e->failed = true;
    return;
  }
  while (out->capacity - out->count < length) out->at = vec_grow(macros->arena, out->at, out->count, &out->capacity, 1);
  for (; at < end; at++) out->at[out->count++] = *at == '\n' ? ' ' : *at;
}

static bool is_in_use(const Use *use, const Macro *macro) {
  for (; use; use = use->around)
    if (use->macro == macro) return true;
  return false;
}

static void expand(Expansion *e, Text text, const Use *use, Bytes *out);

static int compare_begins(const void *place, const void *comment) {
  uintptr_t a = (uintptr_t)place, b = (uintptr_t)((const Stretch *)comment)->at;
  return (a > b) - (a < b);
}

// What leaves nothing behind: a joined line's end, a line's comment. NULL: this is neither.
static const char *nothing_end(const Expansion *e, const char *at, const char *end) {
  const char *joined = join_end(at, end);
  const Statement *s = e->statement;
  if (joined || *at != '/' || s->line_comments.count == 0) return joined;
  const Stretch *comment = bsearch(at, s->line_comments.at, s->line_comments.count, sizeof *comment, compare_begins);
  return comment ? comment->end : NULL;
}

// The arguments of a use, from the parenthesis on; where it ends, NULL if it does not.
static const char *arguments(Expansion *e, Texts *list, const char *at, const char *end) {
  unsigned depth = 0;
  const char *begin = ++at;
  while (at < end) {
    const char *behind = nothing_end(e, at, end);
    if (!behind) behind = inert_end(at, end);
    if (behind) {
      at = behind;
    } else if (utf8_starts(at, end, "/*")) {
      at = skip_blanks(at, end);
    } else if (*at == ')' && depth == 0) {
      *VEC_PUSH(e->macros->arena, list) = (Text){begin, at};
      return at + 1;
    } else {
      depth += *at == '(';
      depth -= *at == ')';
      if (*at == ',' && depth == 0) {
        *VEC_PUSH(e->macros->arena, list) = (Text){begin, at};
        begin = at + 1;
      }
      at++;
    }
  }
  return NULL;
}

// The body with its parameters replaced by the arguments, whose macros are replaced before.
static Text substitute(Expansion *e, const Macro *macro, const Texts *given, const Use *around) {
  Bytes result = {0};
  for (const char *at = macro->body.at, *end = macro->body.end; at < end;) {
    const char *behind = inert_end(at, end);
    size_t i = macro->parameters.count;
    const char *joined = join_end(at, end);
    if (joined) {
      at = joined;
      continue;
    }
    if (!behind && is_letter(*at)) {
      behind = name_end(at, end);
      for (i = 0; i < macro->parameters.count; i++) {
        Text p = macro->parameters.at[i];
        if (p.end - p.at == behind - at && memcmp(p.at, at, (size_t)(behind - at)) == 0) break;
      }
    }
    if (!behind) behind = at + 1;
    if (i < macro->parameters.count)
      expand(e, given->at[i], around, &result);
    else
      append(e, &result, at, behind);
    at = behind;
  }
  return (Text){result.at, result.at + result.count};
}

// What is appended from here on is made of this.
static void add_origin(Expansion *e, Span from, Span macro) {
  *VEC_PUSH(e->macros->arena, &e->origins) = (Origin){(uint32_t)e->out.count, from, macro};
}

// Reports a use with another number of arguments, or too many in one another.
static bool usable(Expansion *e, const Macro *macro, size_t given) {
  if (e->failed) return false;
  size_t wanted = macro->parameters.count;
  if (e->depth == DEEPEST_MACRO)
    diag_error(e->macros->diag, e->use, "macros are nested too deep here");
  else if (given != wanted)
    diag_error(e->macros->diag, e->use, "macro `%s` needs %zu argument%s, not %zu", macro->name, wanted,
               wanted == 1 ? "" : "s", given);
  else
    return true;
  e->failed = true;
  return false;
}

// Replaces the use of a macro at `at`; where it ends, NULL if it is none.
static const char *replace(Expansion *e, const Macro *macro, Text text, const char *at, const Use *use, Bytes *out) {
  const char *behind = name_end(at, text.end);
  Texts given = {0};
  if (macro->function) {
    const char *paren = skip_blanks(behind, text.end);
    if (paren == text.end || *paren != '(') return NULL;
    behind = arguments(e, &given, paren, text.end);
    if (!behind) return NULL;
    bool empty = given.count == 1 && skip_blanks(given.at[0].at, given.at[0].end) == given.at[0].end;
    if (empty && macro->parameters.count == 0) given.count = 0;
  }
  bool outermost = out == &e->out && !use;
  if (outermost) {
    e->use = statement_span(e->statement, at, behind);
    add_origin(e, e->use, macro->span);
  }
  if (usable(e, macro, given.count)) {
    e->depth++;
    Text body = macro->function ? substitute(e, macro, &given, use) : macro->body;
    expand(e, body, &(Use){macro, use}, out);
    e->depth--;
  }
  if (outermost) add_origin(e, statement_span(e->statement, behind, text.end), (Span){0, 0});
  return behind;
}

// Behind `defined NAME` or `defined(NAME)`.
static const char *defined_end(const char *at, const char *end) {
  at = skip_blanks(at, end);
  if (at < end && *at == '(') at = skip_blanks(at + 1, end);
  return name_end(at, end);
}

static void expand(Expansion *e, Text text, const Use *use, Bytes *out) {
  for (const char *at = text.at; at < text.end && !e->failed;) {
    const char *nothing = nothing_end(e, at, text.end);
    if (nothing) {
      at = nothing;
      continue;
    }
    const char *behind = inert_end(at, text.end);
    if (!behind && utf8_starts(at, text.end, "/*")) {
      // Nothing of a comment is replaced; outside of macros it stays, byte for byte.
      behind = skip_blanks(at, text.end);
    } else if (!behind && is_letter(*at)) {
      behind = name_end(at, text.end);
      const Macro *macro = trie_find(e->macros->defined, at, (size_t)(behind - at));
      const char *used = macro && !is_in_use(use, macro) ? replace(e, macro, text, at, use, out) : NULL;
      if (used) {
        at = used;
        continue;
      }
      if (behind - at == 7 && memcmp(at, "defined", 7) == 0) behind = defined_end(behind, text.end);
    }
    if (!behind) behind = at + 1;
    append(e, out, at, behind);
    at = behind;
  }
}

bool macros_expand(Macros *macros, Statement *s) {
  Expansion e = {.macros = macros, .statement = s};
  add_origin(&e, statement_span(s, s->begin, s->end), (Span){0, 0});
  expand(&e, (Text){s->begin, s->end}, NULL, &e.out);
  if (e.failed) return false;
  if (e.origins.count == 1) return true;
  const char *text = arena_copy(macros->arena, e.out.at, e.out.count);
  const SourceFile *made = sources_add_made(macros->sources, text, e.out.count, e.origins.at, e.origins.count);
  if (!made) {
    diag_error(macros->diag, e.use, "the texts of this grammar become too long");
    return false;
  }
  Splitter splitter;
  splitter_init(&splitter, macros->arena, macros->diag, s->notation, made);
  return splitter_next(&splitter, s);
}
