// film.h -- one picture a step, all on pages of one size and scale.
#ifndef LSYS_SINKS_FILM_H
#define LSYS_SINKS_FILM_H

#include "core/derive.h"
#include "core/formats.h"
#include "sinks/layout.h"
#include "sinks/view.h"

// What the pictures of a film share: the last step's, which is made first, lays out the others.
typedef struct LsysFilm {
  bool laid_out;
  LsysLayout layout;
  LsysPage page;
  LsysEye *eye;    // of each start word
  uint64_t step;   // of the picture that is being made
  uint64_t steps;  // of the last one
  bool animate;    // all pictures go into one SVG, shown one after another
  bool begun;      // its head is written
  double seconds;  // that a picture of it is shown
} LsysFilm;

// --frames: writes plant-000.png, plant-001.png, ... for -o plant.png; --svg-animate: all into one file.
// False after printing what went wrong.
bool lsys_film_run(LsysDerivation *derivation, const LsysSinkContext *context);

#endif
