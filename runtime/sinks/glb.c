// glb.c -- glTF 2.0 in one binary file: a mesh of triangles and one of lines
// over common vertices with normals and colours. The head holds sizes and
// bounds, so vertices and indices are spooled.
// Source: Khronos, glTF 2.0 specification, sections 3.6, 3.7 and 4.4.
#include "sinks/glb.h"

#include "core/message.h"
#include "sinks/model.h"
#include "sinks/spool.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  VERTEX = 6 * 4 + 4,  // position, normal, colour
  BATCH = 512,
  MAGIC = 0x46546c67,  // "glTF"
  CHUNK_JSON = 0x4e4f534a,
  CHUNK_BINARY = 0x004e4942,
  HEAD = 12,
  CHUNK_HEAD = 8,
  JSON_ROOM = 4096,
};

typedef struct Glb {
  LsysModel model;
  const LsysPalette *palette;
  LsysOut *out;
  LsysSpool vertex, triangle, edge;
  float low[3], high[3];
  uint8_t linear[256];  // from the palette's sRGB to glTF's linear light
} Glb;

static bool open_model(LsysModel *model, const LsysPalette *palette) {
  Glb *g = (Glb *)model;
  g->palette = palette;
  for (uint32_t i = 0; i < 256; i++) {
    double linear[3];
    lsys_glb_linear(i, linear);
    g->linear[i] = (uint8_t)lrint(255 * linear[2]);
  }
  for (int i = 0; i < 3; i++) {
    g->low[i] = INFINITY;
    g->high[i] = -INFINITY;
  }
  return lsys_spool_open(&g->vertex) && lsys_spool_open(&g->triangle) && lsys_spool_open(&g->edge);
}

static void pack(Glb *g, const LsysVertex *v, uint8_t *to) {
  const float place[3] = {v->x, v->y, v->z};
  for (int i = 0; i < 3; i++) {
    if (place[i] < g->low[i]) g->low[i] = place[i];
    if (place[i] > g->high[i]) g->high[i] = place[i];
  }
  uint32_t rgb = g->palette->rgb[v->colour];
  memcpy(to, v, 6 * sizeof(float));
  to[24] = g->linear[rgb >> 16 & 255];
  to[25] = g->linear[rgb >> 8 & 255];
  to[26] = g->linear[rgb & 255];
  to[27] = 255;
}

static bool vertices(LsysModel *model, const LsysVertex *v, size_t count) {
  Glb *g = (Glb *)model;
  uint8_t bytes[BATCH * VERTEX];
  while (count) {
    size_t n = count < BATCH ? count : BATCH;
    for (size_t i = 0; i < n; i++) pack(g, &v[i], bytes + i * VERTEX);
    if (!lsys_spool_write(&g->vertex, bytes, n * VERTEX)) return false;
    v += n;
    count -= n;
  }
  return true;
}

static bool triangles(LsysModel *model, const uint32_t *corner, const uint8_t *colour, size_t count) {
  (void)colour;
  return lsys_spool_write(&((Glb *)model)->triangle, corner, count * 3 * sizeof *corner);
}

static bool edges(LsysModel *model, const uint32_t *end, const uint8_t *colour, size_t count) {
  (void)colour;
  return lsys_spool_write(&((Glb *)model)->edge, end, count * 2 * sizeof *end);
}

// ---- the file ------------------------------------------------------------

// The JSON chunk, grown by append.
typedef struct Json {
  char text[JSON_ROOM];
  size_t size;
} Json;

static void append(Json *j, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void append(Json *j, const char *format, ...) {
  va_list args;
  va_start(args, format);
  int n = vsnprintf(j->text + j->size, JSON_ROOM - j->size, format, args);
  va_end(args);
  j->size += (size_t)n;
}

static void append_primitive(Json *j, bool first, unsigned indices, unsigned mode) {
  append(j, "%s{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"COLOR_0\":2},\"indices\":%u,\"mode\":%u,\"material\":0}",
         first ? "" : ",", indices, mode);
}

static void append_indices(Json *j, unsigned view, unsigned long long count) {
  append(j, ",{\"bufferView\":%u,\"componentType\":5125,\"count\":%llu,\"type\":\"SCALAR\"}", view, count);
}

static void describe(const Glb *g, Json *j, uint64_t binary) {
  unsigned long long count = g->vertex.size / VERTEX, vertex = g->vertex.size, triangle = g->triangle.size,
                     edge = g->edge.size;
  append(j, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"lsysc\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
  if (!count) {  // a figure without anything in it
    append(j, "\"nodes\":[{\"name\":\"figure\"}]}");
    return;
  }
  append(j, "\"nodes\":[{\"name\":\"figure\",\"mesh\":0}],\"meshes\":[{\"primitives\":[");
  if (triangle) append_primitive(j, true, 3, 4);
  if (edge) append_primitive(j, !triangle, triangle ? 4 : 3, 1);
  append(j, "]}],\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
            "\"roughnessFactor\":0.9}}],\"accessors\":[");
  append(j,
         "{\"bufferView\":0,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC3\",\"min\":[%.9g,%.9g,%.9g],"
         "\"max\":[%.9g,%.9g,%.9g]}",
         count, (double)g->low[0], (double)g->low[1], (double)g->low[2], (double)g->high[0], (double)g->high[1],
         (double)g->high[2]);
  append(j, ",{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC3\"}", count);
  append(j,
         ",{\"bufferView\":0,\"byteOffset\":24,\"componentType\":5121,\"normalized\":true,\"count\":%llu,"
         "\"type\":\"VEC4\"}",
         count);
  if (triangle) append_indices(j, 1, triangle / 4);
  if (edge) append_indices(j, triangle ? 2 : 1, edge / 4);
  append(j, "],\"bufferViews\":[{\"buffer\":0,\"byteLength\":%llu,\"byteStride\":%d,\"target\":34962}", vertex, VERTEX);
  if (triangle) append(j, ",{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,\"target\":34963}", vertex, triangle);
  if (edge)
    append(j, ",{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,\"target\":34963}", vertex + triangle, edge);
  append(j, "],\"buffers\":[{\"byteLength\":%llu}]}", (unsigned long long)binary);
}

static bool write_number(LsysOut *out, uint32_t number) {
  uint8_t bytes[4] = {(uint8_t)number, (uint8_t)(number >> 8), (uint8_t)(number >> 16), (uint8_t)(number >> 24)};
  return lsys_out_write(out, bytes, sizeof bytes);
}

bool lsys_glb_head(LsysOut *out, uint64_t json, uint64_t binary) {
  uint64_t size = HEAD + CHUNK_HEAD + json + (binary ? CHUNK_HEAD + binary : 0);
  if (size > UINT32_MAX) {
    lsys_error("the model takes %llu bytes; a GLB holds no more than 4 GiB", (unsigned long long)size);
    return false;
  }
  write_number(out, MAGIC);
  write_number(out, 2);
  write_number(out, (uint32_t)size);
  write_number(out, (uint32_t)json);
  return write_number(out, CHUNK_JSON);
}

bool lsys_glb_binary(LsysOut *out, uint64_t binary) {
  write_number(out, (uint32_t)binary);
  return write_number(out, CHUNK_BINARY);
}

void lsys_glb_linear(uint32_t rgb, double *linear) {
  for (int i = 0; i < 3; i++) {
    double c = (rgb >> (16 - 8 * i) & 255) / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
  }
}

static bool close_model(LsysModel *model) {
  Glb *g = (Glb *)model;
  uint64_t binary = g->vertex.size + g->triangle.size + g->edge.size;
  Json json = {.size = 0};
  describe(g, &json, binary);
  while (json.size % 4) append(&json, " ");
  bool well = lsys_glb_head(g->out, json.size, binary) && lsys_out_write(g->out, json.text, json.size);
  if (!well || !binary) return well;
  return lsys_glb_binary(g->out, binary) && lsys_spool_copy(&g->vertex, g->out) && lsys_spool_copy(&g->triangle, g->out)
      && lsys_spool_copy(&g->edge, g->out);
}

static void destroy(LsysModel *model) {
  Glb *g = (Glb *)model;
  lsys_spool_close(&g->vertex);
  lsys_spool_close(&g->triangle);
  lsys_spool_close(&g->edge);
  free(g);
}

LsysModel *lsys_glb_create(LsysOut *out) {
  Glb *g = calloc(1, sizeof *g);
  if (!g) {
    lsys_error("out of memory");
    return NULL;
  }
  g->model = (LsysModel){.open = open_model,
                         .vertices = vertices,
                         .triangles = triangles,
                         .edges = edges,
                         .close = close_model,
                         .destroy = destroy};
  g->out = out;
  return &g->model;
}
