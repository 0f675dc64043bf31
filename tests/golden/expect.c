// expect.c -- comments of a grammar -> Tests, and Tests against what was printed.
//
// A line counts when, behind the signs that begin a comment in any dialect, it
// begins with a keyword of the table below and a colon.
#include "expect.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

const char *const view_options[VIEW_COUNT] = {"", "--count", "--stats", "--hash"};

// ---- reading ---------------------------------------------------------------------

typedef struct Reader {
  Case *test;
  Tests *tests;
  FileOptions *file;
  unsigned line;
  bool wrong;
} Reader;

static void __attribute__((format(printf, 2, 3))) complain(Reader *reader, const char *format, ...) {
  va_list args;
  va_start(args, format);
  case_fail(reader->test, reader->line, "%s", arena_vprintf(reader->test->arena, format, args));
  va_end(args);
  reader->wrong = true;
}

static void add(Reader *reader, Test *t, View view, const char *text) {
  *VEC_PUSH(reader->test->arena, &t->expectations) = (Expectation){.view = view, .text = text, .line = reader->line};
}

// "W1 0.4 | W2 0.6": words, for frequencies with a probability behind each.
static void add_outcomes(Reader *reader, Test *t, const char *text, bool frequencies) {
  Arena *arena = reader->test->arena;
  t->frequencies = frequencies;
  for (;;) {
    size_t length = strcspn(text, "|");
    char *word = arena_copy(arena, text, length);
    Outcome *outcome = VEC_PUSH(arena, &t->outcomes);
    outcome->word = word;
    if (frequencies) {
      char *end = word + strlen(word);
      while (end > word && isspace((unsigned char)end[-1])) *--end = '\0';
      char *blank = strrchr(word, ' ');
      outcome->probability = blank ? strtod(blank, NULL) : 0;
      if (!blank || outcome->probability <= 0) complain(reader, "`%s` has no probability", word);
      if (blank) *blank = '\0';
    }
    if (!text[length]) return;
    text += length + 1;
  }
}

static void add_seeds(Reader *reader, Test *t, const char *text) {
  t->seeded = true;
  if (sscanf(text, "%lu..%lu", &t->first_seed, &t->last_seed) != 2 || t->first_seed > t->last_seed)
    complain(reader, "seeds are written as 1..100");
}

static void take(Reader *reader, const char *key, const char *value) {
  Arena *arena = reader->test->arena;
  if (strcmp(key, "options") == 0) {
    reader->file->options = value;
    return;
  }
  if (strcmp(key, "engines") == 0) {
    reader->file->interp_only = strcmp(value, "interp") == 0;
    if (!reader->file->interp_only) complain(reader, "`engines:` can be interp; without it all run");
    return;
  }
  bool query = strcmp(key, "query") == 0;
  if (query || strcmp(key, "test") == 0) {
    *VEC_PUSH(arena, reader->tests) = (Test){.options = value, .line = reader->line, .query = query};
    return;
  }
  Test *t = reader->tests->count ? &reader->tests->at[reader->tests->count - 1] : NULL;
  if (!t)
    complain(reader, "`%s:` stands before the first `test:`", key);
  else if (strcmp(key, "word") == 0)
    add(reader, t, VIEW_WORD, value);
  else if (strcmp(key, "count") == 0)
    add(reader, t, VIEW_SYMBOLS, value);
  else if (strcmp(key, "length") == 0)
    add(reader, t, VIEW_SYMBOLS, arena_printf(arena, "total %s", value));
  else if (strcmp(key, "stats") == 0)
    add(reader, t, VIEW_STATS, value);
  else if (strcmp(key, "hash") == 0)
    add(reader, t, VIEW_HASH, value);
  else if (strcmp(key, "outcomes") == 0)
    add_outcomes(reader, t, value, false);
  else if (strcmp(key, "frequencies") == 0)
    add_outcomes(reader, t, value, true);
  else if (strcmp(key, "seeds") == 0)
    add_seeds(reader, t, value);
  else if (strcmp(key, "fails") == 0)
    t->fails = value;
}

static bool is_key(const char *key) {
  static const char *const keys[] = {"options", "engines", "test",     "query",       "word",  "count", "length",
                                     "stats",   "hash",    "outcomes", "frequencies", "seeds", "fails"};
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
    if (strcmp(key, keys[i]) == 0) return true;
  return false;
}

// Takes the line if it is a comment "// key: value", "; key: value", "# key: value", "/* key: value */".
static void read_line(Reader *reader, const char *line, size_t length) {
  Arena *arena = reader->test->arena;
  size_t signs = 0, at = 0;
  while (at < length && strchr("/*;# \t", line[at])) signs += !strchr(" \t", line[at++]);
  if (signs == 0) return;
  size_t end = at;
  while (end < length && isalpha((unsigned char)line[end])) end++;
  if (end == length || line[end] != ':') return;
  const char *key = arena_copy(arena, line + at, end - at);
  if (!is_key(key)) return;
  for (at = end + 1; at < length && isspace((unsigned char)line[at]);) at++;
  while (length > at && isspace((unsigned char)line[length - 1])) length--;
  if (length - at >= 2 && memcmp(line + length - 2, "*/", 2) == 0) length -= 2;
  while (length > at && isspace((unsigned char)line[length - 1])) length--;
  take(reader, key, arena_copy(arena, line + at, length - at));
}

bool expect_read(Case *test, const char *text, unsigned line, Tests *tests, FileOptions *file) {
  Reader reader = {.test = test, .tests = tests, .file = file, .line = line};
  *file = (FileOptions){.options = ""};
  while (*text) {
    size_t length = strcspn(text, "\n");
    reader.line++;
    read_line(&reader, text, length);
    text += length + (text[length] != '\0');
  }
  for (size_t i = 0; i < tests->count; i++) {
    const Test *t = &tests->at[i];
    reader.line = t->line;
    if (t->expectations.count == 0 && t->outcomes.count == 0 && !t->fails && !t->seeded)
      complain(&reader, "`test:` expects nothing");
    if (t->frequencies && !t->seeded) complain(&reader, "`frequencies:` needs `seeds:`");
  }
  return !reader.wrong;
}

// ---- comparing -------------------------------------------------------------------

bool expect_needs(const Test *t, View view) {
  if (view == VIEW_HASH && !t->query && !t->fails) return true;
  if (view == VIEW_WORD && (t->outcomes.count > 0 || t->fails)) return true;
  for (size_t i = 0; i < t->expectations.count; i++)
    if (t->expectations.at[i].view == view) return true;
  return false;
}

// The line with number `index` of a text, without its end; NULL behind the last.
static const char *line_at(Arena *arena, const char *text, size_t index) {
  for (; index > 0 && *text; index--) {
    text += strcspn(text, "\n");
    if (*text) text++;
  }
  return *text ? arena_copy(arena, text, strcspn(text, "\n")) : NULL;
}

// The values that rows "name<TAB>value" have in the blocks of all start words, with blanks between them.
static const char *values_of(Arena *arena, const char *text, const char *name) {
  size_t length = strlen(name);
  const char *values = "";
  for (; *text; text += strcspn(text, "\n"), text += *text != '\0')
    if (strncmp(text, name, length) == 0 && text[length] == '\t') {
      const char *value = text + length + 1;
      values = arena_printf(arena, "%s%s%.*s", values, *values ? " " : "", (int)strcspn(value, "\n"), value);
    }
  return values;
}

// "colour 2 17": the name is all but as many values as are expected; it ends at the last blank before a digit or sign
// that makes the row known to the text.
static bool row_holds(Case *test, const Expectation *e, const char *printed) {
  for (const char *blank = strchr(e->text, ' '); blank; blank = strchr(blank + 1, ' ')) {
    const char *name = arena_copy(test->arena, e->text, (size_t)(blank - e->text));
    const char *values = values_of(test->arena, printed, name);
    if (!*values) continue;
    if (text_same_value(blank + 1, values)) return true;
    case_fail(test, e->line, "expected %s %s, not %s", name, blank + 1, values);
    return false;
  }
  case_fail(test, e->line, "there is no row for `%s` in\n%s", e->text, printed);
  return false;
}

static bool holds(Case *test, const Expectation *e, size_t which, const char *printed) {
  if (e->view == VIEW_SYMBOLS || e->view == VIEW_STATS) return row_holds(test, e, printed);
  const char *line = line_at(test->arena, printed, which);
  if (line && (e->view == VIEW_WORD ? text_same_word(e->text, line) : strcmp(e->text, line) == 0)) return true;
  case_fail(test, e->line, "expected %s, not %s", e->text, line ? line : "nothing");
  return false;
}

bool expect_holds(Case *test, Test *t, View view, const char *printed) {
  size_t which = 0;
  bool all = true;
  for (size_t i = 0; i < t->expectations.count; i++)
    if (t->expectations.at[i].view == view) all &= holds(test, &t->expectations.at[i], which++, printed);
  if (view == VIEW_WORD && which > 0 && line_at(test->arena, printed, which)) {
    case_fail(test, t->line, "there are more words than are expected");
    all = false;
  }
  if (view == VIEW_WORD && t->outcomes.count > 0 && !expect_outcome(t, printed)) {
    case_fail(test, t->line, "is none of the outcomes: %s", printed);
    all = false;
  }
  return all;
}

bool expect_same_stats(const Test *t, const char *a, const char *b) {
  Arena *arena = arena_create();
  bool same = true;
  for (size_t i = 0; i < t->expectations.count; i++) {
    const char *text = t->expectations.at[i].text;
    if (t->expectations.at[i].view != VIEW_STATS) continue;
    for (const char *blank = strchr(text, ' '); blank; blank = strchr(blank + 1, ' ')) {
      const char *name = arena_copy(arena, text, (size_t)(blank - text));
      same &= strcmp(values_of(arena, a, name), values_of(arena, b, name)) == 0;
    }
  }
  arena_destroy(arena);
  return same;
}

// ---- outcomes --------------------------------------------------------------------

bool expect_outcome(Test *t, const char *printed) {
  for (size_t i = 0; i < t->outcomes.count; i++)
    if (text_same_word(t->outcomes.at[i].word, printed)) {
      t->outcomes.at[i].came++;
      return true;
    }
  return false;
}

bool expect_all_came(Case *test, const Test *t) {
  for (size_t i = 0; i < t->outcomes.count; i++)
    if (t->outcomes.at[i].came == 0) {
      case_fail(test, t->line, "no seed gave %s", t->outcomes.at[i].word);
      return false;
    }
  return true;
}

bool expect_frequencies(Case *test, const Test *t) {
  double runs = (double)(t->last_seed - t->first_seed + 1), square = 0;
  for (size_t i = 0; i < t->outcomes.count; i++) {
    double expected = runs * t->outcomes.at[i].probability;
    double off = (double)t->outcomes.at[i].came - expected;
    square += off * off / expected;
  }
  // Mean and variance of chi-square are the degrees of freedom and twice that: five deviations never come by chance,
  // and the seeds are always the same ones.
  double freedom = (double)t->outcomes.count - 1, limit = freedom + 5 * 1.4142135623730951 * freedom;
  if (square <= limit) return true;
  case_fail(test, t->line, "frequencies: chi-square is %.1f, over %.1f", square, limit);
  return false;
}
