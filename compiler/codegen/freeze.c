// freeze.c -- the in-memory LsysGrammar -> the module's one exported constant,
// with the compiled functions filled in.
// Invariant: fields stand in the order of abi.h, which is checked against the
// offsets that this compiler was built with. Runs last: room_sym and frame_bytes
// are what emission asked for.
#include "codegen/ir.h"

#include <stddef.h>
#include <string.h>

static LLVMValueRef int_of(LLVMTypeRef type, uint64_t value) {
  return LLVMConstInt(type, value, false);
}

static LLVMValueRef text(Ir *ir, const char *string) {
  if (!string) return LLVMConstNull(ir->types.ptr);
  return ir_data(ir, LLVMConstStringInContext2(ir->context, string, strlen(string), false), "text");
}

// count structs of a mirror type, each made of its fields' values.
static LLVMValueRef structs(Ir *ir, LLVMTypeRef type, LLVMValueRef *values, size_t count, const char *name) {
  if (count == 0) return LLVMConstNull(ir->types.ptr);
  return ir_data(ir, LLVMConstArray2(type, values, count), name);
}

static LLVMValueRef bytes(Ir *ir, const uint8_t *at, uint64_t count, const char *name) {
  if (!at || count == 0) return LLVMConstNull(ir->types.ptr);
  LLVMValueRef data = ir_data(ir, LLVMConstStringInContext2(ir->context, (const char *)at, count, true), name);
  LLVMSetAlignment(data, 16);
  return data;
}

static LLVMValueRef kinds(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMValueRef *rows = arena_array(ir->arena, g->kind_count, sizeof *rows);
  for (uint32_t i = 0; i < g->kind_count; i++) {
    const LsysKind *kind = &g->kinds[i];
    LLVMValueRef fields[] = {text(ir, kind->symbol), int_of(ir->types.i16, kind->arity),
                             int_of(ir->types.i8, kind->turtle), int_of(ir->types.i8, kind->flags)};
    rows[i] = LLVMConstNamedStruct(ir->types.kind, fields, 4);
  }
  return structs(ir, ir->types.kind, rows, g->kind_count, "kinds");
}

static LLVMValueRef params(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMValueRef *rows = arena_array(ir->arena, g->param_count, sizeof *rows);
  for (uint32_t i = 0; i < g->param_count; i++) {
    const LsysParam *param = &g->params[i];
    LLVMValueRef fields[] = {text(ir, param->name), int_of(ir->types.i32, param->value), ir_double(ir, param->low),
                             ir_double(ir, param->high), text(ir, param->text)};
    rows[i] = LLVMConstNamedStruct(ir->types.param, fields, 5);
  }
  return structs(ir, ir->types.param, rows, g->param_count, "params");
}

static LLVMValueRef doubles(Ir *ir, const double *at, uint64_t count) {
  LLVMValueRef *values = arena_array(ir->arena, count, sizeof *values);
  for (uint64_t i = 0; i < count; i++) values[i] = ir_double(ir, at[i]);
  return structs(ir, ir->types.f64, values, count, "arg");
}

static LLVMValueRef axioms(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMValueRef *rows = arena_array(ir->arena, g->axiom_count, sizeof *rows);
  uint64_t width = g->flags & LSYS_GRAMMAR_WIDE ? 2 : 1;
  for (uint32_t i = 0; i < g->axiom_count; i++) {
    const LsysWord *word = &g->axioms[i].word;
    LLVMValueRef fields[] = {bytes(ir, word->sym, word->nsym * width, "sym"),
                             doubles(ir, word->arg, word->narg),
                             LLVMConstNull(ir->types.ptr),
                             ir_int(ir, word->nsym),
                             ir_int(ir, word->narg),
                             ir_int(ir, 0)};
    LLVMValueRef packed = LLVMConstNamedStruct(ir->types.word, fields, 6);
    rows[i] = LLVMConstNamedStruct(ir->types.axiom, &packed, 1);
  }
  return structs(ir, ir->types.axiom, rows, g->axiom_count, "axioms");
}

static LLVMValueRef numbers(Ir *ir, const uint32_t *at, size_t count) {
  LLVMValueRef *values = arena_array(ir->arena, count, sizeof *values);
  for (size_t i = 0; i < count; i++) values[i] = int_of(ir->types.i32, at[i]);
  return structs(ir, ir->types.i32, values, count, "growth");
}

static LLVMValueRef growth(Ir *ir) {
  const LsysGrammar *g = ir->description;
  if (!g->growth.row) return LLVMConstNull(ir->types.growth);
  size_t entries = g->growth.row[g->kind_count];
  LLVMValueRef fields[] = {numbers(ir, g->growth.row, g->kind_count + (size_t)1), numbers(ir, g->growth.kind, entries),
                           numbers(ir, g->growth.count, entries)};
  return LLVMConstNamedStruct(ir->types.growth, fields, 3);
}

static LLVMValueRef texts(Ir *ir, const char *const *at, size_t count) {
  if (!at) return LLVMConstNull(ir->types.ptr);
  LLVMValueRef *rows = arena_array(ir->arena, count, sizeof *rows);
  for (size_t i = 0; i < count; i++) rows[i] = text(ir, at[i]);
  return structs(ir, ir->types.ptr, rows, count, "texts");
}

static LLVMValueRef surfaces(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMValueRef *rows = arena_array(ir->arena, g->surface_count, sizeof *rows);
  for (uint32_t i = 0; i < g->surface_count; i++) {
    const LsysSurface *s = &g->surfaces[i];
    const size_t point = 3 * sizeof(double), triangle = 3 * sizeof(uint32_t);
    LLVMValueRef size[3] = {ir_double(ir, s->size[0]), ir_double(ir, s->size[1]), ir_double(ir, s->size[2])};
    LLVMValueRef fields[] = {text(ir, s->name),
                             int_of(ir->types.i32, s->form),
                             int_of(ir->types.i32, s->vertices),
                             int_of(ir->types.i32, s->triangles),
                             int_of(ir->types.i32, s->reserved),
                             LLVMConstArray2(ir->types.f64, size, 3),
                             bytes(ir, (const uint8_t *)s->vertex, s->vertices * point, "vertex"),
                             bytes(ir, (const uint8_t *)s->normal, s->vertices * point, "normal"),
                             bytes(ir, (const uint8_t *)s->corner, s->triangles * triangle, "corner")};
    rows[i] = LLVMConstStructInContext(ir->context, fields, 9, false);
  }
  return g->surface_count ? structs(ir, LLVMTypeOf(rows[0]), rows, g->surface_count, "surfaces")
                          : LLVMConstNull(ir->types.ptr);
}

static LLVMValueRef contours(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMTypeRef i32 = ir->types.i32;
  LLVMValueRef *rows = arena_array(ir->arena, g->contour_count, sizeof *rows);
  for (uint32_t i = 0; i < g->contour_count; i++) {
    const LsysContour *c = &g->contours[i];
    LLVMValueRef fields[] = {
      int_of(i32, c->number), int_of(i32, c->pieces), int_of(i32, c->closed), int_of(i32, c->reserved),
      bytes(ir, (const uint8_t *)c->point, (c->pieces + (size_t)1) * 2 * sizeof(double), "point")};
    rows[i] = LLVMConstStructInContext(ir->context, fields, 5, false);
  }
  return g->contour_count ? structs(ir, LLVMTypeOf(rows[0]), rows, g->contour_count, "contours")
                          : LLVMConstNull(ir->types.ptr);
}

static LLVMValueRef views(Ir *ir) {
  const LsysGrammar *g = ir->description;
  LLVMValueRef *rows = arena_array(ir->arena, g->view_count, sizeof *rows);
  for (uint32_t i = 0; i < g->view_count; i++) {
    LLVMValueRef fields[] = {bytes(ir, g->views[i].context_class, g->kind_count, "context_class"),
                             ir_int(ir, g->views[i].ring)};
    rows[i] = LLVMConstStructInContext(ir->context, fields, 2, false);
  }
  return structs(ir, LLVMTypeOf(rows[0]), rows, g->view_count, "views");
}

// One field of the descriptor: where it stands in C, and its value.
typedef struct Field {
  size_t offset;
  LLVMValueRef value;
} Field;

// What one level of a rewriting function may keep on the stack: its counters, and every
// argument and key of a successor twice over.
static uint32_t frame_bytes(const Ir *ir) {
  uint64_t bytes =
    4096 + 8 * (uint64_t)ir->counters + 32 * ((uint64_t)ir->facts->most_arguments + ir->facts->longest_successor);
  return bytes < UINT32_MAX ? (uint32_t)bytes : UINT32_MAX;
}

static LLVMValueRef pointer(Ir *ir, LLVMValueRef function) {
  return function ? function : LLVMConstNull(ir->types.ptr);
}

// A table of cases needs no index of branches.
static uint32_t flags(const Ir *ir) {
  uint32_t given = ir->description->flags;
  if (!ir->letters) return given;
  if (!(given & LSYS_GRAMMAR_WHOLE)) given &= ~(uint32_t)LSYS_GRAMMAR_RIGHT;
  return given | LSYS_GRAMMAR_LETTERS;
}

#define FIELD(name, value)                                                                                             \
  { offsetof(LsysGrammar, name), (value) }

void freeze_grammar(Ir *ir, const Entries *entries) {
  const LsysGrammar *g = ir->description;
  LLVMTypeRef i32 = ir->types.i32;
  LLVMValueRef null = LLVMConstNull(ir->types.ptr);
  const Field fields[] = {
    FIELD(abi_version, int_of(i32, g->abi_version)),
    FIELD(flags, int_of(i32, flags(ir))),
    FIELD(name, text(ir, g->name)),
    FIELD(names, text(ir, g->names)),
    FIELD(kind_count, int_of(i32, g->kind_count)),
    FIELD(kinds, kinds(ir)),
    FIELD(param_count, int_of(i32, g->param_count)),
    FIELD(params, params(ir)),
    FIELD(axiom_count, int_of(i32, g->axiom_count)),
    FIELD(axioms, axioms(ir)),
    FIELD(value_count, int_of(i32, g->value_count + blocks_values(ir))),
    FIELD(seed, ir_int(ir, g->seed)),
    FIELD(room_sym, int_of(i32, ir->room_sym > g->room_sym ? ir->room_sym : g->room_sym)),
    FIELD(frame_bytes, int_of(i32, frame_bytes(ir))),
    FIELD(growth, growth(ir)),
    FIELD(init, pointer(ir, entries->init)),
    FIELD(axiom, pointer(ir, entries->axiom)),
    FIELD(expand, pointer(ir, entries->expand)),
    FIELD(step, pointer(ir, entries->step)),
    FIELD(views, views(ir)),
    FIELD(view_count, int_of(i32, g->view_count)),
    FIELD(left_window, int_of(i32, g->left_window)),
    FIELD(system_count, int_of(i32, g->system_count)),
    FIELD(system_number, doubles(ir, g->system_number, g->system_count)),
    FIELD(block, pointer(ir, entries->block)),
    FIELD(decompose, pointer(ir, entries->decompose)),
    FIELD(derive, null),
    FIELD(derive_data, null),
    FIELD(homomorphism, pointer(ir, entries->homomorphism)),
    FIELD(interpret, pointer(ir, entries->interpret)),
    FIELD(surface_count, int_of(i32, g->surface_count)),
    FIELD(surfaces, surfaces(ir)),
    FIELD(colour_count, int_of(i32, g->colour_count)),
    FIELD(colours, numbers(ir, g->colours, g->colour_count)),
    FIELD(page, texts(ir, g->page, LSYS_PAGE_COUNT)),
    FIELD(environment, int_of(i32, g->environment)),
    FIELD(environment_path, g->environment_path ? text(ir, g->environment_path) : null),
    FIELD(environment_value,
          bytes(ir, (const uint8_t *)g->environment_value, LSYS_ENVIRONMENT_VALUES * sizeof(double), "environment")),
    FIELD(contour_count, int_of(i32, g->contour_count)),
    FIELD(contours, contours(ir)),
    FIELD(texts, texts(ir, g->texts, g->kind_count)),
  };
  enum { COUNT = sizeof fields / sizeof fields[0] };
  LLVMValueRef values[COUNT];
  for (size_t i = 0; i < COUNT; i++) values[i] = fields[i].value;
  LLVMValueRef frozen = LLVMConstStructInContext(ir->context, values, COUNT, false);
  LLVMTargetDataRef layout = LLVMGetModuleDataLayout(ir->module);
  for (unsigned i = 0; i < COUNT; i++) {
    // A field that was added to abi.h but not here would shift everything behind it.
    bool same = LLVMOffsetOfElement(layout, LLVMTypeOf(frozen), i) == fields[i].offset;
    if (!same)
      diag_error(ir->diag, (Span){0, 0}, "internal error: field %u of LsysGrammar is not where abi.h has it", i);
  }
  if (LLVMABISizeOfType(layout, LLVMTypeOf(frozen)) != sizeof(LsysGrammar))
    diag_error(ir->diag, (Span){0, 0}, "internal error: LsysGrammar has fields that are not exported");
  LLVMValueRef global = LLVMAddGlobal(ir->module, LLVMTypeOf(frozen), ir->options->symbol);
  LLVMSetInitializer(global, frozen);
  LLVMSetGlobalConstant(global, true);
}
