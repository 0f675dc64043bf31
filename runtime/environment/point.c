// point.c -- the environment of grammars that name none: each ?E hears where the last line on its path ends.
//
// One argument is the y of that place, two are x and y, three x, y and z.
#include "environment/environment.h"

int environment_point(LsysScene *scene) {
  for (size_t i = 0; i < scene->messages; i++) {
    LsysCommunication *message = &scene->message[i];
    const double *from = message->arity == 1 ? message->drawn + 1 : message->drawn;
    for (uint32_t k = 0; k < message->arity && k < 3; k++) message->argument[k] = from[k];
  }
  return 1;
}
