// notation.h -- what the native notation and cpfg's write differently; reader,
// splitter, scanner and grammar are shared.
#ifndef LSYSC_FRONTEND_NOTATION_H
#define LSYSC_FRONTEND_NOTATION_H

#include <stdbool.h>

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
} Notation;

extern const Notation notation_native, notation_cpfg;

#endif
