// spline.c -- files of B-splines, and their values.
//
// A file holds one spline or, behind a gallery's heading, several. Each is a
// row of lines `keyword: values`, and then one line for each control point.
// Source: the function and contour editors of the Virtual Laboratory.
#include "frontend/spline.h"

#include "lsys/input.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 10000, USUAL_SAMPLES = 100, DEGREE = 3 };

// ---- files -------------------------------------------------------------------

typedef struct Reader {
  Arena *arena;
  Splines *splines;
  bool curves;
  unsigned line;
  size_t left;     // points that the last one still lacks,
  int dimensions;  //   and coordinates of each
  size_t idle;     // lines that are read over
  char *why;
  size_t size;
} Reader;

static bool fail(Reader *r, const char *what) {
  if (r->line)
    snprintf(r->why, r->size, "line %u: %s", r->line, what);
  else
    snprintf(r->why, r->size, "%s", what);
  return false;
}

static Spline *current(Reader *r) {
  return r->splines->count ? &r->splines->at[r->splines->count - 1] : NULL;
}

static bool begin(Reader *r) {
  if (r->left) return fail(r, "points are missing above this line");
  *VEC_PUSH(r->arena, r->splines) = (Spline){.name = "", .clamped = !r->curves, .samples = USUAL_SAMPLES};
  r->dimensions = r->curves ? 3 : 2;
  return true;
}

static bool begins_with(const char *line, const char *word) {
  return strncmp(line, word, strlen(word)) == 0;
}

static bool point(Reader *r, const char *line) {
  double number[4] = {0, 0, 0, 1};
  int wanted = r->dimensions, given = 0;
  for (char *end; given < wanted + 1; given++, line = end) {
    double value = strtod(line, &end);
    if (end == line) break;
    number[given == wanted ? 3 : given] = value;
  }
  if (given < wanted) return fail(r, "this is no point");
  if (!r->left) return fail(r, "more points than `points:` said");
  for (int i = 0; i < wanted; i++)
    if (!isfinite(number[i])) return fail(r, "this is no point");
  r->left--;
  Spline *spline = current(r);
  for (int times = 0; times < (number[3] >= 1 && number[3] <= DEGREE ? (int)number[3] : 1); times++)
    *VEC_PUSH(r->arena, &spline->points) = (SplinePoint){{number[0], number[1], number[2]}};
  return true;
}

// The oldest form of a contour: `4 2 closed`, and nothing else before its points.
static bool old_heading(Reader *r, const char *line) {
  char *end, *behind;
  long points = strtol(line, &end, 10), dimensions = strtol(end, &behind, 10);
  if (!r->curves || points < 1 || points > MOST_POINTS || dimensions < 2 || dimensions > 3 || behind == end)
    return fail(r, "this is no beginning of a contour or a function");
  if (!begin(r)) return false;
  current(r)->closed = strstr(behind, "closed") != NULL;
  r->left = (size_t)points;
  r->dimensions = (int)dimensions;
  return true;
}

static bool count(Reader *r, const char *value) {
  char *end;
  long points = strtol(value, &end, 10);
  if (end == value || points < 1 || points > MOST_POINTS) return fail(r, "`points:` is followed by their number");
  if (current(r)->points.count || r->left) return fail(r, "`points:` stands here a second time");
  r->left = (size_t)points;
  return true;
}

static bool samples(Reader *r, const char *value) {
  char *end;
  long given = strtol(value, &end, 10);
  if (end == value || given < 1 || given > SPLINE_MOST_SAMPLES) return fail(r, "`samples:` is a number up to 10000");
  current(r)->samples = (unsigned)given;
  return true;
}

// In words, or open, closed and regular, endpoint as one letter each. A closed one that begins and ends in its first
// point ends in a copy of it.
static void type(Reader *r, const char *text) {
  bool letters = (*text == 'o' || *text == 'c') && (text[1] == 'r' || text[1] == 'e') && (text[2] & 0x7f) <= ' ';
  current(r)->closed = letters ? *text == 'c' : strstr(text, "closed") != NULL;
  current(r)->clamped = !r->curves || (letters ? text[1] == 'e' : strstr(text, "endpoint") != NULL);
}

static bool heading(Reader *r, const char *line) {
  static const char *const idle[] = {
    "contact:", "end:", "heading:", "up:", "size:", "version:", "range:", "dimension:", "flip:"};
  if (begins_with(line, "funcgalleryver") || begins_with(line, "contourgalleryver") || begins_with(line, "items:"))
    return true;
  bool first = begins_with(line, r->curves ? "cver" : "fver");
  if ((first || !current(r)) && !begin(r)) return false;
  if (first) return true;
  if (begins_with(line, "points:")) return count(r, line + 7);
  if (begins_with(line, "samples:")) return samples(r, line + 8);
  if (begins_with(line, "name:")) {
    line += 5 + strspn(line + 5, " \t");
    current(r)->name = arena_copy(r->arena, line, strcspn(line, " \t\r\n"));
    return true;
  }
  if (begins_with(line, "type:")) {
    type(r, line + 5 + strspn(line + 5, " \t"));
    return true;
  }
  if (begins_with(line, "background") || begins_with(line, "markers:")) {  // the editor's
    r->idle = begins_with(line, "markers:") ? strtoul(line + 8, NULL, 10) : 1;
    return true;
  }
  for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
    if (begins_with(line, idle[i])) return true;
  return fail(r, r->curves ? "this is no line of a contour" : "this is no line of a function");
}

static bool read_line(Reader *r, const char *line) {
  if (r->idle) {
    r->idle--;
    return true;
  }
  line += strspn(line, " \t\r\n");
  if (!*line) return true;
  if (!strchr("+-.0123456789", *line)) return heading(r, line);
  return current(r) ? point(r, line) : old_heading(r, line);
}

static bool complete(Reader *r) {
  if (r->left) return fail(r, "the file ends before its last point");
  for (size_t i = 0; i < r->splines->count; i++) {
    Spline *spline = &r->splines->at[i];
    if (!spline->points.count) return fail(r, "there are no points");
    SplinePoint first = spline->points.at[0];
    if (r->curves && spline->closed && spline->clamped) *VEC_PUSH(r->arena, &spline->points) = first;
  }
  r->line = 0;
  return r->splines->count || fail(r, r->curves ? "there is no contour" : "there is no function");
}

bool splines_read(Arena *arena, const char *path, bool curves, Splines *splines, char *why, size_t size) {
  Reader r = {.arena = arena, .splines = splines, .curves = curves, .why = why, .size = size};
  const char *reason;
  FILE *file = lsys_input_open(path, &reason);
  if (!file) {
    snprintf(why, size, "%s", reason);
    return false;
  }
  char *line = NULL;
  size_t room = 0;
  bool good = true;
  while (good && getline(&line, &room, file) >= 0) {
    r.line++;
    good = read_line(&r, line);
  }
  if (good && ferror(file)) good = fail(&r, strerror(errno));
  free(line);
  fclose(file);
  return good && complete(&r);
}

// ---- values ------------------------------------------------------------------

// Points of the knot vector: those of a closed spline go on with its first ones.
static size_t points_of(const Spline *s) {
  return s->points.count + (s->closed && !s->clamped ? DEGREE : 0);
}

static unsigned degree_of(const Spline *s) {
  size_t points = points_of(s);
  return points > DEGREE ? DEGREE : (unsigned)points - 1;
}

static double knot(const Spline *s, size_t i) {
  size_t degree = degree_of(s), last = points_of(s) - degree;
  if (!s->clamped) return (double)i - (double)degree;
  return i < degree ? 0 : i - degree > last ? (double)last : (double)(i - degree);
}

// The point at t of 0 to 1, by de Boor's recursion.
static SplinePoint spline_at(const Spline *s, double t) {
  SplinePoint d[DEGREE + 1];
  unsigned degree = degree_of(s);
  size_t pieces = points_of(s) - degree;
  double u = t * (double)pieces;
  size_t piece = u < (double)pieces ? (size_t)u : pieces - 1;
  for (unsigned j = 0; j <= degree; j++) d[j] = s->points.at[(piece + j) % s->points.count];
  for (unsigned r = 1; r <= degree; r++)
    for (unsigned j = degree; j >= r; j--) {
      double low = knot(s, piece + j), high = knot(s, piece + j + degree + 1 - r);
      double share = high > low ? (u - low) / (high - low) : 0;
      for (int c = 0; c < 3; c++) d[j].at[c] = (1 - share) * d[j - 1].at[c] + share * d[j].at[c];
    }
  return d[degree];
}

void spline_function(const Spline *spline, double range[2], double *values) {
  enum { HALVINGS = 60 };
  range[0] = spline_at(spline, 0).at[0];
  range[1] = spline_at(spline, 1).at[0];
  for (unsigned i = 0; i <= spline->samples; i++) {
    double x = range[0] + (range[1] - range[0]) * i / spline->samples, low = 0, high = 1;
    for (int n = 0; n < HALVINGS; n++) {
      double middle = (low + high) / 2;
      if (spline_at(spline, middle).at[0] < x)
        low = middle;
      else
        high = middle;
    }
    values[i] = spline_at(spline, i == 0 ? 0 : i == spline->samples ? 1 : high).at[1];
  }
}

static double distance(SplinePoint a, SplinePoint b) {
  double x = a.at[0] - b.at[0], y = a.at[1] - b.at[1], z = a.at[2] - b.at[2];
  return sqrt(x * x + y * y + z * z);
}

double spline_curve(Arena *arena, const Spline *spline, double *const values[3]) {
  enum { STEPS = 16 };  // of measuring, for each sample
  size_t steps = (size_t)STEPS * spline->samples, at = 0;
  double *length = arena_array(arena, steps + 1, sizeof *length);
  for (size_t i = 1; i <= steps; i++)
    length[i] =
      length[i - 1]
      + distance(spline_at(spline, (double)(i - 1) / (double)steps), spline_at(spline, (double)i / (double)steps));
  for (unsigned i = 0; i <= spline->samples; i++) {
    double wanted = length[steps] * i / spline->samples;
    while (at + 1 < steps && length[at + 1] < wanted) at++;
    double piece = length[at + 1] - length[at], share = piece > 0 ? (wanted - length[at]) / piece : 0;
    SplinePoint p = spline_at(spline, i == spline->samples ? 1 : ((double)at + share) / (double)steps);
    for (int c = 0; c < 3; c++) values[c][i] = p.at[c];
  }
  return length[steps];
}
