/* SPDX-License-Identifier: MIT */
/** @file convex.h
 *  Convex pieces of a polygon: ears are cut off, and triangles joined as long as they stay convex (Hertel, Mehlhorn,
 *  LNCS 158 (1983) 207-218: at most four times as many pieces as needed). cpPolylineConvexDecomposition() recurses
 *  without end where corners are on a line but for rounding (7.0.3). */
#ifndef SPH2D_CONTACTS_CONVEX_H
#define SPH2D_CONTACTS_CONVEX_H

#include "sph2d/scene.h"

/** Corners of a piece, anticlockwise: indices of the polygon's. */
typedef struct sph2d__piece {
    int count;
    int *corners; /**< room for all corners of the polygon */
} sph2d__piece;

/** Twice the area of a triangle, positive if it is anticlockwise. */
double sph2d__turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c);

/** Cuts a polygon without crossings, its corners anticlockwise. `left` has room for `count` indices, `pieces` are
 *  `count` - 2. Returns how many there are. It comes to an end whatever the corners are. */
int sph2d__convex_pieces(const sph2d_vec2 *corners, int count, int *left, sph2d__piece *pieces);

#endif
