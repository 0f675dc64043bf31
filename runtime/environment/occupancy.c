// occupancy.c -- space is divided into cubes; each ?E hears how many lines end in its cube, but for the line that leads
// to it.
//
// In: the ends of lines. They are sorted by cube, so that the answer is found by bisection, whatever the order.
#include "environment/environment.h"

#include <stdlib.h>
#include <string.h>

typedef struct Cube {
  double at[3];
} Cube;

static Cube cube_of(const double at[3], double cell) {
  Cube cube;
  for (int i = 0; i < 3; i++) cube.at[i] = environment_cell(at[i], cell);
  return cube;
}

static int compare(const void *left, const void *right) {
  const Cube *a = left, *b = right;
  for (int i = 0; i < 3; i++)
    if (a->at[i] != b->at[i]) return a->at[i] < b->at[i] ? -1 : 1;
  return 0;
}

// The number of cubes before the first that is not less than cube; with `behind`, that is greater.
static size_t place(const Cube *cubes, size_t count, const Cube *cube, int behind) {
  size_t low = 0, high = count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    int order = compare(&cubes[middle], cube);
    if (order < 0 || (behind && order == 0))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

int environment_occupancy(LsysScene *scene) {
  double cell = scene->parameter[0];
  Cube *cubes = scene->room(scene, scene->lines * sizeof *cubes);
  if (!cubes) return 0;
  for (size_t i = 0; i < scene->lines; i++) cubes[i] = cube_of(scene->line[i] + 3, cell);
  if (scene->lines) qsort(cubes, scene->lines, sizeof *cubes, compare);
  for (size_t i = 0; i < scene->messages; i++) {
    LsysCommunication *message = &scene->message[i];
    Cube here = cube_of(message->at, cell), end = cube_of(message->drawn, cell);
    size_t lines = place(cubes, scene->lines, &here, 1) - place(cubes, scene->lines, &here, 0);
    if (message->lines && lines && compare(&here, &end) == 0) lines--;
    environment_say(message, (double)lines);
  }
  return 1;
}
