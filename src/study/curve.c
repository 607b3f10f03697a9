/* SPDX-License-Identifier: MIT */
/** @file curve.c
 *  Reduces a series of samples to one number. */
#include "study/curve.h"

#include <math.h>

typedef sph2d_study_curve curve;

/** Number of shifts of a reference that are tried to each side. */
enum { SHIFTS = 100 };

/** Relative tolerance of times, as the time of a simulation is a sum of steps with rounding errors. */
static const double ROUNDING = 1e-12;

static double slack(double x)
{
    return ROUNDING * fabs(x);
}

curve sph2d__curve_select(const double *rows, size_t width, size_t column, size_t count, double from, double to,
                          double *room)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i) {
        double x = rows[i * width], y = rows[i * width + column];
        if (x < from - slack(from) || x > to + slack(to) || !isfinite(y) || !isfinite(x))
            continue;
        room[kept] = x;
        room[count + kept++] = y;
    }
    return (curve){room, room + count, kept};
}

/* ---- numbers of a curve ------------------------------------------------------------------------------------------ */

/** The largest value with sign 1, the smallest with sign -1. */
static double extreme(curve c, double sign)
{
    double result = c.count > 0 ? sign * c.y[0] : NAN;
    for (size_t i = 1; i < c.count; ++i)
        result = fmax(result, sign * c.y[i]);
    return sign * result;
}

static double last(curve c)
{
    return c.count > 0 ? c.y[c.count - 1] : NAN;
}

/** The mean of y or of y^2 over x, exact for straight lines; a curve that takes no time is its last sample. */
static double mean(curve c, bool squared)
{
    double sum = 0, length = 0;
    for (size_t i = 1; i < c.count; ++i) {
        double a = c.y[i - 1], b = c.y[i], dx = c.x[i] - c.x[i - 1];
        sum += dx * (squared ? (a * a + a * b + b * b) / 3 : (a + b) / 2);
        length += dx;
    }
    if (length > 0)
        return sum / length;
    return squared ? last(c) * last(c) : last(c);
}

/** Where the line from point i - 1 to point i comes to `level`. */
static double meeting(curve c, size_t i, double level)
{
    double part = (level - c.y[i - 1]) / (c.y[i] - c.y[i - 1]);
    return c.x[i - 1] + part * (c.x[i] - c.x[i - 1]);
}

static double crossing(curve c, double level)
{
    for (size_t i = 1; i < c.count; ++i) {
        bool upwards = c.y[i - 1] < level && c.y[i] >= level;
        bool downwards = c.y[i - 1] > level && c.y[i] <= level;
        if (upwards || downwards)
            return meeting(c, i, level);
    }
    return NAN;
}

static double period(curve c, double level)
{
    double first = NAN, newest = NAN;
    size_t crossings = 0;
    for (size_t i = 1; i < c.count; ++i) {
        if (!(c.y[i - 1] < level && c.y[i] >= level))
            continue;
        newest = meeting(c, i, level);
        if (crossings++ == 0)
            first = newest;
    }
    return crossings > 1 ? (newest - first) / (double)(crossings - 1) : NAN;
}

/** Minus the slope of the line through the logarithms of the peaks, without an incomplete one at the end. */
static double decay(curve c, double level)
{
    double n = 0, st = 0, sl = 0, stt = 0, stl = 0, peak = 0, time = 0, first = NAN;
    bool open = true; /* the start of the present half period is not known */
    for (size_t i = 0; i < c.count; ++i) {
        double y = c.y[i] - level;
        bool crossed = i > 0 && (c.y[i - 1] < level) != (c.y[i] < level);
        if (crossed && !open && peak > 0) {
            double t = time - first, l = log(peak);
            n += 1, st += t, sl += l, stt += t * t, stl += t * l;
        }
        if (crossed) {
            open = false;
            peak = 0;
        }
        if (!open && fabs(y) > peak) {
            peak = fabs(y);
            time = c.x[i];
            first = isnan(first) ? time : first;
        }
    }
    double spread = n * stt - st * st;
    return n > 1 && spread > 0 ? (st * sl - n * stl) / spread : NAN;
}

double sph2d__curve_at(curve c, double x)
{
    if (c.count == 0 || !(x >= c.x[0] - slack(x)) || !(x <= c.x[c.count - 1] + slack(x)))
        return NAN;
    size_t low = 0, high = c.count - 1; /* the line that x lies on goes from one to the other in the end */
    while (high > low + 1) {
        size_t middle = low + (high - low) / 2;
        if (c.x[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    double dx = c.x[high] - c.x[low];
    double part = dx > 0 ? fmin(fmax((x - c.x[low]) / dx, 0), 1) : 1;
    return c.y[low] + part * (c.y[high] - c.y[low]);
}

double sph2d__curve_reduce(sph2d_take take, curve c, double level, double at)
{
    switch (take) {
    case SPH2D_TAKE_DEFAULT:
    case SPH2D_TAKE_LAST:
        return last(c);
    case SPH2D_TAKE_MAX:
        return extreme(c, 1);
    case SPH2D_TAKE_MIN:
        return extreme(c, -1);
    case SPH2D_TAKE_MEAN:
        return mean(c, false);
    case SPH2D_TAKE_RMS:
        return sqrt(mean(c, true));
    case SPH2D_TAKE_SPREAD:
        return extreme(c, 1) - extreme(c, -1);
    case SPH2D_TAKE_PERIOD:
        return period(c, isnan(level) ? mean(c, false) : level);
    case SPH2D_TAKE_CROSSING:
        return crossing(c, level);
    case SPH2D_TAKE_DECAY:
        return decay(c, isnan(level) ? mean(c, false) : level);
    case SPH2D_TAKE_VALUE:
        return sph2d__curve_at(c, at);
    }
    return NAN;
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

/** Sums of differences, so that no list of them is needed. */
typedef struct differences {
    double largest, squares, sum;
    size_t count;
} differences;

static void add(differences *d, double difference)
{
    double size = fabs(difference);
    d->largest = fmax(d->largest, size);
    d->squares += size * size;
    d->sum += size;
    ++d->count;
}

static double norm_of(const differences *d, sph2d_norm norm)
{
    if (d->count == 0 || isnan(d->sum))
        return NAN;
    switch (norm) {
    case SPH2D_NORM_MAX:
        return d->largest;
    case SPH2D_NORM_RMS:
        return sqrt(d->squares / (double)d->count);
    case SPH2D_NORM_MEAN:
        return d->sum / (double)d->count;
    }
    return NAN;
}

double sph2d__norm(sph2d_norm norm, const double *values, size_t count)
{
    differences d = {0, 0, 0, 0};
    for (size_t i = 0; i < count; ++i)
        add(&d, values[i]);
    return norm_of(&d, norm);
}

static double compare_moved(curve c, double scale, curve reference, sph2d_norm norm, double by)
{
    differences d = {0, 0, 0, 0};
    for (size_t i = 0; i < reference.count; ++i) {
        double value = sph2d__curve_at(c, reference.x[i] + by);
        if (!isnan(value))
            add(&d, value / scale - reference.y[i]);
    }
    return norm_of(&d, norm);
}

double sph2d__curve_compare(curve c, double scale, curve reference, sph2d_norm norm, double shift)
{
    double least = compare_moved(c, scale, reference, norm, 0);
    for (int k = -SHIFTS; k <= SHIFTS && shift > 0; ++k)
        least = fmin(least, compare_moved(c, scale, reference, norm, shift * k / SHIFTS));
    return least;
}

double sph2d__error(double value, double expect, bool relative)
{
    return relative ? fabs(value / expect - 1) : fabs(value - expect);
}

double sph2d__order(double error_coarse, double error_fine, double spacing_coarse, double spacing_fine)
{
    bool positive = error_coarse > 0 && error_fine > 0 && spacing_coarse > 0 && spacing_fine > 0;
    if (!positive || spacing_coarse == spacing_fine)
        return NAN;
    return log(error_coarse / error_fine) / log(spacing_coarse / spacing_fine);
}
