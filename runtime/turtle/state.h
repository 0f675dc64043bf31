// state.h -- the turtle's insides, shared by turtle.c (words in), plain.c (the
// fast loop), trail.c (words that come again), act.c (one module) and strokes.c (batches out).
#ifndef LSYS_TURTLE_STATE_H
#define LSYS_TURTLE_STATE_H

#include "lsys/settings.h"
#include "turtle/directions.h"
#include "turtle/turtle.h"
#include "turtle/vector.h"

enum {
  BATCH_POINTS = 2048,            // points of one batch; 48 KiB, it stays in the second-level cache
  BATCH_FULL = BATCH_POINTS - 3,  // points behind which it is handed on: a module adds three at most
  MOST_SIDES = 64,                // of a generalised cylinder
  STRAIGHTEN_TURNS = 64,          // rotations of a frame after which it is made orthonormal again
};

// A place that a generalised cylinder goes through.
typedef struct SweepNode {
  LsysVec3 place, heading, left;
  double radius;
} SweepNode;

typedef struct SweepPatch {
  double number;
  bool bspline;
  LsysVec3 control[16];
} SweepPatch;

// What sweep.c works with: the nodes of the open `{(n)`, patches by number, and room for a mesh.
typedef struct Sweep {
  SweepNode *node;
  SweepPatch *patch;
  LsysVec3 *vertex, *normal;
  uint32_t *corner;
  size_t nodes, node_room, patches, patch_room, vertex_room, normal_room, corner_room;
} Sweep;

// What `[` saves. The first part suffices for a flat turtle whose turns are all in
// the table of directions and whose lengths are all the default one.
typedef struct State {
  Pair at;           // place in the page, in the coordinates of Turtle.lattice
  double width;      // >= 0
  uint32_t heading;  // index into Turtle.directions
  uint8_t colour;
  bool swapped;                        // @x: + turns right
  uint16_t turned;                     // rotations since the frame was straightened
  double z;                            // ---- from here on saved only by turtles that need it
  double extra;                        // degrees that the turtle is turned beyond directions[heading]
  Pair direction;                      // its heading, where extra is not 0
  double second;                       // degrees of the second direction (@a), from +x
  double scale;                        // of default lengths (@s)
  double size;                         // of all lengths and widths (@D)
  double elasticity;                   // how much moves bend towards the tropism
  Frame frame;                         // of a turtle that leaves the page
  double elasticities[LSYS_TROPISMS];  // ---- and from here on only by those that untwist: of numbered tropisms
  Frame kept;                          // the frame at the last line or @Tf
  SweepNode node;                      // ---- and from here on only by those that sweep: the last node of @Gs
  double tangent[2];                   // lengths of tangents, in distances between nodes
  bool sweeping;                       // between @Gs and @Ge
  uint8_t contour, sides;
  LsysVec3 drawn;  // of a turtle that watches: the end of the last line on the way here,
  uint32_t lines;  //   and how many there are
} State;

enum {
  STATE_SMALL = offsetof(State, z),
  STATE_MEDIUM = offsetof(State, elasticities),
  STATE_UNTWIST = offsetof(State, node)
};

// A numbered tropism.
typedef struct Tropism {
  LsysVec3 towards;
  double cosine, sine;  // of the angle to it that the heading bends to
  double step;          // of @Ti and @Td without a second argument
  bool torque;          // it rolls, and does not bend
} Tropism;

// What the fast loop does for a kind of modules.
typedef enum PlainAct {
  PLAIN_GO,  // turns, moves and draws without arguments; nothing
  PLAIN_PUSH,
  PLAIN_POP,
  PLAIN_JUMP,      // moves without drawing
  PLAIN_DRAW_ARG,  // as far as the argument says
  PLAIN_JUMP_ARG,
  PLAIN_TURN_ARG,
  PLAIN_SKIP,  // nothing, but has arguments
  PLAIN_OTHER,
} PlainAct;

typedef struct PlainKind {
  double move;      // in lattice units; -1: PLAIN_TURN_ARG to the right
  uint32_t turn;    // indices of the table of directions
  uint8_t advance;  // bytes of the point that is kept: 0 where nothing is drawn
  uint8_t act;      // PlainAct
  uint16_t skip;    // number of arguments
} PlainKind;

typedef struct KindInfo {
  uint8_t op;        // LsysTurtleOp
  uint8_t arity;     // saturates at 255
  uint16_t width;    // arity, exact
  uint8_t colour;    // with by_kind: of what comes next
  uint32_t surface;  // the grammar's surface of this name, or NO_SURFACE
  const char *text;  // what a label says, or NULL
} KindInfo;

enum { NO_SURFACE = UINT16_MAX, KEEP_COLOUR = UINT8_MAX };

struct LsysTurtle {
  const LsysRun *run;
  LsysGeometry *to;
  State state;

  bool flat;          // directions are those of the table, z stays 0; else the frame
  bool in_page;       // z stays 0
  bool plain;         // the fast loop can be used
  bool sweeps;        // it has generalised cylinders: widths are lengths
  bool splining;      // inside `{(n)`, which is no polygon
  bool skip_next;     // the module behind `~`
  bool by_kind;       // colours come from kinds (KindInfo.colour)
  bool by_depth;      // strokes end where brackets begin, too, and know how deep they are
  bool by_age;        // strokes know when they were born
  uint32_t born;      //   of the part that is being read
  size_t state_size;  // bytes of State that brackets save

  double angle, step;                               // defaults; step in lattice units
  double turn_cos, turn_sin;                        // of the default angle
  double width_step, colour_step, elasticity_step;  // of symbols without an argument; width_step nan: by a ratio
  LsysVec3 tropism;
  Tropism numbered[LSYS_TROPISMS];
  uint32_t tropisms;  // up to the last one in use
  bool untwists;      // State.kept is kept
  bool clockwise;     // turns:
  bool watches;       // State.drawn and lines are kept
  bool to_points;     // F(x,y) draws to the point (x,y)
  State start;
  Directions directions;
  KindInfo *kind;
  PlainKind *plain_kind;
  struct Trails *trails;  // of blocks (trail.c)

  // Saved states, state_size bytes each.
  unsigned char *stack;
  size_t depth, stack_room;

  // The open batch. Points open .. points-1 are the stroke that is being drawn; there is at
  // least one, where it began. Points are in lattice coordinates until the batch is handed on.
  LsysVec3 *point;
  LsysStroke *stroke;
  uint32_t points, open, strokes;
  bool joined;  // the open stroke goes on from the one before it

  // Vertices of open polygons, one polygon behind the other; polygon[i] is where number i begins.
  LsysVec3 *vertex;
  size_t *polygon;
  size_t vertices, vertex_room, polygons, polygon_room;

  Sweep sweep;

  uint32_t axiom;
  uint64_t read;           // modules before the current one
  uint64_t polygon_place;  // of the last `{`
  uint32_t warned;         // bit i: warning i was printed
};

// strokes.c. Each returns false to stop.
bool turtle_flush(LsysTurtle *t);       // hands on the batch; the open stroke goes on
void turtle_jump(LsysTurtle *t);        // the turtle stands somewhere else: a new stroke begins
void turtle_change_pen(LsysTurtle *t);  // before width or colour change
void turtle_draw_to(LsysTurtle *t);     // the turtle went to state.at with the pen down
LsysVec3 turtle_out(const LsysTurtle *t, LsysVec3 p);

// act.c: what one module does. False to stop.
bool turtle_act(LsysTurtle *t, uint32_t kind, const double *arg);
bool turtle_push(LsysTurtle *t);
bool turtle_pop(LsysTurtle *t);

// Does the state allow the fast loop? Turns and lengths have to mean what its table says.
static inline bool turtle_is_plain(const LsysTurtle *t) {
  const State *s = &t->state;
  return t->plain && s->extra == 0 && s->scale == 1 && s->size == 1 && !s->swapped && !t->skip_next && !t->polygons
      && !t->splining;
}

// plain.c: reads modules while they are plain, and their arguments; returns how many. Sets *ok to false to stop.
size_t turtle_read_plain(LsysTurtle *t, const uint8_t *sym, const double **arg, size_t count, bool *ok);

// turtle.c: a setting's value; its default where it is nan or infinite.
double turtle_setting(const LsysRun *run, LsysSetting which);

// tropism.c: reads the settings of numbered tropisms. False: they make the turtle leave the page.
bool turtle_set_tropisms(LsysTurtle *t, const LsysRun *run, double *elasticities);

typedef enum TurtleWarning {
  WARN_POP,
  WARN_CLOSE,
  WARN_NOT_FINITE,
  WARN_OPEN_POLYGON,
  WARN_TROPISM,
  WARN_SWEEP,
  WARN_PATCH,
  WARN_CONTOUR,
} TurtleWarning;

// Prints a warning about the current module, once for each kind of warning.
void turtle_warn(LsysTurtle *t, TurtleWarning which, uint64_t place, const char *text);

// Grows *array to hold at least count elements. False after printing that memory ran out.
bool turtle_grow(LsysTurtle *t, void *array, size_t *room, size_t count, size_t size);

#endif
