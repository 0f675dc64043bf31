// outputs.c -- whole runs of compiled grammars, from options to the last byte
// written: to memory files, so that no disk is measured.
#include "bench.h"
#include "compile.h"
#include "measure.h"
#include "program.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Row {
  const char *name, *grammar, *steps, *file;  // file NULL: only reports
  const char *option;                         // or several, separated by blanks; NULL: none
  double modules, segments;                   // of the word
} Row;

static const Row rows[] = {
  {"text of plant", "plant", "14", "word.txt", NULL, 28679199, 9533170},
  {"text of tree", "row-of-trees", "21", "word.txt", NULL, 16777209, 2097151},
  {"hash of plant", "plant", "16", NULL, "--hash", 258149251, 85962370},
  {"stats of koch", "koch", "8", NULL, "--stats", 124630747, 67108864},
  {"stats of plant", "plant", "14", NULL, "--stats", 28679199, 9533170},
  {"stats of tree", "row-of-trees", "21", NULL, "--stats", 16777209, 2097151},
  {"svg of plant", "plant", "14", "plant.svg", NULL, 28679199, 9533170},
  {"png of plant", "plant", "14", "plant.png", "--size=4096x4096", 28679199, 9533170},
  {"ply of plant", "plant", "14", "plant.ply", NULL, 28679199, 9533170},
  {"glb of plant", "plant", "14", "plant.glb", NULL, 28679199, 9533170},
  {"pdf of plant", "plant", "12", "plant.pdf", NULL, 3180451, 1054690},
  {"obj of plant", "plant", "12", "plant.obj", NULL, 3180451, 1054690},
  {"json of plant", "plant", "12", "plant.json", NULL, 3180451, 1054690},
  {"png of tree", "row-of-trees", "21", "tree.png", "--size=4096x4096", 16777209, 2097151},
  {"hash of flowers", "flowers", "11", NULL, "--hash --homomorphism", 12134564, 3897233},
};

static const char *folder(void) {
  return access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
}

static void print_row(const Options *options, const Row *row, double seconds, double bytes) {
  if (options->json)
    printf("{\"row\":\"%s\",\"seconds\":%.6g,\"modules\":%.0f,\"segments\":%.0f,\"bytes\":%.0f}\n", row->name, seconds,
           row->modules, row->segments, bytes);
  else
    printf("%-16s %12.0f %12.0f %9.3f %10.2f %10.2f %10.1f\n", row->name, row->modules, row->segments, seconds,
           seconds / row->modules * 1e9, seconds / row->segments * 1e9, bytes / 1e6);
  fflush(stdout);
}

static void run_row(const Options *options, const Row *row) {
  char grammar[4096], file[4096], extra[64];
  snprintf(grammar, sizeof grammar, "%s/%s.lsys", options->grammars, row->grammar);
  snprintf(file, sizeof file, "%s/lsysc-bench-%d-%s", folder(), (int)getpid(), row->file ? row->file : "none");
  Compiled *compiled = compile_grammar(grammar, options->home);
  Program program = program_of(compiled_grammar(compiled));
  program_add(&program, "-n");
  program_add(&program, row->steps);
  snprintf(extra, sizeof extra, "%s", row->option ? row->option : "");
  program_add_all(&program, extra);
  if (row->file) {
    program_add(&program, "-o");
    program_add(&program, file);
  }
  int screen = screen_hide();
  Side side = {.name = row->name, .run = program_run, .data = &program};
  measure(&side, 1, options->runs);
  screen_show(screen);
  struct stat info = {0};
  if (row->file && stat(file, &info) == 0) unlink(file);
  print_row(options, row, median(side.seconds, options->runs), (double)info.st_size);
  compile_release(compiled);
}

void bench_outputs(const Options *options) {
  if (!options->json)
    printf("%-16s %12s %12s %9s %10s %10s %10s\n", "row", "modules", "segments", "seconds", "ns/module", "ns/segment",
           "MB out");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    if (bench_wants(options, rows[i].name)) run_row(options, &rows[i]);
}
