// docs.c -- examples in a document do what the document says.
//
// In a fenced block ```lsys NAME the grammar is put into the file NAME, in a
// folder that the whole document shares; it has to pass `lsysc check`, and
// tests in its comments are run. In ```console the lines behind "$ " are
// commands, the others what they print; a line "..." stands for any lines.
// Other blocks are left alone.
#include "golden.h"

#include <string.h>

typedef struct Document {
  Case *test;
  unsigned grammars;
} Document;

static Result shell(Case *test, const char *command) {
  Strings argv = {0};
  *VEC_PUSH(test->arena, &argv) = "sh";
  *VEC_PUSH(test->arena, &argv) = "-c";
  *VEC_PUSH(test->arena, &argv) = command;
  *VEC_PUSH(test->arena, &argv) = NULL;
  return process_run(test->arena, &argv, test->folder, true);
}

static void run_grammar(Document *document, const char *name, const char *text, unsigned line) {
  Case *test = document->test;
  if (!*name) name = arena_printf(test->arena, "example%u.lsys", ++document->grammars);
  const char *path = arena_printf(test->arena, "%s/%s", test->folder, name);
  if (!text_write(path, text, strlen(text))) {
    case_fail(test, line, "cannot write %s", path);
    return;
  }
  Result result = shell(test, arena_printf(test->arena, "lsysc check '%s'", name));
  if (result.status != 0 || result.size > 0)
    case_fail(test, line, "the example gets messages\n%s", result.out);
  else
    case_pass(test);
  derive_text(test, path, line);
}

static void run_command(Case *test, const char *command, const char *expected, unsigned line) {
  Result result = shell(test, command);
  if (!result.late && text_same_lines(expected, result.out, true)) {
    case_pass(test);
    return;
  }
  case_fail(test, line, "$ %s", command);
  text_report_difference(test->report, expected, result.out);
}

static void run_console(Case *test, const char *text, unsigned line) {
  while (*text) {
    size_t length = strcspn(text, "\n");
    const char *command = arena_copy(test->arena, text + 2, length > 2 ? length - 2 : 0);
    unsigned command_line = ++line;
    if (length < 2 || memcmp(text, "$ ", 2) != 0) {
      case_fail(test, line, "a console block begins with `$ command`");
      return;
    }
    text += length + 1;
    const char *output = text;
    for (; *text && strncmp(text, "$ ", 2) != 0; line++) text += strcspn(text, "\n") + 1;
    run_command(test, command, arena_copy(test->arena, output, (size_t)(text - output)), command_line);
  }
}

static void run_block(Document *document, const char *info, const char *text, unsigned line) {
  if (strncmp(info, "lsys", 4) == 0 && (!info[4] || info[4] == ' '))
    run_grammar(document, info + 4 + strspn(info + 4, " "), text, line);
  else if (strcmp(info, "console") == 0)
    run_console(document->test, text, line);
}

void docs_run(Case *test) {
  const char *at = text_read(test->arena, test->path);
  if (!at) {
    case_fail(test, 0, "cannot be read");
    return;
  }
  Document document = {.test = test};
  const char *info = NULL, *block = NULL;  // of the block that is open
  unsigned block_line = 0;
  for (unsigned line = 1; *at; line++) {
    size_t length = strcspn(at, "\n");
    if (strncmp(at, "```", 3) == 0) {
      if (block) run_block(&document, info, arena_copy(test->arena, block, (size_t)(at - block)), block_line);
      info = arena_copy(test->arena, at + 3, length - 3);
      block = block ? NULL : at + length + 1;
      block_line = line;
    }
    at += length + (at[length] != '\0');
  }
  if (block) case_fail(test, block_line, "the block is not closed");
}
