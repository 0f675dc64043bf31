// help.h -- what lsysc says about itself, all of it read from the tables.
#ifndef LSYSC_DRIVER_HELP_H
#define LSYSC_DRIVER_HELP_H

#include "driver/options.h"

// The few lines for someone who typed `lsysc` alone.
void help_short(FILE *out);

// The help of lsysc (COMMAND_COMPILE) or of one command.
void help_command(FILE *out, Command command);

// `lsysc help NAME`: a command, a topic such as turtle, functions, warnings, man, bash, or anything in the tables.
// False: nothing is called that, and a message said so.
bool help_topic(FILE *out, const char *name);

// The name of the i-th command or topic that `lsysc help` takes; NULL: there are no more.
const char *help_topic_name(int i);

#endif
