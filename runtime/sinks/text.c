// text.c -- a word as text that reads back as the same word (LANGUAGE.md section 9).
//
// A blank stands only where two modules would otherwise scan differently. The
// scanner takes the longest name (section 2): the text that follows a module
// decides whether it would swallow more than the module's own symbol. Symbols
// that could are `careful`; a grammar without any is written straight through.
#include "core/formats.h"
#include "core/stream.h"
#include "lsys/number.h"

#include <stdlib.h>
#include <string.h>

enum {
  PIECE = 1 << 12,   // bytes of text that are made at once
  SHORT_SYMBOL = 8,  // symbols up to this length are copied as one 8-byte store
};

typedef struct Spelling {
  char padded[SHORT_SYMBOL];  // the symbol, if it is short
  const char *symbol;
  uint32_t length;
  uint32_t most;  // bytes that a module can take
  uint16_t arity;
  bool careful;
  bool empty_parentheses;  // `,()`: a bare comma would separate start words
} Spelling;

// A module whose text is in the window, and the end of that text.
typedef struct Placed {
  uint32_t kind, end;
} Placed;

typedef struct TextSink {
  LsysSink sink;
  LsysMemory *memory;
  LsysOut *out;
  uint32_t kind_count;
  unsigned width;
  bool careful;        // some symbol is
  uint32_t longest;    // bytes of text that decide how a module scans
  uint64_t modules;    // of this word so far
  uint32_t last;       // the last one's kind
  size_t window_used;  // careful grammars: text not yet written, because what follows may ask for a blank
  size_t placed_count;
  char *window;
  Placed *placed;
  size_t window_size, placed_size;
  Spelling spelling[];
} TextSink;

// ---- the scanner's view ------------------------------------------------------

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Bytes above 127 count as letters: a blank too many does no harm, one too few would.
static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80);
}

static size_t character_length(const char *text, size_t size) {
  size_t length = 1;
  while (length < size && (text[length] & 0xC0) == 0x80) length++;
  return length;
}

static size_t longer(size_t a, size_t b) {
  return a > b ? a : b;
}

// The length of a prefix of text that is a subscripted letter, a query, or the beginning of a comment.
static size_t compound_length(const char *text, size_t size) {
  size_t first = character_length(text, size);
  if (size > 1 && text[0] == '?' && is_letter(text[1])) return 1 + character_length(text + 1, size - 1);
  if (size > 1 && text[0] == '/' && text[1] == '*') return 2;
  if (!is_letter(text[0]) || size < first + 2 || text[first] != '_') return 0;
  size_t at = first + 1;
  if (is_letter(text[at])) return at + character_length(text + at, size - at);
  while (at < size && is_digit(text[at])) at++;
  return at > first + 1 ? at : 0;
}

// How much of text the scanner takes as its first symbol.
static size_t scanned_length(const TextSink *text_sink, const char *text, size_t size) {
  size_t length = longer(character_length(text, size), compound_length(text, size));
  for (uint32_t i = 0; i < text_sink->kind_count; i++) {
    const Spelling *name = &text_sink->spelling[i];
    if (name->length <= size && memcmp(name->symbol, text, name->length) == 0) length = longer(length, name->length);
  }
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++) {
    const char *name = lsys_turtle[op].symbol;
    size_t name_length = strlen(name);
    if (name_length <= size && memcmp(name, text, name_length) == 0) length = longer(length, name_length);
  }
  return length;
}

// True if some symbol of the grammar begins like rest, or is the beginning of it.
static bool can_continue(const LsysGrammar *grammar, const char *rest) {
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    const char *symbol = grammar->kinds[i].symbol;
    size_t length = strlen(symbol), rest_length = strlen(rest);
    if (memcmp(symbol, rest, length < rest_length ? length : rest_length) == 0) return true;
  }
  return false;
}

static bool some_symbol_begins(const LsysGrammar *grammar, bool (*how)(char)) {
  for (uint32_t i = 0; i < grammar->kind_count; i++)
    if (how(grammar->kinds[i].symbol[0])) return true;
  return false;
}

// True if name begins with symbol and modules of the grammar could spell its rest.
static bool may_become(const LsysGrammar *grammar, const char *symbol, const char *name) {
  size_t length = strlen(symbol);
  return strncmp(symbol, name, length) == 0 && name[length] && can_continue(grammar, name + length);
}

static bool is_careful(const LsysGrammar *grammar, const char *symbol) {
  size_t length = strlen(symbol), first = character_length(symbol, length);
  if (strcmp(symbol, "?") == 0 && some_symbol_begins(grammar, is_letter)) return true;
  if (strcmp(symbol, "/") == 0 && can_continue(grammar, "*")) return true;
  if (length == first && is_letter(symbol[0]) && can_continue(grammar, "_")) return true;
  bool numbered = length > first + 1 && symbol[first] == '_' && is_digit(symbol[first + 1]);
  if (numbered && some_symbol_begins(grammar, is_digit)) return true;
  for (uint32_t i = 0; i < grammar->kind_count; i++)
    if (may_become(grammar, symbol, grammar->kinds[i].symbol)) return true;
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++)
    if (may_become(grammar, symbol, lsys_turtle[op].symbol)) return true;
  return false;
}

// ---- writing -----------------------------------------------------------------

static char *put_arguments(char *to, const double *arg, unsigned count) {
  *to++ = '(';
  for (unsigned i = 0; i < count; i++) {
    if (i) *to++ = ',';
    to = lsys_number_print(to, arg[i]);
  }
  *to++ = ')';
  return to;
}

// Writes one module; to has room for spelling->most bytes.
static char *put_module(char *to, const Spelling *spelling, const double *arg) {
  if (spelling->length <= SHORT_SYMBOL)
    memcpy(to, spelling->padded, SHORT_SYMBOL);
  else
    memcpy(to, spelling->symbol, spelling->length);
  to += spelling->length;
  if (spelling->arity) return put_arguments(to, arg, spelling->arity);
  if (spelling->empty_parentheses) {
    *to++ = '(';
    *to++ = ')';
  }
  return to;
}

static unsigned kind_at(const TextSink *text, const LsysWord *part, uint64_t i) {
  return text->width == 1 ? part->sym[i] : (unsigned)(part->sym[2 * i] | part->sym[2 * i + 1] << 8);
}

static bool write_plain(TextSink *text, const LsysWord *part) {
  const double *arg = part->arg;
  for (uint64_t i = 0; i < part->nsym;) {
    char *room = lsys_out_room(text->out, 2 * PIECE), *to = room;
    while (i < part->nsym && to < room + PIECE) {
      const Spelling *spelling = &text->spelling[kind_at(text, part, i)];
      if (spelling->most > PIECE) break;
      to = put_module(to, spelling, arg);
      arg += spelling->arity;
      i++;
    }
    lsys_out_filled(text->out, (size_t)(to - room));
    if (to < room + PIECE && i < part->nsym) {  // a module too long for the buffer
      const Spelling *spelling = &text->spelling[kind_at(text, part, i++)];
      char *long_text = lsys_memory_alloc(text->memory, spelling->most, 1);
      if (!long_text) return false;
      char *end = put_module(long_text, spelling, arg);
      arg += spelling->arity;
      lsys_out_write(text->out, long_text, (size_t)(end - long_text));
      lsys_memory_free(text->memory, long_text, spelling->most, 1);
    }
  }
  return lsys_out_write(text->out, "", 0);
}

// Writes the modules of the window of which enough text follows to decide on a
// blank, all of them at the end of the word; moves the rest to its beginning.
static bool write_window(TextSink *text, bool at_end) {
  size_t start = 0, i = 0;
  for (; i < text->placed_count; i++) {
    size_t available = text->window_used - start, end = text->placed[i].end;
    if (!at_end && available < text->longest) break;
    const Spelling *spelling = &text->spelling[text->placed[i].kind];
    lsys_out_write(text->out, text->window + start, end - start);
    bool closed = spelling->arity || spelling->empty_parentheses;
    if (spelling->careful && !closed && scanned_length(text, text->window + start, available) != spelling->length)
      lsys_out_write(text->out, " ", 1);
    start = end;
  }
  text->window_used -= start;
  text->placed_count -= i;
  memmove(text->window, text->window + start, text->window_used);
  memmove(text->placed, text->placed + i, text->placed_count * sizeof *text->placed);
  for (size_t j = 0; j < text->placed_count; j++) text->placed[j].end -= (uint32_t)start;
  return lsys_out_write(text->out, "", 0);
}

static bool write_careful(TextSink *text, const LsysWord *part) {
  const double *arg = part->arg;
  for (uint64_t i = 0; i < part->nsym; i++) {
    unsigned kind = kind_at(text, part, i);
    const Spelling *spelling = &text->spelling[kind];
    bool full = text->placed_count == text->placed_size || text->window_size - text->window_used < spelling->most;
    if (full && !write_window(text, false)) return false;
    char *end = put_module(text->window + text->window_used, spelling, arg);
    arg += spelling->arity;
    text->window_used = (size_t)(end - text->window);
    text->placed[text->placed_count++] = (Placed){kind, (uint32_t)text->window_used};
  }
  return true;
}

// ---- the sink ----------------------------------------------------------------

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)axiom, (void)pass;
  ((TextSink *)sink)->modules = 0;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  TextSink *text = (TextSink *)sink;
  if (!part->nsym) return true;
  text->modules += part->nsym;
  text->last = kind_at(text, part, part->nsym - 1);
  return text->careful ? write_careful(text, part) : write_plain(text, part);
}

// A word of one `*` would read as the empty word, one of `\` would go on in the next line.
static bool end(LsysSink *sink) {
  TextSink *text = (TextSink *)sink;
  if (text->careful && !write_window(text, true)) return false;
  const Spelling *last = &text->spelling[text->last];
  bool alone = text->modules == 1 && !last->arity && last->length == 1 && strchr("*\\", *last->symbol);
  return lsys_out_write(text->out, alone ? "()\n" : "\n", alone ? 3 : 1);
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  TextSink *text = (TextSink *)sink;
  lsys_memory_free(text->memory, text->window, text->window_size, 1);
  lsys_memory_free(text->memory, text->placed, text->placed_size, sizeof *text->placed);
  lsys_memory_free(text->memory, text, 1, sizeof *text + text->kind_count * sizeof *text->spelling);
}

static void spell(TextSink *text, const LsysGrammar *grammar) {
  size_t widest = 0;
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    Spelling *spelling = &text->spelling[i];
    spelling->symbol = grammar->kinds[i].symbol;
    spelling->length = (uint32_t)strlen(spelling->symbol);
    spelling->arity = grammar->kinds[i].arity;
    spelling->most = (uint32_t)longer(spelling->length, SHORT_SYMBOL) + 2 + spelling->arity * (LSYS_NUMBER_SIZE + 1u);
    if (spelling->length <= SHORT_SYMBOL) memcpy(spelling->padded, spelling->symbol, spelling->length);
    spelling->careful = !spelling->arity && is_careful(grammar, spelling->symbol);
    spelling->empty_parentheses = !spelling->arity && strcmp(spelling->symbol, ",") == 0;
    text->careful |= spelling->careful;
    text->longest = (uint32_t)longer(text->longest, spelling->length + 8);
    widest = longer(widest, spelling->most);
  }
  for (int op = LSYS_TURTLE_NONE + 1; op < LSYS_TURTLE_COUNT; op++)
    text->longest = (uint32_t)longer(text->longest, strlen(lsys_turtle[op].symbol) + 8);
  text->window_size = PIECE + text->longest + widest;
  text->placed_size = PIECE + text->longest;
}

LsysSink *lsys_sink_text(const LsysSinkContext *context) {
  const LsysGrammar *grammar = context->grammar;
  TextSink *text = lsys_memory_alloc(context->memory, 1, sizeof *text + grammar->kind_count * sizeof *text->spelling);
  if (!text) return NULL;
  text->sink = (LsysSink){1, begin, take, end, finish, destroy};
  text->memory = context->memory;
  text->out = context->out;
  text->kind_count = grammar->kind_count;
  text->width = lsys_symbol_width(grammar);
  spell(text, grammar);
  text->window = lsys_memory_alloc(text->memory, text->window_size, 1);
  text->placed = lsys_memory_alloc(text->memory, text->placed_size, sizeof *text->placed);
  if (text->window && text->placed) return &text->sink;
  destroy(&text->sink);
  return NULL;
}
