/* SPDX-License-Identifier: MIT */
/** @file team.c
 *  Worker threads, their slots, and parallel loops.
 *
 *  Each worker has a slot, one cache line: its state, and the chunks of the loop that are its own. The caller opens a
 *  slot with chunks in it; the worker takes the slot, works, and leaves it. A slot that no worker has taken when all
 *  chunks are done is closed again. A chunk is taken by incrementing `next`, from the own slot first (work stealing).
 *
 *  Where another job has a processor, two things cost a time slice, milliseconds, where they could cost microseconds: a
 *  worker on the caller's processor, and a worker that is preempted in the middle of a chunk. The first moves to
 *  another processor; the second is moved to the caller's, which waits. Neither stays bound to it. */
#define _GNU_SOURCE /* sched_getaffinity, pthread_setaffinity_np */
#include "base/team.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdalign.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/pace.h"

/* How long a thread spins before it sleeps [ns]: longer than the serial code between two loops of a step, and than
 * waking a thread takes; short enough not to waste processor time. */
static const int64_t SPIN = 100000;
/* How long the caller waits at least for a chunk that is being worked on [ns]. */
static const int64_t MIN_WAIT = 60000;

/** States of a slot. Its worker sets ASLEEP from IDLE, TAKEN from OPEN, and IDLE when done; the caller the others. */
enum { IDLE, ASLEEP, OPEN, TAKEN, AWAITED, ENDED };

typedef struct slot {
    alignas(64) atomic_int state;
    atomic_size_t next; /**< next chunk */
    size_t end;         /**< one past the last chunk */
    sph2d__team *team;
    pthread_t thread;
    cpu_set_t may; /**< affinity to restore, while the worker is moved to the caller's processor */
} slot;

/** The loop that is being run. */
typedef struct loop {
    sph2d__share_work *work;
    void *with;
    size_t count, grain;
    int members;
} loop;

struct sph2d__team {
    loop loop;
    bool running;
    int limit, now; /**< maximum number of threads, and the number in use */
    int started;    /**< threads that exist: 1 at first; fewer than `limit` if the system refuses more */
    pid_t process;  /**< that started them */
    sph2d__pace pace;
    double chunks;          /**< since sph2d__team_begin */
    int64_t begun;          /**< time of sph2d__team_begin [ns] */
    atomic_int caller_cpu;  /**< the processor of the caller at the start of the loop */
    pthread_mutex_t common; /**< for sph2d__team_lock */
    pthread_mutex_t sleep;
    pthread_cond_t opened, left; /**< a slot was opened (workers wait), or left (the caller waits) */
    slot *slots;                 /**< `limit` slots, the caller's first */
};

int sph2d__team_processors(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        return CPU_COUNT(&set);
    long online = sysconf(_SC_NPROCESSORS_ONLN); /* more processors than the set has bits */
    return online < 1 ? 1 : online < 1024 ? (int)online : 1024;
}

static int64_t now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

static inline void pause_briefly(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("isb");
#endif
}

/** Moves the calling thread to another processor of its affinity mask. */
static void move_away(const cpu_set_t *may)
{
    cpu_set_t other = *may;
    int here = sched_getcpu();
    if (here >= 0)
        CPU_CLR((size_t)here, &other);
    sched_setaffinity(0, sizeof other, &other); /* fails if there is no other */
    sched_setaffinity(0, sizeof *may, may);
}

/** Leaves the caller's processor. The system may wake a worker there when all processors seem busy, and then it keeps
 *  the caller from running. */
static void leave_caller_cpu(const sph2d__team *team)
{
    cpu_set_t may;
    if (sched_getcpu() == atomic_load_explicit(&team->caller_cpu, memory_order_relaxed) &&
        sched_getaffinity(0, sizeof may, &may) == 0)
        move_away(&may);
}

/** Moves a worker that another job has preempted to this processor, which the caller is about to leave idle. The worker
 *  moves away again when it has left its slot. */
static void move_here(slot *s)
{
    cpu_set_t here;
    int cpu = sched_getcpu();
    if (pthread_getaffinity_np(s->thread, sizeof s->may, &s->may) != 0 || cpu < 0)
        return;
    CPU_ZERO(&here);
    CPU_SET((size_t)cpu, &here);
    pthread_setaffinity_np(s->thread, sizeof here, &here);
}

/** Spins while a slot is in a state; false if it still is after a time [ns]. */
static bool spin_while(slot *s, int state, int64_t timeout)
{
    enum { CHECKS = 32 }; /* of the state between two readings of the clock */
    for (int64_t end = now() + timeout; now() < end;) {
        for (int k = 0; k < CHECKS; ++k) {
            if (atomic_load_explicit(&s->state, memory_order_acquire) != state)
                return true;
            pause_briefly();
        }
        if (state == IDLE)
            leave_caller_cpu(s->team);
    }
    return false;
}

/** Sleeps while a slot is in a state, which becomes `asleep`: the thread that changes it then knows that it must wake
 *  the sleeper. False if the state has already changed. */
static bool sleep_while(slot *s, int state, int asleep, pthread_cond_t *changed)
{
    sph2d__team *team = s->team;
    if (!atomic_compare_exchange_strong(&s->state, &state, asleep))
        return false;
    pthread_mutex_lock(&team->sleep);
    while (atomic_load_explicit(&s->state, memory_order_acquire) == asleep)
        pthread_cond_wait(changed, &team->sleep);
    pthread_mutex_unlock(&team->sleep);
    return true;
}

/** Sets the state of a slot and wakes the thread that sleeps on it; whether one did. */
static bool set_state(slot *s, int state, int asleep, pthread_cond_t *changed)
{
    bool waiting = atomic_exchange_explicit(&s->state, state, memory_order_acq_rel) == asleep;
    if (!waiting || getpid() != s->team->process) /* a forked child has no workers, and the mutex may stay locked */
        return false;
    pthread_mutex_lock(&s->team->sleep);
    pthread_cond_broadcast(changed);
    pthread_mutex_unlock(&s->team->sleep);
    return true;
}

/** Works on the chunks of a slot until there are none. */
static void work_off(const loop *l, slot *s)
{
    for (;;) {
        size_t chunk = atomic_fetch_add_explicit(&s->next, 1, memory_order_relaxed);
        if (chunk >= s->end)
            return;
        size_t first = chunk * l->grain;
        l->work(l->with, first, l->count - first > l->grain ? first + l->grain : l->count);
    }
}

/** Works on the chunks of member k, then on those that the others have not begun. */
static void take_chunks(sph2d__team *team, int k)
{
    const loop *l = &team->loop;
    for (int n = 0; n < l->members; ++n)
        work_off(l, &team->slots[(k + n) % l->members]);
}

static void *worker(void *argument)
{
    slot *s = argument;
    sph2d__team *team = s->team;
    for (;;) {
        if (!spin_while(s, IDLE, SPIN))
            sleep_while(s, IDLE, ASLEEP, &team->opened);
        int state = OPEN;
        if (atomic_compare_exchange_strong_explicit(&s->state, &state, TAKEN, memory_order_acquire,
                                                    memory_order_acquire)) {
            take_chunks(team, (int)(s - team->slots));
            if (set_state(s, IDLE, AWAITED, &team->left))
                move_away(&s->may);
        } else if (state == ENDED)
            return NULL;
    }
}

/** Starts the workers, with all signals blocked: the host's own threads handle them. The team is smaller if the system
 *  refuses threads. */
static void start(sph2d__team *team)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    team->process = getpid();
    while (team->started < team->limit) {
        slot *s = &team->slots[team->started];
        if (pthread_create(&s->thread, NULL, worker, s) != 0)
            break;
        ++team->started;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    team->now = team->started;
    team->pace = sph2d__pace_start(team->started);
}

sph2d__team *sph2d__team_create(sph2d__memory *memory, int limit)
{
    sph2d__team *team = sph2d__alloc(memory, 1, sizeof *team);
    if (!team)
        return NULL;
    team->limit = team->now = limit;
    team->started = 1;
    team->pace = sph2d__pace_start(limit);
    team->slots = sph2d__alloc(memory, (size_t)limit, sizeof *team->slots);
    if (!team->slots) {
        void *block = team;
        sph2d__release(memory, &block, 1, sizeof *team);
        return NULL;
    }
    for (int k = 0; k < limit; ++k)
        team->slots[k].team = team;
    pthread_mutex_init(&team->common, NULL);
    pthread_mutex_init(&team->sleep, NULL);
    pthread_cond_init(&team->opened, NULL);
    pthread_cond_init(&team->left, NULL);
    return team;
}

void sph2d__team_destroy(sph2d__team *team, sph2d__memory *memory)
{
    if (!team)
        return;
    if (team->started == 1 || getpid() == team->process) {
        for (int k = 1; k < team->started; ++k)
            set_state(&team->slots[k], ENDED, ASLEEP, &team->opened);
        for (int k = 1; k < team->started; ++k)
            pthread_join(team->slots[k].thread, NULL);
        pthread_cond_destroy(&team->opened);
        pthread_cond_destroy(&team->left);
        pthread_mutex_destroy(&team->sleep);
        pthread_mutex_destroy(&team->common);
    }
    void *slots = team->slots, *block = team;
    sph2d__release(memory, &slots, (size_t)team->limit, sizeof *team->slots);
    sph2d__release(memory, &block, 1, sizeof *team);
}

int sph2d__team_limit(const sph2d__team *team)
{
    return team ? team->limit : 1;
}

int sph2d__team_members(const sph2d__team *team, size_t count, size_t grain)
{
    if (!team || team->running)
        return 1;
    size_t worth = count / grain;
    return worth < 1 ? 1 : worth < (size_t)team->now ? (int)worth : team->now;
}

/** Gives each member its chunks, then opens the slots: a worker that is early may take chunks of all members. */
static void open_slots(sph2d__team *team)
{
    const loop *l = &team->loop;
    size_t chunks = (l->count + l->grain - 1) / l->grain, members = (size_t)l->members;
    for (size_t k = 0; k < members; ++k) {
        atomic_store_explicit(&team->slots[k].next, chunks * k / members, memory_order_relaxed);
        team->slots[k].end = chunks * (k + 1) / members;
    }
    atomic_store_explicit(&team->caller_cpu, sched_getcpu(), memory_order_relaxed);
    for (int k = 1; k < l->members; ++k)
        set_state(&team->slots[k], OPEN, ASLEEP, &team->opened);
}

/** Closes slots that no worker has taken, and waits for workers that are busy with a chunk; one that takes longer than
 *  `wait` [ns] has probably been preempted and is moved here. */
static void close_slots(sph2d__team *team, int64_t wait)
{
    for (int k = 1; k < team->loop.members; ++k) {
        slot *s = &team->slots[k];
        int state = OPEN;
        if (atomic_compare_exchange_strong(&s->state, &state, IDLE))
            continue;
        if (state == TAKEN && !spin_while(s, TAKEN, wait)) {
            move_here(s);
            if (!sleep_while(s, TAKEN, AWAITED, &team->left)) /* it left just now, before it was moved: undo that */
                pthread_setaffinity_np(s->thread, sizeof s->may, &s->may);
        }
    }
}

void sph2d__share(sph2d__team *team, size_t count, size_t grain, sph2d__share_work *work, void *with)
{
    if (count == 0)
        return;
    int members = sph2d__team_members(team, count, grain);
    if (team && !team->running)
        team->chunks += (double)count / (double)grain;
    if (members > 1 && team->started == 1) {
        start(team);
        members = sph2d__team_members(team, count, grain);
    }
    if (members == 1) {
        work(with, 0, count);
        return;
    }
    team->loop = (loop){work, with, count, grain, members};
    team->running = true;
    int64_t begun = now();
    open_slots(team);
    take_chunks(team, 0);
    int64_t worked = now() - begun; /* one chunk should not take as long as all of the caller's own */
    close_slots(team, worked > MIN_WAIT ? worked : MIN_WAIT);
    team->running = false;
}

void sph2d__team_lock(sph2d__team *team)
{
    if (team)
        pthread_mutex_lock(&team->common);
}

void sph2d__team_unlock(sph2d__team *team)
{
    if (team)
        pthread_mutex_unlock(&team->common);
}

void sph2d__team_begin(sph2d__team *team)
{
    if (!team)
        return;
    team->chunks = 0;
    team->begun = now();
}

void sph2d__team_end(sph2d__team *team)
{
    if (team && team->started > 1)
        team->now = sph2d__pace_note(&team->pace, team->chunks, 1e-9 * (double)(now() - team->begun));
}

/* Bytes that are worth another thread. */
enum { LARGE = 1 << 21 };

static void clear_part(void *block, size_t first, size_t last)
{
    memset((char *)block + first, 0, last - first);
}

static void clear(void *team, char *block, size_t size)
{
    sph2d__share(team, size, LARGE, clear_part, block);
}

void sph2d__team_clears(sph2d__team *team, sph2d__memory *memory)
{
    memory->clear = team ? clear : NULL;
    memory->helper = team;
}
