// text.c -- a word as text that reads back as the same word (LANGUAGE.md section 9).
//
// A blank stands only where two modules would otherwise scan differently
// (spelling.h). The common grammars never need one and are written straight
// through; where all symbols are single bytes, two modules at a time.
#include "core/formats.h"
#include "core/stream.h"
#include "lsys/number.h"
#include "sinks/spelling.h"

#include <string.h>

enum {
  PIECE = 1 << 15,      // bytes of text that are made at once
  MOST_PAIRED = 64,     // kinds of a grammar whose pairs are tabulated
  CACHE_BITS = 10,      // of the table of numbers printed before
  LONGEST_NUMBER = 24,  // -2.2250738585072014e-308

};

// A number and its text: words have few different numbers, and finding one is cheaper than printing it.
typedef struct Printed {
  uint64_t bits;
  char text[LONGEST_NUMBER];
  uint64_t length;  // 0: none here
} Printed;

// A module whose text is in the window, and the end of that text.
typedef struct Placed {
  uint32_t kind, end;
} Placed;

// Text that is not written yet because what follows may ask for a blank.
typedef struct Window {
  char *text;
  Placed *placed;
  size_t used, count;  // of text, of placed
  size_t size, most;
  size_t decides;  // bytes that decide how the module in front of them scans
} Window;

typedef struct TextSink {
  LsysSink sink;
  LsysMemory *memory;
  LsysOut *out;
  LsysSpeller speller;
  unsigned width;
  uint64_t modules;  // of this word so far
  uint32_t last;     // the last one's kind
  bool careful;      // some symbol is
  Window window;     // if careful
  uint16_t *pair;    // pair[a | b << 8]: the two bytes of kinds a and b; NULL unless all kinds are single bytes
  Printed *printed;  // NULL unless some kind has arguments
} TextSink;

// ---- one module --------------------------------------------------------------

static char *put_number(Printed *cache, char *to, double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  Printed *printed = &cache[(bits * LSYS_GOLDEN) >> (64 - CACHE_BITS)];
  if (printed->bits != bits || !printed->length) {
    char number[LSYS_NUMBER_SIZE];
    printed->length = (uint64_t)(lsys_number_print(number, x) - number);
    printed->bits = bits;
    memcpy(printed->text, number, LONGEST_NUMBER);
  }
  memcpy(to, printed->text, LONGEST_NUMBER);
  return to + printed->length;
}

// Writes one module; to has room for spelling->most bytes.
static char *put_module(Printed *cache, char *to, const LsysSpelling *spelling, const double *arg) {
  if (spelling->length <= LSYS_SHORT_SYMBOL)
    memcpy(to, spelling->padded, LSYS_SHORT_SYMBOL);
  else
    memcpy(to, spelling->symbol, spelling->length);
  to += spelling->length;
  if (!spelling->parentheses) return to;
  *to++ = '(';
  if (spelling->quoted) {
    memcpy(to, spelling->quoted, spelling->quoted_size);
    to += spelling->quoted_size;
    if (spelling->arity) *to++ = ',';
  }
  for (unsigned i = 0; i < spelling->arity; i++) {
    if (i) *to++ = ',';
    to = put_number(cache, to, arg[i]);
  }
  *to++ = ')';
  return to;
}

static unsigned kind_at(const TextSink *text, const LsysWord *part, uint64_t i) {
  return text->width == 1 ? part->sym[i] : (unsigned)(part->sym[2 * i] | part->sym[2 * i + 1] << 8);
}

// ---- whole parts -------------------------------------------------------------

// Every module is one byte.
static bool write_pairs(TextSink *text, const LsysWord *part) {
  const uint8_t *sym = part->sym;
  for (uint64_t left = part->nsym; left;) {
    size_t n = left < PIECE ? (size_t)left : PIECE, i = 0;
    char *to = lsys_out_room(text->out, PIECE);
    for (; i + 2 <= n; i += 2) memcpy(to + i, &text->pair[sym[i] | sym[i + 1] << 8], 2);
    if (i < n) to[i] = text->speller.kinds[sym[i]].padded[0];
    lsys_out_filled(text->out, n);
    sym += n;
    left -= n;
  }
  return lsys_out_write(text->out, "", 0);
}

// Modules of a part from the i-th on.
typedef struct Rest {
  const LsysWord *part;
  uint64_t i;
  const double *arg;
} Rest;

// Writes modules until PIECE bytes are passed, none is left, or the next one is longer than that; to has room for
// twice as many.
static char *put_piece(const TextSink *text, Printed *cache, char *to, Rest *rest) {
  const char *enough = to + PIECE;
  while (rest->i < rest->part->nsym && to < enough) {
    const LsysSpelling *spelling = &text->speller.kinds[kind_at(text, rest->part, rest->i)];
    if (spelling->most > PIECE) break;
    to = put_module(cache, to, spelling, rest->arg);
    rest->arg += spelling->arity;
    rest->i++;
  }
  return to;
}

// A module that does not fit into a piece.
static bool write_long(TextSink *text, const LsysSpelling *spelling, const double *arg) {
  char *buffer = lsys_memory_alloc(text->memory, spelling->most, 1);
  if (!buffer) return false;
  char *end = put_module(text->printed, buffer, spelling, arg);
  bool well = lsys_out_write(text->out, buffer, (size_t)(end - buffer));
  lsys_memory_free(text->memory, buffer, spelling->most, 1);
  return well;
}

static bool write_plain(TextSink *text, const LsysWord *part) {
  Rest rest = {.part = part, .arg = part->arg};
  while (rest.i < part->nsym) {
    char *room = lsys_out_room(text->out, 2 * PIECE);
    lsys_out_filled(text->out, (size_t)(put_piece(text, text->printed, room, &rest) - room));
    if (rest.i == part->nsym) break;
    const LsysSpelling *next = &text->speller.kinds[kind_at(text, part, rest.i)];
    if (next->most <= PIECE) continue;
    if (!write_long(text, next, rest.arg)) return false;
    rest.arg += next->arity;
    rest.i++;
  }
  return lsys_out_write(text->out, "", 0);
}

// ---- words that may need blanks ----------------------------------------------

static bool needs_blank(const TextSink *text, const LsysSpelling *spelling, const char *at, size_t available) {
  return spelling->careful && lsys_speller_scan(&text->speller, at, available) != spelling->length;
}

// Writes the modules of the window of which enough text follows to decide on a
// blank, all of them at the end of the word; moves the rest to its beginning.
static bool write_window(TextSink *text, bool at_end) {
  Window *window = &text->window;
  size_t start = 0, i = 0;
  for (; i < window->count; i++) {
    const char *at = window->text + start;
    size_t available = window->used - start, end = window->placed[i].end;
    if (!at_end && available < window->decides) break;
    lsys_out_write(text->out, at, end - start);
    if (needs_blank(text, &text->speller.kinds[window->placed[i].kind], at, available))
      lsys_out_write(text->out, " ", 1);
    start = end;
  }
  window->used -= start;
  window->count -= i;
  memmove(window->text, window->text + start, window->used);
  memmove(window->placed, window->placed + i, window->count * sizeof *window->placed);
  for (size_t j = 0; j < window->count; j++) window->placed[j].end -= (uint32_t)start;
  return lsys_out_write(text->out, "", 0);
}

static bool write_careful(TextSink *text, const LsysWord *part) {
  Window *window = &text->window;
  const double *arg = part->arg;
  for (uint64_t i = 0; i < part->nsym; i++) {
    unsigned kind = kind_at(text, part, i);
    const LsysSpelling *spelling = &text->speller.kinds[kind];
    bool full = window->count == window->most || window->size - window->used < spelling->most;
    if (full && !write_window(text, false)) return false;
    char *end = put_module(text->printed, window->text + window->used, spelling, arg);
    arg += spelling->arity;
    window->used = (size_t)(end - window->text);
    window->placed[window->count++] = (Placed){kind, (uint32_t)window->used};
  }
  return true;
}

// ---- on other threads --------------------------------------------------------

// Prepared text begins with what end needs to know of the part.
typedef struct Summary {
  uint64_t modules;
  uint32_t last;
} Summary;

static bool prepare_modules(const TextSink *text, const LsysWord *part, LsysPrepared *prepared) {
  Rest rest = {.part = part, .arg = part->arg};
  if (text->printed && !prepared->scratch) {
    prepared->scratch_bytes = sizeof(Printed) << CACHE_BITS;
    prepared->scratch = lsys_memory_alloc(prepared->memory, 1, prepared->scratch_bytes);
    if (!prepared->scratch) return false;
  }
  while (rest.i < part->nsym) {
    const LsysSpelling *next = &text->speller.kinds[kind_at(text, part, rest.i)];
    char *room = lsys_prepared_room(prepared, next->most > PIECE ? next->most : 2 * PIECE);
    if (!room) return false;
    if (next->most > PIECE) {
      prepared->used += (size_t)(put_module(prepared->scratch, room, next, rest.arg) - room);
      rest.arg += next->arity;
      rest.i++;
    } else {
      prepared->used += (size_t)(put_piece(text, prepared->scratch, room, &rest) - room);
    }
  }
  return true;
}

static bool prepare(const LsysSink *sink, const LsysWord *part, LsysPrepared *prepared) {
  const TextSink *text = (const TextSink *)sink;
  Summary summary = {part->nsym, part->nsym ? kind_at(text, part, part->nsym - 1) : 0};
  char *room = lsys_prepared_room(prepared, sizeof summary);
  if (!room) return false;
  memcpy(room, &summary, sizeof summary);
  prepared->used += sizeof summary;
  return prepare_modules(text, part, prepared);
}

static bool accept(LsysSink *sink, const LsysPrepared *prepared) {
  TextSink *text = (TextSink *)sink;
  Summary summary;
  memcpy(&summary, prepared->data, sizeof summary);
  text->modules += summary.modules;
  if (summary.modules) text->last = summary.last;
  return lsys_out_write(text->out, prepared->data + sizeof summary, prepared->used - sizeof summary);
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
  if (text->pair) return write_pairs(text, part);
  return text->careful ? write_careful(text, part) : write_plain(text, part);
}

// A word of one `*` would read as the empty word, one of `\` would go on in the next line.
static bool end(LsysSink *sink) {
  TextSink *text = (TextSink *)sink;
  if (text->careful && !write_window(text, true)) return false;
  const LsysSpelling *last = &text->speller.kinds[text->last];
  bool alone = text->modules == 1 && !last->arity && last->length == 1 && strchr("*\\", *last->symbol);
  return lsys_out_write(text->out, alone ? "()\n" : "\n", alone ? 3 : 1);
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  TextSink *text = (TextSink *)sink;
  LsysMemory *memory = text->memory;
  lsys_memory_free(memory, text->window.text, text->window.size, 1);
  lsys_memory_free(memory, text->window.placed, text->window.most, sizeof *text->window.placed);
  lsys_memory_free(memory, text->pair, 1 << 16, sizeof *text->pair);
  lsys_memory_free(memory, text->printed, 1 << CACHE_BITS, sizeof *text->printed);
  lsys_speller_close(&text->speller);
  lsys_memory_free(memory, text, 1, sizeof *text);
}

static bool open_window(TextSink *text) {
  Window *window = &text->window;
  size_t widest = 0;
  for (uint32_t i = 0; i < text->speller.kind_count; i++) {
    const LsysSpelling *spelling = &text->speller.kinds[i];
    if (widest < spelling->most) widest = spelling->most;
  }
  window->decides = text->speller.longest + LSYS_SHORT_SYMBOL;  // a subscript may follow
  window->size = PIECE + window->decides + widest;
  window->most = PIECE + window->decides;
  window->text = lsys_memory_alloc(text->memory, window->size, 1);
  window->placed = lsys_memory_alloc(text->memory, window->most, sizeof *window->placed);
  return window->text && window->placed;
}

static bool open_pairs(TextSink *text) {
  text->pair = lsys_memory_alloc(text->memory, 1 << 16, sizeof *text->pair);
  for (uint32_t a = 0; text->pair && a < text->speller.kind_count; a++)
    for (uint32_t b = 0; b < text->speller.kind_count; b++) {
      char both[2] = {text->speller.kinds[a].padded[0], text->speller.kinds[b].padded[0]};
      memcpy(&text->pair[a | b << 8], both, 2);
    }
  return text->pair;
}

// Chooses the way of writing that the grammar's symbols allow.
static bool open_tables(TextSink *text) {
  bool parametric = false, single = text->speller.kind_count <= MOST_PAIRED;
  for (uint32_t i = 0; i < text->speller.kind_count; i++) {
    const LsysSpelling *spelling = &text->speller.kinds[i];
    text->careful |= spelling->careful;
    parametric |= spelling->arity > 0;
    single &= spelling->length == 1 && !spelling->parentheses;
  }
  if (parametric) {
    text->printed = lsys_memory_alloc(text->memory, 1 << CACHE_BITS, sizeof *text->printed);
    if (!text->printed) return false;
  }
  if (text->careful) return open_window(text);
  return !single || open_pairs(text);
}

LsysSink *lsys_sink_text(const LsysSinkContext *context) {
  TextSink *text = lsys_memory_alloc(context->memory, 1, sizeof *text);
  if (!text) return NULL;
  text->sink = (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  text->memory = context->memory;
  text->out = context->out;
  text->width = lsys_symbol_width(context->grammar);
  bool well = lsys_speller_open(&text->speller, context->grammar, context->memory) && open_tables(text);
  if (!text->careful && !text->pair) {  // pairs are written as fast as they would be handed over
    text->sink.prepare = prepare;
    text->sink.accept = accept;
  }
  if (well) return &text->sink;
  destroy(&text->sink);
  return NULL;
}
