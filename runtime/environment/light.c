// light.c -- light from above: each ?E is a leaf and hears how much of the light reaches it, 1 if nothing is above it.
//
// Space is divided into cubes. A leaf in a higher cube of the same column lets the part `shade` of the light through.
// The leaves are sorted by column and, in it, from the top, so that one walk counts those above.
#include "environment/environment.h"

#include "lsys/functions.h"

#include <stdlib.h>

typedef struct Leaf {
  double x, z, y;  // of its cube
  LsysCommunication *message;
} Leaf;

static int compare(const void *left, const void *right) {
  const Leaf *a = left, *b = right;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  if (a->z != b->z) return a->z < b->z ? -1 : 1;
  if (a->y != b->y) return a->y > b->y ? -1 : 1;
  return 0;
}

int environment_light(LsysScene *scene) {
  double cell = scene->parameter[0], shade = scene->parameter[1];
  Leaf *leaves = scene->room(scene, scene->messages * sizeof *leaves);
  if (!leaves) return 0;
  for (size_t i = 0; i < scene->messages; i++) {
    const double *at = scene->message[i].at;
    leaves[i] = (Leaf){environment_cell(at[0], cell), environment_cell(at[2], cell), environment_cell(at[1], cell),
                       &scene->message[i]};
  }
  if (scene->messages) qsort(leaves, scene->messages, sizeof *leaves, compare);
  size_t top = 0, level = 0;  // the first leaf of the column, of the cube
  for (size_t i = 0; i < scene->messages; i++) {
    if (leaves[i].x != leaves[top].x || leaves[i].z != leaves[top].z) top = level = i;
    if (leaves[i].y != leaves[level].y) level = i;
    environment_say(leaves[i].message, lsys_pow(shade, (double)(level - top)));
  }
  return 1;
}
