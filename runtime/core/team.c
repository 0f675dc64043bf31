// team.c -- see team.h. Members that fail keep their message to themselves:
// which one the user reads is decided by the order of the work, not by time.
#include "core/team.h"

#include <stdatomic.h>

bool lsys_team_open(LsysTeam *team, LsysWorker *worker, unsigned threads) {
  *team = (LsysTeam){.worker = worker, .count = threads};
  pthread_mutex_init(&team->lock, NULL);
  pthread_cond_init(&team->changed, NULL);
  team->members = lsys_memory_alloc(worker->memory, threads, sizeof *team->members);
  if (!team->members) return false;
  for (unsigned i = 0; i < threads; i++) {
    LsysMember *member = &team->members[i];
    member->team = team;
    member->number = i;
    member->worker.run = worker->run;
    member->worker.memory = worker->memory;
    member->worker.stack_limit = worker->stack_limit;  // helpers get others with their threads
    member->worker.stack_bytes = worker->stack_bytes;
  }
  return true;
}

void lsys_team_close(LsysTeam *team) {
  pthread_mutex_lock(&team->lock);
  team->quit = true;
  pthread_cond_broadcast(&team->changed);
  pthread_mutex_unlock(&team->lock);
  for (unsigned i = 1; team->members && i < team->count; i++)
    if (team->members[i].started) lsys_thread_join(&team->members[i].thread);
  lsys_memory_free(team->worker->memory, team->members, team->count, sizeof *team->members);
  pthread_cond_destroy(&team->changed);
  pthread_mutex_destroy(&team->lock);
  *team = (LsysTeam){0};
}

// ---- helpers -----------------------------------------------------------------

// Waits for the next round; false when there will be none.
static bool wait_for_round(LsysMember *member) {
  LsysTeam *team = member->team;
  pthread_mutex_lock(&team->lock);
  while (!team->quit && team->round == member->round) pthread_cond_wait(&team->changed, &team->lock);
  bool goes_on = !team->quit;
  member->round = team->round;
  pthread_mutex_unlock(&team->lock);
  return goes_on;
}

static void *help(void *data) {
  LsysMember *member = data;
  LsysTeam *team = member->team;
  while (wait_for_round(member)) {
    team->work(member, team->data);
    pthread_mutex_lock(&team->lock);
    if (--team->busy == 0) pthread_cond_broadcast(&team->changed);
    pthread_mutex_unlock(&team->lock);
  }
  return NULL;
}

static bool start(LsysTeam *team) {
  for (unsigned i = 1; i < team->count; i++) {
    LsysMember *member = &team->members[i];
    if (!member->started) member->started = lsys_thread_start(&member->thread, &member->worker, help, member);
    if (!member->started) return false;
  }
  return true;
}

bool lsys_team_begin(LsysTeam *team, LsysTeamWork *work, void *data) {
  for (unsigned i = 0; i < team->count; i++) {
    team->members[i].worker.run = team->worker->run;
    *team->members[i].message.text = 0;
  }
  if (!start(team)) return false;
  pthread_mutex_lock(&team->lock);
  team->work = work;
  team->data = data;
  team->busy = team->count - 1;
  team->round++;
  pthread_cond_broadcast(&team->changed);
  pthread_mutex_unlock(&team->lock);
  return true;
}

void lsys_team_wait(LsysTeam *team) {
  pthread_mutex_lock(&team->lock);
  while (team->busy) pthread_cond_wait(&team->changed, &team->lock);
  pthread_mutex_unlock(&team->lock);
}

// ---- items -------------------------------------------------------------------

bool lsys_member_try(LsysMember *member, LsysTeamItem *item, void *data, uint64_t i) {
  LsysMessage *before = lsys_message_catch(&member->message);
  bool well = setjmp(member->worker.stop) == 0;
  if (well) item(member, data, i);
  lsys_message_catch(before);
  return well;
}

typedef struct Items {
  LsysTeamItem *item;
  void *data;
  uint64_t count;
  _Atomic uint64_t next, failed;  // failed: the first one that did
} Items;

// Every item before one that failed was begun before it, and is still done to its end.
static void do_items(LsysMember *member, void *data) {
  Items *items = data;
  uint64_t i;
  while ((i = atomic_fetch_add(&items->next, 1)) < items->count && i < atomic_load(&items->failed)) {
    if (lsys_member_try(member, items->item, items->data, i)) continue;
    member->failed = i;
    uint64_t first = atomic_load(&items->failed);
    while (i < first && !atomic_compare_exchange_weak(&items->failed, &first, i)) continue;
    return;
  }
}

static void report(const LsysTeam *team, uint64_t failed) {
  for (unsigned i = 0; i < team->count; i++)
    if (team->members[i].failed == failed) lsys_error("%s", team->members[i].message.text);
}

bool lsys_team_each(LsysTeam *team, uint64_t count, LsysTeamItem *item, void *data) {
  Items items = {.item = item, .data = data, .count = count, .failed = UINT64_MAX};
  for (unsigned i = 0; i < team->count; i++) team->members[i].failed = UINT64_MAX;
  bool well = lsys_team_begin(team, do_items, &items);
  if (well) do_items(&team->members[0], &items);
  lsys_team_wait(team);
  uint64_t failed = atomic_load(&items.failed);
  if (failed != UINT64_MAX) report(team, failed);
  return well && failed == UINT64_MAX;
}
