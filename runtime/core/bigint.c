// bigint.c -- schoolbook arithmetic on 64-bit limbs.
#include "core/bigint.h"

#include <string.h>

#define TEN_TO_19 UINT64_C(10000000000000000000)

enum { DIGITS = 19 };  // of a limb's worth of decimals

static bool reserve(LsysMemory *memory, LsysBig *a, size_t count) {
  while (a->capacity < count) {
    void *grown = lsys_memory_grow(memory, a->limb, &a->capacity, sizeof *a->limb);
    if (!grown) return false;
    a->limb = grown;
  }
  return true;
}

bool lsys_big_add_product(LsysMemory *memory, LsysBig *to, const LsysBig *a, uint64_t factor) {
  size_t count = (to->count > a->count ? to->count : a->count) + 1;
  if (!reserve(memory, to, count)) return false;
  memset(to->limb + to->count, 0, (count - to->count) * sizeof *to->limb);
  uint64_t carry = 0;
  for (size_t i = 0; i < count && (i < a->count || carry); i++) {
    unsigned __int128 sum = (unsigned __int128)to->limb[i] + carry;
    if (i < a->count) sum += (unsigned __int128)a->limb[i] * factor;
    to->limb[i] = (uint64_t)sum;
    carry = (uint64_t)(sum >> 64);
  }
  while (count && !to->limb[count - 1]) count--;
  to->count = count;
  return true;
}

void lsys_big_clear(LsysBig *a) {
  a->count = 0;
}

void lsys_big_free(LsysMemory *memory, LsysBig *a) {
  lsys_memory_free(memory, a->limb, a->capacity, sizeof *a->limb);
  *a = (LsysBig){0};
}

// a /= 10^19; returns the rest.
static uint64_t divide(LsysBig *a) {
  unsigned __int128 rest = 0;
  for (size_t i = a->count; i-- > 0;) {
    rest = rest << 64 | a->limb[i];
    a->limb[i] = (uint64_t)(rest / TEN_TO_19);
    rest %= TEN_TO_19;
  }
  while (a->count && !a->limb[a->count - 1]) a->count--;
  return (uint64_t)rest;
}

char *lsys_big_decimal(LsysMemory *memory, LsysBig *a, size_t *size) {
  *size = (a->count + 1) * (DIGITS + 2);  // 2^64 has 20 digits
  char *text = lsys_memory_alloc(memory, *size, 1);
  if (!text) return NULL;
  char *at = text + *size - 1;  // behind the digits; the last byte stays zero
  while (a->count) {
    uint64_t digits = divide(a);
    for (int i = 0; i < DIGITS; i++, digits /= 10) *--at = (char)('0' + digits % 10);
  }
  while (*at == '0') at++;
  if (!*at) *--at = '0';
  memmove(text, at, strlen(at) + 1);
  return text;
}
