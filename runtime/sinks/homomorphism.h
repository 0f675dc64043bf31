// homomorphism.h -- a sink in front of a sink: what flows in is a derived word,
// what flows on is what the grammar's homomorphism makes of it.
#ifndef LSYS_SINKS_HOMOMORPHISM_H
#define LSYS_SINKS_HOMOMORPHISM_H

#include "core/formats.h"

// The grammar has a homomorphism. Owns inner. NULL after printing why not (inner is destroyed then, too).
LsysSink *lsys_sink_homomorphism(const LsysSinkContext *context, LsysSink *inner);

#endif
