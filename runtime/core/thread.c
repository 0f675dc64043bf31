// thread.c -- big stacks, whose pages cost memory only when a recursion reaches them.
#include "core/thread.h"

#include "core/message.h"

#include <errno.h>
#include <string.h>
#include <sys/mman.h>

enum {
  GUARD_BYTES = 1 << 16,    // below the stack: touching it ends the program, not its data
  RESERVE_BYTES = 1 << 18,  // for the sinks, which run on the same stack
  LEAST_STACK = 1 << 23,    // the interpreter does not tell how deep it goes
};

// Virtual size: a frame for each step, no more than half of the allowed memory. Without a grammar nothing is derived.
static size_t stack_size(const LsysWorker *worker) {
  const LsysGrammar *grammar = worker->run.grammar;
  uint64_t size, steps = worker->run.steps > UINT64_MAX - 64 ? UINT64_MAX : worker->run.steps + 64;
  if (__builtin_mul_overflow(steps, grammar ? (uint64_t)grammar->frame_bytes : 0, &size)) size = UINT64_MAX;
  if (size > worker->memory->limit / 2) size = worker->memory->limit / 2;
  if (size < LEAST_STACK) size = LEAST_STACK;
  return (size_t)(size & ~UINT64_C(0xffff)) + GUARD_BYTES + RESERVE_BYTES;
}

bool lsys_thread_start(LsysThread *thread, LsysWorker *worker, void *(*work)(void *), void *data) {
  size_t size = stack_size(worker);
  char *stack =
    mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
  if (stack == MAP_FAILED) {
    lsys_error("no room for a stack of %zu bytes: %s", size, strerror(errno));
    return false;
  }
  mprotect(stack, GUARD_BYTES, PROT_NONE);
  worker->stack_limit = (uintptr_t)stack + GUARD_BYTES + RESERVE_BYTES;
  worker->stack_bytes = size - GUARD_BYTES - RESERVE_BYTES;
  *thread = (LsysThread){.stack = stack, .size = size};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack + GUARD_BYTES, size - GUARD_BYTES);
  int error = pthread_create(&thread->id, &attributes, work, data);
  pthread_attr_destroy(&attributes);
  if (!error) return true;
  lsys_error("cannot start a thread: %s", strerror(error));
  munmap(stack, size);
  return false;
}

void lsys_thread_join(LsysThread *thread) {
  pthread_join(thread->id, NULL);
  munmap(thread->stack, thread->size);
}
