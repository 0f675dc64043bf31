// out.h -- where results are written: a file that appears under its name only
// when it is complete, or standard output.
#ifndef LSYS_CORE_OUT_H
#define LSYS_CORE_OUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct LsysOut LsysOut;

// Opens path ("-": standard output). A file is written as a temporary one in
// the same folder, which SIGINT, SIGTERM and lsys_out_abandon remove. An existing
// path that is no regular file (/dev/null, a pipe) is written directly.
// NULL after printing why.
LsysOut *lsys_out_open(const char *path);

// Appends bytes. The first failure (full disk, closed pipe) is remembered;
// later calls do nothing. True while all is well.
bool lsys_out_write(LsysOut *out, const void *bytes, size_t size);
bool lsys_out_print(LsysOut *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

// Room of at least size bytes to fill in place; lsys_out_filled tells how many were. size <= 64 KiB.
char *lsys_out_room(LsysOut *out, size_t size);
void lsys_out_filled(LsysOut *out, size_t size);

// Overwrites bytes written earlier: possible only where lsys_out_seekable is true.
bool lsys_out_seekable(const LsysOut *out);
bool lsys_out_patch(LsysOut *out, uint64_t at, const void *bytes, size_t size);
uint64_t lsys_out_size(const LsysOut *out);

// Flushes, moves the file to its name and closes. False after printing why it failed (and removing the file).
bool lsys_out_commit(LsysOut *out);
void lsys_out_abandon(LsysOut *out);

#endif
