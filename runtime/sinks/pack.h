// pack.h -- zlib streams made of pieces that know nothing of each other, on any thread.
// Source: RFC 1950 (zlib), RFC 1951 (deflate).
#ifndef LSYS_SINKS_PACK_H
#define LSYS_SINKS_PACK_H

#include "sinks/sink.h"

// In front of a packed piece of text.
typedef struct LsysPiece {
  uint32_t sum, size;  // of the text
} LsysPiece;

// A stream is LSYS_PACK_HEAD, the bytes behind the LsysPiece of every piece, and what lsys_pack_end gives.
#define LSYS_PACK_HEAD "\x78\x9c"
enum { LSYS_PACK_HEAD_SIZE = 2, LSYS_PACK_END_SIZE = 6 };

// Appends a piece to `to`; size up to INT32_MAX. False after printing that memory ran out.
bool lsys_pack(const void *text, size_t size, LsysPrepared *to);

// The sum over a stream's text: of nothing, and with one more piece.
uint32_t lsys_pack_begin(void);
uint32_t lsys_pack_add(uint32_t sum, const LsysPiece *piece);

// Writes LSYS_PACK_END_SIZE bytes.
void lsys_pack_end(uint32_t sum, uint8_t *to);

#endif
