// test_binary.c -- the binary format, read back by its description.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "grammars.h"
#include "lsys/lsys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BLOCK = 1 << 16 };

static uint64_t whole(FILE *in) {
  uint8_t bytes[8];
  assert_int_equal(fread(bytes, 1, 8, in), 8);
  uint64_t number = 0;
  for (int i = 0; i < 8; i++) number |= (uint64_t)bytes[i] << (8 * i);
  return number;
}

static void padded(FILE *in, char *to, uint64_t size) {
  char padding[8];
  assert_int_equal(fread(to, 1, size, in), size);
  assert_int_equal(fread(padding, 1, -size % 8, in), -size % 8);
}

static void read_header(FILE *in, const LsysGrammar *grammar) {
  char magic[8], name[64];
  padded(in, magic, 8);
  assert_memory_equal(magic, "LSYSWORD", 8);
  assert_int_equal(whole(in), 1);
  assert_int_equal(whole(in), 1);
  assert_int_equal(whole(in), grammar->kind_count);
  for (uint32_t i = 0; i < grammar->kind_count; i++) {
    assert_int_equal(whole(in), grammar->kinds[i].arity);
    uint64_t length = whole(in);
    padded(in, name, length);
    name[length] = 0;
    assert_string_equal(name, grammar->kinds[i].symbol);
  }
}

// The whole word, as lsys_derive hands it over.
typedef struct Word {
  uint8_t *sym;
  double *arg;
  uint64_t nsym, narg;
} Word;

static bool receive(void *data, uint32_t axiom, const LsysWord *part) {
  (void)axiom;
  Word *word = data;
  word->sym = realloc(word->sym, word->nsym + part->nsym + 1);
  word->arg = realloc(word->arg, (word->narg + part->narg + 1) * sizeof(double));
  memcpy(word->sym + word->nsym, part->sym, part->nsym);
  if (part->narg) memcpy(word->arg + word->narg, part->arg, part->narg * sizeof(double));
  word->nsym += part->nsym;
  word->narg += part->narg;
  return true;
}

static void compare(FILE *in, const Word *word) {
  static char sym[BLOCK];
  uint64_t nsym = 0, narg = 0, n;
  while ((n = whole(in))) {
    uint64_t arguments = whole(in);
    assert_true(n == BLOCK || nsym + n == word->nsym);
    padded(in, sym, n);
    assert_memory_equal(sym, word->sym + nsym, n);
    for (uint64_t i = 0; i < arguments; i++) {
      double x;
      assert_int_equal(fread(&x, sizeof x, 1, in), 1);
      assert_true(x == word->arg[narg + i]);
    }
    nsym += n;
    narg += arguments;
  }
  assert_int_equal(nsym, word->nsym);
  assert_int_equal(narg, word->narg);
  assert_int_equal(fgetc(in), EOF);
}

static void reads_back(const LsysGrammar *grammar, const char *steps, const char *threads) {
  char path[] = "/tmp/test_binary.XXXXXX";
  close(mkstemp(path));
  Word word = {0};
  const char *const options[] = {"-n", steps, "-o", path, "--format", "binary", "--threads", threads, NULL};
  assert_true(lsys_derive(grammar, options, receive, &word));
  FILE *in = fopen(path, "rb");
  read_header(in, grammar);
  compare(in, &word);
  fclose(in);
  unlink(path);
  free(word.sym);
  free(word.arg);
}

static void words(void **state) {
  (void)state;
  reads_back(&algae, "0", "1");
  reads_back(&algae, "30", "1");
  reads_back(&bush, "3", "1");
  reads_back(&bush, "33", "2");
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(words)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
