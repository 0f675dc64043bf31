// progress.h -- how far a derivation is, on the terminal.
#ifndef LSYS_SINKS_PROGRESS_H
#define LSYS_SINKS_PROGRESS_H

#include "core/formats.h"

// A sink that shows how many modules flowed by, in one line of standard error
// that it rewrites and removes in the end. NULL after printing why not.
LsysSink *lsys_sink_progress(const LsysSinkContext *context);

#endif
