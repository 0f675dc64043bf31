// look.c -- the look at the word before a step: the turtle reads it, with its homomorphism, from query to query.
//
// Requires: a grammar with LSYS_GRAMMAR_QUERIES. Ensures: the arguments of queries and communication modules are set,
// nothing else changes. All memory that it takes hangs on the run and is booked.
// Source: Mech and Prusinkiewicz, Visual models of plants interacting with their environment, SIGGRAPH 96.
#include "core/cut.h"
#include "core/message.h"
#include "environment/environment.h"
#include "turtle/turtle.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

typedef double Line[6];

typedef struct LsysSurroundings {
  LsysGeometry lines;  // first: what the turtle draws comes here
  LsysSink feed;       // what the homomorphism shows goes to the turtle
  LsysWorker *worker;
  LsysTurtle *turtle;
  LsysWriter writer;  // into feed
  bool shows;         // there is a homomorphism, and writer is open
  LsysEnvironment environment;
  void *library;
  LsysScene scene;
  LsysCommunication *message;
  Line *line;
  void *scratch;
  size_t message_room, line_room, scratch_room;
} LsysSurroundings;

// ---- environments --------------------------------------------------------------

static const LsysEnvironment built_in[LSYS_ENVIRONMENT_COUNT] = {
  [LSYS_ENVIRONMENT_POINT] = {LSYS_ENVIRONMENT_VERSION, 0, environment_point},
  [LSYS_ENVIRONMENT_OCCUPANCY] = {LSYS_ENVIRONMENT_VERSION, LSYS_ENVIRONMENT_LINES, environment_occupancy},
  [LSYS_ENVIRONMENT_LIGHT] = {LSYS_ENVIRONMENT_VERSION, 0, environment_light},
  [LSYS_ENVIRONMENT_TERRAIN] = {LSYS_ENVIRONMENT_VERSION, 0, environment_terrain},
};

const LsysEnvironmentInfo lsys_environment_table[LSYS_ENVIRONMENT_COUNT] = {
  [LSYS_ENVIRONMENT_NONE] = {"none", {"", ""}, {0, 0}, "?E keeps its arguments"},
#define ENVIRONMENT(id, name, first, first_value, second, second_value, doc)                                           \
  [LSYS_ENVIRONMENT_##id] = {name, {first, second}, {first_value, second_value}, doc},
#include "lsys/environments.def"
};

// A name without a slash is looked for where libraries are, and then here.
static void *open_library(const char *path) {
  void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  char here[PATH_MAX];
  if (library || strchr(path, '/') || (size_t)snprintf(here, sizeof here, "./%s", path) >= sizeof here) return library;
  return dlopen(here, RTLD_NOW | RTLD_LOCAL);
}

static bool load(LsysSurroundings *s, const char *path) {
  s->library = open_library(path);
  const LsysEnvironment *found = s->library ? dlsym(s->library, "lsys_environment") : NULL;
  if (!found) {
    lsys_error("cannot load the environment: %s", dlerror());
    return false;
  }
  s->environment = *found;
  if (found->version == LSYS_ENVIRONMENT_VERSION && found->answer) return true;
  lsys_error("the environment %s was made for another version of lsysc", path);
  return false;
}

// ---- what the turtle draws -------------------------------------------------------

static bool strokes(LsysGeometry *to, const LsysStrokes *batch) {
  LsysSurroundings *s = (LsysSurroundings *)to;
  for (size_t i = 0; i < batch->count; i++) {
    const LsysVec3 *point = batch->point + batch->stroke[i].first;
    for (uint32_t k = 1; k < batch->stroke[i].count; k++) {
      while (s->scene.lines == s->line_room) {
        void *grown = lsys_memory_grow(s->worker->memory, s->line, &s->line_room, sizeof *s->line);
        if (!grown) return false;
        s->line = grown;
      }
      const Line line = {point[k - 1].x, point[k - 1].y, point[k - 1].z, point[k].x, point[k].y, point[k].z};
      memcpy(s->line[s->scene.lines++], line, sizeof line);
    }
  }
  return true;
}

static bool feed(LsysSink *sink, const LsysWord *part) {
  LsysSurroundings *s = (LsysSurroundings *)((char *)sink - offsetof(LsysSurroundings, feed));
  return lsys_turtle_take(s->turtle, part);
}

static void show(LsysSurroundings *s, const LsysWord *part) {
  if (!part->nsym) return;
  bool well = true;
  if (s->shows) {
    s->worker->run.grammar->homomorphism(&s->worker->run, part, &s->writer.stream);
    lsys_flush(&s->writer.stream);
  } else {
    well = lsys_turtle_take(s->turtle, part);
  }
  if (!well) longjmp(s->worker->stop, 1);
}

// ---- queries -----------------------------------------------------------------------

// -0 is 0 there.
static void put(double to[3], LsysVec3 from) {
  to[0] = from.x + 0.0;
  to[1] = from.y + 0.0;
  to[2] = from.z + 0.0;
}

static void tell(double *argument, uint32_t arity, const double *values, uint32_t count) {
  for (uint32_t i = 0; i < arity && i < count; i++) argument[i] = values[i];
}

static void add_message(LsysSurroundings *s, const LsysCommunication *message) {
  while (s->scene.messages == s->message_room) {
    void *grown = lsys_memory_grow(s->worker->memory, s->message, &s->message_room, sizeof *s->message);
    if (!grown) longjmp(s->worker->stop, 1);
    s->message = grown;
  }
  s->message[s->scene.messages++] = *message;
}

// The module is a query: it gets its answer, or waits for the environment's.
static void ask(LsysSurroundings *s, uint8_t turtle, double *argument, uint32_t arity, uint64_t module) {
  LsysPose pose = lsys_turtle_pose(s->turtle);
  LsysCommunication message = {.width = pose.width, .module = module, .arity = arity, .argument = argument};
  LsysVec3 drawn;
  message.lines = lsys_turtle_drawn(s->turtle, &drawn);
  put(message.at, pose.at);
  put(message.heading, pose.h);
  put(message.left, pose.l);
  put(message.up, pose.u);
  put(message.drawn, drawn);
  double frame[9];
  memcpy(frame, message.heading, sizeof message.heading);
  memcpy(frame + 3, message.left, sizeof message.left);
  memcpy(frame + 6, message.up, sizeof message.up);
  switch ((LsysTurtleOp)turtle) {
  case LSYS_TURTLE_QUERY_PLACE:
    tell(argument, arity, message.at, 3);
    break;
  case LSYS_TURTLE_QUERY_HEADING:
    tell(argument, arity, frame, 3);
    break;
  case LSYS_TURTLE_QUERY_LEFT:
    tell(argument, arity, frame + 3, 3);
    break;
  case LSYS_TURTLE_QUERY_UP:
    tell(argument, arity, frame + 6, 3);
    break;
  case LSYS_TURTLE_QUERY_FRAME:
    tell(argument, arity, frame, 9);
    break;
  default:
    if (s->environment.answer) add_message(s, &message);
    break;
  }
}

static bool is_query(uint8_t turtle) {
  return turtle >= LSYS_TURTLE_QUERY_PLACE && turtle <= LSYS_TURTLE_QUERY_ENVIRONMENT;
}

// ---- the look ----------------------------------------------------------------------

static void *room(LsysScene *scene, size_t bytes) {
  LsysSurroundings *s = (LsysSurroundings *)((char *)scene - offsetof(LsysSurroundings, scene));
  while (!s->scratch || s->scratch_room < bytes) {
    void *grown = lsys_memory_grow(s->worker->memory, s->scratch, &s->scratch_room, 1);
    if (!grown) return NULL;
    s->scratch = grown;
  }
  return s->scratch;
}

static bool set_up(LsysSurroundings *s, LsysWorker *worker) {
  const LsysGrammar *grammar = worker->run.grammar;
  s->worker = worker;
  s->lines = (LsysGeometry){0};
  s->feed = (LsysSink){.passes = 1, .take = feed};
  s->scene.parameter = grammar->environment_value;
  s->scene.room = room;
  if (grammar->flags & LSYS_GRAMMAR_WHOLE) {
    lsys_error("the turtle cannot be asked where the homomorphism has contexts, or there are several L-systems");
    return false;
  }
  if (grammar->environment == LSYS_ENVIRONMENT_FILE) {
    if (!load(s, grammar->environment_path)) return false;
  } else {
    s->environment = built_in[grammar->environment];
  }
  if (s->environment.wants & LSYS_ENVIRONMENT_LINES) s->lines.strokes = strokes;
  if (!(s->turtle = lsys_turtle_create(&worker->run))) return false;
  lsys_turtle_watch(s->turtle);
  if (grammar->homomorphism && !lsys_writer_open(&s->writer, worker, &s->feed)) return false;
  s->shows = grammar->homomorphism;
  return true;
}

static LsysSurroundings *surroundings(LsysRun *run) {
  LsysWorker *worker = (LsysWorker *)run;
  if (!run->surroundings) {
    run->surroundings = lsys_memory_alloc(worker->memory, 1, sizeof *run->surroundings);
    if (!run->surroundings || !set_up(run->surroundings, worker)) longjmp(worker->stop, 1);
  }
  return run->surroundings;
}

void lsys_look(LsysRun *run, const LsysWord *word, double *argument) {
  const LsysGrammar *grammar = run->grammar;
  if (!(grammar->flags & LSYS_GRAMMAR_QUERIES)) return;
  LsysSurroundings *s = surroundings(run);
  bool wide = grammar->flags & LSYS_GRAMMAR_WIDE;
  s->scene.messages = s->scene.lines = 0;
  lsys_turtle_begin(s->turtle, 0, &s->lines);
  LsysCut cut;
  lsys_cut_begin(&cut, grammar, word);
  for (uint64_t at = 0; at < word->nsym;) {
    uint64_t end = at;
    const LsysKind *kind = NULL;
    for (; end < word->nsym; end++) {
      uint32_t symbol = wide ? word->sym[2 * end] | (uint32_t)word->sym[2 * end + 1] << 8 : word->sym[end];
      kind = &grammar->kinds[symbol];
      if (is_query(kind->turtle)) break;
    }
    LsysWord part = lsys_cut_take(&cut, end - at);
    show(s, &part);
    at = end;
    if (at == word->nsym) break;
    part = lsys_cut_take(&cut, 1);
    ask(s, kind->turtle, argument + (part.arg - word->arg), kind->arity, at++);
    show(s, &part);
  }
  if (!lsys_turtle_end(s->turtle)) longjmp(s->worker->stop, 1);
  s->scene.message = s->message;
  s->scene.line = (const double(*)[6])s->line;
  if (s->scene.messages && !s->environment.answer(&s->scene)) longjmp(s->worker->stop, 1);
}

void lsys_look_end(LsysRun *run) {
  LsysSurroundings *s = run->surroundings;
  if (!s) return;
  LsysMemory *memory = ((LsysWorker *)run)->memory;
  if (s->writer.stream.run) lsys_writer_close(&s->writer);
  lsys_turtle_destroy(s->turtle);
  if (s->library) dlclose(s->library);
  lsys_memory_free(memory, s->message, s->message_room, sizeof *s->message);
  lsys_memory_free(memory, s->line, s->line_room, sizeof *s->line);
  lsys_memory_free(memory, s->scratch, s->scratch_room, 1);
  lsys_memory_free(memory, s, 1, sizeof *s);
  run->surroundings = NULL;
}
