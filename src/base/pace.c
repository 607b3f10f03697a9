/* SPDX-License-Identifier: MIT */
/** @file pace.c
 *  Choosing the number of threads by measured throughput. */
#include "base/pace.h"

#include <math.h>

/* Length of a turn, about one time slice, and at least one step [s]. */
static const double TURN = 0.005;
/* Time from a change to the next comparison [s]; each comparison that changes nothing multiplies it, up to a limit. */
static const double MIN_INTERVAL = 0.03, INTERVAL_GROWTH = 3, MAX_INTERVAL = 3;
/* Comparisons that change nothing take at most this fraction of the time. */
static const double MAX_OVERHEAD = 0.04;
/* More threads are chosen when they are faster by this factor; fewer when they are slower by less: threads cost
 * processor time. */
static const double MIN_GAIN = 1.05;
/* A rival, or the choice with more threads, whose throughput is below this fraction of the other's loses after one pair
 * of turns, if the pair took so long that time slices do not matter [s]. */
static const double CLEAR_LOSS = 0.8, LONG_PAIR = 0.1;
/* Beside other jobs on the same processors one turn in three may get nothing done. A comparison goes on until its
 * result is so many standard errors from the threshold, or up to a number of pairs of turns; at least MIN_PAIRS, or
 * MIN_NOISY_PAIRS when the pairs of the last comparison (the logarithm of their ratio) scattered by more than
 * SCATTER. */
static const double ERRORS = 2, SCATTER = 0.2;
enum { MIN_PAIRS = 2, MIN_NOISY_PAIRS = 5, MAX_PAIRS = 16 };
/* Below this fraction of the usual throughput the next comparison comes earlier: after this fraction of the
 * interval. */
static const double DROP = 0.8, DROP_INTERVAL = 0.25;

sph2d__pace sph2d__pace_start(int limit)
{
    return (sph2d__pace){.limit = limit, .chosen = limit};
}

/** Whether the number of threads can go up, or down. */
static bool can_change(const sph2d__pace *p, bool upwards)
{
    return upwards ? p->chosen < p->limit : p->chosen > 1;
}

/** Twice or half as many threads, in the preferred direction if that is possible. */
static int rival_of(const sph2d__pace *p)
{
    bool upwards = can_change(p, p->upwards) ? p->upwards : !p->upwards;
    int twice = 2 * p->chosen < p->limit ? 2 * p->chosen : p->limit;
    return upwards ? twice : p->chosen / 2;
}

/** Ends a comparison that took `spent` seconds. */
static void decide(sph2d__pace *p, bool better, double spent)
{
    bool upwards = p->rival > p->chosen;
    if (better)
        p->chosen = p->rival;
    p->rival = 0;
    p->age = 0;
    p->upwards = better ? upwards : !upwards; /* go on, or try the other direction next */
    double longer = fmin(fmax(INTERVAL_GROWTH * p->interval, MIN_INTERVAL), MAX_INTERVAL);
    p->interval = better ? MIN_INTERVAL : fmax(longer, spent / MAX_OVERHEAD);
}

/** Standard deviation of the logarithm of pairs of turns. */
static double scatter_of(const sph2d__pace *p)
{
    double pairs = p->turn / 2, mean = p->sum / pairs;
    return sqrt(fmax(p->squares / pairs - mean * mean, 0) * pairs / (pairs - 1));
}

/** Whether the mean of the pairs of turns is significantly off a threshold, or there are enough pairs. */
static bool is_decided(const sph2d__pace *p, double measured, double threshold)
{
    int pairs = p->turn / 2;
    return pairs >= (p->noisy ? MIN_NOISY_PAIRS : MIN_PAIRS) &&
           (fabs(measured - threshold) * sqrt(pairs) > ERRORS * scatter_of(p) || pairs == MAX_PAIRS);
}

/** Ends a turn of a comparison: the rival's or the choice's. */
static void end_turn(sph2d__pace *p)
{
    sph2d__stint now = p->now, *total = p->turn % 2 == 0 ? &p->of_rival : &p->of_choice;
    p->now = (sph2d__stint){0, 0};
    total->work += now.work;
    total->spent += now.spent;
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
    double threshold = more ? log(MIN_GAIN) : -log(MIN_GAIN);
    if (p->turn == 2) {
        if (spent > LONG_PAIR && (ratio < CLEAR_LOSS || (!more && ratio * CLEAR_LOSS > 1)))
            decide(p, ratio > 1, spent);
    } else if (is_decided(p, log(ratio), threshold)) {
        p->noisy = scatter_of(p) > SCATTER;
        decide(p, log(ratio) > threshold, spent);
    }
}

/** Begins a comparison when it is due. */
static void start_comparison(sph2d__pace *p)
{
    bool dropped = p->now.work < DROP * p->usual * p->now.spent;
    p->now = (sph2d__stint){0, 0};
    if (p->age < (dropped ? DROP_INTERVAL : 1) * p->interval)
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
            end_turn(p);
        else
            start_comparison(p);
    }
    return p->rival > 0 && p->turn % 2 == 0 ? p->rival : p->chosen;
}
