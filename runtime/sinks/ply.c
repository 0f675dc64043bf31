// ply.c -- the polygon file format, binary little-endian: vertices with normals
// and colours, then faces, then edges. The head counts them, so all are spooled.
// Source: Turk, "The PLY polygon file format", 1994.
#include "core/message.h"
#include "core/out.h"
#include "sinks/model.h"
#include "sinks/spool.h"

#include <stdlib.h>
#include <string.h>

enum { VERTEX = 6 * 4 + 3, FACE = 1 + 3 * 4, EDGE = 2 * 4, BATCH = 512 };

typedef struct Ply {
  LsysModel model;
  const LsysPalette *palette;
  LsysOut *out;
  LsysSpool vertex, face, edge;
} Ply;

static bool open_model(LsysModel *model, const LsysPalette *palette) {
  Ply *p = (Ply *)model;
  p->palette = palette;
  return lsys_spool_open(&p->vertex) && lsys_spool_open(&p->face) && lsys_spool_open(&p->edge);
}

static bool vertices(LsysModel *model, const LsysVertex *v, size_t count) {
  uint8_t bytes[BATCH * VERTEX];
  while (count) {
    size_t n = count < BATCH ? count : BATCH;
    for (size_t i = 0; i < n; i++) {
      uint32_t rgb = ((Ply *)model)->palette->rgb[v[i].colour];
      uint8_t *to = bytes + i * VERTEX;
      memcpy(to, &v[i], 6 * sizeof(float));
      to[24] = (uint8_t)(rgb >> 16);
      to[25] = (uint8_t)(rgb >> 8);
      to[26] = (uint8_t)rgb;
    }
    if (!lsys_spool_write(&((Ply *)model)->vertex, bytes, n * VERTEX)) return false;
    v += n;
    count -= n;
  }
  return true;
}

static bool triangles(LsysModel *model, const uint32_t *corner, const uint8_t *colour, size_t count) {
  (void)colour;
  uint8_t bytes[BATCH * FACE];
  while (count) {
    size_t n = count < BATCH ? count : BATCH;
    for (size_t i = 0; i < n; i++) {
      bytes[i * FACE] = 3;
      memcpy(bytes + i * FACE + 1, corner + 3 * i, 3 * sizeof *corner);
    }
    if (!lsys_spool_write(&((Ply *)model)->face, bytes, n * FACE)) return false;
    corner += 3 * n;
    count -= n;
  }
  return true;
}

static bool edges(LsysModel *model, const uint32_t *end, const uint8_t *colour, size_t count) {
  (void)colour;
  return lsys_spool_write(&((Ply *)model)->edge, end, count * EDGE);
}

static bool close_model(LsysModel *model) {
  Ply *p = (Ply *)model;
  lsys_out_print(p->out,
                 "ply\nformat binary_little_endian 1.0\ncomment made by lsysc\nelement vertex %llu\n"
                 "property float x\nproperty float y\nproperty float z\n"
                 "property float nx\nproperty float ny\nproperty float nz\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                 (unsigned long long)(p->vertex.size / VERTEX));
  lsys_out_print(p->out, "element face %llu\nproperty list uchar int vertex_indices\n",
                 (unsigned long long)(p->face.size / FACE));
  if (p->edge.size)
    lsys_out_print(p->out, "element edge %llu\nproperty int vertex1\nproperty int vertex2\n",
                   (unsigned long long)(p->edge.size / EDGE));
  return lsys_out_print(p->out, "end_header\n") && lsys_spool_copy(&p->vertex, p->out)
      && lsys_spool_copy(&p->face, p->out) && lsys_spool_copy(&p->edge, p->out);
}

static void destroy(LsysModel *model) {
  Ply *p = (Ply *)model;
  lsys_spool_close(&p->vertex);
  lsys_spool_close(&p->face);
  lsys_spool_close(&p->edge);
  free(p);
}

LsysModel *lsys_ply_create(LsysOut *out) {
  Ply *p = calloc(1, sizeof *p);
  if (!p) {
    lsys_error("out of memory");
    return NULL;
  }
  p->model = (LsysModel){.open = open_model,
                         .vertices = vertices,
                         .triangles = triangles,
                         .edges = edges,
                         .close = close_model,
                         .destroy = destroy};
  p->out = out;
  return &p->model;
}
