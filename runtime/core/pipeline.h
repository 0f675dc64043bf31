// pipeline.h -- stretches of a word, each written by whatever thread is free,
// flow into one sink in their order and in bounded memory.
#ifndef LSYS_CORE_PIPELINE_H
#define LSYS_CORE_PIPELINE_H

#include "core/team.h"

typedef struct LsysPipeline LsysPipeline;

// Writes stretch number i to out and flushes it, on the member's thread, to whose worker out belongs.
typedef void LsysPipelineWrite(LsysMember *member, void *data, uint64_t i, LsysStream *out);

// The sink is called on this thread only, which is member 0 of the team; the first `alone` stretches are written here
// before the other members start, because small words need no threads. *place holds what is to be closed, also after
// a longjmp. False after printing why not.
bool lsys_pipeline_open(LsysPipeline **place, LsysTeam *team, LsysSink *sink, uint64_t alone, LsysPipelineWrite *write,
                        void *data);

// How many stretches are under way at most: number i is over when i plus that many have been added.
uint64_t lsys_pipeline_most(const LsysTeam *team);

// One more stretch can be written, before which so many modules stand in the word, unless *place is NULL: nobody knows.
// Numbers count from 0. False after printing why the run has to stop.
bool lsys_pipeline_add(LsysPipeline *pipeline, const uint64_t *place);

// Waits until the sink has all of them.
bool lsys_pipeline_finish(LsysPipeline *pipeline);

// Stops the others and releases everything; NULL is fine. The team is free for other work then.
void lsys_pipeline_close(LsysPipeline *pipeline);

#endif
