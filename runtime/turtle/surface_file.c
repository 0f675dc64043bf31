// surface_file.c -- meshes from files: Wavefront OBJ, and cpfg's surfaces of
// bicubic Bezier patches.
#include "lsys/input.h"
#include "lsys/surface.h"
#include "turtle/patch.h"
#include "turtle/triangulate.h"
#include "turtle/vector.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATCH_PIECES = 8, MOST_VERTICES = 1 << 26 };

typedef struct Reader {
  FILE *file;
  char *line;
  size_t line_room;
  unsigned number;  // of the line
  LsysVec3 *vertex, *normal;
  uint32_t *corner;
  size_t vertices, vertex_room, normals, normal_room, corners, corner_room;
  LsysVec3 *smooth;  // OBJ: the sum of the normals that faces give to each vertex
  size_t smooth_room;
  uint32_t *face;  // the vertices of the face that is read, and where they are
  LsysVec3 *place;
  size_t face_room, place_room;
  PolygonCutter cutter;
  char *why;
  size_t size;
} Reader;

static bool fail(Reader *r, const char *what) {
  if (r->number)
    snprintf(r->why, r->size, "line %u: %s", r->number, what);
  else
    snprintf(r->why, r->size, "%s", what);
  return false;
}

static bool grow(Reader *r, void *array, size_t *room, size_t count, size_t size) {
  if (count <= *room) return true;
  size_t wanted = count < 128 ? 256 : 2 * count;
  void *old, *grown = NULL;
  memcpy(&old, array, sizeof old);
  if (count <= MOST_VERTICES) grown = realloc(old, wanted * size);
  if (!grown) return fail(r, "the surface is too big");
  memset((char *)grown + *room * size, 0, (wanted - *room) * size);
  memcpy(array, &grown, sizeof grown);
  *room = wanted;
  return true;
}

static bool next_line(Reader *r) {
  ssize_t length = getline(&r->line, &r->line_room, r->file);
  if (length < 0) return false;
  r->number++;
  return true;
}

static bool read_vec(const char *text, LsysVec3 *v) {
  char *end;
  double number[3];
  for (int i = 0; i < 3; i++) {
    number[i] = strtod(text, &end);
    if (end == text || !isfinite(number[i])) return false;
    text = end;
  }
  *v = (LsysVec3){number[0], number[1], number[2]};
  return true;
}

static bool add_vec(Reader *r, LsysVec3 **array, size_t *count, size_t *room, LsysVec3 v) {
  if (!grow(r, array, room, *count + 1, sizeof v)) return false;
  (*array)[(*count)++] = v;
  return true;
}

static bool add_triangle(Reader *r, uint32_t a, uint32_t b, uint32_t c) {
  if (!grow(r, &r->corner, &r->corner_room, r->corners + 3, sizeof *r->corner)) return false;
  r->corner[r->corners++] = a;
  r->corner[r->corners++] = b;
  r->corner[r->corners++] = c;
  return true;
}

// ---- OBJ -----------------------------------------------------------------

// "7", "7/1", "7//3", "-1/…": numbers count from 1, negative ones back from the last. 0: there is none.
static bool read_reference(char **text, size_t vertices, size_t normals, uint32_t *vertex, uint32_t *normal) {
  long number[3] = {0};
  for (int i = 0; i < 3; i++) {
    char *end;
    number[i] = strtol(*text, &end, 10);
    *text = end;
    if (**text != '/') break;
    ++*text;
  }
  long v = number[0] < 0 ? (long)vertices + 1 + number[0] : number[0];
  long n = number[2] < 0 ? (long)normals + 1 + number[2] : number[2];
  if (v < 1 || (size_t)v > vertices || n < 0 || (size_t)n > normals) return false;
  *vertex = (uint32_t)v - 1;
  *normal = (uint32_t)n;
  return true;
}

// The next vertex of a face, number `count` of it.
static bool read_corner(Reader *r, char **text, size_t count) {
  uint32_t vertex, normal;
  if (!grow(r, &r->face, &r->face_room, count + 1, sizeof *r->face)
      || !grow(r, &r->place, &r->place_room, count + 1, sizeof *r->place))
    return false;
  if (!read_reference(text, r->vertices, r->normals, &vertex, &normal) || !(**text == 0 || strchr(" \t\r\n", **text)))
    return fail(r, "a face names a vertex or normal that is not there");
  if (normal) {
    if (!grow(r, &r->smooth, &r->smooth_room, r->vertices, sizeof *r->smooth)) return false;
    r->smooth[vertex] = vec_sum(r->smooth[vertex], 1, r->normal[normal - 1], 1);
  }
  r->face[count] = vertex;
  r->place[count] = r->vertex[vertex];
  return true;
}

static bool read_face(Reader *r, char *text) {
  uint32_t count = 0;
  for (;; count++) {
    text += strspn(text, " \t\r\n");
    if (*text == 0 || *text == '#') break;
    if (!read_corner(r, &text, count)) return false;
  }
  if (count < 3) return fail(r, "a face needs three vertices");
  if (!polygon_triangles(&r->cutter, r->place, count)) return fail(r, "out of memory");
  for (uint32_t i = 0; i + 2 < count; i++) {
    const uint32_t *t = r->cutter.triangle + 3 * i;
    if (!add_triangle(r, r->face[t[0]], r->face[t[1]], r->face[t[2]])) return false;
  }
  return true;
}

static bool read_obj(Reader *r) {
  while (next_line(r)) {
    char *line = r->line + strspn(r->line, " \t");
    LsysVec3 v;
    bool vertex = line[0] == 'v' && strchr(" \t", line[1]), normal = line[0] == 'v' && line[1] == 'n';
    if (vertex || normal) {
      if (!read_vec(line + 2, &v)) return fail(r, "three numbers should stand here");
      if (vertex && !add_vec(r, &r->vertex, &r->vertices, &r->vertex_room, v)) return false;
      if (normal && !add_vec(r, &r->normal, &r->normals, &r->normal_room, v)) return false;
    } else if (line[0] == 'f' && strchr(" \t", line[1])) {
      if (!read_face(r, line + 1)) return false;
    }
  }
  if (!r->smooth) return true;
  // Normals are kept if every vertex has one.
  if (!grow(r, &r->smooth, &r->smooth_room, r->vertices, sizeof *r->smooth)) return false;
  for (size_t i = 0; i < r->vertices; i++) {
    double length = vec_length(r->smooth[i]);
    if (!(length > 0)) return true;
    r->smooth[i] = vec_scale(r->smooth[i], 1 / length);
  }
  free(r->normal);
  r->normal = r->smooth;
  r->normals = r->vertices;
  r->smooth = NULL;
  return true;
}

// ---- Bezier patches ------------------------------------------------------

// Where a surface of cpfg lies: its own frame and size.
typedef struct Fit {
  LsysVec3 contact, right, ahead, up;
  double size;
} Fit;

static LsysVec3 fitted(const Fit *f, LsysVec3 p, bool place) {
  if (place) p = vec_sum(p, 1, f->contact, -1);
  double scale = place ? 1 / f->size : 1;
  return (LsysVec3){scale * vec_dot(p, f->right), scale * vec_dot(p, f->ahead), scale * vec_dot(p, f->up)};
}

static bool add_patch(Reader *r, const Fit *fit, const LsysVec3 *control) {
  enum { VERTICES = (PATCH_PIECES + 1) * (PATCH_PIECES + 1), CORNERS = 6 * PATCH_PIECES * PATCH_PIECES };
  LsysVec3 vertex[VERTICES], normal[VERTICES];
  uint32_t corner[CORNERS], first = (uint32_t)r->vertices;
  patch_grid(control, PATCH_BEZIER, PATCH_PIECES, PATCH_PIECES, fit->up, first, vertex, normal, corner);
  for (int i = 0; i < VERTICES; i++) {
    if (!add_vec(r, &r->vertex, &r->vertices, &r->vertex_room, fitted(fit, vertex[i], true))
        || !add_vec(r, &r->normal, &r->normals, &r->normal_room, fitted(fit, normal[i], false)))
      return false;
  }
  for (int i = 0; i < CORNERS; i += 3) {
    if (!add_triangle(r, corner[i], corner[i + 1], corner[i + 2])) return false;
  }
  return true;
}

// "HEADING  X: 0.00 Y: 1.00 Z: 0.00"
static bool read_named(const char *line, const char *name, LsysVec3 *v) {
  size_t length = strlen(name);
  return strncmp(line, name, length) == 0 && sscanf(line + length, " X: %lf Y: %lf Z: %lf", &v->x, &v->y, &v->z) == 3;
}

static bool complete(Reader *r, Fit *fit) {
  double h = vec_length(fit->ahead), u = vec_length(fit->up);
  LsysVec3 right = vec_cross(fit->ahead, fit->up);
  double across = vec_length(right);
  if (!(h > 0) || !(u > 0) || !(across > 1e-6 * h * u) || !(fit->size > 0))
    return fail(r, "HEADING, UP and SIZE do not give a frame");
  fit->ahead = vec_scale(fit->ahead, 1 / h);
  fit->right = vec_scale(right, 1 / across);
  fit->up = vec_cross(fit->right, fit->ahead);
  return true;
}

// Behind the head come patches: lines of names and neighbours, then four of four points.
static bool read_patches(Reader *r, const Fit *fit) {
  LsysVec3 control[16];
  int points = 0;
  while (next_line(r)) {
    char *text = r->line, *end = text;
    double number[12];
    int n = 0;
    for (; n < 12; n++, text = end) {
      number[n] = strtod(text, &end);
      if (end == text || !isfinite(number[n])) break;
    }
    if (n == 0 && points == 0) continue;
    if (n < 12) return fail(r, "four points should stand here");
    for (int i = 0; i < 4; i++) control[points++] = (LsysVec3){number[3 * i], number[3 * i + 1], number[3 * i + 2]};
    if (points < 16) continue;
    points = 0;
    if (!add_patch(r, fit, control)) return false;
  }
  return points == 0 || fail(r, "the last patch is not complete");
}

static bool read_patch_file(Reader *r) {
  Fit fit = {.ahead = {0, 1, 0}, .up = {0, 0, 1}, .size = 1};
  LsysVec3 end;
  if (!next_line(r)) return fail(r, "the file is empty");  // its box
  while (next_line(r)) {
    const char *line = r->line;
    if (sscanf(line, "SIZE: %lf", &fit.size) == 1) return complete(r, &fit) && read_patches(r, &fit);
    bool known = read_named(line, "CONTACT POINT", &fit.contact) || read_named(line, "END POINT", &end)
              || read_named(line, "HEADING", &fit.ahead) || read_named(line, "UP", &fit.up)
              || strncmp(line, "PRECISION", 9) == 0;
    if (!known) return fail(r, "this is no head of a cpfg surface");
  }
  return fail(r, "there is no SIZE:");
}

// --------------------------------------------------------------------------

bool lsys_surface_read(const char *path, LsysSurface *surface, char *why, size_t size) {
  const char *reason;
  Reader r = {.file = lsys_input_open(path, &reason), .why = why, .size = size};
  if (!r.file) return fail(&r, reason);
  const char *suffix = strrchr(path, '.');
  bool well = suffix && strcmp(suffix, ".s") == 0 ? read_patch_file(&r) : read_obj(&r);
  r.number = 0;
  if (well && r.corners == 0) well = fail(&r, "there is no face in it");
  fclose(r.file);
  free(r.line);
  free(r.smooth);
  free(r.face);
  free(r.place);
  polygon_cutter_free(&r.cutter);
  if (r.normals != r.vertices) {
    free(r.normal);
    r.normal = NULL;
  }
  *surface = (LsysSurface){.form = LSYS_SURFACE_MESH,
                           .vertices = (uint32_t)r.vertices,
                           .triangles = (uint32_t)(r.corners / 3),
                           .vertex = (const double *)r.vertex,
                           .normal = (const double *)r.normal,
                           .corner = r.corner};
  if (!well) lsys_surface_free(surface);
  return well;
}

void lsys_surface_free(LsysSurface *surface) {
  free((void *)surface->vertex);
  free((void *)surface->normal);
  free((void *)surface->corner);
  *surface = (LsysSurface){0};
}
