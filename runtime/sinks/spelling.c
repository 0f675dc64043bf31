// spelling.c -- the scanner's view of a word's text: it takes the longest name
// that stands at a place (LANGUAGE.md section 2), so a symbol is `careful` if
// modules of the grammar could go on from it to a longer name.
#include "sinks/spelling.h"

#include "lsys/number.h"
#include "lsys/quote.h"

#include <stdlib.h>
#include <string.h>

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

// ---- sorted names ---------------------------------------------------------------

// As memcmp orders bytes, the shorter one first where one is the beginning of the other.
static int compare(const void *left, const void *right) {
  const LsysName *a = left, *b = right;
  int order = memcmp(a->at, b->at, a->length < b->length ? a->length : b->length);
  return order ? order : (a->length > b->length) - (a->length < b->length);
}

// The first name that is not before key.
static size_t lower_bound(const LsysName *names, size_t count, LsysName key) {
  size_t low = 0, high = count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (compare(&names[middle], &key) < 0)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

static bool begins(LsysName name, LsysName with) {
  return name.length >= with.length && memcmp(name.at, with.at, with.length) == 0;
}

static bool contains(const LsysName *names, size_t count, LsysName key) {
  size_t i = lower_bound(names, count, key);
  return i < count && names[i].length == key.length && begins(names[i], key);
}

size_t lsys_speller_scan(const LsysSpeller *speller, const char *text, size_t size) {
  size_t length = longer(character_length(text, size), compound_length(text, size));
  for (size_t n = size < speller->longest ? size : speller->longest; n > length; n--)
    if (contains(speller->names, speller->name_count, (LsysName){text, n})) return n;
  return length;
}

// ---- what needs care -----------------------------------------------------------

// True if some kind's symbol begins like rest, or is the beginning of it.
static bool can_continue(const LsysSpeller *speller, LsysName rest) {
  size_t count = speller->kind_count, i = lower_bound(speller->symbols, count, rest);
  if (i < count && begins(speller->symbols[i], rest)) return true;
  for (size_t n = 1; n < rest.length; n++)
    if (contains(speller->symbols, count, (LsysName){rest.at, n})) return true;
  return false;
}

static bool is_careful(const LsysSpeller *speller, LsysName symbol) {
  const char *at = symbol.at;
  size_t length = symbol.length, first = character_length(at, length);
  if (length == 1 && *at == '?' && speller->letter_begins) return true;
  if (length == 1 && *at == '/' && can_continue(speller, (LsysName){"*", 1})) return true;
  if (length == first && is_letter(*at) && can_continue(speller, (LsysName){"_", 1})) return true;
  bool numbered = length > first + 1 && at[first] == '_' && is_digit(at[first + 1]);
  if (numbered && speller->digit_begins) return true;
  size_t i = lower_bound(speller->names, speller->name_count, symbol);
  for (; i < speller->name_count && begins(speller->names[i], symbol); i++) {
    LsysName rest = {speller->names[i].at + length, speller->names[i].length - length};
    if (rest.length && can_continue(speller, rest)) return true;
  }
  return false;
}

// ---- opening ---------------------------------------------------------------------

static bool add_name(LsysSpeller *speller, const char *at, size_t length) {
  if (length < 2) return true;  // every character is a symbol anyway
  if (speller->name_count == speller->name_room) {
    void *grown = lsys_memory_grow(speller->memory, speller->names, &speller->name_room, sizeof *speller->names);
    if (!grown) return false;
    speller->names = grown;
  }
  speller->names[speller->name_count++] = (LsysName){at, length};
  speller->longest = longer(speller->longest, length);
  return true;
}

static bool add_names(LsysSpeller *speller, const LsysGrammar *grammar) {
  bool well = true;
  for (uint32_t i = 0; well && i < speller->kind_count; i++)
    well = add_name(speller, speller->kinds[i].symbol, speller->kinds[i].length);
  for (int op = LSYS_TURTLE_NONE + 1; well && op < LSYS_TURTLE_COUNT; op++)
    well = add_name(speller, lsys_turtle[op].symbol, strlen(lsys_turtle[op].symbol));
  for (const char *at = grammar->names; well && at && *at;) {
    size_t length = strcspn(at, " ");
    well = add_name(speller, at, length);
    at += length + (at[length] == ' ');
  }
  return well;
}

static bool add_text(LsysSpelling *kind, const char *text, LsysMemory *memory) {
  kind->quoted_size = lsys_quoted_size(text);
  kind->quoted = lsys_memory_alloc(memory, kind->quoted_size, 1);
  if (!kind->quoted) return false;
  lsys_quote(kind->quoted, text);
  kind->parentheses = true;
  kind->most += (uint32_t)kind->quoted_size + 1;
  return true;
}

bool lsys_speller_open(LsysSpeller *speller, const LsysGrammar *grammar, LsysMemory *memory) {
  uint32_t count = grammar->kind_count;
  *speller = (LsysSpeller){.memory = memory, .kind_count = count, .longest = 1};
  speller->kinds = lsys_memory_alloc(memory, count, sizeof *speller->kinds);
  speller->symbols = lsys_memory_alloc(memory, count, sizeof *speller->symbols);
  if (!speller->kinds || !speller->symbols) return false;
  for (uint32_t i = 0; i < count; i++) {
    LsysSpelling *kind = &speller->kinds[i];
    kind->symbol = grammar->kinds[i].symbol;
    kind->length = (uint32_t)strlen(kind->symbol);
    kind->arity = grammar->kinds[i].arity;
    kind->most = (uint32_t)longer(kind->length, LSYS_SHORT_SYMBOL) + 2 + kind->arity * (LSYS_NUMBER_SIZE + 1u);
    if (kind->length <= LSYS_SHORT_SYMBOL) memcpy(kind->padded, kind->symbol, kind->length);
    kind->parentheses = kind->arity || strcmp(kind->symbol, ",") == 0;
    if (grammar->texts && grammar->texts[i] && !add_text(kind, grammar->texts[i], memory)) return false;
    speller->symbols[i] = (LsysName){kind->symbol, kind->length};
    speller->letter_begins |= is_letter(kind->symbol[0]);
    speller->digit_begins |= is_digit(kind->symbol[0]);
  }
  if (!add_names(speller, grammar)) return false;
  qsort(speller->symbols, count, sizeof *speller->symbols, compare);
  qsort(speller->names, speller->name_count, sizeof *speller->names, compare);
  for (uint32_t i = 0; i < count; i++) {
    LsysSpelling *kind = &speller->kinds[i];
    kind->careful = !kind->parentheses && is_careful(speller, (LsysName){kind->symbol, kind->length});
  }
  return true;
}

void lsys_speller_close(LsysSpeller *speller) {
  for (uint32_t i = 0; speller->kinds && i < speller->kind_count; i++)
    lsys_memory_free(speller->memory, speller->kinds[i].quoted, speller->kinds[i].quoted_size, 1);
  lsys_memory_free(speller->memory, speller->kinds, speller->kind_count, sizeof *speller->kinds);
  lsys_memory_free(speller->memory, speller->names, speller->name_room, sizeof *speller->names);
  lsys_memory_free(speller->memory, speller->symbols, speller->kind_count, sizeof *speller->symbols);
  speller->kinds = NULL;
  speller->names = speller->symbols = NULL;
}
