// keys.c -- the random functions of expressions: key and number -> value.
//
// Each is a pure function of the module's key and the call's number. The
// uniform numbers that it needs are the draws number + (part << 40), part = 0, 1, ...
#include "lsys/keys.h"

#include <math.h>

// The uniform numbers of one call, taken in order.
typedef struct Uniforms {
  uint64_t key, number;
} Uniforms;

static double next(Uniforms *u) {
  double value = lsys_draw(u->key, u->number);
  u->number += UINT64_C(1) << LSYS_PART_BITS;
  return value;
}

double lsys_ran(uint64_t key, uint64_t number, double x) {
  return x * lsys_draw(key, number);
}

// The cosine branch of Box and Muller, Ann. Math. Stat. 29 (1958): parts 0 and
// 1. 1 - u is in (0, 1], so that the logarithm is finite.
double lsys_nran(uint64_t key, uint64_t number, double mean, double deviation) {
  Uniforms u = {key, number};
  double radius = sqrt(-2 * log(1 - next(&u)));
  return mean + deviation * (radius * cos(2 * M_PI * next(&u)));
}

// Algorithm BA of Cheng, "Generating beta variates with nonintegral shape
// parameters", CACM 21 (1978): rejection, two parts a trial, at most 4 trials
// on average for any a and b. nan unless both are positive and finite.
double lsys_bran(uint64_t key, uint64_t number, double a, double b) {
  if (!(a > 0 && b > 0 && isfinite(a + b))) return NAN;
  Uniforms u = {key, number};
  double sum = a + b;
  double beta = fmin(a, b) <= 1 ? fmax(1 / a, 1 / b) : sqrt((sum - 2) / (2 * a * b - sum));
  double gamma = a + 1 / beta;
  for (;;) {
    double u1 = next(&u), u2 = next(&u);
    double v = beta * log(u1 / (1 - u1)), w = a * exp(v);
    double log_bw = isinf(w) ? v + log(a) : log(b + w);
    // log 4 makes the hat touch the density. Written so that a nan (0 * inf) ends the loop.
    if (!(sum * (log(sum) - log_bw) + gamma * v - log(4) < log(u1 * u1 * u2))) return isinf(w) ? 1 : w / (b + w);
  }
}

// Inversion by sequential search: one part; for small n p, where (1-p)^n does not underflow.
static double binomial_search(Uniforms *u, double n, double p) {
  double q = 1 - p, ratio = p / q, probability = exp(n * log1p(-p)), rest = next(u);
  double k = 0;
  while (rest >= probability && k < n) {
    rest -= probability;
    k++;
    probability *= ratio * (n - k + 1) / k;
    if (probability == 0) break;  // rounding left a rest that no term will take
  }
  return k;
}

static double log_factorial(double n) {
  int sign;
  return lgamma_r(n + 1, &sign);
}

// Algorithm BTRS of Hörmann, "The generation of binomial random variates",
// J. Stat. Comput. Simul. 46 (1993): transformed rejection with squeeze, two
// parts a trial; for n p >= 10 and p <= 1/2.
static double binomial_rejection(Uniforms *uniforms, double n, double p) {
  double q = 1 - p, spread = sqrt(n * p * q);
  double b = 1.15 + 2.53 * spread, a = -0.0873 + 0.0248 * b + 0.01 * p, c = n * p + 0.5;
  double v_r = 0.92 - 4.2 / b, alpha = (2.83 + 5.1 / b) * spread, log_odds = log(p / q);
  double mode = floor((n + 1) * p), at_mode = log_factorial(mode) + log_factorial(n - mode);
  for (;;) {
    double u = next(uniforms) - 0.5, v = next(uniforms);
    double us = 0.5 - fabs(u), k = floor((2 * a / us + b) * u + c);
    if (k < 0 || k > n) continue;
    if (us >= 0.07 && v <= v_r) return k;
    double scaled = log(v * alpha / (a / (us * us) + b));
    if (scaled <= at_mode - log_factorial(k) - log_factorial(n - k) + (k - mode) * log_odds) return k;
  }
}

// Successes of floor(n) trials. nan unless n >= 0 is finite and p is in [0, 1].
double lsys_biran(uint64_t key, uint64_t number, double n, double p) {
  if (!(n >= 0 && isfinite(n) && p >= 0 && p <= 1)) return NAN;
  n = floor(n);
  if (p == 0 || n == 0) return 0;
  if (p == 1) return n;
  Uniforms u = {key, number};
  double rarer = fmin(p, 1 - p);
  double k = n * rarer < 10 ? binomial_search(&u, n, rarer) : binomial_rejection(&u, n, rarer);
  return rarer < p ? n - k : k;
}
