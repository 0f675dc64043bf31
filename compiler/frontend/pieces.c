// pieces.c -- a statement as the pieces that the scanner reads: which bytes are
// words, which expressions, which tokens by themselves.
#include "frontend/parse.tab.h"
#include "frontend/split.h"
#include "support/utf8.h"

// Without the white space behind it.
static size_t trimmed(const char *begin, const char *end) {
  while (end > begin && (unsigned char)end[-1] <= ' ') end--;
  return (size_t)(end - begin);
}

size_t statement_label(const char *begin, const char *colon) {
  size_t length = trimmed(begin, colon);
  bool digit = false;
  for (size_t i = 0; i < length; i++) {
    char c = begin[i];
    bool number = c >= '0' && c <= '9', letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    if (!letter && (!number || i == 0)) return 0;
    digit |= number;
  }
  return digit || (length == 1 && *begin == 'p') ? length : 0;
}

bool statement_is_production(const Statement *s, const Trie *declared) {
  if (!s->arrow) return false;
  const KeywordMatch *first = &s->first;
  if (!first->keyword) return true;
  if (*s->begin == '#') return false;
  if (!first->colon) return true;
  size_t length = (size_t)(first->end - s->begin);
  return length == utf8_length(s->begin, s->end) || trie_find(declared, s->begin, length);
}

typedef struct Pieces {
  const Statement *s;
  Piece *at;
  size_t count;
} Pieces;

static void add(Pieces *pieces, ScanMode mode, int token, const char *begin, const char *end) {
  Piece *piece = &pieces->at[pieces->count++];
  *piece = (Piece){mode, token, 0, begin, (size_t)(end - begin), statement_span(pieces->s, begin, end)};
}

static void add_production(Pieces *pieces, const Trie *declared) {
  const Statement *s = pieces->s;
  const char *at = s->begin, *colon = s->colons[0];
  size_t label = s->notation->labels && colon && !s->first.keyword ? statement_label(at, colon) : 0;
  if (label && !trie_find(declared, at, label)) {
    add(pieces, SCAN_TOKEN, TOK_LABEL, at, at + label);  // its colon is no token
    at = colon + 1;
    colon = s->colons[1];
  }
  add(pieces, SCAN_WORD, 0, at, colon ? colon : s->arrow);
  if (colon) {
    add(pieces, SCAN_TOKEN, TOK_COLON, colon, colon + 1);
    add(pieces, SCAN_BLOCK, 0, colon + 1, s->arrow);
  }
  add(pieces, SCAN_TOKEN, TOK_ARROW, s->arrow, s->arrow_end);
  add(pieces, SCAN_WORD, 0, s->arrow_end, s->weight ? s->weight : s->end);
  if (s->weight) {
    add(pieces, SCAN_TOKEN, TOK_COLON, s->weight, s->weight + 1);
    add(pieces, SCAN_EXPRESSION, 0, s->weight + 1, s->end);
  }
}

size_t statement_pieces(const Statement *s, const Trie *declared, Piece pieces[MOST_PIECES]) {
  Pieces all = {s, pieces, 0};
  if (statement_is_production(s, declared)) {
    add_production(&all, declared);
  } else {
    add(&all, SCAN_TOKEN, s->first.keyword->token, s->begin, s->first.end);
    pieces[0].setting = s->first.keyword->setting;
    add(&all, s->first.keyword->rest, 0, s->first.rest, s->end);
  }
  return all.count;
}
