/* SPDX-License-Identifier: MIT */
/** @file cubic.h
 *  Interpolation by cubics between nodes that may be any distances apart.
 *
 *  Between two nodes it is Hermite's cubic of their values and slopes; the slope at a node is that of the polynomial
 *  through it and its two neighbours on either side (at the ends of the nodes the nearest five; all if there are fewer).
 *  Cubic functions are exact from four nodes on, quadratic ones from three. Others have errors of the fourth order in the
 *  distance of the nodes, and slopes are continuous. Fritsch & Carlson 1980 call it the piecewise cubic of given slopes. */
#ifndef SPH2D_SCENE_CUBIC_H
#define SPH2D_SCENE_CUBIC_H

#include <stddef.h>

/** The nodes that a value depends on: value = sum of weight[k] f(first + k). */
enum { SPH2D__CUBIC_NODES = 6 };
typedef struct sph2d__cubic {
    size_t first, count;
    double weight[SPH2D__CUBIC_NODES];
} sph2d__cubic;

/** The weights at a place among `count` increasing nodes, 1 at least, `stride` doubles apart; beyond them those of the
 *  nearest end. */
sph2d__cubic sph2d__cubic_at(const double *items, size_t stride, size_t count, double place);

#endif
