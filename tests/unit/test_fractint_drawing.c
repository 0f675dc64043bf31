// test_fractint_drawing.c -- random systems of Fractint, drawn by our turtle and
// by the recursion that Fractint's own code does: the same lines in the same colours.
#include "parsing.h"

#include "core/derive.h"
#include "frontend/fractint.h"
#include "frontend/program.h"
#include "interp/interp.h"
#include "lsys/keys.h"
#include "turtle/turtle.h"

#include <ctype.h>
#include <math.h>

enum { MOST_LINES = 20000, RULES = 3, LONGEST = 96 };

typedef struct Line {
  double x0, y0, x1, y1;
  int colour;
} Line;

typedef struct Lines {
  Line at[MOST_LINES];
  size_t count;
  bool full;
} Lines;

static void add_line(Lines *lines, Line line) {
  lines->full = lines->full || lines->count == MOST_LINES;
  if (!lines->full) lines->at[lines->count++] = line;
}

// ---- a random system -----------------------------------------------------------

typedef struct System {
  int angle, order;
  char axiom[LONGEST], rule[RULES][LONGEST];
  char letter[RULES];
} System;

static int below(uint64_t *state, int n) {
  return (int)(lsys_mix64(*state += LSYS_GOLDEN) % (uint64_t)n);
}

static void random_string(uint64_t *state, char *out, int pieces) {
  static const char *const plain[] = {"f", "f", "f", "F", "g", "d", "m", "x", "y", "x", "+", "-", "+", "-", "|", "!"};
  static const char *const more[] = {"@.6", "@2", "@q2", "@iq3", "@i1.5", "\\30", "/45.5",       "\\90", "c3",
                                     "<1",  ">2", "<",   ">20",  "[f]",   "[-x]", "[!+@.5y>1d]", ",",    "_"};
  *out = 0;
  for (int i = 0; i < pieces; i++) {
    bool rare = below(state, 100) < 35;
    strcat(out,
           rare ? more[below(state, sizeof more / sizeof *more)] : plain[below(state, sizeof plain / sizeof *plain)]);
  }
}

static System random_system(uint64_t number) {
  static const char *const letters[RULES] = {"xxxf", "yfdgm", "fy_,"};
  uint64_t state = lsys_root(number);
  System system = {.angle = 3 + below(&state, 48), .order = below(&state, 6)};
  if (below(&state, 2)) system.angle = 3 + below(&state, 4);
  random_string(&state, system.axiom, 4);
  strcat(system.axiom, "xfy");  // so that most systems grow
  for (int i = 0; i < RULES; i++) {
    system.letter[i] = letters[i][below(&state, (int)strlen(letters[i]))];
    random_string(&state, system.rule[i], 1 + below(&state, 6));
    if (i < 2) strcat(system.rule[i], below(&state, 2) ? "yfx" : "x");
  }
  return system;
}

static char *system_text(const System *system) {
  char *text;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  fprintf(out, "Random {\nangle %d\naxiom %s\n", system->angle, system->axiom);
  for (int i = 0; i < RULES; i++) fprintf(out, "%c=%s\n", system->letter[i], system->rule[i]);
  fputs("}\n", out);
  fclose(out);
  return text;
}

// ---- as Fractint does it -----------------------------------------------------------

typedef struct State {
  double x, y, size, second;  // y grows downwards; the second angle in degrees
  int angle, colour;
  bool reverse;
} State;

typedef struct Fractint {
  const System *system;
  State state;
  Lines *lines;
} Fractint;

static double number(const char **at) {
  bool root = false, inverse = false;
  for (int i = 0; i < 2 && (**at == 'q' || **at == 'i'); i++) *(*(*at)++ == 'q' ? &root : &inverse) = true;
  char *end = (char *)*at;
  double value = isdigit((unsigned char)**at) || **at == '.' ? strtod(*at, &end) : 0;
  *at = end;
  if (value <= 0) return 0;
  if (root) value = sqrt(value);
  return inverse ? 1 / value : value;
}

static void go(Fractint *f, bool draws, double degrees) {
  State *s = &f->state;
  double x = s->x, y = s->y;
  s->x += s->size * lsys_cos(degrees);
  s->y += s->size * lsys_sin(degrees);
  if (draws) add_line(f->lines, (Line){x, -y, s->x, -s->y, s->colour});
}

static void recolour(State *s, int by) {
  s->colour = ((s->colour + by) % 256 + 256) % 256;
}

// A command with what belongs to it; `at` stands behind the character.
static void execute(Fractint *f, char c, const char **at) {
  State *s = &f->state;
  int n = f->system->angle;
  double heading = 360.0 * s->angle / n;
  switch (c) {
  case 'f':
    go(f, true, heading);
    break;
  case 'g':
    go(f, false, heading);
    break;
  case 'd':
    go(f, true, s->second);
    break;
  case 'm':
    go(f, false, s->second);
    break;
  case '+':
    s->angle = (s->angle + (s->reverse ? 1 : n - 1)) % n;
    break;
  case '-':
    s->angle = (s->angle + (s->reverse ? n - 1 : 1)) % n;
    break;
  case '|':
    s->angle = (s->angle + n / 2) % n;
    break;
  case '!':
    s->reverse = !s->reverse;
    break;
  case '@':
    s->size *= number(at);
    break;
  case '/':
    s->second += (s->reverse ? -1 : 1) * number(at);
    break;
  case '\\':
    s->second -= (s->reverse ? -1 : 1) * number(at);
    break;
  case 'c':
    s->colour = (int)number(at) % 256;
    break;
  case '<':
    recolour(s, (int)number(at));
    if (s->colour == 0) s->colour = 1;
    break;
  case '>':
    recolour(s, -(int)number(at));
    if (s->colour == 0) s->colour = 255;
    break;
  default:
    break;
  }
}

// Up to the end of the body or an unmatched `]`, where it returns. Rules of one letter add up.
static const char *expand(Fractint *f, const char *at, int depth) {
  while (*at && *at != ']' && !f->lines->full) {
    char c = (char)tolower((unsigned char)*at++);
    bool rewritten = false;
    for (int i = 0; depth > 0 && i < RULES; i++)
      if (f->system->letter[i] == c) {
        expand(f, f->system->rule[i], depth - 1);
        rewritten = true;
      }
    if (c == '[') {
      State saved = f->state;
      at = expand(f, at, depth);
      if (*at) at++;
      f->state = saved;
    } else if (!rewritten) {
      execute(f, c, &at);
    }
  }
  return at;
}

// ---- as we do it -----------------------------------------------------------------

typedef struct Drawing {
  LsysSink sink;
  LsysGeometry geometry;
  LsysTurtle *turtle;
  Lines *lines;
} Drawing;

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  Drawing *drawing = (Drawing *)((char *)to - offsetof(Drawing, geometry));
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *stroke = &batch->stroke[i];
    const LsysVec3 *p = batch->point + stroke->first;
    for (uint32_t k = 1; k < stroke->count; k++)
      add_line(drawing->lines, (Line){p[k - 1].x, p[k - 1].y, p[k].x, p[k].y, stroke->pen.colour});
  }
  return true;
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  Drawing *drawing = (Drawing *)sink;
  drawing->turtle = lsys_turtle_create(run);
  lsys_turtle_begin(drawing->turtle, axiom, &drawing->geometry);
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((Drawing *)sink)->turtle, part);
}

static bool end(LsysSink *sink) {
  return lsys_turtle_end(((Drawing *)sink)->turtle);
}

static void draw(const char *text, int order, Lines *lines) {
  Arena *arena = arena_create();
  Sources *sources = sources_create(arena);
  const SourceFile *file = sources_add(sources, "random.l", text, strlen(text), (Span){0});
  DiagOptions diag_options;
  diag_options_default(&diag_options);
  diag_options.no_warnings = true;
  Diag *diag = diag_create(arena, sources, &diag_options);
  const Ast *ast = fractint_parse(arena, sources, diag, file, &(ParseOptions){0});
  const Program *program = check(arena, ast, diag);
  assert_int_equal(diag_errors(diag), 0);
  const LsysGrammar *described = describe(arena, program, facts_find(arena, program));
  LsysGrammar *grammar = interp_grammar(arena, program, described);
  LsysOptions options = {0};
  options.at[LSYS_OPTION_STEPS] = (LsysOptionValue){.given = true, .whole = (uint64_t)order};
  LsysMemory memory = {.limit = UINT64_C(1) << 30};
  LsysDerivation derivation;
  Drawing drawing = {{.passes = 1, .begin = begin, .take = take, .end = end}, {.strokes = strokes}, NULL, lines};
  assert_true(lsys_derivation_open(&derivation, grammar, &options, &memory));
  assert_true(lsys_derivation_run(&derivation, 0, &drawing.sink, 0));
  lsys_turtle_destroy(drawing.turtle);
  lsys_derivation_close(&derivation);
  interp_release(grammar);
  arena_destroy(arena);
}

// ---- the comparison ----------------------------------------------------------------

static double extent(const Lines *lines) {
  double most = 1;
  for (size_t i = 0; i < lines->count; i++) most = fmax(most, fmax(fabs(lines->at[i].x1), fabs(lines->at[i].y1)));
  return most;
}

static bool close_to(const Line *a, const Line *b, double most) {
  return fabs(a->x0 - b->x0) <= most && fabs(a->y0 - b->y0) <= most && fabs(a->x1 - b->x1) <= most
      && fabs(a->y1 - b->y1) <= most && a->colour == b->colour;
}

static void lines_are_those_of_fractint(void **state) {
  (void)state;
  Lines *wanted = malloc(sizeof *wanted), *drawn = malloc(sizeof *drawn);
  assert_non_null(wanted);
  assert_non_null(drawn);
  size_t compared = 0;
  for (uint64_t i = 1; i <= 1000; i++) {
    System system = random_system(i);
    char *text = system_text(&system);
    wanted->count = drawn->count = 0;
    wanted->full = drawn->full = false;
    Fractint fractint = {&system, {.size = 1, .colour = 15}, wanted};
    expand(&fractint, system.axiom, system.order);
    if (!wanted->full && extent(wanted) < 1e6) {
      draw(text, system.order, drawn);
      if (drawn->count != wanted->count) fail_msg("%zu lines, not %zu:\n%s", drawn->count, wanted->count, text);
      double most = 1e-9 * extent(wanted);
      for (size_t k = 0; k < wanted->count; k++)
        if (!close_to(&wanted->at[k], &drawn->at[k], most))
          fail_msg("line %zu at order %d differs:\n%s", k, system.order, text);
      compared += wanted->count;
    }
    free(text);
  }
  assert_true(compared > 10000);
  free(wanted);
  free(drawn);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(lines_are_those_of_fractint)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
