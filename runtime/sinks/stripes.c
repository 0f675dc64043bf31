// stripes.c -- see stripes.h. Lines are collected until there are enough to share out; the stripes are then as high as
// makes each hold as many points.
#include "sinks/stripes.h"

#include "core/memory.h"
#include "core/team.h"

#include <stdlib.h>
#include <string.h>

enum { ENOUGH = 1 << 15, SAMPLES = 512 };  // points

typedef struct Line {
  size_t first, count;  // points
  LsysInk ink;
} Line;

struct LsysStripes {
  LsysRaster *raster;
  LsysMemory *memory;
  uint32_t height;
  LsysWorker worker;
  LsysTeam team;
  unsigned threads;
  int *border;  // stripe i: rows border[i] to border[i + 1] - 1
  LsysPoint *point;
  Line *line;
  size_t points, lines, point_room, line_room;
};

LsysStripes *lsys_stripes_open(const LsysPage *page, LsysRaster *raster) {
  LsysStripes *s = lsys_memory_alloc(page->memory, 1, sizeof *s);
  if (!s) return NULL;
  s->raster = raster;
  s->memory = page->memory;
  s->height = page->height;
  s->worker = (LsysWorker){.memory = page->memory, .run = {.memory = page->memory}};
  s->threads = page->threads;
  s->border = lsys_memory_alloc(s->memory, s->threads + 1, sizeof *s->border);
  if (s->border && lsys_team_open(&s->team, &s->worker, s->threads)) return s;
  lsys_stripes_close(s);
  return NULL;
}

static int by_size(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void choose_borders(LsysStripes *s) {
  double sample[SAMPLES];
  size_t step = (s->points + SAMPLES - 1) / SAMPLES, samples = 0;
  for (size_t i = 0; i < s->points; i += step) sample[samples++] = s->point[i].y;
  qsort(sample, samples, sizeof *sample, by_size);
  s->border[0] = 0;
  for (unsigned i = 1; i < s->threads; i++) {
    double y = sample[samples * i / s->threads];
    s->border[i] = y > s->border[i - 1] ? y < s->height ? (int)y : (int)s->height : s->border[i - 1];
  }
  s->border[s->threads] = (int)s->height;
}

static void draw_within(const LsysStripes *s, int from, int end) {
  for (size_t i = 0; i < s->lines; i++) {
    const Line *line = &s->line[i];
    s->raster->line_within(s->raster, s->point + line->first, line->count, &line->ink, from, end);
  }
}

static void draw_stripe(LsysMember *member, void *data, uint64_t i) {
  const LsysStripes *s = data;
  (void)member;
  draw_within(s, s->border[i], s->border[i + 1]);
}

bool lsys_stripes_draw(LsysStripes *s) {
  bool well = true;
  if (s->points < ENOUGH) {
    draw_within(s, 0, (int)s->height);
  } else {
    choose_borders(s);
    well = lsys_team_each(&s->team, s->threads, draw_stripe, s);
  }
  s->points = s->lines = 0;
  return well;
}

bool lsys_stripes_add(LsysStripes *s, const LsysPoint *point, size_t count, const LsysInk *ink) {
  if (!lsys_memory_fit(s->memory, &s->point, &s->point_room, s->points + count, sizeof *s->point)
      || !lsys_memory_fit(s->memory, &s->line, &s->line_room, s->lines + 1, sizeof *s->line))
    return false;
  memcpy(s->point + s->points, point, count * sizeof *point);
  s->line[s->lines++] = (Line){s->points, count, *ink};
  s->points += count;
  return s->points < ENOUGH || lsys_stripes_draw(s);
}

void lsys_stripes_close(LsysStripes *s) {
  if (!s) return;
  if (s->team.worker) lsys_team_close(&s->team);
  lsys_memory_free(s->memory, s->point, s->point_room, sizeof *s->point);
  lsys_memory_free(s->memory, s->line, s->line_room, sizeof *s->line);
  lsys_memory_free(s->memory, s->border, s->threads + 1, sizeof *s->border);
  lsys_memory_free(s->memory, s, 1, sizeof *s);
}
