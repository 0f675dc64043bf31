// spelling.c -- the scanner's view of a word's text: it takes the longest name
// that stands at a place (LANGUAGE.md section 2), so a symbol is `careful` if
// modules of the grammar could go on from it to a longer name.
#include "sinks/spelling.h"

#include "lsys/number.h"

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

size_t lsys_speller_scan(const LsysSpeller *speller, const char *text, size_t size) {
  size_t length = longer(character_length(text, size), compound_length(text, size));
  for (size_t i = 0; i < speller->name_count; i++) {
    const LsysName *name = &speller->names[i];
    if (name->length > length && name->length <= size && memcmp(name->at, text, name->length) == 0)
      length = name->length;
  }
  return length;
}

// ---- what needs care -----------------------------------------------------------

// True if some kind's symbol begins like rest, or is the beginning of it.
static bool can_continue(const LsysSpeller *speller, const char *rest, size_t size) {
  for (uint32_t i = 0; i < speller->kind_count; i++) {
    const LsysSpelling *kind = &speller->kinds[i];
    if (memcmp(kind->symbol, rest, kind->length < size ? kind->length : size) == 0) return true;
  }
  return false;
}

static bool some_symbol_begins(const LsysSpeller *speller, bool (*how)(char)) {
  for (uint32_t i = 0; i < speller->kind_count; i++)
    if (how(speller->kinds[i].symbol[0])) return true;
  return false;
}

static bool is_careful(const LsysSpeller *speller, const char *symbol, size_t length) {
  size_t first = character_length(symbol, length);
  if (strcmp(symbol, "?") == 0 && some_symbol_begins(speller, is_letter)) return true;
  if (strcmp(symbol, "/") == 0 && can_continue(speller, "*", 1)) return true;
  if (length == first && is_letter(symbol[0]) && can_continue(speller, "_", 1)) return true;
  bool numbered = length > first + 1 && symbol[first] == '_' && is_digit(symbol[first + 1]);
  if (numbered && some_symbol_begins(speller, is_digit)) return true;
  for (size_t i = 0; i < speller->name_count; i++) {
    const LsysName *name = &speller->names[i];
    if (name->length > length && memcmp(name->at, symbol, length) == 0
        && can_continue(speller, name->at + length, name->length - length))
      return true;
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

bool lsys_speller_open(LsysSpeller *speller, const LsysGrammar *grammar, LsysMemory *memory) {
  uint32_t count = grammar->kind_count;
  *speller = (LsysSpeller){.memory = memory, .kind_count = count, .longest = 1};
  speller->kinds = lsys_memory_alloc(memory, count, sizeof *speller->kinds);
  if (!speller->kinds) return false;
  for (uint32_t i = 0; i < count; i++) {
    LsysSpelling *kind = &speller->kinds[i];
    kind->symbol = grammar->kinds[i].symbol;
    kind->length = (uint32_t)strlen(kind->symbol);
    kind->arity = grammar->kinds[i].arity;
    kind->most = (uint32_t)longer(kind->length, LSYS_SHORT_SYMBOL) + 2 + kind->arity * (LSYS_NUMBER_SIZE + 1u);
    if (kind->length <= LSYS_SHORT_SYMBOL) memcpy(kind->padded, kind->symbol, kind->length);
    kind->empty_parentheses = !kind->arity && strcmp(kind->symbol, ",") == 0;
  }
  if (!add_names(speller, grammar)) return false;
  for (uint32_t i = 0; i < count; i++)
    speller->kinds[i].careful =
      !speller->kinds[i].arity && is_careful(speller, speller->kinds[i].symbol, speller->kinds[i].length);
  return true;
}

void lsys_speller_close(LsysSpeller *speller) {
  lsys_memory_free(speller->memory, speller->kinds, speller->kind_count, sizeof *speller->kinds);
  lsys_memory_free(speller->memory, speller->names, speller->name_room, sizeof *speller->names);
  speller->kinds = NULL;
  speller->names = NULL;
}
