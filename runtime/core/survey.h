// survey.h -- what the segments of a word have to know of each other, so that
// each can be rewritten on its own: which branches end in another segment, and
// what stands on the paths that lead into a segment.
#ifndef LSYS_CORE_SURVEY_H
#define LSYS_CORE_SURVEY_H

#include "core/scan.h"

// One segment by itself. Branches that it leaves open, and the axis that they stand on, are its frames.
typedef struct Survey {
  ScanBrackets closes, opens;  // whose partners stand in other segments, in order
  LsysNeighbour *near;         // of each frame: its last seen modules, nearest first, window of them
  uint32_t *near_count;        //   and how many there are; 1 or more counts where the window is 0, too
  uint32_t *next;              // words of letters: the first seen module behind the border and each of `closes`
  size_t near_room, count_room, next_room;
} Survey;

// All segments together, from step to step.
typedef struct SurveyJoin {
  LsysNeighbour *left;         // the window of the path
  struct SurveyLevel *levels;  //   and what its open brackets saved,
  LsysNeighbour *saved;        //   with their windows
  LsysNeighbour *windows;      // of all borders: a window, and those that are saved
  uint8_t *fresh;              //   and whether those are
  uint32_t *behind, *kinds;
  size_t left_room, level_room, saved_room, window_room, fresh_room, behind_room, kind_room;
} SurveyJoin;

// Looks through a segment, whose arguments end at `end`, and fills the skips of branches that end in it. The survey is
// all zeros or was used before. The run ends where there is no memory.
void survey_segment(Survey *survey, const ScanTables *tables, LsysRun *run, const LsysSegment *segment, uint32_t number,
                    const double *end);

// Finds with what a scan enters each of the segments, and fills the other skips. The borders hold until the next join.
void survey_join(SurveyJoin *join, const Survey *surveys, const ScanTables *tables, LsysRun *run,
                 const LsysSegment *segments, uint32_t count, ScanBorder *borders);

void survey_free(Survey *survey, LsysRun *run);
void survey_join_free(SurveyJoin *join, LsysRun *run);

#endif
