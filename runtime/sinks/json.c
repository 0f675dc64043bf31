// json.c -- segments and polygons as numbers, for programs of the user's own:
//   {"figures": [{"axiom": 1, "segments": [[x,y,z, x,y,z, width, colour, depth], ...],
//     "polygons": [[colour, [x,y,z], ...], ...], "labels": [[colour, [x,y,z], "text"], ...]}, ...]}
// Segments come as they are drawn; polygons and labels wait until the figure ends. By age, the last number of a segment
// is the step in which its module was born, and colours go from 0 to 255 with it.
#include "core/formats.h"
#include "core/message.h"
#include "core/options.h"
#include "lsys/number.h"
#include "sinks/colours.h"
#include "sinks/press.h"
#include "sinks/spool.h"
#include "turtle/turtle.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 1024 };  // segments that are made into text at once

typedef struct Segment {
  LsysVec3 from, to;
  double width;
  uint32_t mark;
  uint8_t colour;
  bool later;  // than the first one of its figure
} Segment;

typedef struct JsonSink {
  LsysSink sink;
  LsysGeometry geometry;
  LsysOut *out;
  LsysTurtle *turtle;
  LsysColours colours;
  LsysRecolour recolour;
  LsysPress *press;  // of segments
  LsysSpool polygons, labels;
  uint64_t segments;  // of the figure
  bool later_figure, later_polygon, later_label;
} JsonSink;

static JsonSink *sink_of(LsysGeometry *geometry) {
  return (JsonSink *)((char *)geometry - offsetof(JsonSink, geometry));
}

// JSON has no numbers that are not finite.
static char *put_real(char *to, double x) {
  if (!(x - x == 0)) x = 0;
  return lsys_number_print(to, x);
}

static char *put_point(char *to, const LsysVec3 *p) {
  to = put_real(to, p->x);
  *to++ = ',';
  to = put_real(to, p->y);
  *to++ = ',';
  return put_real(to, p->z);
}

static bool same_place(const LsysVec3 *a, const LsysVec3 *b) {
  return memcmp(a, b, sizeof *a) == 0;
}

static bool put_segments(const void *data, const void *block, size_t size, LsysPrepared *to) {
  (void)data;
  const Segment *segment = block;
  char last[3 * LSYS_NUMBER_SIZE];  // where the segment before ended
  size_t last_size = 0;
  for (size_t i = 0; i < size / sizeof *segment; i++) {
    const Segment *s = &segment[i];
    char *room = lsys_prepared_room(to, 16 * LSYS_NUMBER_SIZE), *at = room;
    if (!room) return false;
    if (s->later) *at++ = ',';
    *at++ = '\n';
    *at++ = '[';
    if (i && same_place(&s->from, &s[-1].to)) {
      memcpy(at, last, last_size);
      at += last_size;
    } else {
      at = put_point(at, &s->from);
    }
    *at++ = ',';
    char *end = put_point(at, &s->to);
    last_size = (size_t)(end - at);
    memcpy(last, at, last_size);
    at = end;
    *at++ = ',';
    at = put_real(at, s->width);
    *at++ = ',';
    at = lsys_whole_print(at, s->colour);
    *at++ = ',';
    at = lsys_whole_print(at, s->mark);
    *at++ = ']';
    to->used += (size_t)(at - room);
  }
  return true;
}

static bool write_segments(void *data, const LsysPrepared *text) {
  return lsys_out_write(((JsonSink *)data)->out, text->data, text->used);
}

static bool add_segment(JsonSink *j, const LsysVec3 *p, const LsysPen *pen) {
  Segment *s = lsys_press_add(j->press, sizeof *s);
  if (!s) return false;
  *s = (Segment){p[0], p[1], pen->width, pen->mark, pen->colour, j->segments > 0};
  return ++j->segments % BLOCK || lsys_press_send(j->press);
}

static bool strokes(LsysGeometry *geometry, const LsysStrokes *batch) {
  JsonSink *j = sink_of(geometry);
  for (size_t i = 0; i < batch->count; i++) {
    const LsysStroke *s = &batch->stroke[i];
    const LsysVec3 *p = batch->point + s->first;
    for (uint32_t k = 1; k < s->count; k++)
      if (!add_segment(j, &p[k - 1], &s->pen)) return false;
  }
  return true;
}

static bool polygon(LsysGeometry *geometry, const LsysVec3 *vertices, size_t count, const LsysPen *pen) {
  JsonSink *j = sink_of(geometry);
  char text[4 * LSYS_NUMBER_SIZE], *to = text;
  to += sprintf(to, "%s\n[%u", j->later_polygon ? "," : "", pen->colour);
  j->later_polygon = true;
  bool well = lsys_spool_write(&j->polygons, text, (size_t)(to - text));
  for (size_t i = 0; well && i < count; i++) {
    to = text;
    *to++ = ',';
    *to++ = '[';
    to = put_point(to, &vertices[i]);
    *to++ = ']';
    well = lsys_spool_write(&j->polygons, text, (size_t)(to - text));
  }
  return well && lsys_spool_write(&j->polygons, "]", 1);
}

// Of a text, one character as it stands in quotes.
static char *put_character(char *to, char c) {
  unsigned char byte = (unsigned char)c;
  if (byte < ' ') return to + sprintf(to, "\\u%04x", byte);
  if (c == '"' || c == '\\') *to++ = '\\';
  *to++ = c;
  return to;
}

static bool label(LsysGeometry *geometry, const LsysVec3 *at, const char *said, const LsysPen *pen) {
  JsonSink *j = sink_of(geometry);
  char text[4 * LSYS_NUMBER_SIZE], *to = text;
  to += sprintf(to, "%s\n[%u,[", j->later_label ? "," : "", pen->colour);
  j->later_label = true;
  to = put_point(to, at);
  to += sprintf(to, "],\"");
  bool well = lsys_spool_write(&j->labels, text, (size_t)(to - text));
  for (; well && *said; said++) well = lsys_spool_write(&j->labels, text, (size_t)(put_character(text, *said) - text));
  return well && lsys_spool_write(&j->labels, "\"]", 2);
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)pass;
  JsonSink *j = (JsonSink *)sink;
  if (!j->turtle) j->turtle = lsys_turtle_create(run);
  if (!j->press) j->press = lsys_press_open(run->memory, run->threads, put_segments, write_segments, j);
  if (!j->turtle || !j->press || !lsys_spool_open(&j->polygons) || !lsys_spool_open(&j->labels)) return false;
  if (j->colours.by != LSYS_BY_AGE) lsys_turtle_by_depth(j->turtle);
  lsys_turtle_begin(j->turtle, axiom,
                    lsys_recolour_begin(&j->recolour, &j->colours, 0, run->steps, j->turtle, &j->geometry));
  j->segments = 0;
  j->later_polygon = j->later_label = false;
  lsys_out_print(j->out, "%s{\"axiom\": %u, \"segments\": [", j->later_figure ? ",\n" : "{\"figures\": [\n", axiom + 1);
  j->later_figure = true;
  return true;
}

static bool take(LsysSink *sink, const LsysWord *part) {
  return lsys_turtle_take(((JsonSink *)sink)->turtle, part);
}

static bool end(LsysSink *sink) {
  JsonSink *j = (JsonSink *)sink;
  bool well = lsys_turtle_end(j->turtle) && lsys_press_finish(j->press) && lsys_out_print(j->out, "],\n\"polygons\": [")
           && lsys_spool_copy(&j->polygons, j->out) && lsys_out_print(j->out, "],\n\"labels\": [")
           && lsys_spool_copy(&j->labels, j->out) && lsys_out_print(j->out, "]}");
  lsys_spool_close(&j->polygons);
  lsys_spool_close(&j->labels);
  return well;
}

static bool finish(LsysSink *sink) {
  JsonSink *j = (JsonSink *)sink;
  return lsys_out_print(j->out, j->later_figure ? "]}\n" : "{\"figures\": []}\n");
}

static void destroy(LsysSink *sink) {
  JsonSink *j = (JsonSink *)sink;
  lsys_turtle_destroy(j->turtle);
  lsys_press_close(j->press);
  lsys_spool_close(&j->polygons);
  lsys_spool_close(&j->labels);
  free(j);
}

// There are no colours to give before all segments are counted.
static bool read_colours(const LsysOptions *options, LsysColours *colours) {
  if (!lsys_colours_read(options, colours)) return false;
  if (colours->by != LSYS_BY_PROGRESS) return true;
  lsys_error("--colour-by progress: json tells segments in the order in which they are drawn, and has pen, order, "
             "kind and age");
  return false;
}

LsysSink *lsys_sink_json(const LsysSinkContext *context) {
  LsysColours colours;
  if (!read_colours(context->options, &colours)) return NULL;
  JsonSink *j = calloc(1, sizeof *j);
  if (!j) {
    lsys_error("out of memory");
    return NULL;
  }
  j->sink = (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  j->geometry = (LsysGeometry){.strokes = strokes, .polygon = polygon, .label = label};
  j->out = context->out;
  j->colours = colours;
  return &j->sink;
}
