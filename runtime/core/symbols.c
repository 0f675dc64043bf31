// symbols.c -- the functions that compiled code may call, by name (abi.h):
// what a JIT binds to addresses in this process.
#include "lsys/abi.h"

#define SYMBOL(name)                                                                                                   \
  { #name, (void *)(uintptr_t)name }

const LsysSymbol lsys_symbols[] = {
  SYMBOL(lsys_charge),     SYMBOL(lsys_fail),       SYMBOL(lsys_flush),        SYMBOL(lsys_append),
  SYMBOL(lsys_too_deep),   SYMBOL(lsys_sin),        SYMBOL(lsys_cos),          SYMBOL(lsys_tan),
  SYMBOL(lsys_asin),       SYMBOL(lsys_acos),       SYMBOL(lsys_atan),         SYMBOL(lsys_atan2),
  SYMBOL(lsys_sqrt),       SYMBOL(lsys_exp),        SYMBOL(lsys_log),          SYMBOL(lsys_pow),
  SYMBOL(lsys_fabs),       SYMBOL(lsys_abs),        SYMBOL(lsys_floor),        SYMBOL(lsys_ceil),
  SYMBOL(lsys_trunc),      SYMBOL(lsys_round),      SYMBOL(lsys_sign),         SYMBOL(lsys_mod),
  SYMBOL(lsys_min),        SYMBOL(lsys_max),        SYMBOL(lsys_ran),          SYMBOL(lsys_nran),
  SYMBOL(lsys_bran),       SYMBOL(lsys_biran),      SYMBOL(lsys_scan_open),    SYMBOL(lsys_scan_close),
  SYMBOL(lsys_scan_enter), SYMBOL(lsys_scan_leave), SYMBOL(lsys_behind),       SYMBOL(lsys_ahead),
  SYMBOL(lsys_right),      SYMBOL(lsys_branch),     SYMBOL(lsys_closes),       SYMBOL(lsys_cut),
  SYMBOL(lsys_cut_short),  SYMBOL(lsys_print),      SYMBOL(lsys_print_to),     SYMBOL(lsys_fopen),
  SYMBOL(lsys_fclose),     SYMBOL(lsys_fscanf),     SYMBOL(lsys_step_letters),

};
const size_t lsys_symbol_count = sizeof lsys_symbols / sizeof *lsys_symbols;
