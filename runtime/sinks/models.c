// models.c -- the mesh formats as the command line asks for them.
#include "core/formats.h"
#include "core/message.h"
#include "sinks/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool lsys_model_options(const LsysOptions *given, LsysModelOptions *options) {
  const LsysOptionValue *width = &given->at[LSYS_OPTION_LINE_WIDTH], *sides = &given->at[LSYS_OPTION_SIDES];
  *options = (LsysModelOptions){.line_width = width->given ? width->real : NAN,
                                .sides = sides->given ? (uint32_t)sides->whole : 0,
                                .film = given->at[LSYS_OPTION_FRAMES].given};
  if (width->given && !(width->real > 0 && isfinite(width->real))) {
    lsys_error("--line-width %s: it is the width in pixels of a line of width 1, more than 0", width->text);
    return false;
  }
  if (!lsys_colours_read(given, &options->colours)) return false;
  if (!sides->given || sides->whole == 1 || (sides->whole >= 3 && sides->whole <= 64)) return true;
  lsys_error("--sides %s: a tube has 3 to 64 sides; 1 draws lines", sides->text);
  return false;
}

static LsysSink *create(const LsysSinkContext *context, LsysModel *model) {
  LsysModelOptions options;
  if (!model) return NULL;
  if (lsys_model_options(context->options, &options)) return lsys_model_create(model, &options);
  model->destroy(model);
  return NULL;
}

// "plant.obj" has its materials in "plant.mtl"; an OBJ on standard output has none.
static bool open_materials(const LsysSinkContext *context, LsysOut **mtl, char **name) {
  const LsysOptionValue *path = &context->options->at[LSYS_OPTION_OUTPUT];
  if (!path->given || strcmp(path->text, "-") == 0 || strncmp(path->text, "/dev/", 5) == 0) return true;
  const char *slash = strrchr(path->text, '/'), *dot = strrchr(slash ? slash : path->text, '.');
  size_t stem = dot ? (size_t)(dot - path->text) : strlen(path->text);
  char *full = malloc(stem + 5);
  if (!full) return false;
  memcpy(full, path->text, stem);
  strcpy(full + stem, ".mtl");
  *mtl = lsys_out_open(full);
  *name = strdup(slash ? full + (slash + 1 - path->text) : full);
  free(full);
  return *mtl && *name;
}

LsysSink *lsys_sink_obj(const LsysSinkContext *context) {
  LsysOut *mtl = NULL;
  char *name = NULL;
  if (open_materials(context, &mtl, &name)) return create(context, lsys_obj_create(context->out, mtl, name));
  free(name);
  if (mtl) lsys_out_abandon(mtl);
  return NULL;
}

LsysSink *lsys_sink_ply(const LsysSinkContext *context) {
  return create(context, lsys_ply_create(context->out));
}

LsysSink *lsys_sink_glb(const LsysSinkContext *context) {
  return create(context, lsys_glb_create(context->out));
}
