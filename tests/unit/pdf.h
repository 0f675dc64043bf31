// pdf.h -- a reader of the PDF files that we write, from its end as viewers read one: startxref, xref, objects, the
// page's content inflated. Knows nothing of the writer.
#ifndef TESTS_UNIT_PDF_H
#define TESTS_UNIT_PDF_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

typedef struct PdfFile {
  double box[4];        // of the page
  char *content;        // to be freed
  unsigned count[128];  // of each operator of one letter
} PdfFile;

// The text behind "NUMBER 0 obj" that the table has for an object; NULL if it is not there.
static inline const char *pdf_object(const char *text, size_t size, const char *table, unsigned long number) {
  unsigned long first, count, place, generation;
  char use, head[32];
  if (sscanf(table, "xref\n%lu %lu\n", &first, &count) != 2 || first != 0 || number >= count) return NULL;
  const char *rows = strchr(strchr(table, '\n') + 1, '\n') + 1, *row = rows + 20 * number;
  if (sscanf(row, "%10lu %5lu %c \n", &place, &generation, &use) != 3 || use != 'n' || place >= size) return NULL;
  int length = snprintf(head, sizeof head, "%lu 0 obj\n", number);
  return strncmp(text + place, head, (size_t)length) == 0 ? text + place + length : NULL;
}

// The object that a dictionary without others in it refers to under a key.
static inline const char *pdf_follow(const char *text, size_t size, const char *table, const char *from,
                                     const char *key) {
  const char *end = from ? strstr(from, ">>\n") : NULL, *at = end ? strstr(from, key) : NULL;
  unsigned long number;
  if (!at || at > end || sscanf(at + strlen(key), "%*[ []%lu 0 R", &number) != 1) return NULL;
  return pdf_object(text, size, table, number);
}

// All numbers finite, each operator with as many as it takes.
static inline const char *pdf_operators(PdfFile *pdf) {
  static const struct {
    const char *name;
    int numbers;
  } known[] = {{"m", 2},  {"l", 2}, {"S", 0}, {"f", 0}, {"re", 4}, {"rg", 3},
               {"RG", 3}, {"w", 1}, {"J", 1}, {"j", 1}, {"cm", 6}};
  int numbers = 0;
  for (char *at = pdf->content + strspn(pdf->content, " \n"); *at; at += strspn(at, " \n")) {
    char *end;
    size_t length = strcspn(at, " \n");
    if (isfinite(strtod(at, &end)) && end == at + length && strcspn(at, "eEx") >= length) {
      numbers++;
      at = end;
      continue;
    }
    size_t which = 0, all = sizeof known / sizeof *known;
    while (which < all && (strlen(known[which].name) != length || strncmp(known[which].name, at, length))) which++;
    if (which == all || known[which].numbers != numbers) return "has an odd operator";
    if (length == 1) pdf->count[(unsigned char)*at]++;
    numbers = 0;
    at += length;
  }
  return numbers ? "ends within an operator" : NULL;
}

static inline const char *pdf_inflate(PdfFile *pdf, const char *from, unsigned long length) {
  for (unsigned long room = 1 << 16; room < 1ul << 28; room *= 2) {
    unsigned long filled = room;
    pdf->content = realloc(pdf->content, room + 1);
    int status = uncompress((Bytef *)pdf->content, &filled, (const Bytef *)from, length);
    pdf->content[status == Z_OK ? filled : 0] = 0;
    if (status == Z_BUF_ERROR) continue;
    return status == Z_OK ? pdf_operators(pdf) : "has a content that cannot be inflated";
  }
  return "has too much content";
}

// What is wrong with the file, whose bytes end with one more, 0; NULL: nothing.
static inline const char *pdf_read(PdfFile *pdf, const uint8_t *bytes, size_t size) {
  const char *text = (const char *)bytes;
  *pdf = (PdfFile){0};
  if (size < 200 || strncmp(text, "%PDF-1.", 7) || strcmp(text + size - 6, "%%EOF\n")) return "is no PDF";
  unsigned long place, length;
  const char *tail = text + size - 40;
  while (tail < text + size && strncmp(tail, "startxref\n", 10)) tail++;
  if (tail == text + size || sscanf(tail + 10, "%lu\n", &place) != 1 || place >= size) return "has no startxref";
  const char *table = text + place, *trailer = strstr(table, "trailer");
  if (strncmp(table, "xref\n", 5) || !trailer || !strstr(trailer, "/Root")) return "has no xref where it says";
  unsigned long root = strtoul(strstr(trailer, "/Root") + 5, NULL, 10);
  const char *pages = pdf_follow(text, size, table, pdf_object(text, size, table, root), "/Pages");
  const char *page = pdf_follow(text, size, table, pages, "/Kids"), *box = page ? strstr(page, "/MediaBox[") : NULL;
  double *b = pdf->box;
  if (!box || sscanf(box + 10, "%lf %lf %lf %lf]", &b[0], &b[1], &b[2], &b[3]) != 4) return "has no page";
  const char *content = pdf_follow(text, size, table, page, "/Contents");
  const char *size_at = pdf_follow(text, size, table, content, "/Length");
  const char *stream = content ? strstr(content, "stream\n") : NULL;
  if (!size_at || !stream || sscanf(size_at, "%lu\nendobj", &length) != 1) return "has no content";
  stream += 7;
  if (length > (size_t)(text + size - stream) || strncmp(stream + length, "\nendstream\n", 11))
    return "has a content of another length";
  return pdf_inflate(pdf, stream, length);
}

#endif
