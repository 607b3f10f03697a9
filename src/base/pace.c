/* SPDX-License-Identifier: MIT */
/** @file pace.c
 *  Comparing numbers of threads. */
#include "base/pace.h"

/* Turns of a comparison. Two of each, since another job comes and goes by some milliseconds. */
enum { TURNS = 4 };
/* A turn's length, that of a time slice, and one step at least [s]. */
static const double TURN = 0.005;
/* From the start to the first comparison, from each to the next, twice as long each time that it changes nothing [s]. */
static const double FIRST = 0.03, SHORTEST = 0.1, LONGEST = 2;
/* A comparison may take no more than this part of all time. */
static const double SHARE = 0.04;
/* More threads must bring that much; they cost processor time. */
static const double WORTH = 1.05;
/* What is slower than this times its usual pace is compared at once, if it was not just before [s]. */
static const double DROP = 0.8, PATIENCE = 0.05;

sph2d__pace sph2d__pace_start(int limit)
{
    return (sph2d__pace){.limit = limit, .chosen = limit, .interval = FIRST};
}

/** Whether there are numbers of threads further on that way. */
static bool goes_on(const sph2d__pace *p, bool upwards)
{
    return upwards ? p->chosen < p->limit : p->chosen > 1;
}

/** Twice or half as many, on the way that is open. */
static int rival_of(const sph2d__pace *p)
{
    bool upwards = goes_on(p, p->upwards) ? p->upwards : !p->upwards;
    int twice = 2 * p->chosen < p->limit ? 2 * p->chosen : p->limit;
    return upwards ? twice : p->chosen / 2;
}

static void begin_turn(sph2d__pace *p)
{
    p->turn_spent = p->turn_work = 0;
}

static void compare(sph2d__pace *p)
{
    double rival = p->work[0] / p->spent[0], chosen = p->work[1] / p->spent[1];
    bool better = p->rival > p->chosen ? rival > WORTH * chosen : WORTH * rival > chosen;
    bool upwards = p->rival > p->chosen;
    p->usual = better ? rival : chosen;
    p->chosen = better ? p->rival : p->chosen;
    p->rival = 0;
    p->age = 0;
    if (better) {
        p->upwards = upwards;
        p->interval = goes_on(p, upwards) ? FIRST : SHORTEST;
        return;
    }
    double least = (p->spent[0] + p->spent[1]) / SHARE;
    p->upwards = !upwards; /* the other way next time */
    p->interval = p->interval < SHORTEST ? SHORTEST : 2 * p->interval < LONGEST ? 2 * p->interval : LONGEST;
    p->interval = p->interval > least ? p->interval : least;
}

/** Goes on with a comparison. */
static void take_turn(sph2d__pace *p)
{
    int whose = p->turn % 2;
    p->work[whose] += p->turn_work;
    p->spent[whose] += p->turn_spent;
    begin_turn(p);
    if (++p->turn == TURNS)
        compare(p);
}

/** Begins one when it is time. */
static void question(sph2d__pace *p)
{
    bool dropped = p->usual > 0 && p->turn_work < DROP * p->usual * p->turn_spent && p->age > PATIENCE;
    begin_turn(p);
    if (p->age < p->interval && !dropped)
        return;
    if (dropped)
        p->interval = SHORTEST;
    p->rival = rival_of(p);
    p->turn = 0;
    p->work[0] = p->work[1] = p->spent[0] = p->spent[1] = 0;
}

int sph2d__pace_note(sph2d__pace *p, double work, double seconds)
{
    if (p->limit < 2)
        return 1;
    p->age += seconds;
    p->turn_spent += seconds;
    p->turn_work += work;
    if (p->turn_spent >= TURN) {
        if (p->rival > 0)
            take_turn(p);
        else
            question(p);
    }
    return p->rival > 0 && p->turn % 2 == 0 ? p->rival : p->chosen;
}
