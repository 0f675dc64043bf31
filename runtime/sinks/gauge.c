// gauge.c -- see gauge.h. Batches of strokes are copied into the blocks of a press, measured one by one on any thread,
// and joined in their order; what is rarer is measured at once. As a measure adds up the lengths of a batch by
// themselves, too, the sums are the same to the last bit.
#include "sinks/gauge.h"

#include <string.h>

enum { BATCHES = 4 };  // of a block

// In a block, before its strokes and points.
typedef struct Head {
  uint64_t strokes, points;
} Head;

static bool measure_block(const void *data, const void *block, size_t size, LsysPrepared *to) {
  (void)data;
  for (const char *at = block, *end = at + size; at < end;) {
    const Head *head = (const Head *)(const void *)at;
    const LsysStroke *stroke = (const LsysStroke *)(const void *)(at + sizeof *head);
    const LsysVec3 *point = (const LsysVec3 *)(const void *)(stroke + head->strokes);
    at = (const char *)(point + head->points);
    LsysMeasure measure;
    lsys_measure_begin(&measure, true);
    LsysStrokes batch = {point, stroke, head->strokes, head->points};
    measure.geometry.strokes(&measure.geometry, &batch);
    char *room = lsys_prepared_room(to, sizeof measure);
    if (!room) return false;
    memcpy(room, &measure, sizeof measure);
    to->used += sizeof measure;
  }
  return true;
}

static bool join_block(void *data, const LsysPrepared *measures) {
  LsysGauge *gauge = data;
  for (size_t at = 0; at < measures->used; at += sizeof(LsysMeasure)) {
    LsysMeasure measure;
    memcpy(&measure, measures->data + at, sizeof measure);
    lsys_measure_join(&gauge->measure, &measure);
  }
  return true;
}

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysGauge *gauge = (LsysGauge *)to;
  const Head head = {batch->count, batch->points};
  size_t of_strokes = batch->count * sizeof *batch->stroke, of_points = batch->points * sizeof *batch->point;
  char *at = lsys_press_add(gauge->press, sizeof head + of_strokes + of_points);
  if (!at) return false;
  memcpy(at, &head, sizeof head);
  memcpy(at + sizeof head, batch->stroke, of_strokes);
  memcpy(at + sizeof head + of_strokes, batch->point, of_points);
  return ++gauge->batches % BATCHES || lsys_press_send(gauge->press);
}

static bool polygon(LsysGeometry *to, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  LsysGeometry *measure = &((LsysGauge *)to)->measure.geometry;
  return measure->polygon(measure, vertices, count, pen);
}

static bool mesh(LsysGeometry *to, const LsysMesh *mesh, const LsysPlace *place, const LsysPen *pen) {
  LsysGeometry *measure = &((LsysGauge *)to)->measure.geometry;
  return measure->mesh(measure, mesh, place, pen);
}

static bool ball(LsysGeometry *to, const LsysVec3 *centre, double diameter, bool disc, const LsysPen *pen) {
  LsysGeometry *measure = &((LsysGauge *)to)->measure.geometry;
  return measure->ball(measure, centre, diameter, disc, pen);
}

static bool label(LsysGeometry *to, const LsysVec3 *at, const char *text, const LsysPen *pen) {
  LsysGeometry *measure = &((LsysGauge *)to)->measure.geometry;
  return measure->label(measure, at, text, pen);
}

LsysGeometry *lsys_gauge_begin(LsysGauge *gauge, LsysMemory *memory, unsigned threads) {
  lsys_measure_begin(&gauge->measure, true);
  if (threads <= 1) return &gauge->measure.geometry;
  if (!gauge->press) gauge->press = lsys_press_open(memory, threads, measure_block, join_block, gauge);
  gauge->geometry = (LsysGeometry){strokes, polygon, mesh, ball, label};
  return gauge->press ? &gauge->geometry : NULL;
}

bool lsys_gauge_end(LsysGauge *gauge) {
  return !gauge->press || lsys_press_finish(gauge->press);
}

void lsys_gauge_close(LsysGauge *gauge) {
  lsys_press_close(gauge->press);
  gauge->press = NULL;
}
