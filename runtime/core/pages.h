// pages.h -- how to write a word that no cache holds: pages that the system has
// still to give are in the cache once it has cleared them, so that ordinary
// stores are right; into pages that are there, copies go past the caches, which
// saves reading what is overwritten.
#ifndef LSYS_CORE_PAGES_H
#define LSYS_CORE_PAGES_H

#include <stdbool.h>
#include <stddef.h>

// True if nothing was written to the page at this address before, as far as the system tells.
bool lsys_page_fresh(const void *at);

// memcpy past the caches, where the processor can; worth it for some kilobytes and more.
void lsys_copy_past(void *to, const void *from, size_t bytes);

#endif
