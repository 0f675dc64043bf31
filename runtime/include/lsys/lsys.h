// lsys.h -- a compiled grammar inside of a program of one's own, in C or C++.
//
//   lsysc -c plant.lsys                                       makes plant.o
//   cc $(pkg-config --cflags lsysrt) mine.c plant.o $(pkg-config --libs lsysrt)
//
//   #include <lsys/lsys.h>
//   #include <stdio.h>
//
//   extern const LsysGrammar lsys_grammar;                    // what plant.o holds
//
//   static bool count(void *data, uint32_t axiom, const LsysWord *part) {
//     *(uint64_t *)data += part->nsym;
//     return true;
//   }
//
//   int main(void) {
//     static const char *const options[] = {"-n", "8", "--seed", "3", NULL};
//     uint64_t modules = 0;
//     if (!lsys_derive(&lsys_grammar, options, count, &modules)) return 1;
//     printf("%llu modules\n", (unsigned long long)modules);
//   }
//
// lsys_derive_word gives the word in one piece, in memory that is used again from call to call.
//
// abi.h says how a word is packed, and what lsys_grammar tells of its kinds.
#ifndef LSYS_LSYS_H
#define LSYS_LSYS_H

#ifdef __cplusplus
extern "C" {
#endif

#include "lsys/abi.h"

#include <stdbool.h>

// Gets the derived word part by part, in order, on one thread (not the caller's). The part is gone when
// it returns. False stops the derivation.
typedef bool LsysReceive(void *data, uint32_t axiom, const LsysWord *part);

// Derives the grammar's start words as its program would. options are those of
// its command line, up to a NULL; the word is printed only if they ask for it.
// False after printing on standard error what is wrong, or when receive stopped it.
bool lsys_derive(const LsysGrammar *grammar, const char *const *options, LsysReceive *receive, void *data);

// A word in one piece: nsym modules and narg arguments in arrays of so many bytes.
typedef struct LsysWhole {
  uint8_t *sym;
  double *arg;
  size_t sym_bytes, arg_bytes;
  uint64_t nsym, narg;
  bool given;  // the arrays are yours: they do not grow, and a longer word is an error
} LsysWhole;

// Derives a start word (the only one, or the option --axiom's) into `whole`: zeroed, or as an earlier call left it, or
// with arrays of your own. The engine writes there without another copy where one thread derives (--threads 1). False
// as lsys_derive; then nsym and narg say nothing.
bool lsys_derive_word(const LsysGrammar *grammar, const char *const *options, LsysWhole *whole);

// Frees the arrays, unless they were given.
void lsys_whole_free(LsysWhole *whole);

#ifdef __cplusplus
}
#endif

#endif
