/* SPDX-License-Identifier: MIT */
/** @file team.c
 *  Helpers, their seats, and the sharing of a loop.
 *
 *  Each helper has a seat: what it is about, and the parts that are its own, in one cache line. The caller opens a seat
 *  with its parts in it; the helper takes the seat, works, and leaves it. A seat that nobody took when all is done is
 *  closed again. Parts are taken by adding to `next`, from the own seat first.
 *
 *  Where another job has a processor, two things cost milliseconds, a time slice, where they could cost microseconds: a
 *  helper that is on the caller's processor, and one that does not get on with a part in hand. The first goes to
 *  another processor, the second is brought to the caller's, which waits. Neither is bound there. */
#define _GNU_SOURCE /* sched_getaffinity and its like */
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

/* How long a thread spins before it sleeps [ns]: longer than what a step does between two loops, and than waking takes;
 * shorter than anybody misses. */
static const int64_t SPIN = 100000;
/* How long the caller waits for a part in hand at least [ns]. */
static const int64_t PATIENCE = 60000;

/** Of a seat. Its helper turns IDLE into ASLEEP, OPEN into TAKEN and leaves with IDLE; the caller does all else. */
enum { IDLE, ASLEEP, OPEN, TAKEN, AWAITED, ENDED };

typedef struct seat {
    alignas(64) atomic_int state;
    atomic_size_t next; /**< part that comes next */
    size_t end;         /**< behind the last */
    sph2d__team *team;
    pthread_t thread;
    cpu_set_t may; /**< where the helper may run, while it is held at the caller's place */
} seat;

/** The loop that is being shared. */
typedef struct loop {
    sph2d__share_work *work;
    void *with;
    size_t count, grain;
    int members;
} loop;

struct sph2d__team {
    loop loop;
    bool sharing;
    int limit, now; /**< most threads, and those that share loops now */
    int started;    /**< threads that there are: 1 at first; fewer than `limit` where the system gives no more */
    pid_t process;  /**< in which they are */
    sph2d__pace pace;
    double parts;           /**< worked on since the pace was looked at */
    int64_t begun;          /**< when that was [ns] */
    atomic_int place;       /**< the processor that the caller was on */
    pthread_mutex_t common; /**< of sph2d__team_lock */
    pthread_mutex_t sleep;
    pthread_cond_t opened, left; /**< some seat was: helpers wait for one, the caller for the other */
    seat *seats;                 /**< `limit`, the caller's first */
};

int sph2d__team_processors(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        return CPU_COUNT(&set);
    long online = sysconf(_SC_NPROCESSORS_ONLN); /* more than the set has bits */
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

/** Moves the calling thread to another of the processors that it may use. */
static void go_elsewhere(const cpu_set_t *may)
{
    cpu_set_t other = *may;
    int here = sched_getcpu();
    if (here >= 0)
        CPU_CLR((size_t)here, &other);
    sched_setaffinity(0, sizeof other, &other); /* fails where there is no other */
    sched_setaffinity(0, sizeof *may, may);
}

/** Leaves the caller's processor. A helper is woken there when all seem busy, and would be in the way of the one that
 *  it should help: who is not running now. */
static void step_aside(const sph2d__team *team)
{
    cpu_set_t may;
    if (sched_getcpu() == atomic_load_explicit(&team->place, memory_order_relaxed) &&
        sched_getaffinity(0, sizeof may, &may) == 0)
        go_elsewhere(&may);
}

/** Brings a helper, which another job keeps from running, to this processor, which its caller is about to leave idle.
 *  The helper goes elsewhere when it has left its seat. */
static void fetch(seat *s)
{
    cpu_set_t here;
    int place = sched_getcpu();
    if (pthread_getaffinity_np(s->thread, sizeof s->may, &s->may) != 0 || place < 0)
        return;
    CPU_ZERO(&here);
    CPU_SET((size_t)place, &here);
    pthread_setaffinity_np(s->thread, sizeof here, &here);
}

/** Spins while a seat is in a state; false when that takes longer than some time [ns]. */
static bool spin_while(seat *s, int state, int64_t most)
{
    enum { LOOKS = 32 }; /* between looks at the clock */
    for (int64_t end = now() + most; now() < end;) {
        for (int k = 0; k < LOOKS; ++k) {
            if (atomic_load_explicit(&s->state, memory_order_acquire) != state)
                return true;
            pause_briefly();
        }
        if (state == IDLE)
            step_aside(s->team);
    }
    return false;
}

/** Sleeps while a seat is in a state, which becomes `asleep`: who changes it sees from that that somebody must be
 *  woken. False when the state is already another. */
static bool sleep_while(seat *s, int state, int asleep, pthread_cond_t *changed)
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

/** Puts a seat into a state, and wakes who sleeps over that; whether somebody did. */
static bool put(seat *s, int state, int asleep, pthread_cond_t *changed)
{
    bool waiting = atomic_exchange_explicit(&s->state, state, memory_order_acq_rel) == asleep;
    if (!waiting || getpid() != s->team->process) /* forked off: nobody is there, the mutex may be locked for ever */
        return false;
    pthread_mutex_lock(&s->team->sleep);
    pthread_cond_broadcast(changed);
    pthread_mutex_unlock(&s->team->sleep);
    return true;
}

/** Works on parts of a seat until there are none. */
static void empty(const loop *l, seat *s)
{
    for (;;) {
        size_t part = atomic_fetch_add_explicit(&s->next, 1, memory_order_relaxed);
        if (part >= s->end)
            return;
        size_t first = part * l->grain;
        l->work(l->with, first, l->count - first > l->grain ? first + l->grain : l->count);
    }
}

/** Works on the parts of member k, then on those that the others have left. */
static void take_part(sph2d__team *team, int k)
{
    const loop *l = &team->loop;
    for (int n = 0; n < l->members; ++n)
        empty(l, &team->seats[(k + n) % l->members]);
}

static void *help(void *argument)
{
    seat *s = argument;
    sph2d__team *team = s->team;
    for (;;) {
        if (!spin_while(s, IDLE, SPIN))
            sleep_while(s, IDLE, ASLEEP, &team->opened);
        int state = OPEN;
        if (atomic_compare_exchange_strong_explicit(&s->state, &state, TAKEN, memory_order_acquire,
                                                    memory_order_acquire)) {
            take_part(team, (int)(s - team->seats));
            if (put(s, IDLE, AWAITED, &team->left))
                go_elsewhere(&s->may);
        } else if (state == ENDED)
            return NULL;
    }
}

/** Starts the helpers, which take no signals: those are for the host's own threads. Where the system gives fewer, the
 *  team makes do. */
static void start(sph2d__team *team)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    team->process = getpid();
    while (team->started < team->limit) {
        seat *s = &team->seats[team->started];
        if (pthread_create(&s->thread, NULL, help, s) != 0)
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
    team->seats = sph2d__alloc(memory, (size_t)limit, sizeof *team->seats);
    if (!team->seats) {
        void *block = team;
        sph2d__release(memory, &block, 1, sizeof *team);
        return NULL;
    }
    for (int k = 0; k < limit; ++k)
        team->seats[k].team = team;
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
            put(&team->seats[k], ENDED, ASLEEP, &team->opened);
        for (int k = 1; k < team->started; ++k)
            pthread_join(team->seats[k].thread, NULL);
        pthread_cond_destroy(&team->opened);
        pthread_cond_destroy(&team->left);
        pthread_mutex_destroy(&team->sleep);
        pthread_mutex_destroy(&team->common);
    }
    void *seats = team->seats, *block = team;
    sph2d__release(memory, &seats, (size_t)team->limit, sizeof *team->seats);
    sph2d__release(memory, &block, 1, sizeof *team);
}

int sph2d__team_limit(const sph2d__team *team)
{
    return team ? team->limit : 1;
}

int sph2d__team_members(const sph2d__team *team, size_t count, size_t grain)
{
    if (!team || team->sharing)
        return 1;
    size_t worth = count / grain;
    return worth < 1 ? 1 : worth < (size_t)team->now ? (int)worth : team->now;
}

/** Gives each member its parts, then opens the seats: who is early may take from all. */
static void open_seats(sph2d__team *team)
{
    const loop *l = &team->loop;
    size_t parts = (l->count + l->grain - 1) / l->grain, members = (size_t)l->members;
    for (size_t k = 0; k < members; ++k) {
        atomic_store_explicit(&team->seats[k].next, parts * k / members, memory_order_relaxed);
        team->seats[k].end = parts * (k + 1) / members;
    }
    atomic_store_explicit(&team->place, sched_getcpu(), memory_order_relaxed);
    for (int k = 1; k < l->members; ++k)
        put(&team->seats[k], OPEN, ASLEEP, &team->opened);
}

/** Closes seats that nobody took, and waits for those who have a part in hand; so long they may take [ns] that nothing
 *  seems to keep them. */
static void close_seats(sph2d__team *team, int64_t patience)
{
    for (int k = 1; k < team->loop.members; ++k) {
        seat *s = &team->seats[k];
        int state = OPEN;
        if (atomic_compare_exchange_strong(&s->state, &state, IDLE))
            continue;
        if (state == TAKEN && !spin_while(s, TAKEN, patience)) {
            fetch(s);
            if (!sleep_while(s, TAKEN, AWAITED, &team->left)) /* it has just left, and does not know */
                pthread_setaffinity_np(s->thread, sizeof s->may, &s->may);
        }
    }
}

void sph2d__share(sph2d__team *team, size_t count, size_t grain, sph2d__share_work *work, void *with)
{
    if (count == 0)
        return;
    int members = sph2d__team_members(team, count, grain);
    if (team && !team->sharing)
        team->parts += (double)count / (double)grain;
    if (members > 1 && team->started == 1) {
        start(team);
        members = sph2d__team_members(team, count, grain);
    }
    if (members == 1) {
        work(with, 0, count);
        return;
    }
    team->loop = (loop){work, with, count, grain, members};
    team->sharing = true;
    int64_t begun = now();
    open_seats(team);
    take_part(team, 0);
    int64_t worked = now() - begun; /* what has one of the parts in hand should not take as long as all of the own */
    close_seats(team, worked > PATIENCE ? worked : PATIENCE);
    team->sharing = false;
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
    team->parts = 0;
    team->begun = now();
}

void sph2d__team_end(sph2d__team *team)
{
    if (team && team->started > 1)
        team->now = sph2d__pace_note(&team->pace, team->parts, 1e-9 * (double)(now() - team->begun));
}

/* Bytes that are worth a thread. */
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
