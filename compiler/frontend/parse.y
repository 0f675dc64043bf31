// parse.y -- the grammar of one statement (LANGUAGE.md sections 2 to 4).
//
// Takes the tokens of one statement, gives its AST; knows no semantics. What
// check can reject with a better message is accepted here. Left recursion
// everywhere: the parser's stack grows with nesting only.
%require "3.8"
%define api.prefix {syntax_}
%define api.pure full
%define api.value.type union
%define api.token.prefix {TOK_}
%define api.location.type {Span}
%define parse.error custom
%define parse.lac full
%locations
%expect 0
%param {Parser *parser}

%code requires {
#include "frontend/parse_build.h"
}

%code {
#include "frontend/parse_error.h"

#define YYSTACK_USE_ALLOCA 0
#define YYMAXDEPTH 4000  // blocks in one another; for expressions AST_DEEPEST is lower
#define YYLLOC_DEFAULT(current, rhs, n) ((current) = joined(rhs, n))

static Span joined(const Span *rhs, int count);
static int yylex(YYSTYPE *value, Span *span, Parser *parser);
static void yyerror(const Span *span, Parser *parser, const char *message);

#define BUILD (parser->build)
#define PUSH(list) (*VEC_PUSH(parser->build.arena, &(list)))
}

%token END 0 "the end of the statement"
%token <const char *> LABEL "a label" NAME "a name" FUNCTION "a name with parameters"
%token <const char *> SYMBOL "a module" STRING "a string"
%token <double> NUMBER "a number"
%token <unsigned> SETTING "a setting" PAGE "a setting of pictures"
%token EMPTY "`ε`" ARROW "an arrow" CONDITION "a condition"

%token AXIOM "`axiom:`" SEED "`seed:`" IGNORE "`ignore:`" CONSIDER "`consider:`" START "`Start:`"
%token START_EACH "`StartEach:`" END_EACH "`EndEach:`" FINISH "`End:`" ARRAYS "`define:`" DECOMPOSITION "`decomposition`"
%token HOMOMORPHISM "`homomorphism`" PRODUCTIONS "`productions`" MAXIMUM_DEPTH "`maximum depth:`" TABLE "`table`"
%token TABLES "`tables:`" RING "`ring lsystem`" LSYSTEM "`lsystem:`" ENDLSYSTEM "`endlsystem`" SURFACE "`surface`"
%token COLOURS "`colours:`"
%token FUNCTION_FILE "`function`" FUNCTION_SET "`functions:`" CURVE_FILE "`curve`" CONTOUR_FILE "`contour`"
%token ENVIRONMENT "`environment:`" PARAM "`param`" MODULE "`module`" MODULES "`#modules`" DEFINE "`#define`"
%token UNDEF "`#undef`" INCLUDE "`#include`" IFDEF "`#ifdef`" IFNDEF "`#ifndef`" ELIF "`#elif`" ENDIF "`#endif`"
%token HASH_IF "`#if`" HASH_ELSE "`#else`"

%token LPAREN "`(`" RPAREN "`)`" LBRACE "`{`" RBRACE "`}`" LBRACKET "`[`" RBRACKET "`]`" COMMA "`,`" SEMICOLON "`;`"
%token COLON "`:`" RANGE "`..`" IN "`in`" IF "`if`" ELSE "`else`" WHILE "`while`" DO "`do`"
%token ARRAY "`array`" NOT "`!`"
 // The operators; NOT among them would only begin an expression.
%token PLUS "`+`" MINUS "`-`" STAR "`*`" SLASH "`/`" PERCENT "`%`" CARET "`^`" LEFT_CARET OR "`|`" AND "`&`" ASSIGN "`=`" EQ "`==`"
%token NE "`!=`" LT "`<`" LE "`<=`" GT "`>`" GE "`>=`" QUESTION "`?`"

%precedence VALUE  // lower than ASSIGN: `x =` at the begin of an action assigns
%right QUESTION COLON
%left OR
%left AND
%left ASSIGN EQ NE
%left LT LE GT GE
%left PLUS MINUS
%left STAR SLASH PERCENT
%left LEFT_CARET
%precedence UNARY NOT
%right CARET
%precedence THEN
%precedence ELSE

%nterm <AstExpr *> expr argument weight condition
%nterm <AstExprs> arguments list indices values value
%nterm <AstModule> module
%nterm <AstWord> word
%nterm <AstWords> words
%nterm <AstSymbols> symbols names parameters parameter_list
%nterm <Predecessor> predecessor
%nterm <Guard> guard
%nterm <AstActions> actions body block
%nterm <AstArrays> arrays array declarators
%nterm <AstArray> declarator
%nterm <const char *> label

%%

input:
  statement
| CONDITION expr { parser->condition = $2; }
;

// ---- statements --------------------------------------------------------------

statement:
  label predecessor guard ARROW word weight {
    AstProduction *p = build_statement(parser, AST_PRODUCTION)->production = build_production(parser, $2, $3);
    p->label = $1;
    p->label_span = $1 ? @1 : (Span){0, 0};
    p->arrow_span = @4;
    p->successor = build_unless_star($5, false);
    p->weight = $6;
  }
| AXIOM words { build_statement(parser, AST_AXIOM)->words = $2; }
| IGNORE symbols { build_statement(parser, AST_IGNORE)->symbols = $2; }
| CONSIDER symbols { build_statement(parser, AST_CONSIDER)->symbols = $2; }
| SETTING expr {
    AstStatement *s = build_statement(parser, AST_SETTING);
    s->setting = $1;
    s->value = $2;
    if ($2->kind == AST_NAME) s->name = $2->name;
  }
| PAGE NAME { build_named(parser, AST_PAGE, $2, @2)->setting = $1; }
| SEED expr { build_statement(parser, AST_SECTION_SEED)->value = $2; }
| DECOMPOSITION { build_statement(parser, AST_DECOMPOSITION); }
| DECOMPOSITION names { build_section(parser, AST_DECOMPOSITION, $2); }
| HOMOMORPHISM { build_statement(parser, AST_HOMOMORPHISM); }
| HOMOMORPHISM names { build_section(parser, AST_HOMOMORPHISM, $2); }
| PRODUCTIONS { build_statement(parser, AST_PRODUCTIONS); }
| MAXIMUM_DEPTH expr { build_statement(parser, AST_MAXIMUM_DEPTH)->value = $2; }
| TABLE NAME COLON { build_named(parser, AST_TABLE, $2, @2); }
| TABLES names { build_statement(parser, AST_TABLES)->symbols = $2; }
| RING { build_statement(parser, AST_RING); }
| LSYSTEM NAME { build_named(parser, AST_LSYSTEM, $2, @2); }
| ENDLSYSTEM { build_statement(parser, AST_ENDLSYSTEM); }
| SURFACE NAME COLON expr { build_named(parser, AST_SURFACE, $2, @2)->value = $4; }
| COLOURS names { build_statement(parser, AST_COLOURS)->symbols = $2; }
| SURFACE NAME COLON expr COMMA expr {
    AstStatement *s = build_named(parser, AST_SURFACE, $2, @2);
    s->value = $4;
    s->low = $6;
  }
| FUNCTION_FILE NAME COLON expr { build_named(parser, AST_FUNCTION, $2, @2)->value = $4; }
| FUNCTION_SET expr { build_statement(parser, AST_FUNCTION)->value = $2; }
| CURVE_FILE NAME COLON expr { build_named(parser, AST_CURVE, $2, @2)->value = $4; }
| CONTOUR_FILE NAME COLON expr { build_named(parser, AST_CONTOUR, $2, @2)->value = $4; }
| ENVIRONMENT expr { build_statement(parser, AST_ENVIRONMENT)->value = $2; }
| declaration
| blocks
;

declaration:
  DEFINE NAME { build_named(parser, AST_DEFINE, $2, @2)->value = ast_number(BUILD, @2, 1); }
| DEFINE NAME expr { build_named(parser, AST_DEFINE, $2, @2)->value = $3; }
| DEFINE FUNCTION LPAREN parameters RPAREN expr {
    AstStatement *s = build_named(parser, AST_DEFINE, $2, @2);
    s->has_params = true;
    s->symbols = $4;
    s->value = $6;
  }
| UNDEF NAME { build_named(parser, AST_UNDEF, $2, @2); }
| PARAM NAME ASSIGN expr { build_named(parser, AST_PARAM, $2, @2)->value = $4; }
| PARAM NAME ASSIGN expr IN expr RANGE expr {
    AstStatement *s = build_named(parser, AST_PARAM, $2, @2);
    s->value = $4;
    s->low = $6;
    s->high = $8;
  }
| MODULES names { build_statement(parser, AST_MODULES)->symbols = $2; }
| MODULE NAME {
    AstStatement *s = build_statement(parser, AST_MODULES);
    PUSH(s->symbols) = (AstSymbol){$2, @2};
  }
| MODULE NAME LPAREN parameters RPAREN {
    AstStatement *s = build_named(parser, AST_MODULES, $2, @2);
    s->has_params = true;
    s->symbols = $4;
  }
;

blocks:
  START block { build_named(parser, AST_BLOCK, "Start", @1)->actions = $2; }
| START_EACH block { build_named(parser, AST_BLOCK, "StartEach", @1)->actions = $2; }
| END_EACH block { build_named(parser, AST_BLOCK, "EndEach", @1)->actions = $2; }
| FINISH block { build_named(parser, AST_BLOCK, "End", @1)->actions = $2; }
| ARRAYS LBRACE arrays RBRACE { build_statement(parser, AST_ARRAYS)->arrays = $3; }
;

names:
  NAME { $$ = (AstSymbols){0}; PUSH($$) = (AstSymbol){$1, @1}; }
| names NAME { $$ = $1; PUSH($$) = (AstSymbol){$2, @2}; }
| names COMMA NAME { $$ = $1; PUSH($$) = (AstSymbol){$3, @3}; }
;

parameters:
  %empty { $$ = (AstSymbols){0}; }
| parameter_list
;

parameter_list:
  NAME { $$ = (AstSymbols){0}; PUSH($$) = (AstSymbol){$1, @1}; }
| parameter_list COMMA NAME { $$ = $1; PUSH($$) = (AstSymbol){$3, @3}; }
;

symbols:
  %empty { $$ = (AstSymbols){0}; }
| symbols SYMBOL { $$ = build_symbol(parser, $1, $2, @2); }
;

// ---- productions and words ---------------------------------------------------

label:
  %empty { $$ = NULL; }
| LABEL
;

predecessor:
  word { $$ = (Predecessor){.strict = $1}; }
| word LT word { $$ = (Predecessor){.left = build_unless_star($1, true), .strict = $3}; }
| word GT word { $$ = (Predecessor){.strict = $1, .right = build_unless_star($3, true)}; }
| word LT word GT word { $$ = (Predecessor){build_unless_star($1, true), $3, build_unless_star($5, true)}; }
;

guard:
  %empty { $$ = (Guard){0}; }
| COLON condition { $$ = (Guard){.condition = $2}; }
| COLON block { $$ = (Guard){.before = $2, .has_before = true}; }
| COLON block condition { $$ = (Guard){.before = $2, .has_before = true, .condition = $3}; }
| COLON block block { $$ = (Guard){.before = $2, .has_before = true, .after = $3, .has_after = true}; }
| COLON condition block { $$ = (Guard){.condition = $2, .after = $3, .has_after = true}; }
| COLON block condition block {
    $$ = (Guard){.before = $2, .has_before = true, .condition = $3, .after = $4, .has_after = true};
  }
;

condition:
  expr
| STAR { $$ = NULL; }
;

weight:
  %empty { $$ = NULL; }
| COLON expr { $$ = $2; }
;

words:
  word { $$ = (AstWords){0}; PUSH($$) = build_unless_star($1, false); }
| words COMMA word { $$ = $1; PUSH($$) = build_unless_star($3, false); }
;

word:
  module { $$ = (AstWord){.span = @1}; PUSH($$.modules) = $1; }
| EMPTY { $$ = (AstWord){.span = @1}; }
| word module { $$ = $1; $$.span = @$; PUSH($$.modules) = $2; }
| word EMPTY { $$ = $1; $$.span = @$; }
;

module:
  SYMBOL { $$ = (AstModule){.symbol = $1, .span = @1, .symbol_span = @1}; }
| SYMBOL LPAREN arguments RPAREN {
    $$ = (AstModule){.symbol = $1, .span = @$, .symbol_span = @1, .args = $3, .parens = true};
  }
;

// ---- blocks ------------------------------------------------------------------

block:
  LBRACE actions RBRACE { $$ = $2; }
;

actions:
  %empty { $$ = (AstActions){0}; }
| actions body { $$ = build_append_actions(parser, $1, $2); }
;

body:
  block
| SEMICOLON { $$ = (AstActions){0}; }
| NAME ASSIGN expr SEMICOLON { $$ = build_assignment(parser, @$, ast_name(BUILD, @1, $1), $3); }
| NAME indices ASSIGN expr SEMICOLON {
    $$ = build_assignment(parser, @$, ast_index(BUILD, span_join(@1, @2), @1, $1, $2), $4);
  }
| expr SEMICOLON { $$ = build_evaluation(parser, @$, $1); }
| IF LPAREN expr RPAREN body %prec THEN { $$ = build_if(parser, @$, $3, $5, (AstActions){0}); }
| IF LPAREN expr RPAREN body ELSE body { $$ = build_if(parser, @$, $3, $5, $7); }
| WHILE LPAREN expr RPAREN body { $$ = build_loop(parser, AST_WHILE, @$, $3, $5); }
| DO body WHILE LPAREN expr RPAREN SEMICOLON { $$ = build_loop(parser, AST_DO, @$, $5, $2); }
;

arrays:
  %empty { $$ = (AstArrays){0}; }
| arrays array {
    $$ = $1;
    for (size_t i = 0; i < $2.count; i++) PUSH($$) = $2.at[i];
  }
;

array:
  ARRAY declarators SEMICOLON { $$ = $2; }
;

declarators:
  declarator { $$ = (AstArrays){0}; PUSH($$) = $1; }
| declarators COMMA declarator { $$ = $1; PUSH($$) = $3; }
;

declarator:
  NAME indices { $$ = (AstArray){.name = $1, .span = @1, .sizes = $2}; }
| NAME indices ASSIGN LBRACE values RBRACE { $$ = (AstArray){.name = $1, .span = @1, .sizes = $2, .values = $5}; }
;

values:
  value
| values COMMA value { $$ = build_append(parser, $1, $3); }
;

value:
  expr { $$ = (AstExprs){0}; PUSH($$) = $1; }
| LBRACE values RBRACE { $$ = $2; }
;

// ---- expressions ---------------------------------------------------------------

expr:
  NUMBER { $$ = ast_number(BUILD, @1, $1); }
| STRING { $$ = ast_string(BUILD, @1, $1); }
| NAME %prec VALUE { $$ = ast_name(BUILD, @1, $1); }
| NAME indices %prec VALUE { $$ = ast_index(BUILD, @$, @1, $1, $2); }
| NAME LPAREN arguments RPAREN { $$ = ast_call(BUILD, @$, @1, $1, $3); }
| LPAREN expr RPAREN { $$ = ast_parenthesized($2, @$); }
| MINUS expr %prec UNARY { $$ = ast_unary(BUILD, @$, OP_NEG, $2); }
| NOT expr { $$ = ast_unary(BUILD, @$, OP_NOT, $2); }
| expr OR expr { $$ = ast_binary(BUILD, OP_OR, $1, $3); }
| expr AND expr { $$ = ast_binary(BUILD, OP_AND, $1, $3); }
| expr EQ expr { $$ = ast_binary(BUILD, OP_EQ, $1, $3); }
| expr ASSIGN expr { $$ = ast_binary(BUILD, OP_EQ, $1, $3); }
| expr NE expr { $$ = ast_binary(BUILD, OP_NE, $1, $3); }
| expr LT expr { $$ = ast_binary(BUILD, OP_LT, $1, $3); }
| expr LE expr { $$ = ast_binary(BUILD, OP_LE, $1, $3); }
| expr GT expr { $$ = ast_binary(BUILD, OP_GT, $1, $3); }
| expr GE expr { $$ = ast_binary(BUILD, OP_GE, $1, $3); }
| expr PLUS expr { $$ = ast_binary(BUILD, OP_ADD, $1, $3); }
| expr MINUS expr { $$ = ast_binary(BUILD, OP_SUB, $1, $3); }
| expr STAR expr { $$ = ast_binary(BUILD, OP_MUL, $1, $3); }
| expr SLASH expr { $$ = ast_binary(BUILD, OP_DIV, $1, $3); }
| expr PERCENT expr { $$ = ast_binary(BUILD, OP_MOD, $1, $3); }
| expr CARET expr { $$ = ast_binary(BUILD, OP_POW, $1, $3); }
| expr LEFT_CARET expr { $$ = ast_binary(BUILD, OP_POW, $1, $3); }
| expr QUESTION expr COLON expr { $$ = ast_choice(BUILD, $1, $3, $5); }
;

arguments:
  %empty { $$ = (AstExprs){0}; }
| list
;

list:
  argument { $$ = (AstExprs){0}; PUSH($$) = $1; }
| list COMMA argument { $$ = $1; PUSH($$) = $3; }
;

argument:
  expr
| AND NAME { $$ = build_reference(parser, @$, ast_name(BUILD, @2, $2)); }
| AND NAME indices { $$ = build_reference(parser, @$, ast_index(BUILD, span_join(@2, @3), @2, $2, $3)); }
;

indices:
  LBRACKET expr RBRACKET { $$ = (AstExprs){0}; PUSH($$) = $2; }
| indices LBRACKET expr RBRACKET { $$ = $1; PUSH($$) = $3; }
;

%%

// From the first symbol that is not empty to the last.
static Span joined(const Span *rhs, int count) {
  Span all = {rhs[0].end, rhs[0].end};
  bool any = false;
  for (int i = 1; i <= count; i++)
    if (rhs[i].end > rhs[i].begin) {
      all = any ? span_join(all, rhs[i]) : rhs[i];
      any = true;
    }
  return all;
}

static int yylex(YYSTYPE *value, Span *span, Parser *parser) {
  return scanner_next(parser->scanner, value, span);
}

// Only "memory exhausted" comes this way: the stack grows with nesting alone.
static void yyerror(const Span *span, Parser *parser, const char *message) {
  (void)message;
  diag_error(parser->diag, *span, "this is nested too deep");
}

// What stands for many tokens in a message; NULL: the token speaks for itself.
static const char *group(yysymbol_kind_t kind, bool expression, bool operators, bool actions) {
  switch (kind) {
  case YYSYMBOL_NUMBER:
  case YYSYMBOL_STRING:
  case YYSYMBOL_NOT: return "an expression";
  case YYSYMBOL_NAME:
  case YYSYMBOL_LPAREN: return expression ? "an expression" : actions && kind == YYSYMBOL_NAME ? "an action" : NULL;
  case YYSYMBOL_MINUS: return expression ? "an expression" : "an operator";
  case YYSYMBOL_IF:
  case YYSYMBOL_WHILE:
  case YYSYMBOL_DO:
  case YYSYMBOL_LBRACE:
  case YYSYMBOL_SEMICOLON: return actions ? "an action" : NULL;
  case YYSYMBOL_EMPTY: return "a module";
  default: return operators && kind >= YYSYMBOL_PLUS && kind <= YYSYMBOL_QUESTION ? "an operator" : NULL;
  }
}

static int yyreport_syntax_error(const yypcontext_t *context, Parser *parser) {
  enum { MOST = YYNTOKENS };
  yysymbol_kind_t kinds[MOST];
  const char *names[MOST];
  int count = yypcontext_expected_tokens(context, kinds, MOST);
  bool expression = false, operators = false, actions = false;
  for (int i = 0; i < count; i++) {
    expression |= kinds[i] == YYSYMBOL_NUMBER;
    operators |= kinds[i] == YYSYMBOL_PLUS;
    actions |= kinds[i] == YYSYMBOL_IF;
  }
  for (int i = 0; i < count; i++) {
    names[i] = group(kinds[i], expression, operators, actions);
    if (!names[i]) names[i] = yysymbol_name(kinds[i]);
  }
  parse_error(parser, *yypcontext_location(context), names, count < 0 ? 0 : (size_t)count);
  return 0;
}

const char *parser_token_name(int token) {
  return yysymbol_name(YYTRANSLATE(token));
}
