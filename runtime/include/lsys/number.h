// number.h -- numbers as text: the shortest digits that read back to the same double.
#ifndef LSYS_NUMBER_H
#define LSYS_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LSYS_NUMBER_SIZE = 48 };  // room that lsys_number_print and lsys_number_round need, twice the longest text

// Writes x as LANGUAGE.md section 9 asks: shortest digits laid out as %.17g would, "nan", "inf", "-inf".
// Returns the end; writes no terminating zero.
char *lsys_number_print(char *to, double x);

// Writes x with at most that many digits, 1 to 9, as %.{digits}g of printf does. Same return.
char *lsys_number_round(char *to, double x, int digits);

// Whether all are the same: bit for bit, but that any nan is the same as another.
bool lsys_numbers_same(const double *a, const double *b, size_t count);

// Writes n in decimal; at most 20 characters.
char *lsys_whole_print(char *to, uint64_t n);

#endif
