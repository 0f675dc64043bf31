// check_families.c -- productions that compete for the same modules: weights
// that do not add up, and productions that an earlier one always precedes.
//
// Two productions *hold together* if their predecessors, literals and guards
// are the same: whenever one holds, so does the other (a guard that draws is
// the same as itself only). An earlier production also precedes a later one if
// it asks for less: no guard, and contexts that are the near part of the
// later's contexts.
#include "frontend/check.h"

#include <math.h>

// ---- shapes -------------------------------------------------------------------------

// The part of a production's condition that is compared: the last `left`
// modules of its left context, the first `strict` and `right` ones of the
// strict predecessor and the right context, and perhaps its tests.
typedef struct Shape {
  size_t left, strict, right;
  bool tests;
  int32_t table;
} Shape;

typedef struct Family {
  VEC(const Production *) members;
  size_t total;  // over all families of that predecessor and table
} Family;

// All weights of a predecessor in a table, and how many families they belong to.
typedef struct Total {
  double sum;
  size_t families;
} Total;

typedef struct Families {
  Check *check;
  Map *unweighted, *weighted;  // shape -> the first production of it
  Map *competing;              // predecessor's kind -> the first production with a weight
  Map *family;                 // shape -> families
  VEC(Family) list;
  Map *sums;  // predecessor and table -> totals
  VEC(Total) totals;
  const Productions *productions;
} Families;

static uint64_t mixed(uint64_t hash, uint64_t with) {
  hash = (hash ^ with) * UINT64_C(0xBF58476D1CE4E5B9);
  return hash ^ (hash >> 31);
}

static uint64_t patterns_hash(const Pattern *patterns, size_t count) {
  uint64_t hash = count + 1;
  for (size_t i = 0; i < count; i++) hash = mixed(mixed(hash, patterns[i].kind), (uint64_t)patterns[i].what);
  return hash;
}

static const Pattern *near_left(const Production *p, size_t count) {
  return p->left.at + (p->left.count - count);
}

// A guard that is always true asks for nothing.
static const Expr *guard_of(const Production *p) {
  double value;
  return p->guard && expr_literal(p->guard, &value) && lsys_holds(value) ? NULL : p->guard;
}

static uint64_t shape_hash(const Production *p, Shape shape) {
  uint64_t hash = mixed(patterns_hash(near_left(p, shape.left), shape.left), (uint64_t)(uint32_t)shape.table);
  hash = mixed(hash, patterns_hash(p->strict.at, shape.strict));
  hash = mixed(hash, patterns_hash(p->right.at, shape.right));
  return shape.tests ? mixed(mixed(hash, expr_hash(p->match)), expr_hash(guard_of(p))) : hash;
}

static bool patterns_equal(const Pattern *a, const Pattern *b, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (a[i].kind != b[i].kind || a[i].what != b[i].what) return false;
  return true;
}

static bool same_tests(const Program *program, const Production *p, const Production *q) {
  if (!expr_equal(p->match, q->match)) return false;
  return p == q || (expr_equal(guard_of(p), guard_of(q)) && !expr_draws(program, p->guard));
}

// Is `shape` of p all that q asks for?
static bool shape_is(const Program *program, const Production *p, Shape shape, const Production *q) {
  if (q->left.count != shape.left || q->strict.count != shape.strict || q->right.count != shape.right) return false;
  return patterns_equal(near_left(p, shape.left), q->left.at, shape.left)
      && patterns_equal(p->strict.at, q->strict.at, shape.strict)
      && patterns_equal(p->right.at, q->right.at, shape.right)
      && (shape.tests ? same_tests(program, p, q) : !q->match && !guard_of(q));
}

static Shape whole_shape(const Production *p) {
  return (Shape){p->left.count, p->strict.count, p->right.count, p->match || guard_of(p), p->table};
}

// ---- unreachable productions -------------------------------------------------------------

static bool only_modules(const Context *context) {
  for (size_t i = 0; i < context->count; i++)
    if (context->at[i].what != PATTERN_MODULE) return false;
  return true;
}

static const Production *first_of(const Families *families, const Map *map, const Production *p, Shape shape) {
  uint32_t index = map_find(map, NULL, shape_hash(p, shape));
  const Production *first = index == MAP_NONE ? NULL : families->productions->at[index];
  return first && shape_is(families->check->program, p, shape, first) ? first : NULL;
}

// The production that is taken, or chosen among its like, wherever p of that
// shape could be. Once a production with a weight holds, those without are
// passed over: they do not precede a p that competes with an earlier one.
static const Production *taken_before(const Families *families, const Production *p, Shape shape) {
  const Production *found = first_of(families, families->unweighted, p, shape);
  if (!p->weight) return found ? found : first_of(families, families->weighted, p, shape);
  uint32_t competing = map_find(families->competing, NULL, p->strict.at[0].kind);
  return competing == MAP_NONE || (found && families->productions->at[competing]->number > found->number) ? found
                                                                                                          : NULL;
}

static const Production *preceding_in(const Families *families, const Production *p, int32_t table) {
  enum { LONGEST = 8 };  // longer contexts are compared whole only
  Shape shape = whole_shape(p);
  shape.table = table;
  bool guard_changes = p->before.count && p->guard;  // what is assigned before may decide
  const Production *found = guard_changes ? NULL : taken_before(families, p, shape);
  shape.tests = false;
  size_t strict = p->strict.count < LONGEST ? p->strict.count : LONGEST;
  size_t left = only_modules(&p->left) && p->left.count < LONGEST ? p->left.count : 0;
  size_t right = only_modules(&p->right) && p->right.count < LONGEST ? p->right.count : 0;
  for (shape.strict = 1; !found && shape.strict <= strict; shape.strict++)
    for (shape.left = 0; !found && shape.left <= left; shape.left++)
      for (shape.right = 0; !found && shape.right <= (shape.strict == p->strict.count ? right : 0); shape.right++)
        found = taken_before(families, p, shape);
  return found;
}

static void warn_unreachable(const Families *families, const Production *p) {
  const Production *earlier = preceding_in(families, p, -1);
  if (!earlier && p->table >= 0) earlier = preceding_in(families, p, p->table);
  if (!earlier) return;
  Diag *diag = families->check->diag;
  diag_warning(diag, WARN_UNREACHABLE, p->head,
               "this production never applies: an earlier one is always taken before it");
  diag_note(diag, earlier->head, "this one holds whenever the other does");
  if (earlier->weight && !p->weight)
    diag_hint(diag, "a production without weight is not part of the random choice; give it one behind `:`");
}

static void remember(const Families *families, const Production *p, uint32_t index) {
  uint32_t *competing = map_place(families->competing, NULL, p->strict.at[0].kind);
  if (p->weight && *competing == MAP_NONE) *competing = index;
  if (p->before.count && p->guard) return;
  Map *map = p->weight ? families->weighted : families->unweighted;
  uint32_t *place = map_place(map, NULL, shape_hash(p, whole_shape(p)));
  if (*place == MAP_NONE) *place = index;
}

// ---- weights --------------------------------------------------------------------------------

static bool adds_up(double sum) {
  return fabs(sum - 1) <= 1e-9 || fabs(sum - 100) <= 1e-9;
}

static size_t total_of(Families *families, const Production *p) {
  uint64_t key = mixed(patterns_hash(p->strict.at, p->strict.count), (uint64_t)(uint32_t)p->table);
  uint32_t *place = map_place(families->sums, NULL, key);
  if (*place == MAP_NONE) {
    *place = (uint32_t)families->totals.count;
    *VEC_PUSH(families->check->arena, &families->totals) = (Total){0};
  }
  return *place;
}

static void join_family(Families *families, const Production *p) {
  double weight;
  Shape shape = whole_shape(p);
  uint32_t *place = map_place(families->family, NULL, shape_hash(p, shape));
  if (*place == MAP_NONE) {
    *place = (uint32_t)families->list.count;
    *VEC_PUSH(families->check->arena, &families->list) = (Family){.total = total_of(families, p)};
    families->totals.at[families->list.at[*place].total].families++;
  }
  Family *family = &families->list.at[*place];
  if (family->members.count && !shape_is(families->check->program, p, shape, family->members.at[0])) return;
  *VEC_PUSH(families->check->arena, &family->members) = p;
  bool known = expr_constant(families->check->program, p->weight, &weight);
  families->totals.at[family->total].sum += known ? weight : NAN;
}

static void warn_sum(const Families *families, const Family *family, double sum) {
  enum { MOST_NOTES = 8 };
  Diag *diag = families->check->diag;
  const Production *first = family->members.at[0];
  if (family->members.count == 1) {
    diag_warning(diag, WARN_WEIGHTS, first->weight->span,
                 "no other production competes with this one, so it is always taken, whatever its weight of %g", sum);
    diag_hint(
      diag, "weights are relative; for nothing to happen at times add a production that replaces the module by itself");
    return;
  }
  diag_warning(diag, WARN_WEIGHTS, first->weight->span, "these weights sum to %.10g, not to 1 or 100", sum);
  for (size_t i = 1; i < family->members.count && i <= MOST_NOTES; i++)
    diag_note(diag, family->members.at[i]->weight->span, "%s", i == 1 ? "together with this one" : "and this one");
  diag_hint(diag, "weights are relative: each is divided by the sum of those that hold");
}

static void check_sum(const Families *families, const Family *family) {
  double sum = 0;
  bool whole = true;
  for (size_t i = 0; i < family->members.count; i++) {
    double weight;
    if (!expr_constant(families->check->program, family->members.at[i]->weight, &weight)) return;
    if (!(weight > 0)) return;  // said already
    sum += weight;
    whole &= weight == trunc(weight);
  }
  // Where others compete under other conditions, all of them may be meant to add up, or a single one to be an extra.
  const Total *total = &families->totals.at[family->total];
  bool extra = total->families > 1 && family->members.count == 1;
  if (!whole && !extra && !adds_up(sum) && !adds_up(total->sum)) warn_sum(families, family, sum);
}

// ---- all ---------------------------------------------------------------------------------------

static void check_productions(Check *check, const Productions *productions) {
  Arena *arena = check->arena;
  Families families = {.check = check, .productions = productions};
  families.unweighted = map_create(arena);
  families.weighted = map_create(arena);
  families.competing = map_create(arena);
  families.family = map_create(arena);
  families.sums = map_create(arena);
  for (uint32_t i = 0; i < productions->count; i++) {
    const Production *p = productions->at[i];
    warn_unreachable(&families, p);
    remember(&families, p, i);
    if (p->weight) join_family(&families, p);
  }
  for (size_t i = 0; i < families.list.count; i++) check_sum(&families, &families.list.at[i]);
}

void check_families(Check *check) {
  for (size_t i = 0; i < check->program->lsystem_count; i++) {
    const LSystem *lsystem = &check->program->lsystems[i];
    check_productions(check, &lsystem->productions);
    check_productions(check, &lsystem->decomposition.productions);
    check_productions(check, &lsystem->homomorphism.productions);
  }
}
