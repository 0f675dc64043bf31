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

size_t lsys_spelling_scan(const LsysSpelling *spelling, uint32_t count, const char *text, size_t size) {
  size_t length = longer(character_length(text, size), compound_length(text, size));
  for (uint32_t i = 0; i < count; i++) {
    size_t name = spelling[i].length;
    if (name <= size && memcmp(spelling[i].symbol, text, name) == 0) length = longer(length, name);
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

LsysSpelling *lsys_spelling_create(const LsysGrammar *grammar, LsysMemory *memory) {
  LsysSpelling *all = lsys_memory_alloc(memory, grammar->kind_count, sizeof *all);
  for (uint32_t i = 0; all && i < grammar->kind_count; i++) {
    LsysSpelling *one = &all[i];
    one->symbol = grammar->kinds[i].symbol;
    one->length = (uint32_t)strlen(one->symbol);
    one->arity = grammar->kinds[i].arity;
    one->most = (uint32_t)longer(one->length, LSYS_SHORT_SYMBOL) + 2 + one->arity * (LSYS_NUMBER_SIZE + 1u);
    if (one->length <= LSYS_SHORT_SYMBOL) memcpy(one->padded, one->symbol, one->length);
    one->careful = !one->arity && is_careful(grammar, one->symbol);
    one->empty_parentheses = !one->arity && strcmp(one->symbol, ",") == 0;
  }
  return all;
}
