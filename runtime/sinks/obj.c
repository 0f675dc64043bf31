// obj.c -- Wavefront OBJ and its materials. Faces and lines follow the vertices
// that they name, so that it streams. Colours stand twice: as materials, and
// behind the coordinates of vertices, which many programs read.
// Source: Wavefront, Advanced Visualizer manual, appendix B1.
#include "core/message.h"
#include "core/out.h"
#include "sinks/model.h"

#include <stdlib.h>

typedef struct Obj {
  LsysModel model;
  const LsysPalette *palette;
  LsysOut *out, *mtl;  // mtl NULL: no materials
  char *mtl_name;      // owned
  int colour;          // of the last usemtl, -1 at the start
  bool used[256];
} Obj;

static bool open_model(LsysModel *model, const LsysPalette *palette) {
  Obj *o = (Obj *)model;
  o->palette = palette;
  lsys_out_print(o->out, "# made by lsysc\n");
  return !o->mtl || lsys_out_print(o->out, "mtllib %s\n", o->mtl_name);
}

static bool group(LsysModel *model, uint32_t axiom) {
  return lsys_out_print(((Obj *)model)->out, "o axiom%u\n", axiom + 1);
}

static double channel(uint32_t rgb, int shift) {
  return (rgb >> shift & 255) / 255.0;
}

static bool vertices(LsysModel *model, const LsysVertex *v, size_t count) {
  Obj *o = (Obj *)model;
  for (size_t i = 0; i < count; i++, v++) {
    uint32_t rgb = o->palette->rgb[v->colour];
    lsys_out_print(o->out, "v %.7g %.7g %.7g %.3g %.3g %.3g\n", (double)v->x, (double)v->y, (double)v->z,
                   channel(rgb, 16), channel(rgb, 8), channel(rgb, 0));
    if (!lsys_out_print(o->out, "vn %.4g %.4g %.4g\n", (double)v->nx, (double)v->ny, (double)v->nz)) return false;
  }
  return true;
}

static void use(Obj *o, uint8_t colour) {
  if (o->colour == colour) return;
  o->colour = colour;
  o->used[colour] = true;
  if (o->mtl) lsys_out_print(o->out, "usemtl c%u\n", colour);
}

static bool triangles(LsysModel *model, const uint32_t *c, const uint8_t *colour, size_t count) {
  Obj *o = (Obj *)model;
  for (size_t i = 0; i < count; i++, c += 3) {
    unsigned long a[3] = {c[0] + 1ul, c[1] + 1ul, c[2] + 1ul};
    use(o, colour[i]);
    if (!lsys_out_print(o->out, "f %lu//%lu %lu//%lu %lu//%lu\n", a[0], a[0], a[1], a[1], a[2], a[2])) return false;
  }
  return true;
}

static bool edges(LsysModel *model, const uint32_t *e, const uint8_t *colour, size_t count) {
  Obj *o = (Obj *)model;
  for (size_t i = 0; i < count; i++, e += 2) {
    use(o, colour[i]);
    if (!lsys_out_print(o->out, "l %lu %lu\n", e[0] + 1ul, e[1] + 1ul)) return false;
  }
  return true;
}

static bool close_model(LsysModel *model) {
  Obj *o = (Obj *)model;
  if (!o->mtl) return true;
  for (unsigned i = 0; i < 256; i++) {
    if (!o->used[i]) continue;
    uint32_t rgb = o->palette->rgb[i];
    lsys_out_print(o->mtl, "newmtl c%u\nKd %.4g %.4g %.4g\nKa 0 0 0\nKs 0 0 0\nillum 1\n", i, channel(rgb, 16),
                   channel(rgb, 8), channel(rgb, 0));
  }
  LsysOut *mtl = o->mtl;
  o->mtl = NULL;
  return lsys_out_commit(mtl);
}

static void destroy(LsysModel *model) {
  Obj *o = (Obj *)model;
  if (o->mtl) lsys_out_abandon(o->mtl);
  free(o->mtl_name);
  free(o);
}

LsysModel *lsys_obj_create(LsysOut *out, LsysOut *mtl, char *mtl_name) {
  Obj *o = calloc(1, sizeof *o);
  if (!o) {
    lsys_error("out of memory");
    if (mtl) lsys_out_abandon(mtl);
    free(mtl_name);
    return NULL;
  }
  o->model = (LsysModel){open_model, group, vertices, triangles, edges, close_model, destroy};
  o->out = out;
  o->mtl = mtl;
  o->mtl_name = mtl_name;
  o->colour = -1;
  return &o->model;
}
