// sweep.c -- generalised cylinders and patches: surfaces that the turtle spans
// by walking along them.
//
// A cylinder is a row of pieces between nodes, places with a frame and a width.
// The axis of a piece is a Hermite curve whose tangents are the headings at its
// ends; a contour, half the width from its middle to its rim, is carried along.
// Sources: cpfg's manual (@G, {(n), @P); Mech, Prusinkiewicz, Hanan 1997;
// Bloomenthal 1985 ("Modeling the mighty maple").
#include "turtle/actions.h"
#include "turtle/patch.h"

#include <string.h>

enum { MOST_RINGS = 256, SPLINE_RINGS = 6, ROW = MOST_SIDES + 1 };

// A contour in the plane of L (to the left) and U: corners and unit normals, open or closed.
typedef struct Contour {
  double left[ROW], up[ROW], normal_left[ROW], normal_up[ROW];
  uint32_t corners;  // a closed one repeats the first at the end
} Contour;

// The contour of this number that the grammar's files give; NULL: none.
static const LsysContour *file_contour(const LsysTurtle *t, uint32_t number) {
  const LsysGrammar *g = t->run->grammar;
  for (uint32_t i = 0; i < g->contour_count; i++) {
    if (g->contours[i].number == number) return &g->contours[i];
  }
  return NULL;
}

// So many sides of a file's contour, equally long along it. Normals are at right angles to the line between the
// neighbours: out of a closed contour, to the left of an open one as it was drawn.
static void sample_contour(Contour *c, const LsysContour *file, uint32_t sides) {
  c->corners = sides + 1;
  for (uint32_t i = 0; i <= sides; i++) {
    double at = (double)file->pieces * i / sides;
    uint32_t piece = at < file->pieces ? (uint32_t)at : file->pieces - 1;
    const double *p = &file->point[2 * (size_t)piece];
    double share = at - piece;
    c->left[i] = p[0] * (1 - share) + p[2] * share;
    c->up[i] = p[1] * (1 - share) + p[3] * share;
  }
  for (uint32_t i = 0; i <= sides; i++) {
    uint32_t before = i ? i - 1 : file->closed ? sides - 1 : 0, behind = i < sides ? i + 1 : file->closed ? 1 : sides;
    double x = c->left[behind] - c->left[before], y = c->up[behind] - c->up[before];
    double length = sqrt(x * x + y * y), unit = length > 0 ? 1 / length : 0;
    c->normal_left[i] = y * unit;
    c->normal_up[i] = unit == 0 ? 1 : -x * unit;
  }
}

// 0 a circle, 1 a ribbon along L, 2 a gutter (half a circle, open towards U).
static void make_contour(Contour *c, uint32_t which, uint32_t sides) {
  c->corners = sides + 1;
  for (uint32_t i = 0; i <= sides; i++) {
    double part = (double)i / sides, angle = which == 2 ? 180 + 180 * part : 360 * part;
    double x = lsys_cos(angle), y = lsys_sin(angle);
    bool ribbon = which == 1;
    c->left[i] = ribbon ? 2 * part - 1 : x;
    c->up[i] = ribbon ? 0 : y;
    c->normal_left[i] = ribbon ? 0 : which == 2 ? -x : x;
    c->normal_up[i] = ribbon ? 1 : which == 2 ? -y : y;
  }
}

// ---- one piece -----------------------------------------------------------

static LsysVec3 hermite(const LsysVec3 *p, const LsysVec3 *m, double t) {
  double t2 = t * t, t3 = t2 * t;
  return vec_sum(vec_sum(p[0], 2 * t3 - 3 * t2 + 1, m[0], t3 - 2 * t2 + t), 1,
                 vec_sum(p[1], -2 * t3 + 3 * t2, m[1], t3 - t2), 1);
}

static LsysVec3 hermite_slope(const LsysVec3 *p, const LsysVec3 *m, double t) {
  double t2 = t * t;
  return vec_sum(vec_sum(p[0], 6 * t2 - 6 * t, m[0], 3 * t2 - 4 * t + 1), 1,
                 vec_sum(p[1], -6 * t2 + 6 * t, m[1], 3 * t2 - 2 * t), 1);
}

// The part of `side` at right angles to a unit axis, unit; some other such vector if there is none.
static LsysVec3 aside(LsysVec3 side, LsysVec3 axis) {
  side = vec_sum(side, 1, axis, -vec_dot(side, axis));
  if (vec_length(side) < 1e-9) side = vec_cross(axis, fabs(axis.x) < 0.6 ? (LsysVec3){1, 0, 0} : (LsysVec3){0, 1, 0});
  return vec_unit(side);
}

typedef struct Piece {
  LsysVec3 place[2], tangent[2];
  LsysVec3 left[2];
  double radius[2];
} Piece;

static void put_ring(LsysTurtle *t, const Contour *c, const Piece *piece, double at, LsysVec3 **vertex,
                     LsysVec3 **normal) {
  LsysVec3 p = hermite(piece->place, piece->tangent, at), axis = hermite_slope(piece->place, piece->tangent, at);
  double length = vec_length(axis), radius = piece->radius[0] * (1 - at) + piece->radius[1] * at;
  axis = length > 1e-12 ? vec_scale(axis, 1 / length) : turtle_frame(t).h;
  LsysVec3 left = aside(vec_sum(piece->left[0], 1 - at, piece->left[1], at), axis), up = vec_cross(axis, left);
  for (uint32_t i = 0; i < c->corners; i++) {
    *(*vertex)++ = vec_sum(p, 1, vec_sum(left, c->left[i], up, c->up[i]), radius);
    *(*normal)++ = vec_sum(left, c->normal_left[i], up, c->normal_up[i]);
  }
}

static uint32_t *put_walls(uint32_t *corner, uint32_t rings, uint32_t row) {
  for (uint32_t i = 0; i + 1 < rings; i++) {
    for (uint32_t k = 0; k + 1 < row; k++) {
      uint32_t a = i * row + k, b = a + 1, c = a + row, d = c + 1;
      const uint32_t two[6] = {a, b, d, a, d, c};
      memcpy(corner, two, sizeof two);
      corner += 6;
    }
  }
  return corner;
}

static bool room(LsysTurtle *t, size_t vertices, size_t corners) {
  Sweep *s = &t->sweep;
  return turtle_grow(t, &s->vertex, &s->vertex_room, vertices, sizeof *s->vertex)
      && turtle_grow(t, &s->normal, &s->normal_room, vertices, sizeof *s->normal)
      && turtle_grow(t, &s->corner, &s->corner_room, corners, sizeof *s->corner);
}

static bool hand_on(LsysTurtle *t, uint32_t vertices, uint32_t triangles) {
  const LsysPlace as_it_is = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const LsysMesh mesh = {t->sweep.vertex, t->sweep.normal, t->sweep.corner, vertices, triangles, 0};
  LsysPen pen = turtle_pen(t);
  return !t->to->mesh || (turtle_flush(t) && t->to->mesh(t->to, &mesh, &as_it_is, &pen));
}

static bool draw_piece(LsysTurtle *t, const Piece *piece, uint32_t rings) {
  Contour contour;
  const LsysContour *file = file_contour(t, t->state.contour);
  if (file)
    sample_contour(&contour, file, t->state.sides);
  else
    make_contour(&contour, t->state.contour, t->state.contour == 1 ? 2 : t->state.sides);
  uint32_t row = contour.corners;
  if (!room(t, (size_t)(rings + 1) * row, 6 * (size_t)rings * row)) return false;
  LsysVec3 *vertex = t->sweep.vertex, *normal = t->sweep.normal;
  for (uint32_t i = 0; i <= rings; i++) put_ring(t, &contour, piece, (double)i / rings, &vertex, &normal);
  put_walls(t->sweep.corner, rings + 1, row);
  return hand_on(t, (rings + 1) * row, 2 * rings * (row - 1));
}

// ---- @G ------------------------------------------------------------------

static SweepNode node_here(const LsysTurtle *t) {
  LsysVec3 p = turtle_out(t, (LsysVec3){t->state.at[0], t->state.at[1], t->state.z});
  Frame f = turtle_frame(t);
  return (SweepNode){p, f.h, f.l, t->state.width / 2};
}

bool act_cylinder_begin(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  t->state.node = node_here(t);
  t->state.sweeping = true;
  return true;
}

static uint32_t whole(double x, uint32_t least, uint32_t most) {
  return x >= most ? most : x >= least ? (uint32_t)x : least;
}

static bool piece_to_here(LsysTurtle *t, int given, const double *arg) {
  if (!t->state.sweeping) {
    turtle_warn(t, WARN_SWEEP, t->read, "a generalised cylinder goes on that was not begun by @Gs: left out");
    return true;
  }
  SweepNode from = t->state.node, to = node_here(t);
  double distance = vec_length(vec_sum(to.place, 1, from.place, -1));
  const Piece piece = {
    {from.place, to.place},
    {vec_scale(from.heading, distance * t->state.tangent[0]), vec_scale(to.heading, distance * t->state.tangent[1])},
    {from.left, to.left},
    {from.radius, to.radius}};
  t->state.node = to;
  return !(distance > 0) || draw_piece(t, &piece, given ? whole(arg[0], 1, MOST_RINGS) : SPLINE_RINGS);
}

bool act_cylinder_point(LsysTurtle *t, int given, const double *arg) {
  return piece_to_here(t, given, arg);
}

bool act_cylinder_end(LsysTurtle *t, int given, const double *arg) {
  bool well = piece_to_here(t, given, arg);
  t->state.sweeping = false;
  return well;
}

bool act_cylinder_tangent(LsysTurtle *t, int given, const double *arg) {
  t->state.tangent[0] = arg[0];
  t->state.tangent[1] = given > 1 ? arg[1] : arg[0];
  return true;
}

bool act_contour(LsysTurtle *t, int given, const double *arg) {
  double number = given ? arg[0] : 0;
  bool in_range = number >= 0 && number < LSYS_MOST_CONTOUR + 1;
  if (in_range && ((uint32_t)number <= 2 || file_contour(t, (uint32_t)number)))
    t->state.contour = (uint8_t)number;
  else
    turtle_warn(t, WARN_CONTOUR, t->read, "there is no contour of this number: the module is left out");
  return true;
}

bool act_sides(LsysTurtle *t, int given, const double *arg) {
  t->state.sides = given ? (uint8_t)whole(arg[0], 3, MOST_SIDES) : t->start.sides;
  return true;
}

// ---- {(n) ----------------------------------------------------------------

bool turtle_spline_node(LsysTurtle *t) {
  Sweep *s = &t->sweep;
  if (!turtle_grow(t, &s->node, &s->node_room, s->nodes + 1, sizeof *s->node)) return false;
  SweepNode node = node_here(t);
  if (s->nodes) {
    LsysVec3 step = vec_sum(node.place, 1, s->node[s->nodes - 1].place, -1);
    if (!(vec_length(step) > 0)) return true;
  }
  s->node[s->nodes++] = node;
  return true;
}

// Through all nodes (Catmull and Rom): the tangent at a node is parallel to the line between its neighbours.
bool turtle_spline_draw(LsysTurtle *t) {
  const SweepNode *n = t->sweep.node;
  const size_t count = t->sweep.nodes;
  t->sweep.nodes = 0;
  for (size_t i = 0; i + 1 < count; i++) {
    const SweepNode *before = &n[i ? i - 1 : i], *behind = &n[i + 2 < count ? i + 2 : i + 1];
    const Piece piece = {{n[i].place, n[i + 1].place},
                         {vec_sum(n[i + 1].place, i ? 0.5 : 1, before->place, i ? -0.5 : -1),
                          vec_sum(behind->place, i + 2 < count ? 0.5 : 1, n[i].place, i + 2 < count ? -0.5 : -1)},
                         {n[i].left, n[i + 1].left},
                         {n[i].radius, n[i + 1].radius}};
    if (!draw_piece(t, &piece, SPLINE_RINGS)) return false;
  }
  return true;
}

// ---- patches -------------------------------------------------------------

// The patch of a number; NULL if there is no such patch, or memory (then *well is false).
static SweepPatch *find_patch(LsysTurtle *t, double number, bool make, bool *well) {
  Sweep *s = &t->sweep;
  for (size_t i = 0; i < s->patches; i++) {
    if (s->patch[i].number == number) return &s->patch[i];
  }
  if (!make) return NULL;
  *well = turtle_grow(t, &s->patch, &s->patch_room, s->patches + 1, sizeof *s->patch);
  return *well ? &s->patch[s->patches++] : NULL;
}

bool act_patch_begin(LsysTurtle *t, int given, const double *arg) {
  bool well = true;
  SweepPatch *p = find_patch(t, arg[0], true, &well);
  if (p) *p = (SweepPatch){.number = arg[0], .bspline = given > 1 && arg[1] == 2};
  return well;
}

bool act_patch_point(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  bool well = true;
  SweepPatch *p = find_patch(t, arg[0], false, &well);
  if (!p || !(arg[1] >= 0 && arg[1] < 4 && arg[2] >= 0 && arg[2] < 4)) {
    turtle_warn(t, WARN_PATCH, t->read, "@PC needs a patch that @PS began, and a row and column from 0 to 3: left out");
    return true;
  }
  p->control[4 * (uint32_t)arg[1] + (uint32_t)arg[2]] = node_here(t).place;
  return true;
}

bool act_patch_draw(LsysTurtle *t, int given, const double *arg) {
  bool well = true;
  const SweepPatch *p = find_patch(t, arg[0], false, &well);
  uint32_t s = given > 1 ? whole(arg[1], 1, PATCH_MOST_PIECES) : 8,
           k = given > 2 ? whole(arg[2], 1, PATCH_MOST_PIECES) : s;
  if (!p) {
    turtle_warn(t, WARN_PATCH, t->read, "@PD needs a patch that @PS began: left out");
    return true;
  }
  uint32_t vertices = (s + 1) * (k + 1);
  if (!room(t, vertices, 6 * (size_t)s * k)) return false;
  patch_grid(p->control, p->bspline ? PATCH_BSPLINE : PATCH_BEZIER, s, k, turtle_frame(t).u, 0, t->sweep.vertex,
             t->sweep.normal, t->sweep.corner);
  return hand_on(t, vertices, 2 * s * k);
}
