// notation.h -- what the native notation and cpfg's write differently; reader,
// splitter, scanner and grammar are shared.
#ifndef LSYSC_FRONTEND_NOTATION_H
#define LSYSC_FRONTEND_NOTATION_H

#include "support/utf8.h"

#include <stdbool.h>
#include <string.h>

typedef struct Notation {
  bool macros;         // #define replaces text
  bool tabs_join;      // a line that begins with a tab goes on with the statement above it
  bool any_case;       // keywords are found in any case, blanks in them or not
  bool labels;         // `p1 :` before a production, `w:` before a start word
  bool short_arrows;   // `->`, not `-->` alone
  bool subscripts;     // F_l is one symbol
  bool start_words;    // `,` separates start words
  bool left_power;     // `^` is left-associative and binds looser than a sign
  bool angle_unequal;  // `<>` is `!=`
  bool characters;     // symbols are characters: `@x` whatever x is, and in `ignore:` each by itself
  bool references;     // `&x` as an argument
  bool lines;          // a statement is a line, and none but directives has a keyword: view files
  bool line_comments;  // `//` begins a comment behind something, too, and any `\` before a line end joins the next
  bool tight_colons;   // a colon that does not stand right behind a keyword is a guard's where an arrow follows
  bool object_arrows;  // `-o>` is an arrow
} Notation;

extern const Notation notation_native, notation_cpfg;

// Where line_comments hold: whether `at` begins one rather than two rolls. In
// an expression `//` always does; in a word it has white space before it
// (`before` is '\n' where the text begins), and neither an argument nor a third
// roll behind it.
static inline bool starts_line_comment(char before, const char *at, const char *end, bool expression) {
  if (!utf8_starts(at, end, "//")) return false;
  if (expression || before == '\n') return true;
  return strchr(" \t\r", before) && (at + 2 == end || (at[2] != '(' && at[2] != '/'));
}

#endif
