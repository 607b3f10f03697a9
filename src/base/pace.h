/* SPDX-License-Identifier: MIT */
/** @file pace.h
 *  Chooses the number of threads by measured throughput.
 *
 *  Beside another job, or where loops are short, fewer threads may be faster, and only the throughput shows it. From
 *  time to time, and sooner when it drops, it is compared with that of half or twice as many threads, in short
 *  alternating turns, until the difference is significant. The longer a choice stands, the rarer it is compared. */
#ifndef SPH2D_BASE_PACE_H
#define SPH2D_BASE_PACE_H

#include <stdbool.h>

/** Work done, in any fixed unit, and the time that it took [s]. */
typedef struct sph2d__stint {
    double work, spent;
} sph2d__stint;

typedef struct sph2d__pace {
    int limit;                        /**< maximum number of threads */
    int chosen;                       /**< number of threads that won the last comparison */
    int rival;                        /**< number that it is being compared with; 0 for none */
    bool upwards;                     /**< the next comparison is with more threads, if possible */
    int turn;                         /**< index in the comparison; even ones are the rival's */
    sph2d__stint now;                 /**< the present turn, or a period of the same length between comparisons */
    sph2d__stint last;                /**< the rival's last turn */
    sph2d__stint of_rival, of_choice; /**< all turns of the comparison */
    double sum, squares;              /**< over pairs of turns: logarithm of the rival's throughput over the choice's */
    bool noisy;                       /**< the pairs of the last comparison scattered much */
    double usual;                     /**< throughput of the choice in the last comparison [work/s] */
    double age;                       /**< time since the last comparison [s] */
    double interval;                  /**< time to the next comparison [s] */
} sph2d__pace;

/** Starts with the maximum number of threads. */
sph2d__pace sph2d__pace_start(int limit);

/** Records work and the time that it took [s]; returns the number of threads to use next. */
int sph2d__pace_note(sph2d__pace *pace, double work, double seconds);

#endif
