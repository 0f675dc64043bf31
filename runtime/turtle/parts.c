// parts.c -- what every kind of a deterministic grammar does to the turtle in
// its last s steps, from s = 0 upwards: each part is composed of the ones with a
// step less.
// Requires kinds whose words depend on nothing, with brackets and polygons that
// close where they open. Source of the idea: Jones, Saupe, "Stochastic methods
// and natural phenomena" 1986 (display lists); Hart, DeFanti 1991 (instancing).
#include "turtle/parts.h"

#include "core/memory.h"
#include "core/message.h"
#include "turtle/vector.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_STEPS = 100000, MOST_REALS = 1 << 27 };

// ---- which figures have parts --------------------------------------------

bool lsys_parts_expands(const LsysParts *parts, uint32_t kind) {
  return !(parts->run->grammar->kinds[kind].flags & LSYS_KIND_TERMINAL);
}

LsysWord lsys_parts_word(const LsysParts *parts, uint32_t kind) {
  const LsysBlock *b = &parts->run->block[kind][1];
  return (LsysWord){.sym = b->sym, .arg = b->arg, .nsym = b->nsym, .narg = b->narg};
}

static uint32_t symbol(const LsysParts *parts, const LsysWord *word, uint64_t i) {
  if (!(parts->run->grammar->flags & LSYS_GRAMMAR_WIDE)) return word->sym[i];
  return word->sym[2 * i] | (uint32_t)word->sym[2 * i + 1] << 8;
}

// What a turtle does with these does not depend on where it stands and how it came there.
static bool is_local(LsysTurtleOp op) {
  switch (op) {
  case LSYS_TURTLE_VERTICAL:
  case LSYS_TURTLE_VERTICAL_AT:
  case LSYS_TURTLE_MOVE_TO:
  case LSYS_TURTLE_HEAD_TO:
  case LSYS_TURTLE_SCALE:
  case LSYS_TURTLE_SCALE_UP:
  case LSYS_TURTLE_SCALE_DOWN:
  case LSYS_TURTLE_STEP_SCALE:
  case LSYS_TURTLE_SWAP_TURNS:
  case LSYS_TURTLE_SECOND_TURN:
  case LSYS_TURTLE_SECOND_DRAW:
  case LSYS_TURTLE_SECOND_MOVE:
  case LSYS_TURTLE_COLOUR_ADD:
  case LSYS_TURTLE_COLOUR_SUBTRACT:
  case LSYS_TURTLE_ELASTICITY:
  case LSYS_TURTLE_TROPISM_SET:
  case LSYS_TURTLE_TROPISM_UP:
  case LSYS_TURTLE_TROPISM_DOWN:
  case LSYS_TURTLE_TWIST_KEEP:
  case LSYS_TURTLE_UNTWIST:
  case LSYS_TURTLE_CIRCLE:
  case LSYS_TURTLE_LABEL:
  case LSYS_TURTLE_CYLINDER_BEGIN:
  case LSYS_TURTLE_CYLINDER_POINT:
  case LSYS_TURTLE_CYLINDER_END:
  case LSYS_TURTLE_CYLINDER_TANGENT:
  case LSYS_TURTLE_CONTOUR:
  case LSYS_TURTLE_SIDES:
  case LSYS_TURTLE_PATCH_BEGIN:
  case LSYS_TURTLE_PATCH_POINT:
  case LSYS_TURTLE_PATCH_DRAW:
    return false;
  default:
    return true;
  }
}

// Brackets and polygons close in the word, and no part stands in a polygon or behind `~`.
static const char *check_word(const LsysParts *parts, const LsysWord *word) {
  int64_t brackets = 0, polygons = 0;
  bool surface = false;
  for (uint64_t i = 0; i < word->nsym; i++) {
    uint32_t kind = symbol(parts, word, i);
    LsysTurtleOp op = (LsysTurtleOp)parts->run->grammar->kinds[kind].turtle;
    brackets += (op == LSYS_TURTLE_PUSH) - (op == LSYS_TURTLE_POP);
    polygons += (op == LSYS_TURTLE_POLYGON_BEGIN) - (op == LSYS_TURTLE_POLYGON_END);
    if (brackets < 0 || polygons < 0) return "brackets or polygons of a production do not close in it";
    if ((polygons || surface) && lsys_parts_expands(parts, kind))
      return "a polygon or surface holds modules that still change";
    surface = op == LSYS_TURTLE_SURFACE;
  }
  return brackets || polygons ? "brackets or polygons of a production do not close in it" : NULL;
}

static const char *check_kind(const LsysParts *parts, uint32_t i) {
  const LsysKind *kind = &parts->run->grammar->kinds[i];
  LsysTurtleOp op = (LsysTurtleOp)kind->turtle;
  if (!is_local(op)) return "it has symbols that depend on where the turtle stands, or on how it came there";
  bool widens = (op == LSYS_TURTLE_WIDTH || op == LSYS_TURTLE_WIDTH_UP) && !kind->arity;
  if (widens && isfinite(parts->run->value[LSYS_SETTING_WIDTH_STEP])) return "it changes line widths by an amount";
  if (!lsys_parts_expands(parts, i)) return NULL;
  if (!(kind->flags & LSYS_KIND_FIXED) || parts->run->block_levels[i] < 2)
    return "it is not deterministic, or has productions with arguments";
  if (op == LSYS_TURTLE_PUSH || op == LSYS_TURTLE_POP || op == LSYS_TURTLE_POLYGON_BEGIN
      || op == LSYS_TURTLE_POLYGON_END)
    return "brackets are rewritten";
  LsysWord word = lsys_parts_word(parts, i);
  return check_word(parts, &word);
}

static const char *check(const LsysParts *parts) {
  const LsysGrammar *g = parts->run->grammar;
  if (parts->steps == 0 || parts->steps > MOST_STEPS) return "of its number of steps";
  if (!g->expand) return "the interpreter has none";
  if (g->homomorphism) return "it has a homomorphism";
  if (!g->growth.row || !parts->run->block_levels) return "it is not deterministic";
  if (lsys_turtle_bends(parts->run)) return "a tropism bends it";
  for (uint32_t i = 0; i < g->axiom_count; i++) {
    const LsysWord *word = &g->axioms[i].word;
    if (word->narg && g->axiom) return "its start word has arguments that are computed";
    const char *why = check_word(parts, word);
    if (why) return why;
  }
  for (uint32_t i = 0; i < g->kind_count; i++) {
    const char *why = check_kind(parts, i);
    if (why) return why;
  }
  return NULL;
}

// ---- poses ---------------------------------------------------------------

LsysPose lsys_pose_origin(double width, uint8_t colour) {
  return (LsysPose){{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, width, colour};
}

static LsysVec3 direction_within(const LsysPose *outer, LsysVec3 v) {
  return vec_sum(vec_sum(outer->l, -v.x, outer->h, v.y), 1, outer->u, v.z);
}

LsysPose lsys_pose_within(const LsysPose *outer, const LsysPose *inner) {
  LsysPose pose = *inner;
  pose.at = vec_sum(outer->at, 1, direction_within(outer, inner->at), 1);
  Frame f = {direction_within(outer, inner->h), direction_within(outer, inner->l), direction_within(outer, inner->u)};
  frame_straighten(&f);
  pose.h = f.h;
  pose.l = f.l;
  pose.u = f.u;
  return pose;
}

LsysPose lsys_part_behind(const LsysPart *part, const LsysPose *from) {
  LsysPose pose = lsys_pose_within(from, &part->exit);
  if (!part->sets_width) pose.width = from->width * part->exit.width;
  if (!part->sets_colour) pose.colour = (uint8_t)(from->colour + part->exit.colour);
  return pose;
}

// ---- walking -------------------------------------------------------------

void lsys_parts_begin(const LsysParts *parts, const LsysWalk *walk) {
  lsys_turtle_begin(parts->turtle, 0, walk->to);
}

bool lsys_parts_walk(const LsysParts *parts, const LsysWord *word, uint64_t steps, LsysPose *pose,
                     const LsysWalk *walk) {
  LsysTurtle *t = parts->turtle;
  const LsysGrammar *g = parts->run->grammar;
  const uint64_t wide = g->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
  const double *arg = word->arg;
  if (!lsys_turtle_set_pose(t, pose)) return false;
  for (uint64_t i = 0; i < word->nsym; i++) {
    uint32_t kind = symbol(parts, word, i);
    if (steps && lsys_parts_expands(parts, kind)) {
      LsysPose here = lsys_turtle_pose(t), behind = lsys_part_behind(lsys_part(parts, kind, steps), &here);
      // What was drawn before the part is handed on before it.
      if (!lsys_turtle_set_pose(t, &here) || !walk->child(walk->data, kind, steps, &here)
          || !lsys_turtle_set_pose(t, &behind))
        return false;
      continue;
    }
    LsysWord one = {.sym = word->sym + i * wide, .arg = arg, .nsym = 1, .narg = g->kinds[kind].arity};
    if (!lsys_turtle_take(t, &one)) return false;
    arg += one.narg;
  }
  *pose = lsys_turtle_pose(t);
  return lsys_turtle_set_pose(t, pose);  // hands on what was drawn
}

// ---- composing -----------------------------------------------------------

// Gathers what a part draws by itself; children are added to it.
typedef struct Gather {
  LsysGeometry geometry;
  const LsysParts *parts;
  LsysPart *part;
} Gather;

static void add(const Gather *g, LsysVec3 centre, double radius) {
  lsys_support_add(&g->parts->directions, g->part->support, centre, radius);
}

static bool gather_strokes(LsysGeometry *to, const LsysStrokes *batch) {
  const Gather *g = (const Gather *)to;
  for (size_t i = 0; i < batch->points; i++) add(g, batch->point[i], 0);
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *p = batch->point + s->first;
    g->part->segments += s->count - 1;
    for (uint32_t k = 1; k < s->count; k++) g->part->length += vec_length(vec_sum(p[k], 1, p[k - 1], -1));
  }
  return true;
}

static bool gather_polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  const Gather *g = (const Gather *)to;
  (void)pen;
  for (size_t i = 0; i < count; i++) add(g, vertices[i], 0);
  g->part->polygons++;
  return true;
}

static bool gather_ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  const Gather *g = (const Gather *)to;
  (void)disc;
  (void)pen;
  add(g, *centre, diameter / 2);
  return true;
}

static bool gather_child(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  const Gather *g = data;
  const LsysPart *child = lsys_part(g->parts, kind, steps);
  g->part->segments += child->segments;
  g->part->length += child->length;
  g->part->polygons += child->polygons;
  lsys_support_add_part(&g->parts->directions, g->part->support, child->support, pose);
  return true;
}

static bool skip_child(void *data, uint32_t kind, uint64_t steps, const LsysPose *pose) {
  (void)data;
  (void)kind;
  (void)steps;
  (void)pose;
  return true;
}

// What the part does to a pen is found by walking with another one.
static bool compose(LsysParts *parts, uint32_t kind, uint64_t steps) {
  uint8_t own[2] = {(uint8_t)kind, (uint8_t)(kind >> 8)};
  LsysWord word = {.sym = own, .nsym = 1};
  if (steps) word = lsys_parts_word(parts, kind);
  uint64_t left = steps ? steps - 1 : 0;
  LsysPart *part = &parts->part[steps * parts->kinds + kind];
  lsys_support_clear(&parts->directions, part->support);
  Gather gather = {{gather_strokes, gather_polygon, NULL, gather_ball, NULL}, parts, part};
  LsysPose pose = lsys_pose_origin(1, 0), other = lsys_pose_origin(2, 1);
  LsysGeometry nothing = {0};
  const LsysWalk gathering = {&gather.geometry, gather_child, &gather}, trying = {&nothing, skip_child, NULL};
  lsys_parts_begin(parts, &gathering);
  if (!lsys_parts_walk(parts, &word, left, &pose, &gathering)) return false;
  lsys_parts_begin(parts, &trying);
  if (!lsys_parts_walk(parts, &word, left, &other, &trying)) return false;
  part->exit = pose;
  part->sets_width = other.width == pose.width;
  part->sets_colour = other.colour == pose.colour;
  return true;
}

// Steps with 0 left come first, then those that are made of them.
static bool compose_all(LsysParts *parts) {
  for (uint64_t steps = 0; steps <= parts->steps; steps++) {
    for (uint32_t kind = 0; kind < parts->kinds; kind++) {
      if (lsys_parts_expands(parts, kind) && !compose(parts, kind, steps)) return false;
    }
  }
  return true;
}

bool lsys_parts_figure(LsysParts *parts, uint32_t axiom, LsysPose *start, LsysPart *whole) {
  *whole = (LsysPart){.support = parts->whole};
  lsys_support_clear(&parts->directions, parts->whole);
  Gather gather = {{gather_strokes, gather_polygon, NULL, gather_ball, NULL}, parts, whole};
  const LsysWalk walk = {&gather.geometry, gather_child, &gather};
  lsys_parts_begin(parts, &walk);
  LsysPose pose = *start = lsys_turtle_pose(parts->turtle);
  if (!lsys_parts_walk(parts, &parts->run->grammar->axioms[axiom].word, parts->steps, &pose, &walk)) return false;
  whole->exit = pose;
  return true;
}

static bool allocate(LsysParts *parts) {
  size_t count, reals;
  if (__builtin_mul_overflow((size_t)parts->steps + 1, parts->kinds, &count)
      || __builtin_mul_overflow(count, (size_t)parts->directions.count, &reals) || count > SIZE_MAX / sizeof(LsysPart)
      || reals > MOST_REALS) {
    lsys_error("the figure has too many parts: %u kinds of modules in %" PRIu64 " steps", parts->kinds, parts->steps);
    return false;
  }
  LsysMemory *memory = parts->run->memory;
  const size_t directions = (size_t)parts->directions.count + 1;
  parts->parts = count;
  parts->part = lsys_memory_alloc(memory, count, sizeof *parts->part);
  if (parts->part) parts->support = lsys_memory_alloc(memory, reals + 1, sizeof *parts->support);
  if (parts->support) parts->directions.unit = lsys_memory_alloc(memory, directions, sizeof *parts->directions.unit);
  if (parts->directions.unit) parts->whole = lsys_memory_alloc(memory, directions, sizeof *parts->whole);
  if (!parts->whole) return false;
  for (size_t i = 0; i < count; i++) parts->part[i].support = parts->support + i * parts->directions.count;
  lsys_directions_fill(&parts->directions);
  return true;
}

const char *lsys_parts_create(LsysParts *parts, const LsysRun *run) {
  *parts = (LsysParts){.run = run, .steps = run->steps, .kinds = run->grammar->kind_count};
  const char *why = check(parts);
  if (why) return why;
  parts->turtle = lsys_turtle_create(run);
  if (!parts->turtle) return "";
  parts->directions.flat = lsys_turtle_flat(parts->turtle);
  lsys_turtle_free(parts->turtle);
  parts->directions.count = lsys_directions_needed(run->value[LSYS_SETTING_ANGLE], parts->directions.flat);
  if (!allocate(parts)) {
    lsys_parts_destroy(parts);
    return "";
  }
  if (compose_all(parts)) return NULL;
  lsys_parts_destroy(parts);
  return "";
}

void lsys_parts_destroy(LsysParts *parts) {
  lsys_turtle_destroy(parts->turtle);
  LsysMemory *memory = parts->run->memory;
  const size_t directions = (size_t)parts->directions.count + 1;
  lsys_memory_free(memory, parts->part, parts->parts, sizeof *parts->part);
  lsys_memory_free(memory, parts->support, parts->parts * parts->directions.count + 1, sizeof *parts->support);
  lsys_memory_free(memory, parts->whole, directions, sizeof *parts->whole);
  lsys_memory_free(memory, parts->directions.unit, directions, sizeof *parts->directions.unit);
  *parts = (LsysParts){0};
}
