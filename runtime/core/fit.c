// fit.c -- the growth matrix in doubles: exact enough to tell what will never fit.
#include "core/fit.h"

#include "core/message.h"

#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>

#define MOST_WORK 1e8  // multiplications that are done to predict a size

double lsys_fit_axiom(const LsysGrammar *grammar, uint32_t which, double *counts) {
  const LsysWord *word = &grammar->axioms[which].word;
  unsigned width = lsys_symbol_width(grammar);
  for (uint64_t i = 0; i < word->nsym; i++)
    counts[width == 1 ? word->sym[i] : (unsigned)(word->sym[2 * i] | word->sym[2 * i + 1] << 8)]++;
  return (double)word->nsym;
}

double lsys_fit_step(const LsysGrammar *grammar, const double *counts, double *next) {
  const LsysGrowth *growth = &grammar->growth;
  double sum = 0;
  memset(next, 0, grammar->kind_count * sizeof *next);
  for (uint32_t kind = 0; kind < grammar->kind_count; kind++)
    for (uint32_t i = growth->row[kind]; counts[kind] > 0 && i < growth->row[kind + 1]; i++) {
      double made = counts[kind] * growth->count[i];
      next[growth->kind[i]] += made;
      sum += made;
    }
  return sum;
}

double lsys_fit_modules(const LsysDerivation *derivation) {
  const LsysRun *run = &derivation->worker.run;
  const LsysGrammar *grammar = run->grammar;
  if (!grammar->growth.row) return 0;
  if ((double)run->steps * grammar->growth.row[grammar->kind_count] > MOST_WORK) return 0;
  double *counts = calloc(2 * (size_t)grammar->kind_count, sizeof *counts), *next = counts + grammar->kind_count,
         sum = 0;
  if (!counts) return 0;
  double *both = counts;
  for (uint32_t i = derivation->first_axiom; i < derivation->axiom_end; i++) sum += lsys_fit_axiom(grammar, i, counts);
  for (uint64_t step = 0; step < run->steps && sum < 1e300; step++) {
    sum = lsys_fit_step(grammar, counts, next);
    double *swap = counts;
    counts = next;
    next = swap;
  }
  free(both);
  return sum < 1e300 ? sum : 1 / 0.0;
}

// Where the file's folder has how many bytes free; infinite where nobody knows.
static double free_bytes(const char *path) {
  const char *slash = strrchr(path, '/');
  char *folder = slash ? strndup(path, slash == path ? 1 : (size_t)(slash - path)) : strdup(".");
  struct statvfs disk;
  bool known = folder && statvfs(folder, &disk) == 0;
  free(folder);
  return known ? (double)disk.f_bavail * (double)disk.f_frsize : 1 / 0.0;
}

bool lsys_fit_disk(double modules, const char *path) {
  double room = free_bytes(path);
  if (modules <= room) return true;
  bool told = modules < 1e300;
  lsys_error("%s: the word has %s%.3g modules, but the disk only room for %.3g bytes: take fewer steps, or look into "
             "it with --count, --range or a picture",
             path, told ? "" : "over ", told ? modules : 1e300, room);
  return false;
}
