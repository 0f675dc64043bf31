// program.c -- see program.h.
#include "program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

Program program_of(const LsysGrammar *grammar) {
  return (Program){.grammar = grammar, .argv = {(char *)"bench"}, .argc = 1};
}

void program_add(Program *program, const char *argument) {
  if (program->argc == MOST_ARGUMENTS) {
    fputs("bench: a row has too many arguments\n", stderr);
    exit(1);
  }
  program->argv[program->argc++] = (char *)argument;
}

void program_add_all(Program *program, char *arguments) {
  for (char *at = strtok(arguments, " "); at; at = strtok(NULL, " ")) program_add(program, at);
}

void program_run(void *data) {
  Program *program = data;
  if (lsys_main(program->grammar, program->argc, program->argv) != 0) exit(1);
}

int screen_hide(void) {
  fflush(stdout);
  int screen = dup(STDOUT_FILENO);
  if (!freopen("/dev/null", "w", stdout)) exit(1);
  return screen;
}

void screen_show(int screen) {
  fflush(stdout);
  dup2(screen, STDOUT_FILENO);
  close(screen);
}
