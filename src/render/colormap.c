/* SPDX-License-Identifier: MIT */
/** @file colormap.c
 *  The colour map viridis: perceptually uniform, also in grey and with most kinds of colour blindness; and for values of
 *  either sign one from blue to red, whose middle is a grey that lit surfaces do not hide. */
#include "render/colormap.h"

#include <math.h>
#include <string.h>

enum { ANCHORS = 9 };

/* Colours of viridis (by S. van der Walt and N. Smith, in the public domain under CC0), evenly spaced. */
static const unsigned char viridis[ANCHORS][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                                  {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                                  {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

/* Colours of the cool to warm map of K. Moreland, Diverging color maps for scientific visualization, Advances in Visual
 * Computing, 2009. */
static const unsigned char cool_warm[ANCHORS][3] = {{59, 76, 192},   {98, 130, 234},  {141, 176, 254},
                                                    {184, 208, 249}, {221, 221, 221}, {245, 196, 173},
                                                    {244, 154, 123}, {222, 96, 77},   {180, 4, 38}};

void sph2d__colormap(double t, bool diverging, unsigned char color[4])
{
    static const unsigned char unknown[4] = {150, 150, 150, 255};
    if (isnan(t)) {
        memcpy(color, unknown, sizeof unknown);
        return;
    }
    const unsigned char(*anchors)[3] = diverging ? cool_warm : viridis;
    const int last = ANCHORS - 1;
    const double at = fmin(fmax(t, 0.0), 1.0) * last;
    const int low = at < last ? (int)at : last - 1;
    for (int c = 0; c < 3; ++c)
        color[c] = (unsigned char)lrint(anchors[low][c] + (at - low) * (anchors[low + 1][c] - anchors[low][c]));
    color[3] = 255;
}
