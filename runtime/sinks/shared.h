// shared.h -- figures written as shared parts instead of segment by segment.
#ifndef LSYS_SINKS_SHARED_H
#define LSYS_SINKS_SHARED_H

#include "core/derive.h"
#include "core/formats.h"
#include "sinks/layout.h"
#include "sinks/model.h"
#include "sinks/picture.h"
#include "turtle/parts.h"

// Start words first .. end-1 as an SVG of nested definitions; the figure stays in the page. False after an error.
bool lsys_shared_svg(LsysParts *parts, uint32_t first, uint32_t end, const LsysPictureOptions *options, LsysOut *out);

// The same as a PNG, drawn by a descent that stops at parts of an eighth of a pixel. It takes stack: there are no more
// steps than LSYS_SHARED_DEPTH.
enum { LSYS_SHARED_DEPTH = 2000 };
bool lsys_shared_png(LsysParts *parts, uint32_t first, uint32_t end, const LsysPictureOptions *options, LsysOut *out);

// The same as a GLB whose nodes share meshes of sub-figures.
bool lsys_shared_glb(LsysParts *parts, uint32_t first, uint32_t end, const LsysModelOptions *options, LsysOut *out);

// Takes in the figure of a start word, which begins at *start, as it is composed of its parts. False after an error.
bool lsys_shared_measure(LsysParts *parts, uint32_t axiom, LsysLayout *layout, LsysPose *start);

// From how many modules on a figure is to be written so without being asked, in the format that is asked for;
// infinite: never.
double lsys_shared_worth(const LsysSinkContext *context);

// --shared: writes -o or standard output so. False after printing why not. Where that was not asked for, *done may be
// false: the figure has no shared parts, nothing was written or printed, and it can be drawn without them.
bool lsys_shared_run(LsysDerivation *derivation, const LsysSinkContext *context, bool asked, bool *done);

#endif
