// environment.h -- what a plant grows in: the interface between a derivation and the world around it.
//
// Before each step the turtle reads the word. Queries (?P ?H ?L ?U ?F) get where and how it stands; communication
// modules (?E) are handed to the environment with that, all at once, and it sets their arguments. What it answers has
// to depend on the scene alone for derivations to be reproducible.
//
// An environment of one's own is a shared object that exports
//
//   const LsysEnvironment lsys_environment = {LSYS_ENVIRONMENT_VERSION, 0, answer};
//
// and is named by its file: `environment: "./wind.so"`. `lsysc help environments` shows the built-in ones.
#ifndef LSYS_ENVIRONMENT_H
#define LSYS_ENVIRONMENT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LSYS_ENVIRONMENT_VERSION 1u

enum { LSYS_ENVIRONMENT_VALUES = 2 };  // parameters at most

typedef enum LsysEnvironmentId {
  LSYS_ENVIRONMENT_NONE,
#define ENVIRONMENT(id, name, first, first_value, second, second_value, doc) LSYS_ENVIRONMENT_##id,
#include "lsys/environments.def"
  LSYS_ENVIRONMENT_COUNT,
  LSYS_ENVIRONMENT_FILE = LSYS_ENVIRONMENT_COUNT
} LsysEnvironmentId;

typedef struct LsysEnvironmentInfo {
  const char *name;
  const char *parameter[LSYS_ENVIRONMENT_VALUES];  // "" where there is none
  double value[LSYS_ENVIRONMENT_VALUES];           // defaults
  const char *doc;
} LsysEnvironmentInfo;

extern const LsysEnvironmentInfo lsys_environment_table[LSYS_ENVIRONMENT_COUNT];

// A communication module, and how the turtle stands at it.
typedef struct LsysCommunication {
  double at[3], heading[3], left[3], up[3];
  double drawn[3];  // the end of the last line on its path; the turtle's first place if there is none
  double width;     // of lines
  uint64_t module;  // its number in the word, from 0
  uint32_t lines;   // on its path: 0 if nothing is drawn there
  uint32_t arity;
  double *argument;  // arity of them: what it says, to be overwritten by what it hears
} LsysCommunication;

typedef struct LsysScene LsysScene;
struct LsysScene {
  const double *parameter;     // of the environment, as the grammar gives them
  LsysCommunication *message;  // in the order of the word
  size_t messages;
  const double (*line)[6];  // what is drawn: x, y, z of both ends; only where the environment asks for lines
  size_t lines;

  // Memory that is kept until the next call of it; NULL after printing that there is none.
  void *(*room)(LsysScene *scene, size_t bytes);
};

enum { LSYS_ENVIRONMENT_LINES = 1 };  // it wants to see the lines

typedef struct LsysEnvironment {
  uint32_t version;
  uint32_t wants;                   // LSYS_ENVIRONMENT_*
  int (*answer)(LsysScene *scene);  // 0 to stop the derivation
} LsysEnvironment;

#ifdef __cplusplus
}
#endif
#endif
