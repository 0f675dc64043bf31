// test_out.c -- outputs: files appear when they are complete, failures are reported once and leave nothing behind.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/out.h"
#include "core/signals.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[64];

static const char *in_folder(const char *name) {
  static char path[128];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static int make_folder(void **state) {
  (void)state;
  strcpy(folder, "/tmp/test_out.XXXXXX");
  return mkdtemp(folder) == NULL;
}

// Files in the folder, which is emptied.
static int count_files(void) {
  int count = 0;
  DIR *entries = opendir(folder);
  for (struct dirent *entry; (entry = readdir(entries));) {
    if (entry->d_name[0] == '.' && strlen(entry->d_name) < 3) continue;
    unlink(in_folder(entry->d_name));
    count++;
  }
  closedir(entries);
  return count;
}

static int remove_folder(void **state) {
  (void)state;
  int left = count_files();
  return rmdir(folder) || left;
}

static void expect_text(const char *name, const char *wanted) {
  char text[64] = "";
  FILE *file = fopen(in_folder(name), "r");
  assert_non_null(file);
  text[fread(text, 1, sizeof text - 1, file)] = 0;
  fclose(file);
  assert_string_equal(text, wanted);
}

static void appears_when_complete(void **state) {
  (void)state;
  LsysOut *out = lsys_out_open(in_folder("a.txt"));
  assert_non_null(out);
  assert_true(lsys_out_write(out, "one ", 4) && lsys_out_print(out, "%d", 2));
  assert_int_equal(access(in_folder("a.txt"), F_OK), -1);
  assert_true(lsys_out_seekable(out) && lsys_out_size(out) == 5 && lsys_out_patch(out, 0, "ONE", 3));
  memcpy(lsys_out_room(out, 4), " 3", 2);
  lsys_out_filled(out, 2);
  assert_true(lsys_out_commit(out));
  expect_text("a.txt", "ONE 2 3");
  assert_int_equal(count_files(), 1);
}

static void abandoned_leaves_nothing(void **state) {
  (void)state;
  LsysOut *out = lsys_out_open(in_folder("b.txt"));
  assert_true(lsys_out_write(out, "x", 1));
  lsys_out_abandon(out);
  assert_int_equal(count_files(), 0);
}

static void replaces_keeping_links_and_mode(void **state) {
  (void)state;
  FILE *old = fopen(in_folder("c.txt"), "w");
  fclose(old);
  chmod(in_folder("c.txt"), 0640);
  char target[128];
  strcpy(target, in_folder("c.txt"));
  assert_int_equal(symlink(target, in_folder("link")), 0);
  LsysOut *out = lsys_out_open(in_folder("link"));
  assert_true(lsys_out_write(out, "new", 3) && lsys_out_commit(out));
  expect_text("c.txt", "new");
  struct stat status;
  assert_true(stat(in_folder("c.txt"), &status) == 0 && (status.st_mode & 0777) == 0640);
  assert_true(lstat(in_folder("link"), &status) == 0 && S_ISLNK(status.st_mode));
  assert_int_equal(count_files(), 2);
}

static void full_disk(void **state) {
  (void)state;
  LsysOut *out = lsys_out_open("/dev/full");
  assert_non_null(out);
  assert_true(lsys_out_write(out, "x", 1));  // still in the buffer
  assert_false(lsys_out_commit(out));
  out = lsys_out_open("/dev/full");
  char *much = calloc(1, 1 << 20);
  assert_false(lsys_out_write(out, much, 1 << 20));
  assert_false(lsys_out_write(out, "x", 1));
  assert_false(lsys_out_commit(out));
  free(much);
}

static void closed_pipe(void **state) {
  (void)state;
  int ends[2], old = dup(STDOUT_FILENO);
  lsys_signals_install();
  fflush(stdout);
  assert_int_equal(pipe(ends), 0);
  dup2(ends[1], STDOUT_FILENO);
  close(ends[0]);
  close(ends[1]);
  LsysOut *out = lsys_out_open("-");
  lsys_out_write(out, "x", 1);
  bool well = lsys_out_commit(out);
  dup2(old, STDOUT_FILENO);
  close(old);
  assert_false(well);
}

static void no_such_folder(void **state) {
  (void)state;
  assert_null(lsys_out_open("/nowhere/at/all.txt"));
  assert_null(lsys_out_open(folder));
}

// A child that is killed while it writes.
static void signals_remove_the_file(void **state) {
  (void)state;
  static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
  for (int i = 0; i < 3; i++) {
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
      signal(signals[i], SIG_DFL);  // whatever started the tests may have them ignored, which would be respected
      lsys_signals_install();
      LsysOut *out = lsys_out_open(in_folder("d.txt"));
      lsys_out_write(out, "x", 1);
      raise(signals[i]);
      _exit(0);
    }
    int status;
    waitpid(child, &status, 0);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == signals[i]);
    assert_int_equal(count_files(), 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(appears_when_complete),
    cmocka_unit_test(abandoned_leaves_nothing),
    cmocka_unit_test(replaces_keeping_links_and_mode),
    cmocka_unit_test(full_disk),
    cmocka_unit_test(closed_pipe),
    cmocka_unit_test(no_such_folder),
    cmocka_unit_test(signals_remove_the_file),
  };
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
