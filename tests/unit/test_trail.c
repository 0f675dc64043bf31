// test_trail.c -- what a turtle draws along the trails of blocks is, batch by batch and bit by bit, what it draws when
// it reads them.
#include "lsys/abi.h"

#include "core/memory.h"
#include "core/message.h"
#include "sample.h"
#include "turtle/turtle.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { BLOCKS = 4, PARTS = 60, ROOM = 1 << 16 };

// A random word of the letters given, whose brackets match.
static char *put_word(char *to, uint64_t *seed, const char *letters, size_t length) {
  size_t depth = 0, count = strlen(letters);
  for (size_t i = 0; i < length; i++) {
    *seed = lsys_mix64(*seed + 1);
    char letter = letters[*seed % count];
    if (letter == ']' && !depth) letter = 'F';
    depth += letter == '[';
    depth -= letter == ']';
    *to++ = letter;
  }
  while (depth--) *to++ = ']';
  return to;
}

// A word that holds the blocks, and what comes between them.
typedef struct Text {
  char text[ROOM];
  size_t from[BLOCKS + 1], end[BLOCKS + 1];  // the last one: what comes between
} Text;

static Text *make_text(uint64_t seed, const char *letters, size_t length) {
  Text *t = calloc(1, sizeof *t);
  char *to = t->text;
  for (int i = 0; i <= BLOCKS; i++) {
    t->from[i] = (size_t)(to - t->text);
    to = put_word(to, &seed, i < BLOCKS ? letters : "F+-[]!f|;", i < BLOCKS ? length + 700 * (size_t)i : 300);
    t->end[i] = (size_t)(to - t->text);
  }
  return t;
}

typedef struct Recorder {
  LsysGeometry geometry;
  uint64_t sum;  // of everything that was drawn
  uint64_t batches;
} Recorder;

static void add(Recorder *r, const void *bytes, size_t size) {
  const char *at = bytes;
  for (; size; at += sizeof r->sum, size -= sizeof r->sum) {
    uint64_t word;
    memcpy(&word, at, sizeof word);
    r->sum = lsys_mix64(r->sum ^ word) + LSYS_GOLDEN;
  }
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  Recorder *r = (Recorder *)to;
  r->batches++;
  add(r, batch->point, batch->points * sizeof *batch->point);
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    uint64_t numbers[] = {s->first, s->count, s->joined, s->pen.colour, s->pen.mark};
    add(r, numbers, sizeof numbers);
    add(r, &s->pen.width, sizeof s->pen.width);
  }
  return true;
}

// How the turtle is set up.
typedef struct Setting {
  double angle;
  bool by_depth, by_kind, trails;
  uint64_t limit;  // of memory
} Setting;

// Draws blocks and what comes between, in an order that the seed chooses.
static Recorder draw(const Text *text, const Setting *set, uint64_t seed, uint64_t *most) {
  Recorder r = {.geometry = {.strokes = strokes}};
  LsysMemory memory = {.limit = set->limit};
  Sample *s = sample(text->text, set->angle);
  LsysBlock block[BLOCKS];
  const LsysBlock *rows[1] = {block};
  const uint64_t levels[1] = {BLOCKS};
  for (int i = 0; i < BLOCKS; i++)
    block[i] = (LsysBlock){.sym = s->sym + text->from[i], .nsym = text->end[i] - text->from[i]};
  uint64_t *all_levels = calloc(s->grammar.kind_count, sizeof *all_levels);
  const LsysBlock **all_rows = calloc(s->grammar.kind_count, sizeof *all_rows);
  all_levels[0] = levels[0];
  all_rows[0] = rows[0];
  s->run.memory = &memory;
  if (set->trails) {
    s->run.block = all_rows;
    s->run.block_levels = all_levels;
  }
  LsysTurtle *t = lsys_turtle_create(&s->run);
  if (set->by_depth) lsys_turtle_by_depth(t);
  if (set->by_kind) lsys_turtle_by_kind(t);
  lsys_turtle_begin(t, 0, &r.geometry);
  for (int i = 0; i < PARTS; i++) {
    seed = lsys_mix64(seed + 1);
    size_t which = seed % (BLOCKS + 2) % (BLOCKS + 1);  // what comes between comes about as often as a block
    size_t from = text->from[which], end = text->end[which];
    if (which == BLOCKS) from += (seed >> 8) % (end - from), end = from + (seed >> 32) % (end - from);
    LsysWord part = {.sym = s->sym + from, .nsym = end - from};
    assert_true(lsys_turtle_take(t, &part));
  }
  assert_true(lsys_turtle_end(t));
  LsysPose pose = lsys_turtle_pose(t);
  add(&r, &pose.at, sizeof pose.at);
  add(&r, &pose.h, sizeof pose.h);
  *most = memory.used;
  lsys_turtle_destroy(t);
  assert_int_equal(memory.used, 0);
  free(all_levels);
  free(all_rows);
  sample_release(s);
  return r;
}

// With and without trails, and where memory is short, which what has to be held needs first. Returns bytes of the
// trails.
static uint64_t compare(const Text *text, Setting set, uint64_t seed) {
  uint64_t plain, noted, refused;
  set.limit = UINT64_MAX;
  Recorder read = draw(text, &set, seed, &plain);
  set.trails = true;
  Recorder followed = draw(text, &set, seed, &noted);
  assert_int_equal(read.batches, followed.batches);
  assert_true(read.sum == followed.sum);
  set.limit = 3 * plain + 10000;
  Recorder poor = draw(text, &set, seed, &refused);
  assert_true(read.sum == poor.sum && refused <= set.limit);
  return noted - plain;
}

static const double angles[] = {90, 60, 25.7, 22.5, 1};

static void blocks_of_all_letters(void **state) {
  (void)state;
  for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
    for (uint64_t seed = 1; seed <= 20; seed++) {
      Text *text = make_text(seed, seed % 2 ? "FFFF+-[]X|fF[]" : "F+-[]X", 1000 + seed * 131);
      assert_true(compare(text, (Setting){.angle = angles[i]}, seed) > 4000);
      free(text);
    }
  }
}

// Long strokes fill batches in their middle; brackets of nothing, and moves behind each other.
static void extreme_blocks(void **state) {
  (void)state;
  static const char *const letters[] = {"F", "F+", "f", "[]", "Ff", "f[]", "X"};
  for (size_t i = 0; i < sizeof letters / sizeof *letters; i++) {
    for (uint64_t seed = 1; seed <= 5; seed++) {
      Text *text = make_text(seed, letters[i], 5000);
      assert_true(compare(text, (Setting){.angle = 90}, seed) > 0);
      free(text);
    }
  }
}

// Of words with other letters, of directions without end, and of too many brackets there are no trails.
static void what_has_no_trail(void **state) {
  (void)state;
  Text *text = make_text(1, "F!+[]", 3000);
  assert_true(compare(text, (Setting){.angle = 90}, 1) < 4000);
  free(text);
  text = make_text(1, "F+", 3000);
  compare(text, (Setting){.angle = 0.1}, 1);
  free(text);
  text = make_text(1, "[[[F]", 3000);
  compare(text, (Setting){.angle = 25}, 1);
  compare(text, (Setting){.angle = 25, .by_depth = true}, 1);
  compare(text, (Setting){.angle = 25, .by_kind = true}, 1);
  free(text);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(blocks_of_all_letters),
    cmocka_unit_test(extreme_blocks),
    cmocka_unit_test(what_has_no_trail),
  };
  lsys_message_quiet(1);
  return cmocka_run_group_tests(tests, NULL, NULL);
}
