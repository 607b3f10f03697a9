/* SPDX-License-Identifier: MIT */
/** @file colormap.c
 *  The colour map viridis: perceptually uniform, also in grey and with most kinds of colour blindness. */
#include "render/colormap.h"

#include <math.h>
#include <string.h>

/* Nine of viridis' colours (by S. van der Walt and N. Smith, in the public domain under CC0), evenly spaced. */
static const unsigned char anchors[9][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                            {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                            {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};

void sph2d__colormap(double t, unsigned char color[4])
{
    static const unsigned char unknown[4] = {150, 150, 150, 255};
    if (isnan(t)) {
        memcpy(color, unknown, sizeof unknown);
        return;
    }
    const int last = (int)(sizeof anchors / sizeof anchors[0]) - 1;
    const double at = fmin(fmax(t, 0.0), 1.0) * last;
    const int low = at < last ? (int)at : last - 1;
    for (int c = 0; c < 3; ++c)
        color[c] = (unsigned char)lrint(anchors[low][c] + (at - low) * (anchors[low + 1][c] - anchors[low][c]));
    color[3] = 255;
}
