// context.c -- what stands to the left and right of a module in a tree that
// is written as a word with brackets.
//
//   A B C [ D E ] [ S G [ H I [ J K ] L ] M N O ]
//
// Left: the path to the root. C is left of D and of S: sibling branches are
// not on the path. Right: the rest of the module's axis; a branch on it is
// stepped over unless the context names it, as in BC < S > G[H]M, which
// holds for the S above.
// Source: ABOP p. 30-32; LANGUAGE.md 5.4.
#include "interp/context.h"

#include <stdlib.h>

enum { DEEPEST_PATTERN = 1000 };

// ---- neighbours ------------------------------------------------------------

static bool ignored(const Links *links, KindId kind) {
  return links->lsystem->ignored && links->lsystem->ignored[kind];
}

static KindId kind_at(const Links *links, size_t i) {
  return links->word->at[i].kind;
}

static void path_push(LsysRun *run, Links *links, size_t *depth, size_t module) {
  BOXES_RESERVE(run, links->path, *depth, links->path_room);
  links->path[(*depth)++] = module;
}

// Pairs brackets: `[` gets its `]` (or the word's length), a `]` that closes
// one gets its `[`, an unmatched one NOWHERE. Returns how many `[` stay open.
static size_t pair_brackets(LsysRun *run, Links *links) {
  size_t depth = 0;
  for (size_t i = 0; i < links->word->count; i++) {
    links->at[i].close = NOWHERE;
    if (kind_at(links, i) == links->program->open) {
      links->at[i].close = links->word->count;
      path_push(run, links, &depth, i);
    } else if (kind_at(links, i) == links->program->close && depth) {
      size_t open = links->path[--depth];
      links->at[open].close = i;
      links->at[i].close = open;
    }
  }
  return depth;
}

// Left neighbours, by a walk that keeps the last module of each open axis.
// before: what the root's axis begins behind. Returns the last module of the root's axis.
static size_t link_left(LsysRun *run, Links *links, size_t before) {
  size_t depth = 0;
  bool begins = false;
  path_push(run, links, &depth, before);
  for (size_t i = 0; i < links->word->count; i++) {
    Link *link = &links->at[i];
    KindId kind = kind_at(links, i);
    link->left = links->path[depth - 1];
    link->begins_branch = begins;
    if (kind == links->program->open) {
      path_push(run, links, &depth, link->left);
      begins = true;
    } else if (kind == links->program->close) {
      if (depth > 1)
        depth--;
      else
        links->path[0] = NOWHERE;  // an unmatched ] ends the axis
      // After a branch, a module still begins the one around it if no other module stood before.
      begins = link->close != NOWHERE && links->at[link->close].begins_branch;
    } else if (!ignored(links, kind)) {
      links->path[depth - 1] = i;
      begins = false;
    }
  }
  return links->path[0];
}

// Right neighbours, by a walk from the end. open: branches that the word's end
// cuts off. Returns the first module of the root's axis.
static size_t link_right(LsysRun *run, Links *links, size_t open, size_t after) {
  size_t depth = 0;
  path_push(run, links, &depth, after);
  for (size_t i = 0; i < open; i++) path_push(run, links, &depth, NOWHERE);
  for (size_t i = links->word->count; i-- > 0;) {
    Link *link = &links->at[i];
    KindId kind = kind_at(links, i);
    link->right = links->path[depth - 1];
    if (kind == links->program->open) {
      depth--;
    } else if (kind == links->program->close) {
      if (link->close == NOWHERE)
        links->path[depth - 1] = link->right = NOWHERE;
      else
        path_push(run, links, &depth, NOWHERE);
    } else if (!ignored(links, kind)) {
      links->path[depth - 1] = i;
    }
  }
  return links->path[0];
}

void links_find(LsysRun *run, Links *links, const Program *program, const LSystem *lsystem, const Boxes *word) {
  links->program = program;
  links->lsystem = lsystem;
  links->word = word;
  while (links->room < word->count) {
    links->at = boxes_grow(run, links->at, links->room, &links->room, sizeof *links->at);
  }
  size_t open = pair_brackets(run, links);
  size_t last = link_left(run, links, NOWHERE);
  size_t first = link_right(run, links, open, NOWHERE);
  if (lsystem->ring) {
    link_left(run, links, last);
    link_right(run, links, open, first);
  }
}

void links_free(Links *links) {
  free(links->at);
  free(links->path);
  *links = (Links){0};
}

// ---- matching ----------------------------------------------------------------

static void bind(const Links *links, const Pattern *pattern, size_t module, Scope *scope) {
  const Box *box = &links->word->at[module];
  for (uint32_t a = 0; a < links->program->kinds[box->kind].arity; a++) {
    scope->slot[scope->base + pattern->slot + a] = links->word->arg[box->args + a];
  }
}

bool match_left(const Links *links, const Context *context, size_t first, size_t last, Scope *scope) {
  size_t at = first;
  bool around = false;  // a ring: past the word's beginning, down from its end to the strict predecessor
  for (size_t p = context->count; p-- > 0;) {
    const Pattern *pattern = &context->at[p];
    if (pattern->what == PATTERN_OPEN) {
      if (!links->at[at].begins_branch) return false;
      continue;
    }
    size_t next = links->at[at].left;
    if (next == NOWHERE || (around && next >= at)) return false;
    around |= next >= at;
    if (around && next <= last) return false;
    if (pattern->what != PATTERN_MODULE || kind_at(links, next) != pattern->kind) return false;
    bind(links, pattern, next, scope);
    at = next;
  }
  return true;
}

// A right context in progress.
typedef struct Match {
  const Links *links;
  const Context *context;
  size_t first, last;  // the strict predecessor
  Scope *scope;
  unsigned depth;  // open [ of the pattern
} Match;

// A place on an axis: behind the module at, and behind the branches before from.
typedef struct AxisPlace {
  size_t at, from;
  bool around;  // a ring: at is past the word's end; from may be before it is
  bool rest;    // the rest of the branch was skipped
} AxisPlace;

// The next branch at a place, as the index of its `[`.
static size_t next_branch(const Match *match, const AxisPlace *place) {
  const Links *links = match->links;
  bool around = place->around || place->from <= place->at;
  for (size_t i = place->from;; i++) {
    if (i >= links->word->count) {
      if (!links->lsystem->ring || around) return NOWHERE;
      around = true;
      i = 0;
    }
    if (around && i >= match->first) return NOWHERE;
    if (kind_at(links, i) == links->program->open) return i;
    if (kind_at(links, i) == links->program->close || !ignored(links, kind_at(links, i))) return NOWHERE;
  }
}

// The next module of the axis; NOWHERE at its end, which in a ring is the strict predecessor.
static size_t next_module(const Match *match, const AxisPlace *place) {
  size_t next = place->rest ? NOWHERE : match->links->at[place->at].right;
  if (next == NOWHERE || next > place->at) return place->around && next >= match->first ? NOWHERE : next;
  return place->around || next >= match->first ? NOWHERE : next;
}

static bool step_module(const Match *match, const Pattern *pattern, AxisPlace *place) {
  size_t next = next_module(match, place);
  if (next == NOWHERE || kind_at(match->links, next) != pattern->kind) return false;
  bind(match->links, pattern, next, match->scope);
  *place = (AxisPlace){next, next + 1, place->around || next <= place->at, false};
  return true;
}

// In cpfg a ] in a context is a module like others: it has to stand there, unless `=` skipped what stood before it.
static bool is_literal_close(const Match *match, const Pattern *pattern) {
  return pattern->what == PATTERN_MODULE && pattern->kind == match->links->program->close;
}

// The pattern's index behind the ] that closes the group before p.
static size_t group_end(const Match *match, size_t p) {
  unsigned depth = 1;
  while (p < match->context->count) {
    const Pattern *pattern = &match->context->at[p++];
    if (pattern->what == PATTERN_OPEN) depth++;
    bool close = pattern->what == PATTERN_CLOSE || is_literal_close(match, pattern);
    if (close && --depth == 0) break;
  }
  return p;
}

static bool match_axis(Match *match, size_t p, size_t end, AxisPlace place);

// Finds the first branch at place that the group p..end fits, and steps behind it.
static bool step_group(Match *match, size_t p, size_t end, AxisPlace *place) {
  if (place->rest) return false;
  if (++match->depth > DEEPEST_PATTERN) {
    lsys_fail(match->scope->run, "a right context nests more than %d brackets", DEEPEST_PATTERN);
  }
  bool fits = false;
  for (size_t open; !fits && (open = next_branch(match, place)) != NOWHERE;) {
    size_t close = match->links->at[open].close;
    bool around = place->around || open < place->at;
    place->from = close + 1;
    fits = match_axis(match, p, end, (AxisPlace){open, open + 1, around, false});
    if (close >= match->links->word->count) break;
  }
  match->depth--;
  return fits;
}

// True if a ] follows on the axis, behind ignored modules and branches.
static bool at_close(const Match *match, const AxisPlace *place) {
  const Links *links = match->links;
  for (size_t i = place->from; next_module(match, place) == NOWHERE && i < links->word->count; i++) {
    if (kind_at(links, i) == links->program->close) return true;
    if (kind_at(links, i) == links->program->open) i = links->at[i].close;
  }
  return false;
}

// Patterns p..end against what stands behind place.
static bool match_axis(Match *match, size_t p, size_t end, AxisPlace place) {
  while (p < end) {
    const Pattern *pattern = &match->context->at[p++];
    switch (pattern->what) {
    case PATTERN_MODULE: {
      bool close = is_literal_close(match, pattern);
      if (close ? !place.rest && !at_close(match, &place) : !step_module(match, pattern, &place)) return false;
      place.rest |= close;
      break;
    }
    case PATTERN_OPEN: {
      size_t behind = group_end(match, p);
      if (!step_group(match, p, behind, &place)) return false;
      p = behind;
      break;
    }
    case PATTERN_CLOSE:
    case PATTERN_REST:
      place.rest = true;
      break;
    case PATTERN_END:
      if (next_module(match, &place) != NOWHERE) return false;
      break;
    }
  }
  return true;
}

bool match_right(const Links *links, const Context *context, size_t first, size_t last, Scope *scope) {
  Match match = {links, context, first, last, scope, 0};
  return match_axis(&match, 0, context->count, (AxisPlace){last, last + 1, false, false});
}
