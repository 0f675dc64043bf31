// model.h -- figures as triangles and lines in space: a sink that measures the
// words in a first pass, and in a second one turns what the turtle draws into
// vertices, triangles and edges for a mesh format.
#ifndef LSYS_SINKS_MODEL_H
#define LSYS_SINKS_MODEL_H

#include "sinks/colours.h"
#include "sinks/sink.h"

typedef struct LsysModelOptions {
  double line_width;  // pixels of a width of 1 on a page of 1000 for the figure; nan: as pictures choose it
  uint32_t sides;     // of a tube; 0: chosen by the number of segments; 1: lines
  bool film;          // one of several
  LsysColours colours;
} LsysModelOptions;

struct LsysOptions;
// Reads the options of models. False after printing what is wrong.
bool lsys_model_options(const struct LsysOptions *given, LsysModelOptions *options);

typedef struct LsysVertex {
  float x, y, z;
  float nx, ny, nz;  // unit; (0,0,1) at the ends of edges
  uint8_t colour;    // index
  uint8_t reserved[3];
} LsysVertex;

typedef struct LsysModel LsysModel;

// What a format does with them. Numbers of vertices count from 0 through the whole model; triangles and
// edges name vertices that came before. Each returns false to stop after printing an error.
struct LsysModel {
  bool (*open)(LsysModel *model, const LsysPalette *palette);  // which outlives the model
  bool (*group)(LsysModel *model,
                uint32_t axiom);  // what follows belongs to the figure of this start word; may be NULL
  bool (*vertices)(LsysModel *model, const LsysVertex *vertex, size_t count);
  bool (*triangles)(LsysModel *model, const uint32_t *corner, const uint8_t *colour, size_t count);
  bool (*edges)(LsysModel *model, const uint32_t *end, const uint8_t *colour, size_t count);
  bool (*close)(LsysModel *model);
  void (*destroy)(LsysModel *model);
  // Before open: the account, and how many threads may work for the model; 0: one.
  struct LsysMemory *memory;
  unsigned threads;
};

// The models that there are, over an output that is not committed. NULL after printing why. mtl: where the materials
// of an OBJ go and what they are called there, both taken over; NULL: nowhere.
struct LsysOut;
LsysModel *lsys_obj_create(struct LsysOut *out, struct LsysOut *mtl, char *mtl_name);
LsysModel *lsys_ply_create(struct LsysOut *out);
LsysModel *lsys_glb_create(struct LsysOut *out);

// A sink of two passes that draws to model and destroys it in the end. NULL after printing why.
LsysSink *lsys_model_create(LsysModel *model, const LsysModelOptions *options);

#endif
