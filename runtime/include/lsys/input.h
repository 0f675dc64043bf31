// input.h -- opening the files that a grammar names.
#ifndef LSYS_INPUT_H
#define LSYS_INPUT_H

#include <stdio.h>

// A file to be read. Directories and what may never end (devices, FIFOs) are refused: NULL with a phrase such as "is a
// directory" in *why.
FILE *lsys_input_open(const char *path, const char **why);

#endif
