// shared.h -- figures written as shared parts instead of segment by segment.
#ifndef LSYS_SINKS_SHARED_H
#define LSYS_SINKS_SHARED_H

#include "core/derive.h"
#include "core/formats.h"
#include "sinks/model.h"
#include "sinks/picture.h"
#include "turtle/parts.h"

// Start words first .. end-1 as an SVG of nested definitions; the figure stays in the page. False after an error.
bool lsys_shared_svg(LsysParts *parts, uint32_t first, uint32_t end, const LsysPictureOptions *options, LsysOut *out);

// The same as a GLB whose nodes share meshes of sub-figures.
bool lsys_shared_glb(LsysParts *parts, uint32_t first, uint32_t end, const LsysModelOptions *options, LsysOut *out);

// Is the output asked for in a format that can share parts?
bool lsys_shared_format(const LsysSinkContext *context);

// --shared: writes -o or standard output so. False after printing why not.
bool lsys_shared_run(LsysDerivation *derivation, const LsysSinkContext *context);

#endif
