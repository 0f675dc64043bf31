// keys.h -- randomness as a function (LANGUAGE.md 5.8): every module carries a
// 64-bit key; children's keys and draws are pure functions of it.
// Source: SplitMix64, Steele, Lea, Flood, "Fast splittable pseudorandom number
// generators", OOPSLA 2014.
#ifndef LSYS_KEYS_H
#define LSYS_KEYS_H

#include <stdint.h>

#define LSYS_GOLDEN UINT64_C(0x9E3779B97F4A7C15)
#define LSYS_DRAW_SALT UINT64_C(0xD1B54A32D192ED03)
#define LSYS_SITE_BITS 20  // number = site + (repetition << 20) + (part << 40)
#define LSYS_PART_BITS 40
#define LSYS_VALUES_CHILD                                                                                              \
  (UINT64_C(1) << 63)  // the child of the root for #define, param, blocks; of a module for homomorphism

static inline uint64_t lsys_mix64(uint64_t z) {
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static inline uint64_t lsys_root(uint64_t seed) {
  return lsys_mix64(seed);
}

static inline uint64_t lsys_split(uint64_t key, uint64_t child) {
  return lsys_mix64(key + (child + 1) * LSYS_GOLDEN);
}

// Uniform in [0,1), a multiple of 2^-53.
static inline double lsys_draw(uint64_t key, uint64_t number) {
  return (double)(lsys_mix64(key ^ lsys_mix64(number + LSYS_DRAW_SALT)) >> 11) * 0x1p-53;
}

double lsys_ran(uint64_t key, uint64_t number, double x);
double lsys_nran(uint64_t key, uint64_t number, double mean, double deviation);
double lsys_bran(uint64_t key, uint64_t number, double a, double b);
double lsys_biran(uint64_t key, uint64_t number, double n, double p);

#endif
