/* SPDX-License-Identifier: MIT */
/** @file pace.h
 *  How many threads bring most, found by trying.
 *
 *  Beside another job, or where loops are short, fewer threads may be faster, and nothing but the pace tells. From time
 *  to time, and at once when it drops, the pace is compared with that of half or twice as many, in short turns one
 *  after the other. The longer a choice proves right, the rarer it is questioned. */
#ifndef SPH2D_BASE_PACE_H
#define SPH2D_BASE_PACE_H

#include <stdbool.h>

typedef struct sph2d__pace {
    int limit;       /**< most threads */
    int chosen;      /**< what was best when it was last asked */
    int rival;       /**< what it is being compared with; 0 when nothing is */
    bool upwards;    /**< the next comparison is with more threads, where there are */
    int turn;        /**< of the comparison: the rival's are even */
    double work[2];  /**< done by the rival and by the choice, in any unit that is always the same */
    double spent[2]; /**< and the time that it took [s] */
    double turn_spent, turn_work;
    double usual;    /**< work a second of the choice when it was last compared */
    double age;      /**< time since then [s] */
    double interval; /**< until it is compared again [s] */
} sph2d__pace;

/** Starts with as many threads as there may be. */
sph2d__pace sph2d__pace_start(int limit);

/** Takes note of work and the time that it took [s]; returns how many threads to go on with. */
int sph2d__pace_note(sph2d__pace *pace, double work, double seconds);

#endif
