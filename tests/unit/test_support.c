// test_support.c -- arena, growable arrays, trie, places in sources, and how messages look.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support/diag.h"
#include "support/trie.h"
#include "support/utf8.h"
#include "support/vec.h"

#include <stdlib.h>
#include <string.h>

static void test_arena(void **state) {
  (void)state;
  Arena *arena = arena_create();
  assert_non_null(arena_alloc(arena, 0));
  char *before = NULL;
  for (size_t size = 1; size < 1 << 22; size = size * 3 + 1) {
    char *at = arena_alloc(arena, size);
    assert_int_equal((uintptr_t)at % _Alignof(max_align_t), 0);
    assert_ptr_not_equal(at, before);
    for (size_t i = 0; i < size; i++) assert_int_equal(at[i], 0);
    memset(at, 0xAA, size);
    before = at;
  }
  assert_string_equal(arena_copy(arena, "abcdef", 3), "abc");
  assert_string_equal(arena_copy(arena, NULL, 0), "");
  assert_string_equal(arena_printf(arena, "%d %s", 12, "x"), "12 x");
  arena_destroy(arena);
  arena_destroy(NULL);
}

static void test_vec(void **state) {
  (void)state;
  Arena *arena = arena_create();
  VEC(int) list = {0};
  for (int i = 0; i < 1000; i++) *VEC_PUSH(arena, &list) = i;
  assert_int_equal(list.count, 1000);
  for (int i = 0; i < 1000; i++) assert_int_equal(list.at[i], i);
  arena_destroy(arena);
}

static void test_trie(void **state) {
  (void)state;
  Arena *arena = arena_create();
  Trie *trie = trie_create(arena);
  const char *plant = trie_intern(trie, "plant", 5);
  trie_intern(trie, "plants", 6);
  trie_intern(trie, "p", 1);
  assert_ptr_equal(trie_intern(trie, "plantation", 5), plant);
  assert_string_equal(plant, "plant");
  assert_string_equal(trie_intern(trie, "x", 0), "");
  assert_int_equal(trie_longest(trie, "plantsman", 9), 6);
  assert_int_equal(trie_longest(trie, "plantsman", 5), 5);
  assert_int_equal(trie_longest(trie, "plan", 4), 1);
  assert_int_equal(trie_longest(trie, "q", 1), 0);
  assert_int_equal(trie_longest(trie, "p", 0), 0);
  assert_ptr_equal(trie_find(trie, "plant", 5), plant);
  assert_null(trie_find(trie, "plan", 4));
  assert_null(trie_find(trie, "planted", 7));
  *trie_at(trie, "\xFF\x00z", 3) = trie;
  assert_ptr_equal(trie_find(trie, "\xFF\x00z", 3), trie);
  arena_destroy(arena);
}

static size_t length_of(const char *bytes) {
  return utf8_length(bytes, bytes + strlen(bytes));
}

static void test_utf8(void **state) {
  (void)state;
  assert_int_equal(length_of("a"), 1);
  assert_int_equal(length_of("é"), 2);
  assert_int_equal(length_of("→"), 3);
  assert_int_equal(length_of("😀"), 4);
  static const char *const bad[] = {"",
                                    "\x80",
                                    "\xC0\x80",
                                    "\xC1\xBF",
                                    "\xC3",
                                    "\xE0\x9F\xBF",
                                    "\xED\xA0\x80",
                                    "\xF0\x8F\xBF\xBF",
                                    "\xF4\x90\x80\x80",
                                    "\xF5\x80\x80\x80",
                                    "\xE2\x86",
                                    "\xFF"};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) assert_int_equal(length_of(bad[i]), 0);
}

static void test_places(void **state) {
  (void)state;
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  static const char first[] = "ab\néx\n\xFF\x80y", second[] = "";
  const SourceFile *a = sources_add(sources, "a", first, strlen(first), (Span){0, 0});
  const SourceFile *b = sources_add(sources, "b", second, 0, (Span){1, 2});
  assert_null(sources_file(sources, 0));
  assert_null(sources_place(sources, 0).file);
  static const uint32_t columns[] = {1, 2, 3, 1, 2, 2, 3, 1, 2, 3, 4};
  static const uint32_t lines[] = {1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  for (uint32_t i = 0; i <= strlen(first); i++) {
    Place place = sources_place(sources, a->base + i);
    assert_ptr_equal(place.file, a);
    assert_int_equal(place.line, lines[i]);
    if (i != 4) assert_int_equal(place.column, columns[i]);  // not inside of a character
  }
  assert_ptr_equal(sources_file(sources, b->base), b);
  const char *why;
  assert_null(sources_read(sources, "/nowhere/at/all", (Span){0, 0}, &why));
  assert_string_equal(why, "no such file");
  assert_null(sources_read(sources, "/", (Span){0, 0}, &why));
  assert_string_equal(why, "is a directory");
  arena_destroy(arena);
}

static void test_messages(void **state) {
  (void)state;
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  static const char main[] = "#include x\n\tF(ü, lenght*2) \xFF\n", included[] = "bad";
  const SourceFile *file = sources_add(sources, "a.lsys", main, strlen(main), (Span){0, 0});
  const SourceFile *other = sources_add(sources, "x", included, 3, (Span){file->base + 9, file->base + 10});
  char *text;
  size_t size;
  DiagOptions options;
  diag_options_default(&options);
  options.colour = COLOUR_NEVER;
  options.out = open_memstream(&text, &size);
  options.max_errors = 2;
  assert_true(diag_option(&options, "no-label"));
  assert_false(diag_option(&options, "no-such"));
  Diag *diag = diag_create(arena, sources, &options);
  Span name = {file->base + 18, file->base + 24};
  diag_error(diag, name, "unknown name `%s`", "lenght");
  diag_fix(diag, name, "length");
  diag_note(diag, (Span){other->base, other->base + 3}, "from here");
  diag_hint(diag, "look it up");
  diag_warning(diag, WARN_LABEL, name, "not shown");
  diag_note(diag, name, "nor this");
  diag_warning(diag, WARN_WEIGHTS, (Span){0, 0}, "shown");
  diag_error(diag, (Span){other->base + 3, other->base + 3}, "end");
  diag_error(diag, name, "one too many");
  diag_hint(diag, "not shown either");
  fclose(options.out);
  assert_int_equal(diag_errors(diag), 3);
  assert_string_equal(text, "a.lsys:2:7: error: unknown name `lenght`\n"
                            "    2 | \tF(ü, lenght*2) \xEF\xBF\xBD\n"
                            "      | \t     ^~~~~~\n"
                            "      | \t     length\n"
                            "x:1:1: note: from here\n"
                            "    1 | bad\n"
                            "      | ^~~\n"
                            "      = hint: look it up\n"
                            "lsysc: warning: shown [-Wweights]\n"
                            "in the file included at a.lsys:1:\n"
                            "x:1:4: error: end\n"
                            "    1 | bad\n"
                            "      |    ^\n"
                            "lsysc: note: further errors are not shown\n");
  free(text);
  arena_destroy(arena);
}

static void test_nearest(void **state) {
  (void)state;
  static const char *const names[] = {"length", NULL, "width", "x"};
  assert_string_equal(diag_nearest("lenght", names, 4), "length");
  assert_string_equal(diag_nearest("widht", names, 4), "width");
  assert_null(diag_nearest("colour", names, 4));
  assert_null(diag_nearest("y", names, 4));
  char longer[200] = {0};
  memset(longer, 'a', sizeof longer - 1);
  assert_null(diag_nearest(longer, names, 4));
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_arena),   cmocka_unit_test(test_vec),    cmocka_unit_test(test_trie),
    cmocka_unit_test(test_utf8),    cmocka_unit_test(test_places), cmocka_unit_test(test_messages),
    cmocka_unit_test(test_nearest),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
