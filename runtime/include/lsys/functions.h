// functions.h -- the functions of expressions: their enumeration, and the run-time
// functions that every engine calls, so that all give the same bits.
#ifndef LSYS_FUNCTIONS_H
#define LSYS_FUNCTIONS_H

#include <stdint.h>

typedef enum LsysFunction {
#define FUNCTION(id, name, arguments, least, most, how, doc) LSYS_FN_##id,
#include "lsys/functions.def"
  LSYS_FN_COUNT
} LsysFunction;

typedef enum LsysFunctionHow { LSYS_FN_PURE, LSYS_FN_RANDOM, LSYS_FN_EFFECT, LSYS_FN_FILE } LsysFunctionHow;

typedef struct LsysFunctionInfo {
  const char *name, *arguments;
  int least, most;
  LsysFunctionHow how;
  const char *doc;
} LsysFunctionInfo;

extern const LsysFunctionInfo lsys_functions[LSYS_FN_COUNT];

// Angles in degrees. None traps or sets errno; nan in gives nan out.
double lsys_sin(double x);
double lsys_cos(double x);
double lsys_tan(double x);
double lsys_asin(double x);
double lsys_acos(double x);
double lsys_atan(double x);
double lsys_atan2(double y, double x);
double lsys_sqrt(double x);
double lsys_exp(double x);
double lsys_log(double x);
double lsys_pow(double x, double y);  // libm's pow but for y = 1, 2, 3, 0.5: x, x*x, x*x*x, sqrt(x)
double lsys_fabs(double x);
double lsys_abs(double x);
double lsys_floor(double x);
double lsys_ceil(double x);
double lsys_trunc(double x);
double lsys_round(double x);
double lsys_sign(double x);
double lsys_mod(double x, double y);  // the operator %
double lsys_min(double x, double y);  // nan if either is nan
double lsys_max(double x, double y);

#endif
