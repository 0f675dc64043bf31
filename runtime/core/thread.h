// thread.h -- threads whose stack fits the depth of a derivation.
#ifndef LSYS_CORE_THREAD_H
#define LSYS_CORE_THREAD_H

#include "core/stream.h"

#include <pthread.h>

typedef struct LsysThread {
  pthread_t id;
  char *stack;
  size_t size;
} LsysThread;

// Starts work(data) on a thread of its own and enters its stack's limits into the
// worker. False after printing why not.
bool lsys_thread_start(LsysThread *thread, LsysWorker *worker, void *(*work)(void *), void *data);

// Waits for its end and releases the stack.
void lsys_thread_join(LsysThread *thread);

#endif
