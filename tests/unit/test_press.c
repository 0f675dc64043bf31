// test_press.c -- blocks come out in their order, whatever the number of threads and the size of blocks, and a failure
// stops a press on any of them.
#include "sinks/press.h"

#include "core/message.h"
#include "core/out.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NUMBERS = 20000, BAD = 12345 };

typedef struct Numbers {
  LsysOut *out;
  uint64_t bad;
} Numbers;

// One line a number; some take longer than others.
static bool put_lines(const void *data, const void *block, size_t size, LsysPrepared *to) {
  const Numbers *numbers = data;
  const uint64_t *number = block;
  for (size_t i = 0; i < size / sizeof *number; i++) {
    char *room = lsys_prepared_room(to, 32);
    if (!room) return false;
    if (number[i] == numbers->bad) {
      lsys_error("a bad number");
      return false;
    }
    int length = 0;
    for (uint64_t k = 0; k <= number[i] % 64; k++) length = sprintf(room, "%" PRIu64 "\n", number[i]);
    to->used += (size_t)length;
  }
  return true;
}

static bool write_lines(void *data, const LsysPrepared *text) {
  return lsys_out_write(((Numbers *)data)->out, text->data, text->used);
}

static bool press_numbers(LsysMemory *memory, LsysOut *out, unsigned threads, uint64_t a_block, uint64_t bad) {
  Numbers numbers = {out, bad};
  LsysPress *press = lsys_press_open(memory, threads, put_lines, write_lines, &numbers);
  bool well = press;
  for (uint64_t i = 0; well && i < NUMBERS; i++) {
    uint64_t *number = lsys_press_add(press, sizeof *number);
    well = number;
    if (well) *number = i;
    if (well && (i + 1) % a_block == 0) well = lsys_press_send(press);
    if (well && i == NUMBERS / 2) well = lsys_press_finish(press) && lsys_out_print(out, "half\n");
  }
  well = well && lsys_press_finish(press);
  lsys_press_close(press);
  return well;
}

static void check_order(const char *path) {
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  char line[32], wanted[32];
  for (uint64_t i = 0; i < NUMBERS; i++) {
    snprintf(wanted, sizeof wanted, "%" PRIu64 "\n", i);
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, wanted);
    if (i != NUMBERS / 2) continue;
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, "half\n");
  }
  assert_null(fgets(line, sizeof line, file));
  fclose(file);
}

static const unsigned teams[] = {0, 1, 2, 7};
static const uint64_t sizes[] = {1, 3, 100, 2 * NUMBERS};

static void keeps_order(void **state) {
  (void)state;
  char path[] = "/tmp/lsysc-press-XXXXXX";
  close(mkstemp(path));
  for (size_t t = 0; t < 4; t++) {
    for (size_t s = 0; s < 4; s++) {
      LsysMemory memory = {.limit = 1 << 26};
      LsysOut *out = lsys_out_open(path);
      assert_true(press_numbers(&memory, out, teams[t], sizes[s], UINT64_MAX));
      assert_true(lsys_out_commit(out));
      assert_int_equal(memory.used, 0);
      check_order(path);
    }
  }
  unlink(path);
}

static void stops(void **state) {
  (void)state;
  for (size_t t = 0; t < 4; t++) {
    for (size_t s = 0; s < 4; s++) {
      LsysMemory memory = {.limit = 1 << 26};
      LsysOut *out = lsys_out_open("/dev/null");
      assert_false(press_numbers(&memory, out, teams[t], sizes[s], BAD));
      assert_int_equal(memory.used, 0);
      lsys_out_abandon(out);
    }
  }
}

static void refuses_memory(void **state) {
  (void)state;
  for (size_t t = 0; t < 4; t++) {
    LsysMemory memory = {.limit = 100000};
    LsysOut *out = lsys_out_open("/dev/null");
    LsysMessage message = {0}, *before = lsys_message_catch(&message);
    assert_false(press_numbers(&memory, out, teams[t], 2 * NUMBERS, UINT64_MAX));
    lsys_message_catch(before);
    assert_non_null(strstr(message.text, "out of memory"));
    assert_int_equal(memory.used, 0);
    lsys_out_abandon(out);
  }
}

// Of each number so much that few blocks are more than the chunks of a word.
static bool put_much(const void *data, const void *block, size_t size, LsysPrepared *to) {
  (void)data, (void)size;
  char *room = lsys_prepared_room(to, 1 << 20);
  if (!room) return false;
  memset(room, *(const char *)block, 1 << 20);
  to->used += 1 << 20;
  usleep(*(const unsigned char *)block % 7 == 0 ? 2000 : 0);
  return true;
}

// The blocks come in order and are as large as they were made.
static bool count_much(void *data, const LsysPrepared *text) {
  unsigned char *next = data;
  return text->used == 1 << 20 && (unsigned char)text->data[text->used - 1] == (*next)++;
}

static void makes_much_of_little(void **state) {
  (void)state;
  for (size_t t = 0; t < 4; t++) {
    LsysMemory memory = {.limit = 1 << 28};
    unsigned char next = 0;
    LsysPress *press = lsys_press_open(&memory, teams[t], put_much, count_much, &next);
    assert_non_null(press);
    for (int i = 0; i < 200; i++) {
      *(char *)lsys_press_add(press, 1) = (char)i;
      assert_true(lsys_press_send(press));
    }
    assert_true(lsys_press_finish(press));
    lsys_press_close(press);
    assert_int_equal(next, 200);
    assert_int_equal(memory.used, 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(keeps_order),
    cmocka_unit_test(stops),
    cmocka_unit_test(refuses_memory),
    cmocka_unit_test(makes_much_of_little),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
