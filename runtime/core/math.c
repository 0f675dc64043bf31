// math.c -- the functions of expressions (LANGUAGE.md section 4), angles in degrees.
//
// Every engine calls these very functions, so that all give the same bits.
// Source of the angles: x is reduced modulo 360 exactly (fmod is exact), then
// the values that are 0, 1/2 or 1 are given exactly, all others are libm's.
#include "lsys/functions.h"

#include <math.h>

// sin(30 * i) for i = 0..11; nan where the value is irrational.
static const double thirties[12] = {0, 0.5, NAN, 1, NAN, 0.5, 0, -0.5, NAN, -1, NAN, -0.5};

// The exact sine of r degrees moved on by turn * 30 degrees, or nan.
static double exact(double r, int turn) {
  double i = r / 30;
  if (i != floor(i)) return NAN;
  int at = ((int)i + turn) % 12;
  return thirties[at < 0 ? at + 12 : at];
}

static double radians(double r) {
  return r * M_PI / 180;
}

static double degrees(double r) {
  return r * 180 / M_PI;
}

double lsys_sin(double x) {
  double r = fmod(x, 360), value = exact(r, 0);
  return isnan(value) ? sin(radians(r)) : value;
}

double lsys_cos(double x) {
  double r = fmod(x, 360), value = exact(r, 3);
  return isnan(value) ? cos(radians(r)) : value;
}

// Infinite at odd multiples of 90, with the sign of the sine there.
double lsys_tan(double x) {
  double r = fmod(x, 360);
  if (fmod(r, 90) != 0) return tan(radians(r));
  double s = exact(r, 0), c = exact(r, 3);
  return c == 0 ? s / fabs(c) : 0;
}

double lsys_asin(double x) {
  return fabs(x) == 0.5 ? 60 * x : degrees(asin(x));
}

double lsys_acos(double x) {
  return fabs(x) == 0.5 ? 90 - 60 * x : degrees(acos(x));
}

double lsys_atan(double x) {
  return degrees(atan(x));
}

double lsys_atan2(double y, double x) {
  return degrees(atan2(y, x));
}

double lsys_sqrt(double x) {
  return sqrt(x);
}

double lsys_exp(double x) {
  return exp(x);
}

double lsys_log(double x) {
  return log(x);
}

double lsys_pow(double x, double y) {
  if (y == 1) return x;
  if (y == 2) return x * x;
  if (y == 3) return x * x * x;
  if (y == 0.5) return sqrt(x);
  return pow(x, y);
}

double lsys_fabs(double x) {
  return fabs(x);
}

double lsys_abs(double x) {
  return fabs(x);
}

double lsys_floor(double x) {
  return floor(x);
}

double lsys_ceil(double x) {
  return ceil(x);
}

double lsys_trunc(double x) {
  return trunc(x);
}

double lsys_round(double x) {
  return round(x);
}

double lsys_sign(double x) {
  return x < 0 ? -1 : x > 0 ? 1 : isnan(x) ? x : 0;
}

double lsys_mod(double x, double y) {
  return fmod(x, y);
}

double lsys_min(double x, double y) {
  if (isnan(x)) return x;
  return isnan(y) || y < x ? y : x;
}

double lsys_max(double x, double y) {
  if (isnan(x)) return x;
  return isnan(y) || y > x ? y : x;
}
