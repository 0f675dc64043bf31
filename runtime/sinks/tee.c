// tee.c -- hands each part of a word to several sinks in turn.
#include "sinks/tee.h"

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  LsysTee *tee = (LsysTee *)sink;
  tee->pass = pass;
  for (size_t i = 0; i < tee->count; i++)
    if (pass < tee->sinks[i]->passes && !tee->sinks[i]->begin(tee->sinks[i], run, axiom, pass)) return false;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  LsysTee *tee = (LsysTee *)sink;
  for (size_t i = 0; i < tee->count; i++)
    if (tee->pass < tee->sinks[i]->passes && !tee->sinks[i]->take(tee->sinks[i], part)) return false;
  return true;
}

static bool end(LsysSink *sink) {
  LsysTee *tee = (LsysTee *)sink;
  for (size_t i = 0; i < tee->count; i++)
    if (tee->pass < tee->sinks[i]->passes && !tee->sinks[i]->end(tee->sinks[i])) return false;
  return true;
}

static bool finish(LsysSink *sink) {
  LsysTee *tee = (LsysTee *)sink;
  for (size_t i = 0; i < tee->count; i++)
    if (!tee->sinks[i]->finish(tee->sinks[i])) return false;
  return true;
}

static void destroy(LsysSink *sink) {
  (void)sink;
}

void lsys_tee_init(LsysTee *tee, LsysSink **sinks, size_t count) {
  *tee =
    (LsysTee){.sink = {.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy},
              .sinks = sinks,
              .count = count};
  for (size_t i = 0; i < count; i++)
    if (sinks[i]->passes > tee->sink.passes) tee->sink.passes = sinks[i]->passes;
}
