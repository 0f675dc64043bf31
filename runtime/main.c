// main.c -- `main` of a compiled program. An object of its own in the archive:
// a program that brings its own main never pulls it in.
#include "lsys/abi.h"

extern const LsysGrammar lsys_grammar;

int main(int argc, char **argv) {
  return lsys_main(&lsys_grammar, argc, argv);
}
