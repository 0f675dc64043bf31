// message.h -- what the run time says to its user, on standard error:
//   plant: error: cannot write out.svg: No space left on device
#ifndef LSYS_CORE_MESSAGE_H
#define LSYS_CORE_MESSAGE_H

#include <stdarg.h>

// The name that messages begin with; the pointer is kept.
void lsys_message_program(const char *name);
const char *lsys_message_name(void);
void lsys_message_quiet(int quiet);

void lsys_error(const char *format, ...) __attribute__((format(printf, 1, 2)));
void lsys_verror(const char *format, va_list args);
// Say nothing after lsys_message_quiet(1).
void lsys_warning(const char *format, ...) __attribute__((format(printf, 1, 2)));
void lsys_note(const char *format, ...) __attribute__((format(printf, 1, 2)));

// An error that is kept in place of being printed.
typedef struct LsysMessage {
  char text[512];
} LsysMessage;

// From now on the first error of this thread goes there, and others nowhere; NULL: to the user. Returns where they went
// before.
LsysMessage *lsys_message_catch(LsysMessage *message);

// The candidate (of count) nearest to the misspelt word, or NULL if none is near.
const char *lsys_nearest(const char *word, const char *const *candidates, unsigned count);

#endif
