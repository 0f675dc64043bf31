// press.h -- turns what is drawn into bytes of a file: blocks of it are collected in the order of the word, made into
// bytes by whatever thread is free, and written in their order and in bounded memory. On one thread the same blocks
// are made here, so that the bytes do not depend on the number of threads.
#ifndef LSYS_SINKS_PRESS_H
#define LSYS_SINKS_PRESS_H

#include "core/memory.h"
#include "sinks/sink.h"

typedef struct LsysPress LsysPress;

// Appends the bytes of a block of `size` bytes to `to`, on any thread: data is only read, and nothing is known of other
// blocks. False after printing why not.
typedef bool LsysPressWork(const void *data, const void *block, size_t size, LsysPrepared *to);

// Writes what was made of the next block, on this thread. False after printing why not.
typedef bool LsysPressWrite(void *data, const LsysPrepared *bytes);

// threads: that may work, this one included. NULL after printing why not.
LsysPress *lsys_press_open(LsysMemory *memory, unsigned threads, LsysPressWork *work, LsysPressWrite *write,
                           void *data);

// Room for size more bytes, a multiple of 8, in the block that is being collected; it may move until the next call.
// NULL after printing that memory ran out.
void *lsys_press_add(LsysPress *press, size_t size);

// The block is complete, if there is anything in it. False to stop, after printing why.
bool lsys_press_send(LsysPress *press);

// Sends the last block and waits until everything is written.
bool lsys_press_finish(LsysPress *press);

// Stops the others; what is not written never will be. NULL is fine.
void lsys_press_close(LsysPress *press);

#endif
