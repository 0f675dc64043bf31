// team.h -- the threads that work for one run together: the one that derives,
// which is member 0, and helpers that wait until there is something to do.
#ifndef LSYS_CORE_TEAM_H
#define LSYS_CORE_TEAM_H

#include "core/message.h"
#include "core/stream.h"
#include "core/thread.h"

typedef struct LsysMember {
  LsysWorker worker;  // first: engines hold a pointer to its run, a copy of the caller's
  unsigned number;
  struct LsysTeam *team;
  LsysThread thread;  // of helpers, if started
  bool started;
  uint64_t round;       // the last one that it took part in
  uint64_t failed;      // the item that it failed at
  LsysMessage message;  // why it failed: the caller tells the user if that item comes first
} LsysMember;

typedef void LsysTeamWork(LsysMember *member, void *data);
typedef void LsysTeamItem(LsysMember *member, void *data, uint64_t i);

typedef struct LsysTeam {
  LsysWorker *worker;  // the caller's
  unsigned count;
  LsysMember *members;
  pthread_mutex_t lock;  // guards what follows
  pthread_cond_t changed;
  LsysTeamWork *work;
  void *data;
  uint64_t round;  // so many times work was given out
  unsigned busy;   // helpers that are at it
  bool quit;
} LsysTeam;

// A team of `threads` members, whose threads start when there is work. False after printing why not. Close it in
// either case, but not one that is all zeros.
bool lsys_team_open(LsysTeam *team, LsysWorker *worker, unsigned threads);
void lsys_team_close(LsysTeam *team);

// Lets all helpers do work(member, data), each once, until lsys_team_wait. Their runs are copies of what the caller's
// is now. False after printing why threads did not start; wait in either case.
bool lsys_team_begin(LsysTeam *team, LsysTeamWork *work, void *data);
void lsys_team_wait(LsysTeam *team);

// item(member, data, i) on this very thread; false where the run had to stop, with the reason in member->message.
bool lsys_member_try(LsysMember *member, LsysTeamItem *item, void *data, uint64_t i);

// item(member, data, i) for every i below count, on whatever thread is free; they are begun in order. False after
// printing why the first one in order failed that did.
bool lsys_team_each(LsysTeam *team, uint64_t count, LsysTeamItem *item, void *data);

#endif
