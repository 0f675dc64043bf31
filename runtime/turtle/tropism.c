// tropism.c -- what bends the turtle while it moves.
//
// The tropism of the settings bends it behind each move, as in ABOP. Numbered tropisms
// act together before each move, as cpfg's do: the heading bends towards the
// sum of their vectors, each times its elasticity, and then the turtle is
// rolled: to where it stood at its last line, but for the turns since (cpfg
// has no other twist than the wanted), and on by what torques want.
// Sources: ABOP p. 58; cpfg's manual (tropism:, torque:, @T).
#include "core/message.h"
#include "turtle/actions.h"

#include <string.h>

enum { TROPISM_OF_SETTINGS = 1 };  // its number where there are no numbered ones

static const double LEAST = 1e-6;  // rotations by less than so many radians are none, as in cpfg

// Turns the frame about a unit axis.
static Frame frame_about(Frame f, LsysVec3 axis, double angle) {
  double c = cos(angle), s = sin(angle);
  f = (Frame){vec_about(f.h, axis, c, s), vec_about(f.l, axis, c, s), vec_about(f.u, axis, c, s)};
  frame_straighten(&f);
  return f;
}

// Bends the frame towards the tropism by e |H x T| radians (ABOP p. 58), never beyond it.
void turtle_bend(LsysTurtle *t) {
  Frame *f = &t->state.frame;
  LsysVec3 axis = vec_cross(f->h, t->tropism);
  double sine = vec_length(axis), angle = t->state.elasticity * sine;
  if (t->flat || !(fabs(angle) > 1e-15)) return;
  double most = angle > 0 ? atan2(sine, vec_dot(f->h, t->tropism)) : atan2(sine, -vec_dot(f->h, t->tropism));
  angle = copysign(fmin(fabs(angle), most), angle);
  *f = frame_about(*f, vec_scale(axis, 1 / sine), angle);
}

// ---- numbered tropisms -----------------------------------------------------

// Where a tropism of an angle pulls: to the heading nearest to H that has this angle to its vector. Along the vector
// itself all are as near: cpfg takes the one at right angles to L.
static LsysVec3 pull(const Tropism *p, const Frame *f) {
  LsysVec3 towards = vec_scale(p->towards, p->cosine);
  if (p->sine == 0) return towards;
  LsysVec3 across = vec_cross(f->h, p->towards);
  across = vec_length(across) < 1e-7 ? f->l : vec_unit(across);
  return vec_sum(towards, 1, vec_cross(p->towards, across), p->sine);
}

// The sum of the vectors of one sort.
static LsysVec3 sum(const LsysTurtle *t, bool torques) {
  LsysVec3 all = {0, 0, 0};
  for (uint32_t i = 0; i < t->tropisms; i++) {
    const Tropism *p = &t->numbered[i];
    double elasticity = t->state.elasticities[i];
    if (p->torque != torques || elasticity == 0) continue;
    all = vec_sum(all, 1, torques ? p->towards : pull(p, &t->state.frame), elasticity);
  }
  return all;
}

// Brings the frame that was kept to the heading of now by the shortest rotation.
static void untwist(LsysTurtle *t) {
  const Frame *kept = &t->state.kept;
  LsysVec3 h = t->state.frame.h, axis = vec_cross(kept->h, h);
  double sine = vec_length(axis);
  if (sine <= LEAST) return;
  Frame f = frame_about(*kept, vec_scale(axis, 1 / sine), atan2(sine, vec_dot(kept->h, h)));
  f.h = h;
  frame_straighten(&f);
  t->state.frame = f;
}

// Rolls -U, cpfg's up vector, towards a vector.
static void roll_to(LsysTurtle *t, LsysVec3 towards) {
  Frame *f = &t->state.frame;
  LsysVec3 want = vec_sum(towards, 1, f->h, -vec_dot(towards, f->h));
  if (vec_length(want) <= 1e-4 * vec_length(towards)) return;
  double angle = vec_dot(vec_cross(want, f->u), f->h);
  if (fabs(angle) > LEAST / 10) *f = frame_about(*f, f->h, copysign(fmin(fabs(angle), 1), angle));
  t->state.kept = *f;
}

void turtle_lean(LsysTurtle *t) {
  if (!t->tropisms) return;
  Frame *f = &t->state.frame;
  LsysVec3 towards = sum(t, false), axis = vec_cross(f->h, towards);
  double sine = vec_length(axis), angle = fmin(fmin(sine, 1), atan2(sine, vec_dot(f->h, towards)));
  if (angle >= LEAST) {
    *f = frame_about(*f, vec_scale(axis, 1 / sine), angle);
    untwist(t);
  }
  towards = sum(t, true);
  if (vec_length(towards) > 0) roll_to(t, towards);
}

// ---- modules ---------------------------------------------------------------

bool act_elasticity(LsysTurtle *t, int given, const double *arg) {
  t->state.elasticity = given ? arg[0] : t->state.elasticity + t->elasticity_step;
  return true;
}

// The elasticity of the tropism that the module names, and its increment; NULL: there is none.
static double *elasticity_of(LsysTurtle *t, int given, const double *arg, double *step) {
  double number = given ? arg[0] : 1;
  *step = t->elasticity_step;
  if (!t->tropisms && number == TROPISM_OF_SETTINGS) return &t->state.elasticity;
  if (number >= 1 && number < (double)t->tropisms + 1) {
    uint32_t i = (uint32_t)number - 1;
    *step = t->numbered[i].step;
    return &t->state.elasticities[i];
  }
  turtle_warn(t, WARN_TROPISM, t->read, "there is no tropism of this number: the module is left out");
  return NULL;
}

static bool add_elasticity(LsysTurtle *t, int given, const double *arg, double sign) {
  double step, *elasticity = elasticity_of(t, given, arg, &step);
  if (elasticity) *elasticity += sign * (given > 1 ? arg[1] : step);
  return true;
}

bool act_tropism_set(LsysTurtle *t, int given, const double *arg) {
  double step, *elasticity = elasticity_of(t, given, arg, &step);
  if (elasticity) *elasticity = given > 1 ? arg[1] : 0;
  return true;
}

bool act_tropism_up(LsysTurtle *t, int given, const double *arg) {
  return add_elasticity(t, given, arg, 1);
}

bool act_tropism_down(LsysTurtle *t, int given, const double *arg) {
  return add_elasticity(t, given, arg, -1);
}

bool act_twist_keep(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  t->state.kept = t->state.frame;
  return true;
}

bool act_untwist(LsysTurtle *t, int given, const double *arg) {
  (void)given;
  (void)arg;
  untwist(t);
  return true;
}

// ---- set-up ----------------------------------------------------------------

static double value_of(const LsysRun *run, uint32_t number, LsysSetting of_first) {
  return turtle_setting(run, (LsysSetting)((uint32_t)of_first + number * LSYS_TROPISM_SETTINGS));
}

// Is it in effect in the page alone?
static bool stays_in_page(const Tropism *p) {
  return p->towards.z == 0 && p->sine == 0 && !p->torque;
}

bool turtle_set_tropisms(LsysTurtle *t, const LsysRun *run, double *elasticities) {
  bool in_page = true;
  for (uint32_t i = 0; i < LSYS_TROPISMS; i++) {
    Tropism *p = &t->numbered[i];
    double angle = value_of(run, i, LSYS_SETTING_TROPISM_1_ANGLE);
    *p = (Tropism){.towards = {value_of(run, i, LSYS_SETTING_TROPISM_1_X), value_of(run, i, LSYS_SETTING_TROPISM_1_Y),
                               value_of(run, i, LSYS_SETTING_TROPISM_1_Z)},
                   .cosine = lsys_cos(angle),
                   .sine = lsys_sin(angle),
                   .step = value_of(run, i, LSYS_SETTING_TROPISM_1_STEP),
                   .torque = value_of(run, i, LSYS_SETTING_TROPISM_1_TORQUE) != 0};
    elasticities[i] = value_of(run, i, LSYS_SETTING_TROPISM_1_ELASTICITY);
    if (!(vec_reach(p->towards) > 0)) continue;
    t->tropisms = i + 1;
    in_page &= stays_in_page(p);
  }
  return in_page;
}

bool lsys_turtle_bends(const LsysRun *run) {
  bool bends = run->value[LSYS_SETTING_ELASTICITY] != 0;
  for (uint32_t i = 0; i < LSYS_TROPISMS; i++)
    bends |= run->value[LSYS_SETTING_TROPISM_1_ELASTICITY + i * LSYS_TROPISM_SETTINGS] != 0;
  return bends;
}
