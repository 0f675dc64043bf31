// trail.h -- trails that the turtle follows where it has read a word before.
#ifndef LSYS_TURTLE_TRAIL_H
#define LSYS_TURTLE_TRAIL_H

#include "turtle/state.h"

// Draws a part of a word if it is a block of the derivation that the turtle has a trail of, or gets one of now. False:
// it is to be read. *ok: false to stop.
bool turtle_follow(LsysTurtle *t, const LsysWord *part, bool *ok);

void turtle_forget_trails(LsysTurtle *t);

#endif
