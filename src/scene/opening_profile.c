/* SPDX-License-Identifier: MIT */
/** @file opening_profile.c */
#include "scene/opening_profile.h"

#include <math.h>

#include "scene/cubic.h"

/* Doubles from one point to the next. */
enum { STRIDE = sizeof(sph2d_path_point) / sizeof(double) };

size_t sph2d__profile_places(const sph2d_path *profile)
{
    size_t count = 1;
    while (count < profile->count && profile->items[count].t == profile->items[0].t)
        ++count;
    return count;
}

double sph2d__profile_velocity(const sph2d_path *profile, double place, double time)
{
    size_t places = sph2d__profile_places(profile), last = profile->count / places - 1, k = 0;
    while (k < last && profile->items[(k + 1) * places].t <= time)
        ++k;
    const sph2d_path_point *now = &profile->items[k * places], *next = k < last ? now + places : now;
    double part = k < last ? fmax((time - now->t) / (next->t - now->t), 0) : 0, velocity = 0;
    sph2d__cubic c = sph2d__cubic_at(&now->x, STRIDE, places, place);
    for (size_t i = c.first; i < c.first + c.count; ++i)
        velocity += c.weight[i - c.first] * (now[i].y + part * (next[i].y - now[i].y));
    return velocity;
}

/* Two points of Gauss in each interval are exact for cubics. */
double sph2d__profile_mean(const sph2d_path *profile, double from, double to, double time)
{
    size_t places = sph2d__profile_places(profile);
    double sum = 0, off = 0.5 / sqrt(3);
    for (size_t i = 0; i <= places; ++i) {
        double low = i > 0 ? fmin(fmax(profile->items[i - 1].x, from), to) : from;
        double high = i < places ? fmin(fmax(profile->items[i].x, from), to) : to;
        double middle = (low + high) / 2, width = high - low;
        if (width > 0)
            sum += width / 2 *
                   (sph2d__profile_velocity(profile, middle - off * width, time) +
                    sph2d__profile_velocity(profile, middle + off * width, time));
    }
    return sum / (to - from);
}

double sph2d__profile_largest(const sph2d_path *profile)
{
    double largest = 0;
    for (size_t i = 0; i < profile->count; ++i)
        largest = fmax(largest, fabs(profile->items[i].y));
    return largest;
}

/* The parabola is Poiseuille's. The turbulent one is the power law with the exponent 1/7 on both sides of the middle line
 * (Prandtl 1921; Schlichting, Boundary-Layer Theory, chapter 20), whose mean is 7/8 of its largest value. */
double sph2d__profile_shape(sph2d_opening_profile profile, double z)
{
    z = fmin(fmax(z, 0), 1);
    switch (profile) {
    case SPH2D_OPENING_PROFILE_PARABOLA:
        return 6 * z * (1 - z);
    case SPH2D_OPENING_PROFILE_TURBULENT:
        return 8.0 / 7 * pow(1 - fabs(2 * z - 1), 1.0 / 7);
    case SPH2D_OPENING_PROFILE_UNIFORM:
        break;
    }
    return 1;
}

double sph2d__profile_peak(sph2d_opening_profile profile)
{
    return sph2d__profile_shape(profile, 0.5);
}
