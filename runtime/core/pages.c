// pages.c -- see pages.h. Stores past the caches are SSE2's; elsewhere memcpy does.
#include "core/pages.h"

#include <stdint.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

bool lsys_page_fresh(const void *at) {
  long size = sysconf(_SC_PAGE_SIZE);
  unsigned char held = 1;
  if (size <= 0 || mincore((void *)((uintptr_t)at & -(uintptr_t)size), (size_t)size, &held) != 0) return false;
  return !(held & 1);
}

void lsys_copy_past(void *to, const void *from, size_t bytes) {
#ifdef __SSE2__
  enum { LINE = 64, LANE = 16 };
  char *out = to;
  const char *in = from;
  size_t head = -(uintptr_t)out % LINE;
  if (bytes < head + LINE) head = bytes;
  memcpy(out, in, head);
  for (out += head, in += head, bytes -= head; bytes >= LINE; out += LINE, in += LINE, bytes -= LINE) {
    __m128i lane[LINE / LANE];
    for (int i = 0; i < LINE / LANE; i++) lane[i] = _mm_loadu_si128((const __m128i *)(const void *)(in + LANE * i));
    for (int i = 0; i < LINE / LANE; i++) _mm_stream_si128((__m128i *)(void *)(out + LANE * i), lane[i]);
  }
  _mm_sfence();
  to = out;
  from = in;
#endif
  memcpy(to, from, bytes);
}
