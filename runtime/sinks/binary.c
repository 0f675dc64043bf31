// binary.c -- a word as the packed arrays that it is, for other programs to read.
//
// All numbers are little-endian, whole ones of 8 bytes:
//
//   "LSYSWORD"  version (1)  bytes of a symbol (1 or 2)  number of kinds
//   for each kind: arguments, bytes of its name, its name (UTF-8; a label's with its text, @L("x = %g")), zeros up to
//     a multiple of 8
//   for each start word:
//     blocks of up to 65,536 modules:
//       modules (> 0)  arguments  the modules' symbols (numbers of kinds), zeros up to a multiple of 8
//       the arguments, all modules' back to back, as IEEE doubles
//     0
//
// The blocks are those of the hash (LANGUAGE.md section 9): bytes depend on the word alone.
#include "core/cut.h"
#include "core/formats.h"
#include "core/store.h"
#include "lsys/quote.h"

#include <string.h>

enum { BLOCK = 1 << 16, ALIGNMENT = 8 };

typedef struct BinarySink {
  LsysSink sink;
  const LsysGrammar *grammar;
  LsysMemory *memory;
  LsysOut *out;
  LsysStore block;  // that is not complete
} BinarySink;

static bool write_whole(LsysOut *out, uint64_t number) {
  uint8_t bytes[8];
  for (int i = 0; i < 8; i++) bytes[i] = (uint8_t)(number >> (8 * i));
  return lsys_out_write(out, bytes, sizeof bytes);
}

static bool write_padded(LsysOut *out, const void *bytes, size_t size) {
  static const char zeros[ALIGNMENT];
  return lsys_out_write(out, bytes, size) && lsys_out_write(out, zeros, -size % ALIGNMENT);
}

static bool write_name(BinarySink *binary, uint32_t kind) {
  const char *symbol = binary->grammar->kinds[kind].symbol;
  const char *text = binary->grammar->texts ? binary->grammar->texts[kind] : NULL;
  size_t length = strlen(symbol), size = length + (text ? lsys_quoted_size(text) + 2 : 0);
  char *name = lsys_memory_alloc(binary->memory, size + 1, 1);
  if (!name) return false;
  memcpy(name, symbol, length);
  if (text) {
    name[length] = '(';
    *lsys_quote(name + length + 1, text) = ')';
  }
  write_whole(binary->out, size);
  bool well = write_padded(binary->out, name, size);
  lsys_memory_free(binary->memory, name, size + 1, 1);
  return well;
}

static bool write_header(BinarySink *binary) {
  const LsysGrammar *grammar = binary->grammar;
  lsys_out_write(binary->out, "LSYSWORD", 8);
  write_whole(binary->out, 1);
  write_whole(binary->out, lsys_symbol_width(grammar));
  write_whole(binary->out, grammar->kind_count);
  bool well = true;
  for (uint32_t i = 0; well && i < grammar->kind_count; i++) {
    write_whole(binary->out, grammar->kinds[i].arity);
    well = write_name(binary, i);
  }
  return well;
}

// Doubles are stored as this machine has them, which lsysc's targets share.
static bool write_block(BinarySink *binary) {
  LsysWord word = lsys_store_word(&binary->block);
  write_whole(binary->out, word.nsym);
  write_whole(binary->out, word.narg);
  write_padded(binary->out, word.sym, (size_t)word.nsym * lsys_symbol_width(binary->grammar));
  lsys_store_clear(&binary->block);
  return lsys_out_write(binary->out, word.arg, (size_t)word.narg * sizeof(double));
}

static bool begin(LsysSink *sink, const LsysRun *run, uint32_t axiom, unsigned pass) {
  (void)run, (void)axiom, (void)pass;
  BinarySink *binary = (BinarySink *)sink;
  lsys_store_clear(&binary->block);
  return lsys_out_size(binary->out) > 0 || write_header(binary);
}

static bool take(LsysSink *sink, const LsysWord *part) {
  BinarySink *binary = (BinarySink *)sink;
  LsysCut cut;
  lsys_cut_begin(&cut, binary->grammar, part);
  while (cut.rest.nsym) {
    LsysWord next = lsys_cut_take(&cut, BLOCK - binary->block.nsym);
    next.nkey = 0;
    if (!binary->block.sink.take(&binary->block.sink, &next)) return false;
    if (binary->block.nsym == BLOCK && !write_block(binary)) return false;
  }
  return true;
}

static bool end(LsysSink *sink) {
  BinarySink *binary = (BinarySink *)sink;
  return (!binary->block.nsym || write_block(binary)) && write_whole(binary->out, 0);
}

static bool finish(LsysSink *sink) {
  (void)sink;
  return true;
}

static void destroy(LsysSink *sink) {
  BinarySink *binary = (BinarySink *)sink;
  lsys_store_close(&binary->block);
  lsys_memory_free(binary->memory, binary, 1, sizeof *binary);
}

LsysSink *lsys_sink_binary(const LsysSinkContext *context) {
  BinarySink *binary = lsys_memory_alloc(context->memory, 1, sizeof *binary);
  if (!binary) return NULL;
  binary->sink =
    (LsysSink){.passes = 1, .begin = begin, .take = take, .end = end, .finish = finish, .destroy = destroy};
  binary->grammar = context->grammar;
  binary->memory = context->memory;
  binary->out = context->out;
  lsys_store_open(&binary->block, context->grammar, context->memory);
  return &binary->sink;
}
