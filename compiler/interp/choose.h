// choose.h -- choosing the production for one module (LANGUAGE.md 5.2).
#ifndef LSYSC_INTERP_CHOOSE_H
#define LSYSC_INTERP_CHOOSE_H

#include "interp/rewrite.h"

// What is to be rewritten: module at of word, in the neighbourhood of module
// place of the links' word.
typedef struct Subject {
  const Boxes *word;
  size_t at;
  const Links *links;  // NULL: productions with contexts do not apply
  size_t place;
} Subject;

// Begins the rewriting of subject by its key. Returns the production that it
// is rewritten by, whose frame is then the scope's current one, or NULL if it
// stays. table: of this step; -1: all of them.
const Production *choose(Interp *interp, const Section *section, int64_t table, const Subject *subject);

// Would some production of the section replace the subject? Changes nothing.
bool suspects(Interp *interp, const Section *section, const Subject *subject);

// Finishes the rewriting: runs the production's last block and appends its
// successor to out. key is the subject's.
void replace(Interp *interp, const Production *production, uint64_t key, Boxes *out);

#endif
