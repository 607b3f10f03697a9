/* SPDX-License-Identifier: MIT */
/** @file pace.c
 *  Comparing numbers of threads. */
#include "base/pace.h"

#include <math.h>

/* A turn's length, about that of a time slice, and one step at least [s]. */
static const double TURN = 0.005;
/* From a change to the next comparison, and so many times longer each time that it changes nothing [s]. */
static const double FIRST = 0.03, LONGER = 3, LONGEST = 3;
/* A comparison that changes nothing may take no more than this part of all time. */
static const double SHARE = 0.04;
/* More threads must bring that much, fewer may lose it: threads cost processor time. */
static const double WORTH = 1.05;
/* What gets less than this done, and is the rival or has more threads, loses after one pair of turns that takes so long
 * that slices of time do not matter [s]. */
static const double POOR = 0.8, LONG = 0.1;
/* Beside several jobs that take slices of the same processors one turn in three may get nothing done. A comparison goes
 * on until what it found is so many standard errors off what it asks, or for so many pairs of turns; where pairs
 * scattered by more than the last (of a logarithm) before, for so many at least. */
static const double ERRORS = 2, SCATTER = 0.2;
enum { LEAST_PAIRS = 2, LEAST_DOUBTFUL = 5, MOST_PAIRS = 16 };
/* What is slower than this times its usual pace is compared sooner: after this part of the time. */
static const double DROP = 0.8, SOONER = 0.25;

sph2d__pace sph2d__pace_start(int limit)
{
    return (sph2d__pace){.limit = limit, .chosen = limit};
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

/** Ends a comparison that took a time. */
static void decide(sph2d__pace *p, bool better, double spent)
{
    bool upwards = p->rival > p->chosen;
    if (better)
        p->chosen = p->rival;
    p->rival = 0;
    p->age = 0;
    p->upwards = better ? upwards : !upwards; /* on, or the other way next time */
    double longer = fmin(fmax(LONGER * p->interval, FIRST), LONGEST);
    p->interval = better ? FIRST : fmax(longer, spent / SHARE);
}

/** Standard deviation of the logarithm of pairs of turns. */
static double scatter_of(const sph2d__pace *p)
{
    double pairs = p->turn / 2, mean = p->sum / pairs;
    return sqrt(fmax(p->squares / pairs - mean * mean, 0) * pairs / (pairs - 1));
}

/** Whether what the pairs of turns found is beyond doubt, or has taken long enough. */
static bool is_sure(const sph2d__pace *p, double found, double asked)
{
    int pairs = p->turn / 2;
    return pairs >= (p->doubtful ? LEAST_DOUBTFUL : LEAST_PAIRS) &&
           (fabs(found - asked) * sqrt(pairs) > ERRORS * scatter_of(p) || pairs == MOST_PAIRS);
}

/** Ends a turn of a comparison. */
static void take_turn(sph2d__pace *p)
{
    sph2d__stint now = p->now, *whole = p->turn % 2 == 0 ? &p->of_rival : &p->of_choice;
    p->now = (sph2d__stint){0, 0};
    whole->work += now.work;
    whole->spent += now.spent;
    if (p->turn++ % 2 == 0) {
        p->last = now;
        return;
    }
    const sph2d__stint *rival = &p->of_rival, *choice = &p->of_choice;
    double pair = log(p->last.work * now.spent / (now.work * p->last.spent));
    double ratio = rival->work * choice->spent / (choice->work * rival->spent), spent = rival->spent + choice->spent;
    bool more = p->rival > p->chosen;
    p->usual = choice->work / choice->spent;
    p->sum += pair;
    p->squares += pair * pair;
    double asked = more ? log(WORTH) : -log(WORTH);
    if (p->turn == 2) {
        if (spent > LONG && (ratio < POOR || (!more && ratio * POOR > 1)))
            decide(p, ratio > 1, spent);
    } else if (is_sure(p, log(ratio), asked)) {
        p->doubtful = scatter_of(p) > SCATTER;
        decide(p, log(ratio) > asked, spent);
    }
}

/** Begins a comparison when it is time. */
static void question(sph2d__pace *p)
{
    bool dropped = p->now.work < DROP * p->usual * p->now.spent;
    p->now = (sph2d__stint){0, 0};
    if (p->age < (dropped ? SOONER : 1) * p->interval)
        return;
    p->rival = rival_of(p);
    p->turn = 0;
    p->of_rival = p->of_choice = (sph2d__stint){0, 0};
    p->sum = p->squares = 0;
}

int sph2d__pace_note(sph2d__pace *p, double work, double seconds)
{
    if (p->limit < 2)
        return 1;
    p->age += seconds;
    p->now.work += work;
    p->now.spent += seconds;
    if (p->now.spent >= TURN) {
        if (p->rival > 0)
            take_turn(p);
        else
            question(p);
    }
    return p->rival > 0 && p->turn % 2 == 0 ? p->rival : p->chosen;
}
