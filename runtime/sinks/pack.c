// pack.c -- see pack.h. A piece ends at a byte (a flush), so that the next one can follow.
#define ZLIB_CONST  // what is compressed stays as it is
#include "sinks/pack.h"

#include "core/message.h"

#include <string.h>
#include <zlib.h>

enum {
  LEVEL = 5,        // half the time of the usual 6, 2 % more bytes
  FLUSH_ROOM = 64,  // for the end of a piece
};

bool lsys_pack(const void *text, size_t size, LsysPrepared *to) {
  z_stream packer = {0};
  // Rows of pictures, too: lines repeat, which Z_FILTERED does not look for.
  if (deflateInit2(&packer, LEVEL, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    lsys_error("out of memory");
    return false;
  }
  size_t most = deflateBound(&packer, (uLong)size) + FLUSH_ROOM;
  char *at = lsys_prepared_room(to, sizeof(LsysPiece) + most);
  if (at) {
    LsysPiece piece = {(uint32_t)adler32(adler32(0, NULL, 0), text, (uInt)size), (uint32_t)size};
    memcpy(at, &piece, sizeof piece);
    packer.next_in = text;
    packer.avail_in = (uInt)size;
    packer.next_out = (Bytef *)at + sizeof piece;
    packer.avail_out = (uInt)most;
    deflate(&packer, Z_SYNC_FLUSH);
    to->used += sizeof piece + packer.total_out;
  }
  deflateEnd(&packer);
  return at;
}

uint32_t lsys_pack_begin(void) {
  return (uint32_t)adler32(0, NULL, 0);
}

uint32_t lsys_pack_add(uint32_t sum, const LsysPiece *piece) {
  return (uint32_t)adler32_combine(sum, piece->sum, (z_off_t)piece->size);
}

// An empty last piece, and the sum.
void lsys_pack_end(uint32_t sum, uint8_t *to) {
  const uint8_t end[] = {3, 0, (uint8_t)(sum >> 24), (uint8_t)(sum >> 16), (uint8_t)(sum >> 8), (uint8_t)sum};
  memcpy(to, end, sizeof end);
}
