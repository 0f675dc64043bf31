// trie.h -- a map from byte strings to values that also answers "what is the
// longest key that this text begins with?", as a scanner of declared names
// must. Serves as the interner, too.
#ifndef LSYSC_SUPPORT_TRIE_H
#define LSYSC_SUPPORT_TRIE_H

#include "support/arena.h"

typedef struct Trie Trie;

Trie *trie_create(Arena *arena);

// The place of a key's value: NULL there when the key is new. length > 0.
void **trie_at(Trie *trie, const char *key, size_t length);

// The value of a key, NULL if it has none.
void *trie_find(const Trie *trie, const char *key, size_t length);

// Length of the longest key with a value that text[0..length) begins with; 0: none does.
size_t trie_longest(const Trie *trie, const char *text, size_t length);

// The one copy of a string that this trie of strings holds.
const char *trie_intern(Trie *trie, const char *text, size_t length);

#endif
