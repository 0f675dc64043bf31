// terrain.c -- rolling hills: each ?E hears how far it is above the ground, which is
// height * sin(360 x / length) * cos(360 z / length).
#include "environment/environment.h"

#include "lsys/functions.h"

int environment_terrain(LsysScene *scene) {
  double height = scene->parameter[0], length = scene->parameter[1];
  for (size_t i = 0; i < scene->messages; i++) {
    LsysCommunication *message = &scene->message[i];
    double ground = height * lsys_sin(360 * message->at[0] / length) * lsys_cos(360 * message->at[2] / length);
    environment_say(message, message->at[1] - ground + 0.0);
  }
  return 1;
}
