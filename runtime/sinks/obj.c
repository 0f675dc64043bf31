// obj.c -- Wavefront OBJ and its materials. Faces and lines follow the vertices
// that they name, so that it streams. Colours stand twice: as materials, and
// behind the coordinates of vertices, which many programs read.
// Text is made on all threads.
// Source: Wavefront, Advanced Visualizer manual, appendix B1.
#include "core/message.h"
#include "core/out.h"
#include "lsys/number.h"
#include "sinks/model.h"
#include "sinks/press.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  BLOCK = 2048,   // elements of which text is made at once
  LONGEST = 256,  // bytes of an element's text
};

// The elements of a block.
typedef enum What { VERTEX, TRIANGLE, EDGE, GROUP, MATERIAL } What;

static const size_t element_size[] = {
  [VERTEX] = sizeof(LsysVertex), [TRIANGLE] = 3 * sizeof(uint32_t), [EDGE] = 2 * sizeof(uint32_t),
  [GROUP] = sizeof(uint32_t),    [MATERIAL] = sizeof(uint32_t),
};

// Some of them, which follow it.
typedef struct Item {
  uint32_t what, count;
} Item;

// With padding.
static size_t item_bytes(uint32_t what, uint32_t count) {
  return (count * element_size[what] + 7) & ~(size_t)7;
}

// A colour as it stands behind coordinates.
typedef struct Tint {
  char text[28];
  uint32_t size;
} Tint;

typedef struct Obj {
  LsysModel model;
  LsysPress *press;
  uint32_t elements;  // in its block
  Tint tint[256];
  const LsysPalette *palette;
  LsysOut *out, *mtl;  // mtl NULL: no materials
  char *mtl_name;      // owned
  int colour;          // of the last usemtl, -1 at the start
  bool used[256];
} Obj;

static double channel(uint32_t rgb, int shift) {
  return (rgb >> shift & 255) / 255.0;
}

// ---- text, on any thread -----------------------------------------------------

static char *put_numbers(char *to, const char *keyword, const double *x, int count, int digits) {
  to = stpcpy(to, keyword);
  for (int i = 0; i < count; i++) {
    *to++ = ' ';
    to = lsys_number_round(to, x[i], digits);
  }
  return to;
}

static char *put_vertex(const Obj *o, char *to, const LsysVertex *v) {
  to = put_numbers(to, "v", (const double[]){(double)v->x, (double)v->y, (double)v->z}, 3, 7);
  const Tint *tint = &o->tint[v->colour];
  memcpy(to, tint->text, sizeof tint->text);
  to += tint->size;
  if (v->nx == 0 && v->ny == 0 && v->nz == 1) return stpcpy(to, "\nvn 0 0 1\n");  // an end of an edge
  to = put_numbers(to, "\nvn", (const double[]){(double)v->nx, (double)v->ny, (double)v->nz}, 3, 4);
  *to++ = '\n';
  return to;
}

static char *put_triangle(char *to, const uint32_t *corner) {
  *to++ = 'f';
  for (int i = 0; i < 3; i++) {
    *to++ = ' ';
    to = lsys_whole_print(to, corner[i] + UINT64_C(1));
    *to++ = '/';
    *to++ = '/';
    to = lsys_whole_print(to, corner[i] + UINT64_C(1));
  }
  *to++ = '\n';
  return to;
}

static char *put_edge(char *to, const uint32_t *end) {
  *to++ = 'l';
  for (int i = 0; i < 2; i++) {
    *to++ = ' ';
    to = lsys_whole_print(to, end[i] + UINT64_C(1));
  }
  *to++ = '\n';
  return to;
}

static char *put_element(const Obj *o, char *to, uint32_t what, const void *at) {
  const uint32_t *number = at;
  switch (what) {
  case VERTEX:
    return put_vertex(o, to, at);
  case TRIANGLE:
    return put_triangle(to, number);
  case EDGE:
    return put_edge(to, number);
  case GROUP:
    return to + sprintf(to, "o axiom%u\n", *number + 1);
  default:
    return to + sprintf(to, "usemtl c%u\n", *number);
  }
}

static bool put_block(const void *data, const void *block, size_t size, LsysPrepared *to) {
  const Obj *o = data;
  for (const char *at = block, *end = at + size; at < end;) {
    const Item *item = (const Item *)(const void *)at;
    at += sizeof *item;
    for (uint32_t i = 0; i < item->count; i++) {
      char *room = lsys_prepared_room(to, LONGEST);
      if (!room) return false;
      to->used += (size_t)(put_element(o, room, item->what, at + i * element_size[item->what]) - room);
    }
    at += item_bytes(item->what, item->count);
  }
  return true;
}

static bool write_block(void *data, const LsysPrepared *text) {
  return lsys_out_write(((Obj *)data)->out, text->data, text->used);
}

// ---- the model ---------------------------------------------------------------

static bool open_model(LsysModel *model, const LsysPalette *palette) {
  Obj *o = (Obj *)model;
  o->palette = palette;
  for (int i = 0; i < 256; i++) {
    uint32_t rgb = palette->rgb[i];
    Tint *t = &o->tint[i];
    t->size = (uint32_t)snprintf(t->text, sizeof t->text, " %.3g %.3g %.3g", channel(rgb, 16), channel(rgb, 8),
                                 channel(rgb, 0));
  }
  o->press = lsys_press_open(model->memory, model->threads, put_block, write_block, o);
  if (!o->press) return false;
  lsys_out_print(o->out, "# made by lsysc\n");
  return !o->mtl || lsys_out_print(o->out, "mtllib %s\n", o->mtl_name);
}

// Elements for the block, which is sent when it is long enough.
static bool add(Obj *o, What what, const void *elements, size_t count) {
  const char *from = elements;
  for (size_t n; count; count -= n, from += n * element_size[what]) {
    n = count < BLOCK ? count : BLOCK;
    Item item = {what, (uint32_t)n};
    size_t bytes = item_bytes(what, item.count);
    char *at = lsys_press_add(o->press, sizeof item + bytes);
    if (!at) return false;
    memcpy(at, &item, sizeof item);
    memcpy(at + sizeof item, from, n * element_size[what]);
    o->elements += item.count;
    if (o->elements < BLOCK) continue;
    o->elements = 0;
    if (!lsys_press_send(o->press)) return false;
  }
  return true;
}

static bool group(LsysModel *model, uint32_t axiom) {
  return add((Obj *)model, GROUP, &axiom, 1);
}

static bool vertices(LsysModel *model, const LsysVertex *v, size_t count) {
  return add((Obj *)model, VERTEX, v, count);
}

static bool use(Obj *o, uint8_t colour) {
  if (o->colour == colour) return true;
  o->colour = colour;
  o->used[colour] = true;
  return !o->mtl || add(o, MATERIAL, &(uint32_t){colour}, 1);
}

// Elements with `corners` numbers each, in runs of one colour.
static bool add_coloured(Obj *o, What what, const uint32_t *number, const uint8_t *colour, size_t count,
                         size_t corners) {
  for (size_t from = 0, to; from < count; from = to) {
    for (to = from + 1; to < count && colour[to] == colour[from];) to++;
    if (!use(o, colour[from]) || !add(o, what, number + from * corners, to - from)) return false;
  }
  return true;
}

static bool triangles(LsysModel *model, const uint32_t *c, const uint8_t *colour, size_t count) {
  return add_coloured((Obj *)model, TRIANGLE, c, colour, count, 3);
}

static bool edges(LsysModel *model, const uint32_t *e, const uint8_t *colour, size_t count) {
  return add_coloured((Obj *)model, EDGE, e, colour, count, 2);
}

static bool close_model(LsysModel *model) {
  Obj *o = (Obj *)model;
  if (!lsys_press_finish(o->press)) return false;
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
  lsys_press_close(o->press);
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
  o->model = (LsysModel){.open = open_model,
                         .group = group,
                         .vertices = vertices,
                         .triangles = triangles,
                         .edges = edges,
                         .close = close_model,
                         .destroy = destroy};
  o->out = out;
  o->mtl = mtl;
  o->mtl_name = mtl_name;
  o->colour = -1;
  return &o->model;
}
