// reader.c -- a stack of files, each with its stack of #if groups.
#include "frontend/reader.h"

#include "frontend/condition.h"
#include "frontend/macro.h"
#include "frontend/parse.tab.h"
#include "support/utf8.h"

#include <sys/stat.h>

enum { DEEPEST_INCLUDE = 64, MOST_INCLUDES = 1000 };

typedef struct Group {  // from #if to #endif
  Span span;            // of the #if
  bool outer;           // do the lines around it count?
  bool active;          // do the lines here count?
  bool taken;           // did an earlier branch count?
  bool has_else;
} Group;

typedef struct Input Input;
struct Input {
  Input *from;  // the including file
  Splitter splitter;
  VEC(Group) groups;
  struct stat identity;  // of the file, where it has one
};

struct Reader {
  Arena *arena;
  Parser *parser;
  Diag *diag;
  Sources *sources;
  const ParseOptions *options;
  Input *input;
  unsigned depth, inclusions;
  Defines *defines;
  Macros *macros;          // NULL: #define does not replace text
  const SourceFile *line;  // the -D of the command line as #defines; NULL: none
  Defines *from_line;      // what they define
};

static void push_input(Reader *reader, const SourceFile *file) {
  Input *input = ARENA_NEW(reader->arena, Input);
  input->from = reader->input;
  splitter_init(&input->splitter, reader->arena, reader->diag, reader->parser->notation, file);
  if (stat(file->path, &input->identity) != 0) input->identity = (struct stat){0};
  reader->input = input;
  reader->depth++;
}

// The name behind a directive; NULL: there is none.
static const char *directive_name(const Statement *s, Arena *arena) {
  const char *at = s->first.rest, *end;
  for (size_t n; (n = utf8_blank(at, s->end)) > 0;) at += n;
  for (end = at; end < s->end && !strchr(" \t\r\n/(", *end);) end++;
  return end > at ? arena_copy(arena, at, (size_t)(end - at)) : NULL;
}

// ---- -D --------------------------------------------------------------------

typedef VEC(char) Bytes;

static void append(Arena *arena, Bytes *text, const char *bytes, size_t length) {
  for (size_t i = 0; i < length; i++) *VEC_PUSH(arena, text) = bytes[i];
}

// "N=3" becomes "#define N 3\n".
static void append_define(Arena *arena, Bytes *text, const char *definition) {
  size_t name = strcspn(definition, "=");
  append(arena, text, "#define ", 8);
  append(arena, text, definition, name);
  append(arena, text, " ", 1);
  if (definition[name])
    append(arena, text, definition + name + 1, strlen(definition + name + 1));
  else
    append(arena, text, "1", 1);
  append(arena, text, "\n", 1);
}

// What the command line defines is read before the grammar, as if it were included there.
static void push_command_line(Reader *reader) {
  const ParseOptions *options = reader->options;
  Bytes text = {0};
  if (!options) return;
  for (size_t i = 0; i < options->define_count; i++) append_define(reader->arena, &text, options->defines[i]);
  for (size_t i = 0; reader->macros && i < options->given_count; i++)
    append_define(reader->arena, &text, options->given[i]);
  if (text.count == 0) return;
  const char *copy = arena_copy(reader->arena, text.at, text.count);
  reader->line = sources_add(reader->sources, "<command line>", copy, text.count, (Span){0, 0});
  if (reader->line) push_input(reader, reader->line);
}

// The -D of a param's name; NULL: there is none.
static Statement *defined_param(Reader *reader, const Statement *s) {
  if (!reader->line || !s->first.keyword || s->first.keyword->token != TOK_PARAM) return NULL;
  const char *name = directive_name(s, reader->arena);
  if (!name) return NULL;
  if (reader->macros) macros_undefine(reader->macros, name);
  return trie_find(reader->from_line, name, strlen(name));
}

// A param that the command line defines has that value as its default.
static void take_over(Reader *reader, Statement *s, Statement *define) {
  parser_ahead(reader->parser, s);
  parser_ahead(reader->parser, define);
  if (s->ast.count && define->ast.count) s->ast.at[0].value = define->ast.at[0].value;
  define->overridden = true;
}

Reader *reader_create(Parser *parser, Sources *sources, const SourceFile *file, const ParseOptions *options) {
  Arena *arena = parser->build.arena;
  Reader *reader = ARENA_NEW(arena, Reader);
  *reader = (Reader){.arena = arena, .parser = parser, .diag = parser->diag, .sources = sources, .options = options};
  reader->defines = trie_create(arena);
  reader->from_line = trie_create(arena);
  if (parser->notation->macros) reader->macros = macros_create(arena, sources, parser->diag);
  push_input(reader, file);
  push_command_line(reader);
  return reader;
}

// ---- #if -------------------------------------------------------------------

static bool active(const Reader *reader) {
  const Input *input = reader->input;
  return input->groups.count == 0 || input->groups.at[input->groups.count - 1].active;
}

static Span keyword_span(const Statement *s) {
  return statement_span(s, s->begin, s->first.end);
}

// Whether the condition of an #if or #elif holds.
static bool holds(Reader *reader, Statement *s) {
  if (reader->macros && !macros_expand(reader->macros, s)) return false;
  return condition_holds(reader->parser, reader->defines, s);
}

static bool is_defined(Reader *reader, Statement *s) {
  const char *name = directive_name(s, reader->arena);
  if (!name) diag_error(reader->diag, keyword_span(s), "`%.*s` needs a name", (int)(s->first.end - s->begin), s->begin);
  return name && trie_find(reader->defines, name, strlen(name));
}

static void open_group(Reader *reader, Statement *s) {
  Group group = {.span = keyword_span(s), .outer = active(reader)};
  if (group.outer) {
    int token = s->first.keyword->token;
    group.active = token == TOK_HASH_IF ? holds(reader, s) : is_defined(reader, s) == (token == TOK_IFDEF);
  }
  group.taken = group.active;
  *VEC_PUSH(reader->arena, &reader->input->groups) = group;
}

// #elif, #else, #endif.
static void change_group(Reader *reader, Statement *s) {
  Input *input = reader->input;
  int token = s->first.keyword->token, length = (int)(s->first.end - s->begin);
  if (input->groups.count == 0) {
    diag_error(reader->diag, keyword_span(s), "`%.*s` without an `#if` before it", length, s->begin);
    return;
  }
  Group *group = &input->groups.at[input->groups.count - 1];
  if (token == TOK_ENDIF) {
    input->groups.count--;
    return;
  }
  if (group->has_else) {
    diag_error(reader->diag, keyword_span(s), "`%.*s` behind the `#else` of the same `#if`", length, s->begin);
    diag_note(reader->diag, group->span, "the `#if` is here");
  }
  group->has_else |= token == TOK_HASH_ELSE;
  group->active = group->outer && !group->taken && (token == TOK_HASH_ELSE || holds(reader, s));
  group->taken |= group->active;
}

static void conditional(Reader *reader, Statement *s) {
  int token = s->first.keyword->token;
  if (token == TOK_HASH_IF || token == TOK_IFDEF || token == TOK_IFNDEF)
    open_group(reader, s);
  else
    change_group(reader, s);
  if ((token == TOK_HASH_ELSE || token == TOK_ENDIF) && s->end > s->first.rest)
    diag_error(reader->diag, statement_span(s, s->first.rest, s->end), "unexpected text behind `%.*s`",
               (int)(s->first.end - s->begin), s->begin);
}

// ---- #include ----------------------------------------------------------------

// file, "file" or <file>.
static const char *included_path(Reader *reader, const Statement *s, Span *span) {
  const char *at = s->first.rest, *end = s->end;
  for (size_t n; (n = utf8_blank(at, end)) > 0;) at += n;
  char close = *at == '"' ? '"' : *at == '<' ? '>' : '\0';
  if (at < end && close) {
    const char *behind = memchr(at + 1, close, (size_t)(end - at - 1));
    if (behind && behind > at + 1) {
      *span = statement_span(s, at, behind + 1);
      return arena_copy(reader->arena, at + 1, (size_t)(behind - at - 1));
    }
    diag_error(reader->diag, statement_span(s, at, at + 1), "a file's name ends with `%c`", close);
    return NULL;
  }
  const char *name = at;
  while (at < end && !utf8_blank(at, end) && !utf8_starts(at, end, "/*")) at++;
  *span = statement_span(s, name, at);
  if (at > name) return arena_copy(reader->arena, name, (size_t)(at - name));
  diag_error(reader->diag, keyword_span(s), "`#include` needs a file's name");
  return NULL;
}

static const char *beside(Reader *reader, const char *path) {
  const char *here = reader->input->splitter.file->path, *slash = strrchr(here, '/');
  if (*path == '/' || !slash) return path;
  return arena_printf(reader->arena, "%.*s/%s", (int)(slash - here), here, path);
}

// Beside the including file, then in the -I folders. A file that is there but cannot be read ends the search.
static const SourceFile *find_include(Reader *reader, const char *path, Span span) {
  const ParseOptions *options = reader->options;
  const char *why = NULL, *tried = beside(reader, path);
  struct stat info;
  for (size_t i = 0; stat(tried, &info) != 0; i++) {
    if (*path == '/' || !options || i == options->include_count) {
      diag_error(reader->diag, span, "cannot find the file `%s`", path);
      diag_hint(reader->diag, "it is looked for beside the including file and in the folders given with -I");
      return NULL;
    }
    tried = arena_printf(reader->arena, "%s/%s", options->include_dirs[i], path);
  }
  bool readable = S_ISREG(info.st_mode) || S_ISDIR(info.st_mode);  // a device may never end
  const SourceFile *file = readable ? sources_read(reader->sources, tried, span, &why) : NULL;
  if (!readable) why = "is not a file";
  if (!file) diag_error(reader->diag, span, "cannot read the file `%s`: %s", tried, why);
  return file;
}

static void include(Reader *reader, const Statement *s) {
  Span span;
  const char *path = included_path(reader, s, &span);
  if (!path) return;
  if (reader->depth == DEEPEST_INCLUDE || ++reader->inclusions > MOST_INCLUDES) {
    diag_error(reader->diag, span, "too many inclusions; at most %d in one another and %d in all are read",
               DEEPEST_INCLUDE, MOST_INCLUDES);
    reader->input->splitter.at = reader->input->splitter.end;
    return;
  }
  const SourceFile *file = find_include(reader, path, span);
  if (!file) return;
  push_input(reader, file);
  const struct stat *identity = &reader->input->identity;
  for (const Input *in = reader->input->from; in; in = in->from)
    if (identity->st_ino && identity->st_ino == in->identity.st_ino && identity->st_dev == in->identity.st_dev) {
      diag_error(reader->diag, span, "`%s` is being read already: this inclusion would never end", path);
      reader->input = reader->input->from;
      reader->depth--;
      return;
    }
}

// ---- statements ----------------------------------------------------------------

static void pop_input(Reader *reader) {
  Input *input = reader->input;
  for (size_t i = 0; i < input->groups.count; i++)
    diag_error(reader->diag, input->groups.at[i].span, "this `#if` has no `#endif`");
  reader->input = input->from;
  reader->depth--;
}

static void record_define(Reader *reader, Statement *s) {
  const char *name = directive_name(s, reader->arena);
  bool define = s->first.keyword->token == TOK_DEFINE;
  if (name) *trie_at(reader->defines, name, strlen(name)) = define ? s : NULL;
  if (name && s->file == reader->line) *trie_at(reader->from_line, name, strlen(name)) = s;
  if (reader->macros && define)
    macros_define(reader->macros, s);
  else if (reader->macros && name)
    macros_undefine(reader->macros, name);
}

Statement *reader_next(Reader *reader) {
  Statement *s = ARENA_NEW(reader->arena, Statement);
  while (reader->input) {
    Splitter *splitter = &reader->input->splitter;
    bool counts = active(reader);
    if (!(counts ? splitter_next(splitter, s) : splitter_next_conditional(splitter, s))) {
      pop_input(reader);
      continue;
    }
    const Keyword *keyword = s->first.keyword;
    if (keyword && keyword_is_conditional(keyword)) {
      conditional(reader, s);
    } else if (keyword && keyword->token == TOK_INCLUDE) {
      include(reader, s);
    } else if (keyword && (keyword->token == TOK_DEFINE || keyword->token == TOK_UNDEF)) {
      record_define(reader, s);
      if (!reader->macros) return s;
      s = ARENA_NEW(reader->arena, Statement);
    } else {
      Statement *define = defined_param(reader, s);
      if (reader->macros && !macros_expand(reader->macros, s)) continue;
      if (define) take_over(reader, s, define);
      return s;
    }
  }
  return NULL;
}
