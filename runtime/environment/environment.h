// environment.h -- the built-in environments, and the look at the word before a step.
#ifndef LSYS_ENVIRONMENT_ENVIRONMENT_H
#define LSYS_ENVIRONMENT_ENVIRONMENT_H

#include "lsys/environment.h"

// Sets the arguments of messages that are numbers to value, the rest stay.
static inline void environment_say(LsysCommunication *message, double value) {
  if (message->arity) message->argument[0] = value;
}

// The cell of a coordinate, in which -0 is 0; what is not finite is far away.
static inline double environment_cell(double coordinate, double cell) {
  double at = __builtin_floor(coordinate / cell);
  return at - at == 0 ? at + 0.0 : 0x1p60;
}

int environment_point(LsysScene *scene);
int environment_occupancy(LsysScene *scene);
int environment_light(LsysScene *scene);
int environment_terrain(LsysScene *scene);

#endif
