// manual.h -- the manual page and the shells' completions, made from options.def.
#ifndef LSYSC_DRIVER_MANUAL_H
#define LSYSC_DRIVER_MANUAL_H

#include "driver/options.h"

void manual_page(FILE *out);
void manual_bash(FILE *out);
void manual_zsh(FILE *out);
void manual_fish(FILE *out);

#endif
