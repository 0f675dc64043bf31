// shared_glb.c -- a deterministic figure as meshes of sub-figures and one node
// for each place where one stands.
//
// All parts with the same number of steps left, the cut, are meshes; what is
// above them is walked, and each part met there becomes a node. The cut is
// chosen so that meshes and nodes together are small. A mesh has a primitive for
// each colour that it begins with or changes to; with another pen it shares
// places and indices and differs in materials only.
// Source: Khronos, glTF 2.0 specification, sections 3.5, 3.7 and 3.9.
#include "core/memory.h"
#include "core/message.h"
#include "sinks/glb.h"
#include "sinks/layout.h"
#include "sinks/shared.h"
#include "sinks/spool.h"
#include "sinks/tubes.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum {
  NODE_BYTES = 110,  // of JSON, about
  MOST_NODES = 2000000,
  MOST_MESHES = 4096,
  NO_MESH = INT32_MAX,
  VERTEX = 24,  // place and normal
};

// What one mesh draws in one colour, relative to the colour it begins with.
typedef struct Primitive {
  uint32_t mesh;
  uint8_t colour;
  bool lines;
  uint64_t first;  // index, in 4 bytes
  uint64_t count;
} Primitive;

// A sub-figure with a width; its vertices.
typedef struct Mesh {
  uint32_t kind;
  double width;
  uint8_t colour;         // that it begins with; 0 where colours are relative
  uint64_t first, count;  // vertices
  float low[3], high[3];
} Mesh;

// A mesh with a colour that it begins with: a glTF mesh.
typedef struct Look {
  uint32_t mesh;
  uint8_t colour;
} Look;

typedef struct Glb {
  LsysModel model;  // takes in vertices, triangles and edges of the mesh that is being made
  LsysTubes tubes;
  LsysParts *parts;
  LsysOut *out;
  uint64_t cut;
  double width;  // length of a width of 1
  uint32_t sides;
  bool absolute;  // colours are set, not only counted up: meshes differ by colour
  LsysPalette palette;
  LsysSpool vertex, index, node;
  Mesh *mesh;
  Primitive *primitive;
  Look *look;
  size_t meshes, mesh_room, primitives, primitive_room, looks, look_room;
  uint64_t vertices, indices, nodes;
  // Indices of the open mesh, by colour: triangles and edges.
  struct Indices {
    uint32_t *at;
    size_t count, room;
  } open[2][256];
} Glb;

static bool grow(const Glb *g, void *array, size_t *room, size_t count, size_t size) {
  return lsys_memory_fit(g->parts->run->memory, array, room, count, size);
}

// ---- meshes --------------------------------------------------------------

static bool take_vertices(LsysModel *model, const LsysVertex *v, size_t count) {
  Glb *g = (Glb *)model;
  Mesh *m = &g->mesh[g->meshes - 1];
  for (size_t i = 0; i < count; i++) {
    const float place[3] = {v[i].x, v[i].y, v[i].z};
    for (int k = 0; k < 3; k++) {
      m->low[k] = fminf(m->low[k], place[k]);
      m->high[k] = fmaxf(m->high[k], place[k]);
    }
    if (!lsys_spool_write(&g->vertex, &v[i], VERTEX)) return false;
  }
  m->count += count;
  g->vertices += count;
  return true;
}

static bool take_indices(Glb *g, int lines, const uint32_t *index, const uint8_t *colour, size_t count,
                         size_t corners) {
  for (size_t i = 0; i < count; i++) {
    struct Indices *to = &g->open[lines][colour[i]];
    if (!grow(g, &to->at, &to->room, to->count + corners, sizeof *to->at)) return false;
    for (size_t k = 0; k < corners; k++) to->at[to->count++] = index[corners * i + k];
  }
  return true;
}

static bool take_triangles(LsysModel *model, const uint32_t *corner, const uint8_t *colour, size_t count) {
  return take_indices((Glb *)model, 0, corner, colour, count, 3);
}

static bool take_edges(LsysModel *model, const uint32_t *end, const uint8_t *colour, size_t count) {
  return take_indices((Glb *)model, 1, end, colour, count, 2);
}

static bool begin_mesh(Glb *g, uint32_t kind, double width, uint8_t colour) {
  if (g->meshes == MOST_MESHES) {
    lsys_error("--shared: the figure has more than %d different meshes", MOST_MESHES);
    return false;
  }
  if (!grow(g, &g->mesh, &g->mesh_room, g->meshes + 1, sizeof *g->mesh)) return false;
  g->mesh[g->meshes++] =
    (Mesh){kind, width, colour, g->vertices, 0, {FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
  g->tubes.vertices = 0;
  return true;
}

// Hands the indices of the open mesh to the spool, a primitive for each colour.
static bool end_mesh(Glb *g) {
  if (!lsys_tubes_flush(&g->tubes)) return false;
  for (int lines = 0; lines < 2; lines++) {
    for (int colour = 0; colour < 256; colour++) {
      struct Indices *from = &g->open[lines][colour];
      if (!from->count) continue;
      if (!grow(g, &g->primitive, &g->primitive_room, g->primitives + 1, sizeof *g->primitive)) return false;
      g->primitive[g->primitives++] =
        (Primitive){(uint32_t)g->meshes - 1, (uint8_t)colour, lines, g->indices, from->count};
      if (!lsys_spool_write(&g->index, from->at, from->count * sizeof *from->at)) return false;
      g->indices += from->count;
      from->count = 0;
    }
  }
  return true;
}

// The part, all of it, walked from the origin with colour 0.
static bool expand(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  const Glb *g = data;
  LsysWord word = lsys_parts_word(g->parts, kind);
  LsysPose inside = *pose;
  const LsysWalk walk = {(LsysGeometry *)&g->tubes.geometry, expand, data};
  return lsys_parts_walk(g->parts, &word, steps - 1, &inside, &walk);
}

static bool make_mesh(Glb *g, uint32_t kind, double width, uint8_t colour) {
  LsysPose pose = lsys_pose_origin(width, colour);
  const LsysWalk walk = {&g->tubes.geometry, expand, g};
  uint8_t own[2] = {(uint8_t)kind, (uint8_t)(kind >> 8)};
  const LsysWord word = {.sym = own, .nsym = 1};
  if (!begin_mesh(g, kind, width, colour)) return false;
  lsys_parts_begin(g->parts, &walk);
  if (!lsys_parts_walk(g->parts, &word, g->cut, &pose, &walk) || !end_mesh(g)) return false;
  if (!g->mesh[g->meshes - 1].count) g->meshes--;  // polygons without an area
  return true;
}

// ---- nodes ---------------------------------------------------------------

// Collected first, since making a mesh walks with the same turtle.
typedef struct Node {
  LsysPose pose;
  uint32_t kind;
} Node;

typedef struct Nodes {
  Glb *glb;
  Node *at;
  size_t count, room;
} Nodes;

static bool meet(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  Nodes *n = data;
  Glb *g = n->glb;
  if (steps > g->cut) {
    LsysWord word = lsys_parts_word(g->parts, kind);
    LsysPose inside = *pose;
    const LsysWalk walk = {&g->tubes.geometry, meet, n};
    return lsys_parts_walk(g->parts, &word, steps - 1, &inside, &walk);
  }
  if (!(lsys_part(g->parts, kind, steps)->segments + lsys_part(g->parts, kind, steps)->polygons > 0)) return true;
  if (!grow(g, &n->at, &n->room, n->count + 1, sizeof *n->at)) return false;
  n->at[n->count++] = (Node){*pose, kind};
  return true;
}

// NO_MESH: the part draws nothing.
static bool find_mesh(Glb *g, uint32_t kind, double width, uint8_t colour, uint32_t *mesh) {
  for (size_t i = 0; i < g->meshes; i++) {
    *mesh = (uint32_t)i;
    if (g->mesh[i].kind == kind && g->mesh[i].width == width && g->mesh[i].colour == colour) return true;
  }
  *mesh = (uint32_t)g->meshes;
  if (!make_mesh(g, kind, width, colour)) return false;
  if (g->meshes == *mesh) *mesh = NO_MESH;
  return true;
}

static bool find_look(Glb *g, uint32_t mesh, uint8_t colour, size_t *look) {
  for (*look = 0; *look < g->looks; ++*look) {
    if (g->look[*look].mesh == mesh && g->look[*look].colour == colour) return true;
  }
  if (!grow(g, &g->look, &g->look_room, g->looks + 1, sizeof *g->look)) return false;
  g->look[g->looks++] = (Look){mesh, colour};
  return true;
}

static bool spool(LsysSpool *to, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool spool(LsysSpool *to, const char *format, ...) {
  char text[1024];
  va_list args;
  va_start(args, format);
  int n = vsnprintf(text, sizeof text, format, args);
  va_end(args);
  return lsys_spool_write(to, text, (size_t)n);
}

// The unit quaternion of the turn that takes x to right, y to ahead and z to up (Shepperd 1978).
static void quaternion(LsysVec3 r, LsysVec3 a, LsysVec3 u, double *q) {
  const double four[4] = {1 + r.x - a.y - u.z, 1 - r.x + a.y - u.z, 1 - r.x - a.y + u.z, 1 + r.x + a.y + u.z};
  int best = 3;
  for (int i = 0; i < 3; i++)
    if (four[i] > four[best]) best = i;
  const double raw[4][4] = {{four[0], r.y + a.x, u.x + r.z, a.z - u.y},
                            {r.y + a.x, four[1], a.z + u.y, u.x - r.z},
                            {u.x + r.z, a.z + u.y, four[2], r.y - a.x},
                            {a.z - u.y, u.x - r.z, r.y - a.x, four[3]}};
  double length = 0;
  for (int i = 0; i < 4; i++) length += raw[best][i] * raw[best][i];
  for (int i = 0; i < 4; i++) q[i] = raw[best][i] / sqrt(length);
}

static double tidy(double x) {
  return fabs(x) < 1e-7 ? 0 : x;
}

static bool write_node(Glb *g, const LsysPose *p, size_t look) {
  double q[4];
  quaternion((LsysVec3){-p->l.x, -p->l.y, -p->l.z}, p->h, p->u, q);
  spool(&g->node, ",{\"mesh\":%zu", look);
  if (fabs(q[3]) < 1 - 1e-12)
    spool(&g->node, ",\"rotation\":[%.7g,%.7g,%.7g,%.7g]", tidy(q[0]), tidy(q[1]), tidy(q[2]), tidy(q[3]));
  g->nodes++;
  return spool(&g->node, ",\"translation\":[%.6g,%.6g,%.6g]}", tidy(p->at.x), tidy(p->at.y), tidy(p->at.z));
}

// A figure: what is drawn above the cut is a mesh of its own, then come its nodes.
static bool write_figure(Glb *g, uint32_t axiom, double shift) {
  Nodes nodes = {.glb = g};
  const LsysWalk walk = {&g->tubes.geometry, meet, &nodes};
  LsysPose start, pose;
  LsysPart whole;
  if (!lsys_parts_figure(g->parts, axiom, &start, &whole) || !begin_mesh(g, UINT32_MAX, axiom, 0)) return false;
  pose = start;
  lsys_parts_begin(g->parts, &walk);
  bool well = lsys_parts_walk(g->parts, &g->parts->run->grammar->axioms[axiom].word, g->parts->steps, &pose, &walk)
           && end_mesh(g);
  uint32_t mesh = (uint32_t)g->meshes - 1;
  size_t look;
  if (!g->mesh[mesh].count) g->meshes--;
  LsysPose beside = lsys_pose_origin(1, 0);
  beside.at.x = shift;
  if (well && g->meshes > mesh) well = find_look(g, mesh, 0, &look) && write_node(g, &beside, look);
  for (size_t i = 0; well && i < nodes.count; i++) {
    LsysPose at = nodes.at[i].pose;
    at.at.x += shift;
    uint8_t own = g->absolute ? at.colour : 0;
    well = find_mesh(g, nodes.at[i].kind, at.width, own, &mesh);
    if (well && mesh != NO_MESH)
      well = find_look(g, mesh, (uint8_t)(at.colour - own), &look) && write_node(g, &at, look);
  }
  lsys_memory_free(g->parts->run->memory, nodes.at, nodes.room, sizeof *nodes.at);
  return well;
}

// ---- the cut -------------------------------------------------------------

// How many parts of each kind a word has.
static void count_word(const LsysParts *parts, const LsysWord *word, double times, double *count) {
  bool wide = parts->run->grammar->flags & LSYS_GRAMMAR_WIDE;
  for (uint64_t i = 0; i < word->nsym; i++) {
    uint32_t kind = wide ? word->sym[2 * i] | (uint32_t)word->sym[2 * i + 1] << 8 : word->sym[i];
    if (lsys_parts_expands(parts, kind)) count[kind] += times;
  }
}

// Nodes and bytes of the meshes if the cut is here; count[k]: parts of kind k in the figure.
static void cost(const Glb *g, uint64_t cut, const double *count, double *nodes, double *bytes) {
  *nodes = *bytes = 0;
  for (uint32_t k = 0; k < g->parts->kinds; k++) {
    if (!(count[k] > 0)) continue;
    const LsysPart *part = lsys_part(g->parts, k, cut);
    if (!(part->segments + part->polygons > 0)) continue;
    *nodes += count[k];
    *bytes += part->segments * g->sides * (2 * VERTEX + 4 * 12) + part->polygons * 6 * (VERTEX + 12);
  }
  *bytes += *nodes * NODE_BYTES;
}

static bool choose_cut(Glb *g, uint32_t first, uint32_t end) {
  const LsysParts *parts = g->parts;
  double *count = calloc(parts->kinds + 1, sizeof *count), *next = calloc(parts->kinds + 1, sizeof *next);
  double best = INFINITY;
  if (!count || !next) lsys_error("out of memory");
  for (uint32_t i = first; count && next && i < end; i++)
    count_word(parts, &parts->run->grammar->axioms[i].word, 1, count);
  for (uint64_t cut = parts->steps; count && next && cut > 0; cut--) {
    double nodes, bytes;
    cost(g, cut, count, &nodes, &bytes);
    if (nodes > MOST_NODES) break;
    if (bytes < best) {
      best = bytes;
      g->cut = cut;
    }
    memset(next, 0, parts->kinds * sizeof *next);
    for (uint32_t k = 0; k < parts->kinds; k++) {
      LsysWord word;
      if (count[k] > 0 && (word = lsys_parts_word(parts, k)).nsym) count_word(parts, &word, count[k], next);
    }
    memcpy(count, next, parts->kinds * sizeof *count);
  }
  free(count);
  free(next);
  if (best < 4e9) return true;
  if (isfinite(best)) lsys_error("--shared: the figure would take %.3g bytes; a GLB holds no more than 4 GiB", best);
  return false;
}

// ---- the file ------------------------------------------------------------

// Numbers the colours that are used: material[colour].
static void number_materials(const Glb *g, int *material) {
  bool used[256] = {0};
  for (size_t i = 0; i < g->looks; i++) {
    for (size_t k = 0; k < g->primitives; k++)
      if (g->primitive[k].mesh == g->look[i].mesh) used[(uint8_t)(g->primitive[k].colour + g->look[i].colour)] = true;
  }
  int materials = 0;
  for (int i = 0; i < 256; i++) material[i] = used[i] ? materials++ : -1;
}

static bool print_meshes(Glb *g, LsysSpool *json) {
  int material[256];
  number_materials(g, material);
  spool(json, "],\"meshes\":[");
  for (size_t i = 0; i < g->looks; i++) {
    const Look *look = &g->look[i];
    bool later = false;
    spool(json, "%s{\"primitives\":[", i ? "," : "");
    for (size_t k = 0; k < g->primitives; k++) {
      const Primitive *p = &g->primitive[k];
      if (p->mesh != look->mesh) continue;
      uint8_t colour = (uint8_t)(p->colour + look->colour);
      spool(json, "%s{\"attributes\":{\"POSITION\":%u,\"NORMAL\":%u},\"indices\":%zu,\"mode\":%d,\"material\":%d}",
            later ? "," : "", 2 * p->mesh, 2 * p->mesh + 1, 2 * g->meshes + k, p->lines ? 1 : 4, material[colour]);
      later = true;
    }
    spool(json, "]}");
  }
  spool(json, "],\"materials\":[");
  for (int i = 0; i < 256; i++) {
    double c[3];
    if (material[i] < 0) continue;
    lsys_glb_linear(g->palette.rgb[i], c);
    spool(json,
          "%s{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":[%.4g,%.4g,%.4g,1],"
          "\"metallicFactor\":0,\"roughnessFactor\":0.9}}",
          material[i] ? "," : "", c[0], c[1], c[2]);
  }
  return true;
}

static bool print_accessors(const Glb *g, LsysSpool *json) {
  spool(json, "],\"accessors\":[");
  for (size_t i = 0; i < g->meshes; i++) {
    const Mesh *m = &g->mesh[i];
    unsigned long long at = m->first * VERTEX, count = m->count;
    spool(json,
          "%s{\"bufferView\":0,\"byteOffset\":%llu,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC3\","
          "\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]}",
          i ? "," : "", at, count, (double)m->low[0], (double)m->low[1], (double)m->low[2], (double)m->high[0],
          (double)m->high[1], (double)m->high[2]);
    spool(json, ",{\"bufferView\":0,\"byteOffset\":%llu,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC3\"}",
          at + 12, count);
  }
  for (size_t i = 0; i < g->primitives; i++)
    spool(json, ",{\"bufferView\":1,\"byteOffset\":%llu,\"componentType\":5125,\"count\":%llu,\"type\":\"SCALAR\"}",
          (unsigned long long)g->primitive[i].first * 4, (unsigned long long)g->primitive[i].count);
  return spool(json,
               "],\"bufferViews\":[{\"buffer\":0,\"byteLength\":%llu,\"byteStride\":%d,\"target\":34962},"
               "{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,\"target\":34963}],"
               "\"buffers\":[{\"byteLength\":%llu}]}",
               (unsigned long long)g->vertex.size, VERTEX, (unsigned long long)g->vertex.size,
               (unsigned long long)g->index.size, (unsigned long long)(g->vertex.size + g->index.size));
}

// The JSON: nodes were spooled as they came, behind a root that names them all.
static bool print_json(Glb *g, LsysSpool *json) {
  spool(json, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"lsysc\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
              "\"nodes\":[{\"name\":\"figure\"");
  for (uint64_t i = 0; i < g->nodes; i++) spool(json, "%s%llu", i ? "," : ",\"children\":[", (unsigned long long)i + 1);
  spool(json, g->nodes ? "]}" : "}");
  if (!lsys_spool_append(json, &g->node)) return false;
  return g->nodes ? print_meshes(g, json) && print_accessors(g, json) : spool(json, "]}");
}

static bool write_file(Glb *g) {
  LsysSpool json;
  if (!lsys_spool_open(&json)) return false;
  bool well = print_json(g, &json);
  while (well && json.size % 4) well = spool(&json, " ");
  uint64_t binary = g->nodes ? g->vertex.size + g->index.size : 0;
  well = well && lsys_glb_head(g->out, json.size, binary) && lsys_spool_copy(&json, g->out);
  if (well && binary)
    well = lsys_glb_binary(g->out, binary) && lsys_spool_copy(&g->vertex, g->out) && lsys_spool_copy(&g->index, g->out);
  lsys_spool_close(&json);
  return well;
}

// A width of 1 is a tenth of a step.
static void choose_looks(Glb *g, const LsysModelOptions *options) {
  double width = g->parts->run->value[LSYS_SETTING_WIDTH];
  g->width = 0.1 * fabs(g->parts->run->value[LSYS_SETTING_STEP]) / (width > 0 ? width : 1);
  if (g->parts->run->value[LSYS_SETTING_WIDTHS] == 1) g->width = 1;
  if (isfinite(options->line_width)) g->width *= options->line_width;
  const LsysGrammar *grammar = g->parts->run->grammar;
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    LsysTurtleOp op = (LsysTurtleOp)grammar->kinds[i].turtle;
    bool colours = op == LSYS_TURTLE_COLOUR_NEXT || op == LSYS_TURTLE_COLOUR_UP || op == LSYS_TURTLE_COLOUR_DOWN;
    g->absolute |= colours && grammar->kinds[i].arity > 0;
  }
  g->sides = options->sides ? options->sides : g->parts->directions.flat ? 1 : 6;
}

static bool write_figures(Glb *g, uint32_t first, uint32_t end) {
  double shift = 0;
  for (uint32_t i = first; i < end; i++) {
    if (!write_figure(g, i, shift)) return false;
    const Mesh *own = &g->mesh[g->meshes - 1];
    shift += own->count ? 1.2 * (double)(own->high[0] - own->low[0]) : 1;
  }
  return true;
}

static void release(Glb *g) {
  LsysMemory *memory = g->parts->run->memory;
  for (int i = 0; i < 512; i++) {
    const struct Indices *open = &g->open[i / 256][i % 256];
    lsys_memory_free(memory, open->at, open->room, sizeof *open->at);
  }
  lsys_memory_free(memory, g->mesh, g->mesh_room, sizeof *g->mesh);
  lsys_memory_free(memory, g->primitive, g->primitive_room, sizeof *g->primitive);
  lsys_memory_free(memory, g->look, g->look_room, sizeof *g->look);
  free(g);
}

bool lsys_shared_glb(LsysParts *parts, uint32_t first, uint32_t end, const LsysModelOptions *options, LsysOut *out) {
  Glb *g = calloc(1, sizeof *g);
  if (!g) {
    lsys_error("out of memory");
    return false;
  }
  g->model = (LsysModel){.vertices = take_vertices, .triangles = take_triangles, .edges = take_edges};
  g->parts = parts;
  g->out = out;
  lsys_palette_make(&g->palette, &options->colours, parts->run->grammar, true);
  choose_looks(g, options);
  bool well = choose_cut(g, first, end) && lsys_tubes_create(&g->tubes, &g->model) && lsys_spool_open(&g->vertex)
           && lsys_spool_open(&g->index) && lsys_spool_open(&g->node);
  g->tubes.memory = parts->run->memory;
  g->tubes.width = g->width;
  g->tubes.sides = g->sides;
  well = well && write_figures(g, first, end) && write_file(g);
  lsys_tubes_destroy(&g->tubes);
  lsys_spool_close(&g->vertex);
  lsys_spool_close(&g->index);
  lsys_spool_close(&g->node);
  release(g);
  return well;
}
