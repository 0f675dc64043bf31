// trie.c -- one node a byte; the children of a node are a linked list, the
// first level a table, because most symbols are one byte long.
#include "support/trie.h"

typedef struct Node Node;
struct Node {
  Node *next, *child;
  void *value;
  unsigned char byte;
};

struct Trie {
  Arena *arena;
  Node first[256];
};

Trie *trie_create(Arena *arena) {
  Trie *trie = ARENA_NEW(arena, Trie);
  trie->arena = arena;
  return trie;
}

static Node *child(const Node *node, unsigned char byte) {
  Node *at = node->child;
  while (at && at->byte != byte) at = at->next;
  return at;
}

void **trie_at(Trie *trie, const char *key, size_t length) {
  Node *node = &trie->first[(unsigned char)key[0]];
  for (size_t i = 1; i < length; i++) {
    Node *next = child(node, (unsigned char)key[i]);
    if (!next) {
      next = ARENA_NEW(trie->arena, Node);
      *next = (Node){.next = node->child, .byte = (unsigned char)key[i]};
      node->child = next;
    }
    node = next;
  }
  return &node->value;
}

void *trie_find(const Trie *trie, const char *key, size_t length) {
  if (length == 0) return NULL;
  const Node *node = &trie->first[(unsigned char)key[0]];
  for (size_t i = 1; i < length && node; i++) node = child(node, (unsigned char)key[i]);
  return node ? node->value : NULL;
}

size_t trie_longest(const Trie *trie, const char *text, size_t length) {
  if (length == 0) return 0;
  const Node *node = &trie->first[(unsigned char)text[0]];
  size_t longest = 0;
  for (size_t i = 1; node; i++) {
    if (node->value) longest = i;
    if (i == length) break;
    node = child(node, (unsigned char)text[i]);
  }
  return longest;
}

const char *trie_intern(Trie *trie, const char *text, size_t length) {
  if (length == 0) return "";
  void **place = trie_at(trie, text, length);
  if (!*place) *place = arena_copy(trie->arena, text, length);
  return *place;
}
