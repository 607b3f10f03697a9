/* SPDX-License-Identifier: MIT */
/** @file pace.h
 *  How many threads bring most, found by trying.
 *
 *  Beside another job, or where loops are short, fewer threads may be faster, and nothing but the pace tells. From time
 *  to time, and sooner when it drops, the pace is compared with that of half or twice as many threads, in short turns
 *  one after the other, until the difference is larger than the scatter. The longer a choice proves right, the rarer it
 *  is questioned. */
#ifndef SPH2D_BASE_PACE_H
#define SPH2D_BASE_PACE_H

#include <stdbool.h>

/** Work done, in any unit that is always the same, and the time that it took [s]. */
typedef struct sph2d__stint {
    double work, spent;
} sph2d__stint;

typedef struct sph2d__pace {
    int limit;                        /**< most threads */
    int chosen;                       /**< what was best when it was last asked */
    int rival;                        /**< what it is being compared with; 0 when nothing is */
    bool upwards;                     /**< the next comparison is with more threads, where there are */
    int turn;                         /**< of the comparison: the rival's are even */
    sph2d__stint now;                 /**< this turn, or as much time between comparisons */
    sph2d__stint last;                /**< the rival's last turn */
    sph2d__stint of_rival, of_choice; /**< all turns of the comparison */
    double sum, squares; /**< over its pairs of turns: logarithm of the rival's pace over that of the choice */
    bool doubtful;       /**< pairs of the comparison before scattered much */
    double usual;        /**< work a second of the choice when it was last compared */
    double age;          /**< time since then [s] */
    double interval;     /**< until it is compared again [s] */
} sph2d__pace;

/** Starts with as many threads as there may be. */
sph2d__pace sph2d__pace_start(int limit);

/** Takes note of work and the time that it took [s]; returns how many threads to go on with. */
int sph2d__pace_note(sph2d__pace *pace, double work, double seconds);

#endif
