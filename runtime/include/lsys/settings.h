// settings.h -- the run's settings: slots 0 .. LSYS_SETTING_COUNT-1 of its value array.
#ifndef LSYS_SETTINGS_H
#define LSYS_SETTINGS_H

typedef enum LsysSetting {
#define SETTING(id, keyword, others, value, unit, doc) LSYS_SETTING_##id,
#include "lsys/settings.def"
  LSYS_SETTING_COUNT
} LsysSetting;

// Numbered tropisms, and how many settings each has.
enum { LSYS_TROPISMS = 4, LSYS_TROPISM_SETTINGS = LSYS_SETTING_TROPISM_2_X - LSYS_SETTING_TROPISM_1_X };

typedef struct LsysSettingInfo {
  const char *keyword, *others;
  double value;
  const char *unit, *doc;
} LsysSettingInfo;

// What a grammar says of its pictures, as text.
typedef enum LsysPageSetting {
#define PAGE(id, keyword, others, form, option, doc) LSYS_PAGE_##id,
#include "lsys/settings.def"
  LSYS_PAGE_COUNT
} LsysPageSetting;

typedef struct LsysPageInfo {
  const char *keyword, *others, *form, *doc;
} LsysPageInfo;

extern const LsysPageInfo lsys_page_settings[LSYS_PAGE_COUNT];

// What is wanted instead of a text; NULL: nothing is wrong with it.
const char *lsys_page_wrong(LsysPageSetting setting, const char *text);

extern const LsysSettingInfo lsys_settings[LSYS_SETTING_COUNT];

#endif
