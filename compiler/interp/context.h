// context.h -- neighbours of modules in a bracketed word, and the matching of
// contexts against them.
#ifndef LSYSC_INTERP_CONTEXT_H
#define LSYSC_INTERP_CONTEXT_H

#include "interp/evaluate.h"
#include "interp/word.h"

#define NOWHERE SIZE_MAX

// The neighbours of one module, as contexts see them: brackets are structure,
// modules that the L-system ignores are not there.
typedef struct Link {
  size_t left;         // the module before it on the path to the root
  size_t right;        // the next module on its axis; of a `[`, the first inside; NOWHERE at the branch's end
  size_t close;        // of a `[`: its `]`, or the word's length
  bool begins_branch;  // nothing but a `[` stands between it and left
} Link;

typedef struct Links {
  Link *at;  // one per module of word
  size_t room;
  size_t *path;  // scratch: one element per open branch
  size_t path_room;
  const Boxes *word;
  const Program *program;
  const LSystem *lsystem;
} Links;

// Finds the neighbours of every module of word for an L-system. The word must
// outlive the links.
void links_find(LsysRun *run, Links *links, const Program *program, const LSystem *lsystem, const Boxes *word);
void links_free(Links *links);

// Match the context of a strict predecessor that stands at first..last and
// put the arguments of its modules into the current frame of scope.
bool match_left(const Links *links, const Context *context, size_t first, size_t last, Scope *scope);
bool match_right(const Links *links, const Context *context, size_t first, size_t last, Scope *scope);

#endif
