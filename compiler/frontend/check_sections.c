// check_sections.c -- every statement in file order: what it means where it stands.
#include "frontend/check.h"
#include "lsys/colour.h"
#include "lsys/surface.h"

#include <string.h>

// ---- where a statement stands -------------------------------------------------------

static void enter(Check *check, System *system, Section section) {
  check->system = system;
  check->section = section;
  check->table = -1;
}

static void enter_system(Check *check, const AstStatement *statement) {
  enter(check, check->systems.at[map_find(check->system_map, statement->name, 0)], SECTION_MAIN);
}

static void enter_table(Check *check, const AstStatement *statement) {
  enter(check, check->system, SECTION_MAIN);
  check->table = (int32_t)map_find(check->table_map, statement->name, check->system->number);
}

static void enter_section(Check *check, const AstStatement *statement, Section section) {
  enter(check, check->system, section);
  if (!statement->value) return;
  check_scope(check, SCOPE_CONSTANT);
  check->system->depth[section] = check_expression(check, statement->value);
}

// False after an error: the statement makes sense only inside a section.
static bool inside_section(Check *check, const AstStatement *statement, const char *what) {
  if (check->section != SECTION_MAIN) return true;
  diag_error(check->diag, statement->span, "%s belongs behind `decomposition` or `homomorphism`", what);
  return false;
}

// ---- statements ---------------------------------------------------------------------------

static void read_axiom(Check *check, const AstStatement *statement) {
  if (check->system->number != 0) {
    if (strcmp(check->ast->rules.dialect, "cpfg") == 0) return;  // cpfg asks for one and does not use it
    diag_error(check->diag, statement->span, "L-system `%s` has no start word of its own", check->system->name);
    diag_hint(check->diag, "it rewrites what stands in `?(%s) ... $` of the main word", check->system->name);
    return;
  }
  check_scope(check, SCOPE_AXIOM);
  for (size_t i = 0; i < statement->words.count; i++)
    *VEC_PUSH(check->arena, &check->axioms) = check_word(check, &statement->words.at[i], "axiom");
}

static Expr *turns(Check *check, const char *name, Span span) {
  static const char *const names[] = {"counterclockwise", "clockwise"};
  for (int i = 0; i < 2; i++)
    if (strcmp(name, names[i]) == 0) return expr_number(check->arena, i, span);
  diag_error(check->diag, span, "`turns:` is `clockwise` or `counterclockwise`");
  return check->poison;
}

static void read_setting(Check *check, const AstStatement *statement) {
  unsigned setting = statement->setting;
  if (check->system->number != 0 && strcmp(check->ast->rules.dialect, "cpfg") == 0) return;
  check_scope(check, SCOPE_CONSTANT);
  bool fallback = check->fallback[setting];
  check->fallback[setting] = statement->fallback;
  if (check->settings[setting] && !fallback) {
    diag_warning(check->diag, WARN_REDEFINED, statement->span, "`%s:` is given twice; the last one counts",
                 lsys_settings[setting].keyword);
    diag_note(check->diag, check->settings[setting]->span, "the other one is here");
  }
  const AstExpr *value = statement->value;
  if (!value)
    check->settings[setting] = turns(check, statement->name ? statement->name : "", statement->name_span);
  else if (setting == LSYS_SETTING_TURNS && value->kind == AST_NAME)
    check->settings[setting] = turns(check, value->name, value->span);
  else
    check->settings[setting] = check_expression(check, value);
}

static void read_seed(Check *check, const AstStatement *statement) {
  check_scope(check, SCOPE_CONSTANT);
  Expr **seed = check->section == SECTION_MAIN ? &check->seed : &check->system->seed[check->section];
  if (*seed) {
    diag_warning(check->diag, WARN_REDEFINED, statement->span, "`seed:` is given twice; the last one counts");
    diag_note(check->diag, (*seed)->span, "the other one is here");
  }
  *seed = check_expression(check, statement->value);
}

static void read_depth(Check *check, const AstStatement *statement) {
  if (!inside_section(check, statement, "`maximum depth:`")) return;
  check_scope(check, SCOPE_CONSTANT);
  check->system->depth[check->section] = check_expression(check, statement->value);
}

static void read_block(Check *check, const AstStatement *statement) {
  static const char *const names[] = {"Start", "StartEach", "EndEach", "End"};
  check_scope(check, SCOPE_BLOCK);
  check->scope.start = strcasecmp(statement->name, names[0]) == 0;
  Actions actions = check_actions(check, &statement->actions);
  for (int which = 0; which < 4; which++) {
    if (strcasecmp(statement->name, names[which]) != 0) continue;
    for (size_t i = 0; i < actions.count; i++) *VEC_PUSH(check->arena, &check->blocks[which]) = actions.at[i];
  }
}

static void read_schedule(Check *check, const AstStatement *statement) {
  if (check->system->schedule) {
    diag_error(check->diag, statement->span, "`tables:` is given twice");
    diag_note(check->diag, check->system->schedule->span, "the other one is here");
  }
  check->system->schedule = statement;
}

// Several statements add up.
static void read_colours(Check *check, const AstStatement *statement) {
  for (size_t i = 0; i < statement->symbols.count; i++) {
    const AstSymbol *colour = &statement->symbols.at[i];
    uint32_t rgb;
    if (!lsys_colour_read(colour->name, strlen(colour->name), &rgb)) {
      diag_error(check->diag, colour->span, "`%s` is no colour", colour->name);
      diag_hint(check->diag, "a colour is #rrggbb, #rgb, or a name such as brown");
    } else if (check->colours.count == LSYS_MOST_COLOURS) {
      diag_error(check->diag, colour->span, "a palette has no more than %d colours", LSYS_MOST_COLOURS);
      return;
    } else {
      *VEC_PUSH(check->arena, &check->colours) = rgb;
    }
  }
}

static void read_page(Check *check, const AstStatement *statement) {
  LsysPageSetting setting = (LsysPageSetting)statement->setting;
  const char *keyword = lsys_page_settings[setting].keyword, *wanted = lsys_page_wrong(setting, statement->name);
  if (wanted) {
    diag_error(check->diag, statement->name_span, "`%s` is no %s", statement->name, keyword);
    diag_hint(check->diag, "%s", wanted);
  }
  if (check->page[setting]) {
    diag_warning(check->diag, WARN_REDEFINED, statement->span, "`%s:` is given twice; the last one counts", keyword);
    diag_note(check->diag, check->page[setting]->span, "the other one is here");
  }
  check->page[setting] = statement;
}

// ---- surfaces --------------------------------------------------------------------------------

static const struct {
  const char *name;
  uint32_t arguments;
  LsysSurfaceForm form;
} forms[] = {{"disc", 1, LSYS_SURFACE_DISC}, {"sphere", 1, LSYS_SURFACE_SPHERE}, {"box", 3, LSYS_SURFACE_BOX}};

enum { FORMS = sizeof forms / sizeof *forms };

// Sizes are numbers when the grammar is compiled.
static void read_sizes(Check *check, const AstExpr *value, Surface *surface, uint32_t form) {
  surface->shape.form = form;
  for (uint32_t i = 0; i < surface->count && i < 3; i++)
    if (!expr_constant(check->program, surface->args[i], &surface->shape.size[i]))
      diag_error(check->diag, value->args.at[i]->span, "the size of a surface must be a constant");
}

static void read_form(Check *check, const AstExpr *value, Surface *surface) {
  const char *names[FORMS];
  for (int i = 0; i < FORMS; i++) {
    names[i] = forms[i].name;
    if (strcmp(value->name, names[i]) != 0) continue;
    surface->form = names[i];
    surface->args = check_arguments(check, &value->args);
    surface->count = (uint32_t)value->args.count;
    if (surface->count != forms[i].arguments)
      diag_error(check->diag, value->span, "`%s` takes %u argument%s, not %u", names[i], forms[i].arguments,
                 forms[i].arguments == 1 ? "" : "s", surface->count);
    else
      read_sizes(check, value, surface, forms[i].form);
    return;
  }
  const char *meant = diag_nearest(value->name, names, FORMS);
  if (meant)
    diag_error(check->diag, value->name_span, "unknown form `%s`; did you mean `%s`?", value->name, meant);
  else
    diag_error(check->diag, value->name_span, "unknown form `%s`", value->name);
  diag_hint(check->diag, "a surface is disc(d), sphere(d), box(x,y,z), or the name of an .obj or .s file");
}

static void *copy(Check *check, const void *from, size_t count, size_t size) {
  void *to = arena_array(check->arena, count, size);
  if (from && count) memcpy(to, from, count * size);
  return to;
}

const char *check_beside(Check *check, const AstStatement *statement, const char *path) {
  const SourceFile *file = statement->beside ? statement->beside : check->ast->file;
  const char *slash = strrchr(file->path, '/');
  int folder = slash && *path != '/' ? (int)(slash + 1 - file->path) : 0;
  return arena_printf(check->arena, "%.*s%s", folder, file->path, path);
}

// `surface NAME: file, size`
static void resize_mesh(Check *check, const AstStatement *statement, Surface *surface) {
  double size;
  if (!statement->low) return;
  Expr *factor = check_expression(check, statement->low);
  if (factor == check->poison) return;
  if (!expr_constant(check->program, factor, &size) || !(size > 0)) {
    diag_error(check->diag, factor->span, "the size of a surface is a number above 0");
    return;
  }
  double *vertex = copy(check, surface->shape.vertex, surface->shape.vertices, 3 * sizeof(double));
  for (size_t i = 0; i < 3 * (size_t)surface->shape.vertices; i++) vertex[i] *= size;
  surface->shape.vertex = vertex;
}

static void read_mesh(Check *check, const AstStatement *statement, Surface *surface) {
  const AstExpr *value = statement->value;
  const char *path = check_beside(check, statement, surface->path);
  char why[256];
  LsysSurface mesh;
  if (!lsys_surface_read(path, &mesh, why, sizeof why)) {
    diag_error(check->diag, value->span, "cannot read the surface \"%s\": %s", path, why);
    return;
  }
  surface->shape = mesh;
  surface->shape.vertex = copy(check, mesh.vertex, mesh.vertices, 3 * sizeof(double));
  resize_mesh(check, statement, surface);
  if (mesh.normal) surface->shape.normal = copy(check, mesh.normal, mesh.vertices, 3 * sizeof(double));
  surface->shape.corner = copy(check, mesh.corner, mesh.triangles, 3 * sizeof(uint32_t));
  lsys_surface_free(&mesh);
}

static void read_surface(Check *check, const AstStatement *statement) {
  const AstExpr *value = statement->value;
  Surface *surface = VEC_PUSH(check->arena, &check->surfaces);
  *surface = (Surface){.name = statement->name, .span = statement->span};
  check_scope(check, SCOPE_CONSTANT);
  if (value->kind == AST_POISON) return;
  if (value->kind == AST_CALL || value->kind == AST_NAME) {
    read_form(check, value, surface);
    return;
  }
  surface->path = value->kind == AST_STRING ? value->text : "";
  const char *suffix = strrchr(surface->path, '.');
  if (suffix && (strcmp(suffix, ".obj") == 0 || strcmp(suffix, ".s") == 0))
    surface->form = suffix + 1;
  else
    diag_error(check->diag, value->span,
               "a surface is disc(d), sphere(d), box(x,y,z), or the name of an .obj or .s file");
  if (surface->form) read_mesh(check, statement, surface);
}

// ---- all ---------------------------------------------------------------------------------------

static void read_statement(Check *check, const AstStatement *statement) {
  switch (statement->kind) {
  case AST_AXIOM:
    read_axiom(check, statement);
    break;
  case AST_PRODUCTION:
    check_production(check, statement);
    break;
  case AST_DEFINE:
  case AST_PARAM:
    check_definition(check, statement);
    break;
  case AST_UNDEF:
  case AST_MODULES:
    break;
  case AST_SETTING:
    read_setting(check, statement);
    break;
  case AST_IGNORE:
  case AST_CONSIDER:
    *VEC_PUSH(check->arena, &check->system->lists) = statement;
    break;
  case AST_BLOCK:
    read_block(check, statement);
    break;
  case AST_ARRAYS:
    check_arrays(check, statement);
    break;
  case AST_DECOMPOSITION:
    enter_section(check, statement, SECTION_DECOMPOSITION);
    break;
  case AST_HOMOMORPHISM:
    enter_section(check, statement, SECTION_HOMOMORPHISM);
    break;
  case AST_PRODUCTIONS:
    enter(check, check->system, SECTION_MAIN);
    break;
  case AST_WARNINGS:
    if (inside_section(check, statement, "`warnings`")) check->system->warnings[check->section] = true;
    break;
  case AST_MAXIMUM_DEPTH:
    read_depth(check, statement);
    break;
  case AST_SECTION_SEED:
    read_seed(check, statement);
    break;
  case AST_TABLE:
    enter_table(check, statement);
    break;
  case AST_TABLES:
    read_schedule(check, statement);
    break;
  case AST_RING:
    check->system->ring = true;
    break;
  case AST_LSYSTEM:
    enter_system(check, statement);
    break;
  case AST_ENDLSYSTEM:
    enter(check, check->systems.at[0], SECTION_MAIN);
    break;
  case AST_SURFACE:
    read_surface(check, statement);
    break;
  case AST_COLOURS:
    read_colours(check, statement);
    break;
  case AST_PAGE:
    read_page(check, statement);
    break;
  case AST_FUNCTION:
  case AST_CURVE:
  case AST_CONTOUR:
    break;  // read with all others
  case AST_ENVIRONMENT:
    check_environment(check, statement);
    break;
  }
}

void check_statements(Check *check) {
  const Ast *ast = check->ast;
  values_begin(check);
  functions_read(check);
  enter(check, check->systems.at[0], SECTION_MAIN);
  for (check->statement = 0; check->statement < ast->statements.count && !check->failed; check->statement++)
    read_statement(check, &ast->statements.at[check->statement]);
}
